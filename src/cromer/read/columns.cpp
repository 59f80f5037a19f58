#include "cromer/read/columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/base/nearest.h"
#include "cromer/base/quantile.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/sets.h"

namespace cromer::core {
namespace {

std::string number_as_name(std::size_t column) { return concat({"column ", std::to_string(column + 1)}); }

std::string without_subscript(std::string name) {
  while (name.size() > 1 && is_digit(name.back())) name.pop_back();
  return name;
}

/// Rises with every step (but for a few), in steps that are nearly equal.
bool runs_evenly_upward(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (std::isfinite(step)) steps.push_back(step);
  }
  if (steps.size() < 2) return false;
  const double median = upper_median(steps);
  if (!(median > 0)) return false;
  const auto even = std::count_if(steps.begin(), steps.end(),
                                  [&](double step) { return std::fabs(step - median) < 0.5 * median; });
  return static_cast<double>(even) >= 0.9 * static_cast<double>(steps.size());
}

/// 0, 1, 2, ...: not a time if the rate is known.
bool counts_by_one(const std::vector<double>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] - values[i - 1] != 1) return false;
  return true;
}

bool counts_rows(const Column& column) {
  constexpr std::array<std::string_view, 8> names{"sample", "samples", "index", "row",
                                                  "frame",  "n",       "no",    "#"};
  const std::string name = plain_name(column.name);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The period of a spectrum or a pendulum: in seconds, but not a time.
bool is_period(const std::string& name) {
  constexpr std::array<std::string_view, 6> words{"period", "periodo", "période", "periode", "tn", "lag"};
  std::string small = plain_name(name);
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return small.starts_with(word); });
}

/// How many rows apart the values stand, if evenly (sensors sampled in turn, or more slowly than others);
/// else 1.
std::size_t stride_of(const std::vector<double>& values) {
  constexpr std::size_t fewest = 4;
  std::size_t count = 0, last = 0, stride = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    if (count == 1) stride = i - last;
    if (count > 1 && i - last != stride) return 1;
    last = i;
    ++count;
  }
  return count >= fewest ? stride : 1;
}

/// The ending of "2nd", "12th", "22nd".
Notice ordinal_ending(std::size_t n) {
  if (n / 10 % 10 == 1 || n % 10 == 0 || n % 10 > 3) return Notice{"ordinal_th"};
  return n % 10 == 1 ? Notice{"ordinal_st"} : Notice{n % 10 == 2 ? "ordinal_nd" : "ordinal_rd"};
}

/// A time is never scaled by guess: a unit that is unknown or measures something else is an Error, unless
/// another column is a time with a good unit.
Result<void> check_time_units(std::vector<Column>& columns, bool asked) {
  const auto good = [](const Column& column) {
    return column.unit.empty() || is_unit_of(column.unit, "time");
  };
  const auto complain = [asked](const Column& column) {
    const bool unknown = quantity_of("", column.unit).empty();
    return Error{asked ? "bad_time_unit" : "bad_time_unit_or_column",
                 {{"column", column_title(column)},
                  {"unit", column.unit},
                  {"fault", Notice{unknown ? "is_not_known" : "is_no_unit_of_time"}}}};
  };
  bool any_good = false;
  const Column* bad = nullptr;
  for (const Column& column : columns) {
    const bool named = quantity_of(column.name, "") == "time";
    if (column.quantity == "time" && good(column)) any_good = true;
    if ((column.quantity == "time" || (named && !asked)) && !good(column) && !bad) bad = &column;
  }
  if (!bad) return {};
  if (!any_good || asked) return complain(*bad);
  for (Column& column : columns)
    if (column.quantity == "time" && !good(column)) column.quantity.clear();
  return {};
}

}  // namespace

std::string column_title(const Column& column) {
  return column.unit.empty() ? column.name : concat({column.name, " (", column.unit, ")"});
}

std::vector<std::string> quoted_titles(const std::vector<Column>& columns,
                                       const std::vector<std::size_t>& chosen) {
  std::vector<std::string> titles;
  for (const std::size_t j : chosen) titles.push_back(concat({"\"", column_title(columns[j]), "\""}));
  return titles;
}

std::size_t rows_of_run(const Table& table, int run) {
  std::size_t rows = 0;
  for (const Column& column : table.columns)
    for (std::size_t i = column.values.size(); column.run == run && i > rows; --i)
      if (!std::isnan(column.values[i - 1])) rows = i;
  return rows;
}

