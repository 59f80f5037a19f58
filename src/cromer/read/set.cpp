#include "cromer/read/set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace cromer::core::dialects {
namespace {

bool is_time(const Column& column) { return column.quantity == "time"; }

/// What is laid down already, by run.
struct Laid {
  std::map<std::string, int> run_of_label;                     // the last of that label
  std::set<std::tuple<int, std::string, std::string>> titles;  // run, name and unit of what is no time
  std::map<int, std::size_t> time_of_run;                      // the last

  bool has_column_of(int run, const Set& set) const {
    return std::any_of(set.columns.begin(), set.columns.end(), [&](const Column& column) {
      return !is_time(column) && titles.count({run, column.name, column.unit}) > 0;
    });
  }

  /// The last time of the run, if it is the same as this one: then the columns that follow have theirs.
  bool has_time(const std::vector<Column>& table, int run, const Column& time) const {
    const auto last = time_of_run.find(run);
    if (last == time_of_run.end()) return false;
    const auto& known = table[last->second].values;  // padded
    const auto end = known.begin() + static_cast<std::ptrdiff_t>(time.values.size());
    return table[last->second].unit == time.unit &&
           std::equal(time.values.begin(), time.values.end(), known.begin()) &&
           std::all_of(end, known.end(), [](double value) { return std::isnan(value); });
  }
};

}  // namespace

void say_labels(const std::vector<std::string>& labels, std::vector<Notice>& notices) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string own = std::to_string(i + 1);
    const std::size_t digits = labels[i].find_last_not_of("0123456789") + 1;
    const bool numbered = digits < labels[i].size();
    if (numbered ? labels[i].substr(digits) != own : labels.size() > 1 && !labels[i].empty())
      notices.push_back(Notice{"run_called", {{"run", i + 1}, {"label", labels[i]}}});
  }
}

Result<void> lay_side_by_side(std::vector<Set> sets, Recording& recording) {
  constexpr std::size_t most_sets = 10'000, most_laid = 100'000;
  if (sets.size() > most_sets)
    return Error{"too_many_tables", {{"tables", sets.size()}, {"most", most_sets}}};
  std::size_t longest = 0, cells = 0, columns = 0;
  for (const Set& set : sets) {
    longest = std::max(longest, set.lines.size());
    columns += set.columns.size();
    cells += set.columns.size() * set.lines.size();
  }
  if (longest * columns > 16 * cells + 100'000) return Error{"tables_too_unequal", {{"tables", sets.size()}}};
  if (columns > most_laid) return Error{"tables_too_wide", {{"columns", columns}, {"most", most_laid}}};
  auto& table = recording.table.columns;
  std::vector<std::string> labels;  // of the runs
  std::vector<std::size_t> set_of_column;
  Laid laid;
  table.clear();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    Set& set = sets[k];
    const auto known = set.label.empty() ? laid.run_of_label.end() : laid.run_of_label.find(set.label);
    int run = known == laid.run_of_label.end() ? 0 : known->second;
    if (run == 0 || laid.has_column_of(run, set)) {
      labels.push_back(set.label);
      run = static_cast<int>(labels.size());
      laid.run_of_label[set.label] = run;
    }
    for (Column& column : set.columns) {
      if (is_time(column) && laid.has_time(table, run, column)) continue;
      column.run = run;
      column.values.resize(longest, std::numeric_limits<double>::quiet_NaN());
      if (is_time(column))
        laid.time_of_run[run] = table.size();
      else
        laid.titles.insert({run, column.name, column.unit});
      table.push_back(std::move(column));
      set_of_column.push_back(k);
    }
  }
  if (sets.size() == 1) {
    recording.lines = std::move(sets.front().lines);
  } else {
    recording.lines.clear();
    for (Set& set : sets) recording.lines_of_set.push_back(std::move(set.lines));
    recording.set_of_column = std::move(set_of_column);
  }
  say_labels(labels, recording.notices);
  return {};
}

}  // namespace cromer::core::dialects
