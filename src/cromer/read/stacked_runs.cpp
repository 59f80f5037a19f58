#include "cromer/read/stacked_runs.h"

#include <algorithm>
#include <cmath>

#include "cromer/read/set.h"
#include "cromer/read/time.h"

namespace cromer::core::dialects {
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

/// The rows between the starts as sets, without the first `skipped` columns. False, and nothing done, where
/// one long run among many short ones would cost memory that the file's size does not announce.
bool lay_runs(Recording& recording, const std::vector<std::size_t>& starts, std::size_t skipped) {
  const auto& columns = recording.table.columns;
  std::size_t longest = 0;
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) longest = std::max(longest, starts[k + 1] - starts[k]);
  const std::size_t count = starts.size() - 1;
  if (count > most_runs || longest * count > 16 * recording.table.rows() + 1000) return false;
  std::vector<Set> sets(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto from = static_cast<std::ptrdiff_t>(starts[k]), to = static_cast<std::ptrdiff_t>(starts[k + 1]);
    for (std::size_t j = skipped; j < columns.size(); ++j) {
      const auto& values = columns[j].values;
      sets[k].columns.push_back({columns[j].name,
                                 columns[j].quantity,
                                 columns[j].unit,
                                 1,
                                 {values.begin() + from, values.begin() + to}});
    }
    sets[k].lines.assign(recording.lines.begin() + from, recording.lines.begin() + to);
  }
  return lay_side_by_side(std::move(sets), recording).ok();
}

}  // namespace

bool split_stacked_runs(Recording& recording) {
  const auto& columns = recording.table.columns;
  if (columns.size() < 3 || columns[0].name != "run" || !columns[0].unit.empty()) return false;
  const auto starts = run_starts(columns[0].values);
  return starts.size() >= 2 && lay_runs(recording, starts, 1);
}

void split_at_restarts(Recording& recording) {
  if (!recording.lines_of_set.empty()) return;  // its runs are told apart already
  const auto& columns = recording.table.columns;
  const auto is_time = [](const Column& column) { return column.quantity == "time"; };
  const auto time = std::find_if(columns.begin(), columns.end(), is_time);
  if (time == columns.end() || std::count_if(columns.begin(), columns.end(), is_time) != 1) return;
  if (std::any_of(columns.begin(), columns.end(), [](const Column& column) { return column.run != 1; }))
    return;
  std::vector<std::size_t> starts{0};
  for (const std::size_t again : restarts(time->values)) starts.push_back(again);
  starts.push_back(time->values.size());
  if (starts.size() == 2) return;
  const long line = recording.lines[starts[1]];
  const std::size_t more = starts.size() - 3, count = starts.size() - 1;
  if (!lay_runs(recording, starts, 0)) return;
  recording.notices.push_back(
      more > 0 ? Notice{"read_as_runs_again", {{"line", line}, {"times", more}, {"runs", count}}}
               : Notice{"read_as_runs", {{"line", line}, {"runs", count}}});
}

}  // namespace cromer::core::dialects
