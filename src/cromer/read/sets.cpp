#include "cromer/read/sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "cromer/base/ascii.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/formats/plain.h"
#include "cromer/read/header.h"
#include "cromer/read/time.h"

namespace cromer::core::dialects {
namespace {

bool is_time(const Column& column) { return column.quantity == "time"; }

/// The runs laid down so far.
struct Laid {
  std::map<std::string, int> run_of_label;                     // the last of that label
  std::set<std::tuple<int, std::string, std::string>> titles;  // run, name and unit of what is no time
  std::map<int, std::size_t> time_of_run;                      // the last

  bool has_column_of(int run, const Set& set) const {
    return std::any_of(set.columns.begin(), set.columns.end(), [&](const Column& column) {
      return !is_time(column) && titles.count({run, column.name, column.unit}) > 0;
    });
  }

  /// Whether the last time of the run is the same as this one: then the columns that follow share it.
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

namespace {

constexpr std::size_t most_tables = 200;

/// A digit after signs, decimal marks and quotes.
bool begins_as_row(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\"+-.,");
  if (first == std::string_view::npos) return false;
  if (line.substr(first).starts_with("\u2212")) return true;
  return is_digit(line[first]);
}

/// Several names, the first of which is a time.
bool names_a_time(std::string_view line) {
  std::vector<std::string_view> cells;
  for (const char separator : {'\t', ';', ','}) {
    split_cells(line, Layout{separator, '.', 1}, cells);
    if (cells.size() < 2) continue;
    const Heading heading = parse_heading(cells.front());
    return quantity_of(heading.name, heading.unit) == "time";
  }
  return false;
}

/// "Run #1" in a title, else nothing.
std::string run_label(std::string_view title) {
  const std::size_t at = title.find("Run #");
  if (at == std::string_view::npos) return {};
  const std::size_t end = title.find_first_not_of("0123456789", at + 5);
  return std::string(title.substr(at, end == std::string_view::npos ? end : end - at));
}

}  // namespace

std::vector<std::size_t> find_tables(const std::vector<std::string_view>& lines) {
  std::vector<std::size_t> starts{0};
  std::string_view first_header, above;
  bool rows = false;
  std::size_t top = 0, header = 0;  // of the lines of words at work
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool digit = !lines[i].empty() && is_digit(lines[i][0]);  // nearly always
    if (digit && rows && above.empty()) continue;
    if (!digit && (is_blank(lines[i]) || is_comment(lines[i]))) continue;
    if (!digit && !begins_as_row(lines[i])) {
      if (above.empty()) top = i;
      above = lines[i];
      header = i;
      continue;
    }
    if (!rows) first_header = above;
    if (rows && !above.empty() && (above == first_header || names_a_time(lines[header])))
      starts.push_back(top);
    if (starts.size() > most_tables) return {0};
    rows = true;
    above = {};
  }
  return starts;
}

std::vector<Set> as_sets(Recording recording, const std::string& label) {
  std::vector<Set> sets;
  auto& columns = recording.table.columns;
  for (const int run : runs(recording)) {
    Set set;
    set.label = label;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      if (columns[j].run != run) continue;
      if (set.lines.empty())
        for (std::size_t i = 0; i < columns[j].values.size(); ++i)
          set.lines.push_back(line_of(recording, j, i));
      set.columns.push_back(std::move(columns[j]));
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

Result<Recording> read_tables(const std::vector<std::string_view>& lines,
                              const std::vector<std::size_t>& starts, const ReadOptions& options) {
  Recording whole;
  std::vector<Set> sets;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t to = k + 1 < starts.size() ? starts[k + 1] : lines.size();
    const std::vector<std::string_view> part(lines.begin() + static_cast<std::ptrdiff_t>(starts[k]),
                                             lines.begin() + static_cast<std::ptrdiff_t>(to));
    auto table = read_plain(part, options, starts[k]);
    if (!table) return table.error();
    if (k == 0) {
      whole.dialect = table->dialect;
      whole.named = table->named;
    }
    std::string label;
    for (std::size_t i = 0; i < part.size() && !begins_as_row(part[i]) && label.empty(); ++i)
      label = run_label(part[i]);
    whole.notices.insert(whole.notices.end(), table->notices.begin(), table->notices.end());
    for (Set& set : as_sets(std::move(*table), label)) sets.push_back(std::move(set));
  }
  if (const auto laid = lay_side_by_side(std::move(sets), whole); !laid) return laid.error();
  return whole;
}

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

/// Lays the rows between the starts as sets, without the first `skipped` columns. False, and nothing done, if
/// one long run among many short ones would cost far more memory than the file has bytes.
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
