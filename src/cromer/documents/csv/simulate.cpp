#include "cromer/documents/csv/simulate.h"
#include "cromer/documents/words/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cromer/analysis/energy.h"
#include "cromer/model/sensor.h"
#include "cromer/report/csv.h"

namespace cromer::core {
namespace {

std::vector<std::string> comments(const SimulateResult& result, const std::string& command) {
  if (command.empty()) return {};
  std::vector<std::string> lines{command};
  if (result.options.sensor.used)
    lines.emplace_back("synthetic: a simulated motion sensor, not a measurement");
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const SimulatedRun& run = result.runs[i];
    if (result.runs.size() > 1) lines.push_back(fmt::format("run {}: {}", i + 1, run.label));
    if (!run.message.empty()) lines.push_back(fmt::format("run {}: {}", i + 1, in_words(run.message)));
  }
  return lines;
}

std::string states_csv(const SimulateResult& result, const std::vector<std::string>& head) {
  std::string out;
  std::vector<double> energies;
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const SimulatedRun& run = result.runs[i];
    energies.resize(run.trajectory.size());
    for (std::size_t n = 0; n < energies.size(); ++n)
      energies[n] = energy(run.oscillator, State<double>{run.trajectory.x[n], run.trajectory.v[n]});
    const CsvColumn columns[] = {{"run", fmt::format("{}", i + 1)},
                                 {"t (s)", std::span<const double>(run.trajectory.t)},
                                 {"x (m)", std::span<const double>(run.trajectory.x)},
                                 {"v (m/s)", std::span<const double>(run.trajectory.v)},
                                 {"energy (J)", std::span<const double>(energies)}};
    append_csv(out, columns, i == 0 ? head : std::vector<std::string>{}, i == 0);
  }
  return out;
}

std::string sensor_csv(const SimulateResult& result, const std::vector<std::string>& head) {
  std::size_t rows = 0;
  for (const auto& run : result.runs) rows = std::max(rows, run.sensor.size());
  // Runs of different lengths: the shorter ones end with empty cells.
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> cells;
  for (const auto& run : result.runs) {
    auto& times = cells.emplace_back(run.trajectory.t);
    std::transform(times.begin(), times.end(), times.begin(), to_15_digits);
    times.resize(rows, missing);
    cells.emplace_back(run.sensor).resize(rows, missing);
  }
  std::vector<CsvColumn> columns;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string run = result.runs.size() > 1 ? fmt::format(" Run #{}", i / 2 + 1) : "";
    columns.push_back({(i % 2 ? "Position (m)" : "Time (s)") + run, std::span<const double>(cells[i])});
  }
  std::string out;
  append_csv(out, columns, head, true);
  return out;
}

}  // namespace

std::string simulate_csv(const SimulateResult& result, const std::string& command) {
  const auto head = comments(result, command);
  return result.options.sensor.used ? sensor_csv(result, head) : states_csv(result, head);
}

}  // namespace cromer::core
