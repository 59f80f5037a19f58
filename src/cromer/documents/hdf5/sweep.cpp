#include "cromer/documents/hdf5/sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/tasks/sweep/sweep_rows.h"
#include "cromer/version.h"

namespace cromer::core {
namespace {

/// The file's rows without their status, which is counted.
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