Result<std::size_t> find_column(const Table& table, std::string_view name, int run) {
  const auto& columns = table.columns;
  std::vector<std::size_t> of_run;
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (run == 0 || columns[j].run == run) of_run.push_back(j);
  const auto matching = [&](auto&& matches) {
    std::vector<std::size_t> found;
    for (const std::size_t j : of_run)
      if (matches(columns[j])) found.push_back(j);
    return found;
  };
  auto found = matching([&](const Column& column) { return column_title(column) == name; });
  if (found.empty()) found = matching([&](const Column& column) { return column.name == name; });
  const dialects::Heading wanted = dialects::parse_heading(name);
  const std::string plain = plain_name(wanted.name);
  // A unit of another quantity is another column's.
  const auto called = [&](auto&& name_of) {
    return matching([&](const Column& column) {
      if (name_of(column.name) != plain) return false;
      const std::string asked = quantity_of(column.name, wanted.unit),
                        own = quantity_of(column.name, column.unit);
      return wanted.unit.empty() || column.unit.empty() || asked.empty() || own.empty() || asked == own;
    });
  };
  if (found.empty()) found = called([](std::string_view each) { return plain_name(each); });
  if (found.empty())
    found = called([](std::string_view each) { return without_subscript(plain_name(each)); });
  if (found.size() == 1 || (run == 0 && !found.empty())) return found.front();

  std::vector<std::string_view> names;  // nobody means the time
  for (const std::size_t j : of_run)
    if (columns[j].quantity != "time") names.push_back(columns[j].name);
  const std::vector<std::string> titles = quoted_titles(columns, of_run);
  if (!found.empty()) return Error{"several_columns_fit", {{"name", name}, {"columns", titles}}};
  std::string near = nearest(name, names);
  if (!wanted.unit.empty())
    for (const std::size_t j : of_run)
      if (columns[j].name == near) near = column_title(columns[j]);
  if (near.empty()) return Error{"no_such_column", {{"name", name}, {"columns", titles}}};
  return Error{"no_such_column_but", {{"name", name}, {"columns", titles}, {"near", near}}};
}

