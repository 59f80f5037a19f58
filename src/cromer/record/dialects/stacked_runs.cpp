#include "cromer/record/dialects/stacked_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer::dialects {
namespace {

constexpr std::size_t most_runs = 10000;

/// Where each run begins, and the end; empty unless the numbers are whole and each run stands in one piece.
std::vector<std::size_t> run_starts(const std::vector<double>& numbers) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(numbers[i] == std::floor(numbers[i]))) return {};
    if (i > 0 && numbers[i] < numbers[i - 1]) return {};
    if (i == 0 || numbers[i] != numbers[i - 1]) starts.push_back(i);
  }
  starts.push_back(numbers.size());
  return starts;
}

}  // namespace

bool split_stacked_runs(Recording& recording) {
  auto& columns = recording.table.columns;
  if (columns.size() < 3 || columns[0].name != "run" || !columns[0].unit.empty()) return false;
  const auto starts = run_starts(columns[0].values);
  if (starts.size() < 2) return false;
  std::size_t longest = 0;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) longest = std::max(longest, starts[k + 1] - starts[k]);
  // One long run among many short ones would cost memory that the file's size does not announce.
  const std::size_t count = starts.size() - 1;
  if (count > most_runs || longest * count > 16 * columns[0].values.size() + 1000) return false;

  std::vector<Column> side_by_side;
  for (std::size_t k = 0; k < count; ++k) {
    const auto from = static_cast<std::ptrdiff_t>(starts[k]), to = static_cast<std::ptrdiff_t>(starts[k + 1]);
    for (std::size_t j = 1; j < columns.size(); ++j) {
      const auto& values = columns[j].values;
      Column column{columns[j].name,
                    columns[j].quantity,
                    columns[j].unit,
                    static_cast<int>(k) + 1,
                    {values.begin() + from, values.begin() + to}};
      column.values.resize(longest, std::numeric_limits<double>::quiet_NaN());
      side_by_side.push_back(std::move(column));
    }
    recording.lines_of_run.emplace_back(recording.lines.begin() + from, recording.lines.begin() + to);
  }
  columns = std::move(side_by_side);
  return true;
}

}  // namespace cromer::dialects
