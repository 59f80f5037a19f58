#include "cromer/documents/hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/sweep/sweep_rows.h"
#include "cromer/version.h"

namespace cromer::core {

std::vector<Hdf5Table> simulate_tables(const SimulateResult& result, const std::string& command) {
  std::vector<Hdf5Table> tables(1);
  tables[0].texts = {
      {"description", to_json(result, false)}, {"program", "cromer " CROMER_VERSION}, {"command", command}};
  if (result.options.sensor.used)
    tables[0].texts.emplace_back("synthetic", "a simulated motion sensor, not a measurement");
  for (const SimulatedRun& run : result.runs) {
    Hdf5Table& table = tables.emplace_back();
    table.name = fmt::format("run_{}", tables.size() - 1);
    table.texts = {{"method", run.method}, {"label", run.label}};
    if (!run.message.empty()) table.texts.emplace_back("message", in_words(run.message));
    NamedColumns states = state_columns(run);
    for (std::size_t i = 0; i < states.headers.size(); ++i)
      table.columns.push_back({.name = std::move(states.headers[i]),
                               .values = std::move(states.values[i]),
                               .shape = {},
                               .axes = i == 0 ? "" : "t"});
  }
  return tables;
}

namespace {

/// "PSA RotD50 (g)" as "PSA_RotD50 (g)".
std::string without_blanks(std::string header) {
  std::replace(header.begin(),
               header.begin() + static_cast<std::ptrdiff_t>(std::min(header.find(" ("), header.size())), ' ',
               '_');
  return header;
}

/// How many spectra have the first damping ratio: one of each ductility.
std::size_t ductilities_of(const std::vector<ResponseSpectrum>& spectra) {
  std::size_t count = 1;
  while (count < spectra.size() && spectra[count].ductility != spectra[0].ductility) ++count;
  return count;
}

/// Fills in the columns of a table.
void add_spectra(Hdf5Table& table, const SpectrumResult& result) {
  const auto& spectra = result.spectra;
  Hdf5Column ratios{.name = result.hysteretic() ? "loss_factor" : "damping_ratio"},
      ductilities{.name = "ductility"};
  const std::size_t of_each = result.inelastic() ? ductilities_of(spectra) : 1;
  for (std::size_t s = 0; s < spectra.size(); s += of_each) ratios.values.push_back(spectra[s].damping_ratio);
  for (std::size_t s = 0; s < of_each; ++s) ductilities.values.push_back(spectra[s].ductility);
  std::vector<std::uint64_t> shape{ratios.values.size()};
  std::string axes = ratios.name;
  table.columns = {std::move(ratios)};
  if (result.inelastic()) {
    shape.push_back(of_each);
    axes += " ductility";
    table.columns.push_back(std::move(ductilities));
  }
  shape.push_back(result.periods.size());
  table.columns.push_back({.name = "period (s)", .values = result.periods});
  const std::size_t behind = table.columns.size();
  for (const auto& spectrum : spectra) {
    const NamedColumns columns = spectrum_columns(result, spectrum);
    for (std::size_t i = 1; i < columns.headers.size(); ++i) {  // behind the periods
      if (table.columns.size() == behind + i - 1)
        table.columns.push_back({.name = without_blanks(columns.headers[i]),
                                 .values = {},
                                 .shape = shape,
                                 .axes = axes + " period"});
      auto& values = table.columns[behind + i - 1].values;
      values.insert(values.end(), columns.values[i].begin(), columns.values[i].end());
    }
  }
}

}  // namespace

std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const std::string& command) {
  Hdf5Table table;
  table.texts = {
      {"description", to_json(result, false)}, {"program", "cromer " CROMER_VERSION}, {"command", command}};
  add_spectra(table, result);
  return {std::move(table)};
}

std::vector<Hdf5Table> spectra_tables(std::span<const MotionSpectra> motions, const std::string& command) {
  std::vector<Hdf5Table> tables(1);
  tables[0].texts = {{"program", "cromer " CROMER_VERSION}, {"command", command}};
  for (std::size_t m = 0; m < motions.size(); ++m) {
    if (!motions[m].succeeded()) continue;
    const SpectrumResult& result = *motions[m].result;
    Hdf5Table& table = tables.emplace_back();
    table.name = fmt::format("motion_{}", m + 1);
    table.texts = {{"file", fmt::format("{}", fmt::join(motions[m].files, " + "))},
                   {"description", to_json(result, false, {}, false)}};
    add_spectra(table, result);
  }
  return tables;
}

namespace {

/// Reads all rows of the file into the result, and counts their statuses.
void read_back(const RowsFile& file, SweepResult& result) {
  const ChunkedRows& work = result.plan.rows;
  const std::size_t width = work.columns.size() - 1;
  result.rows.resize(work.rows * width);
  result.statuses.assign(work.rows, SweepResult::not_reached);
  result.counts = {};
  std::vector<double> rows(work.rows_per_chunk * (width + 1));
  double* to = result.rows.data();
  for (std::uint64_t chunk = 0; chunk < work.chunks(); ++chunk) {
    file.read(chunk, rows.data());
    const double* row = rows.data();
    for (std::uint64_t i = 0; i < work.rows_of(chunk); ++i, to += width, row += width + 1) {
      std::copy_n(row, width, to);
      if (std::isnan(row[width])) continue;  // not reached
      const std::uint64_t at = chunk * work.rows_per_chunk + i;
      result.statuses[at] = static_cast<unsigned char>(row[width]);
      count_row(result.plan, at, row, result.counts);
    }
  }
}

}  // namespace

Result<RowsFile> open_sweep_file(const SweepPlan& plan, const std::string& path, bool resume,
                                 const std::string& command, const Watch& watch) {
  RowsFileOptions options{
      .path = path, .resume = resume, .program = "cromer " CROMER_VERSION, .command = command};
  for (std::size_t i = 0; i < plan.swept.size(); ++i)
    options.axes.push_back({plan.swept[i].column, plan.work->axes[i].grid});
  return RowsFile::open(plan.rows, options, watch);
}

Result<SweepResult> fill_sweep_file(RowsFile& file, SweepPlan plan, const SweepOptions& options,
                                    const ChunkMaker& make, const Watch& watch) {
  SweepResult result{.plan = std::move(plan), .rows = {}, .counts = {}};
  const ChunkedRows& work = result.plan.rows;
  const std::size_t width = work.columns.size() - 1;
  result.done = work.rows;
  for (const std::uint64_t chunk : file.unfinished()) result.done -= work.rows_of(chunk);
  const auto sink = [&](std::uint64_t chunk, const double* rows) {
    for (std::uint64_t i = 0; i < work.rows_of(chunk); ++i)
      count_row(result.plan, chunk * work.rows_per_chunk + i, rows + i * (width + 1), result.counts);
    result.done += work.rows_of(chunk);
    return file.write(chunk, rows);
  };
  const auto end = make(work, file.unfinished(), options.threads.value_or(0), sink, watch);
  const auto closed = file.close();
  if (!end) return end.error();
  if (!closed) return closed.error();
  result.interrupted = *end == ChunksEnd::interrupted;
  const double numbers = static_cast<double>(work.rows) * static_cast<double>(width);
  if (numbers * sizeof(double) <= options.memory) read_back(file, result);
  if (options.check && !result.interrupted) result.check = check_closed_form(result.plan, watch);
  return result;
}

}  // namespace cromer::core