namespace dialects {
namespace {

/// The label of each column's run in the header. A time without one belongs to the columns behind it, any
/// other column to those before it.
std::vector<std::string> column_labels(const std::vector<Column>& columns, const Header& header) {
  const std::size_t count = columns.size();
  std::vector<std::string> own(count), before(count), behind(count);
  for (std::size_t j = 0; j < count; ++j) {
    if (j < header.headings.size()) own[j] = header.headings[j].run;
    before[j] = own[j].empty() && j > 0 ? before[j - 1] : own[j];
  }
  for (std::size_t j = count; j-- > 0;) behind[j] = own[j].empty() && j + 1 < count ? behind[j + 1] : own[j];
  for (std::size_t j = 0; j < count; ++j) {
    const bool to_the_right = before[j].empty() || (columns[j].quantity == "time" && !behind[j].empty());
    if (own[j].empty()) own[j] = to_the_right ? behind[j] : before[j];
  }
  return own;
}

}  // namespace
std::vector<Column> name_columns(const Header& header, std::size_t count) {
  std::vector<Column> columns(count);
  for (std::size_t j = 0; j < count; ++j) {
    if (j < header.headings.size()) {
      columns[j].name = header.headings[j].name;
      columns[j].unit = header.headings[j].unit;
      columns[j].quantity = quantity_of(columns[j].name, columns[j].unit);
    }
  }
  number_unnamed(columns);
  return columns;
}

void number_unnamed(std::vector<Column>& columns) {
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (columns[j].name.empty()) columns[j].name = number_as_name(j);
}

void drop_unnamed_empty(std::vector<Column>& columns) {
  while (columns.size() > 1) {
    const Column& last = columns.back();
    const bool unnamed = last.name == number_as_name(columns.size() - 1);
    const bool empty =
        std::all_of(last.values.begin(), last.values.end(), [](double value) { return std::isnan(value); });
    if (!unnamed || !empty) return;
    columns.pop_back();
  }
}

void number_runs(Recording& recording, const Header& header) {
  auto& columns = recording.table.columns;
  const std::size_t named = std::min(columns.size(), header.headings.size());
  const auto is_time = [&](std::size_t j) { return columns[j].quantity == "time"; };
  const std::vector<std::string> label = column_labels(columns, header);
  std::vector<std::string> labels;                               // of the runs
  std::map<std::string, int> run_of_label;                       // the last of that label
  std::map<std::string, std::set<std::string>> titles_of_label;  // in that run
  for (std::size_t from = 0, to; from < columns.size(); from = to) {
    // A group of columns goes together: a time and what was measured at it.
    const std::string& group = label[from];
    std::set<std::string> titles;
    for (to = from; to < columns.size() && label[to] == group; ++to) {
      if (to > from && is_time(to) && is_time(from)) break;
      if (to < named && !titles.insert(column_title(columns[to])).second) break;
    }
    if (is_time(from)) titles.erase(column_title(columns[from]));
    // A name that repeats begins the next run; a time that repeats, with other names behind it, does not.
    std::set<std::string>& known = titles_of_label[group];
    const bool repeated = std::any_of(titles.begin(), titles.end(),
                                      [&](const std::string& title) { return known.count(title) > 0; });
    if (repeated || run_of_label.count(group) == 0) {
      labels.push_back(group);
      run_of_label[group] = static_cast<int>(labels.size());
      known.clear();
    }
    known.insert(titles.begin(), titles.end());
    for (std::size_t j = from; j < to; ++j) columns[j].run = run_of_label[group];
  }
  say_labels(labels, recording.notices);
}

Result<void> mark_time(Recording& recording, const ReadOptions& options, bool has_header) {
  auto& columns = recording.table.columns;
  if (!options.time_column.empty()) {
    const auto asked = find_column(recording.table, options.time_column, 0);
    if (!asked) return Error{"time_column_refused", {{"what", asked.error().notice}}};
    const std::string name = columns[*asked].name;
    for (Column& column : columns) {
      if (column.name == name)
        column.quantity = "time";
      else if (column.quantity == "time")
        column.quantity.clear();
    }
    return check_time_units(columns, true);
  }
  // A period in seconds is not a time; nor are other seconds, if a column is called a time.
  const auto named = [](const Column& column) { return quantity_of(column.name, "") == "time"; };
  const bool any_named = std::any_of(columns.begin(), columns.end(), [&](const Column& column) {
    return column.quantity == "time" && named(column);
  });
  for (Column& column : columns)
    if (column.quantity == "time" && (is_period(column.name) || (any_named && !named(column))))
      column.quantity.clear();
  if (const auto checked = check_time_units(columns, false); !checked) return checked;
  const bool any = std::any_of(columns.begin(), columns.end(),
                               [](const Column& column) { return column.quantity == "time"; });
  Column& first = columns.front();
  for (Column& column : columns)
    if (column.quantity.empty() && counts_rows(column)) column.quantity = "index";
  const bool may_be_time = !any && columns.size() > 1 && first.quantity.empty() && !is_period(first.name);
  if (may_be_time && options.rate > 0 && counts_by_one(first.values)) {
    first.quantity = "index";
  } else if (may_be_time && runs_evenly_upward(first.values)) {
    first.quantity = "time";
    recording.notices.push_back(has_header ? Notice{"taken_as_time", {{"column", first.name}}}
                                           : Notice{"first_taken_as_time"});
  }
  return {};
}

void count_missing(Recording& recording) {
  auto& columns = recording.table.columns;
  const auto length_of = [&](const std::vector<double>& values) {
    std::size_t length = values.size();
    while (length > 0 && std::isnan(values[length - 1])) --length;
    return length;
  };
  std::vector<std::size_t> length_of_run;
  for (const Column& column : columns) {
    const auto run = static_cast<std::size_t>(column.run);
    if (length_of_run.size() <= run) length_of_run.resize(run + 1);
    length_of_run[run] = std::max(length_of_run[run], length_of(column.values));
  }
  const bool several = length_of_run.size() > 2;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Column& column = columns[j];
    std::size_t missing = 0;
    long first = 0;
    for (std::size_t i = 0; i < length_of_run[static_cast<std::size_t>(column.run)]; ++i)
      if (std::isnan(column.values[i]) && missing++ == 0) first = line_of(recording, j, i);
    if (missing == 0) continue;
    const std::string title = column_title(column);
    const Notice where = several ? Notice{"column_of_run", {{"column", title}, {"run", column.run}}}
                                 : Notice{"column_named", {{"column", title}}};
    if (const std::size_t stride = stride_of(column.values); stride > 1)
      recording.notices.push_back(
          Notice{"measured_in_some_rows",
                 {{"column", where}, {"stride", stride}, {"ending", ordinal_ending(stride)}}});
    else
      recording.notices.push_back(
          Notice{"missing_values", {{"column", where}, {"values", missing}, {"line", first}}});
  }
}

}  // namespace dialects
}  // namespace cromer::core
