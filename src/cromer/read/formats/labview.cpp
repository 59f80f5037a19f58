// LabVIEW measurement files (.lvm): a header of tags, then segments of a header of tags, names and rows.
// Source: National Instruments, "Specification for the LabVIEW Measurement File (.lvm)".
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/add_once.h"
#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/base/quantile.h"
#include "cromer/base/quantity.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/formats/own_structures.h"
#include "cromer/read/header.h"
#include "cromer/read/in_file.h"
#include "cromer/read/layout.h"
#include "cromer/read/rows.h"

namespace cromer::core::dialects {
namespace {

/// What reading needs of the head of the file.
struct LabviewFile {
  enum class Times { none, one, multi };  ///< X_Columns: none in the rows, one column, one for each channel
  char separator = '\t';
  Times times = Times::one;
  std::size_t end = 0;  ///< index of the line behind ***End_of_Header***
};

/// One tag of a segment's header with a value for each channel.
struct LabviewTag {
  std::string_view name;
  std::vector<std::string_view> values;
};

struct LabviewSegment {
  std::vector<LabviewTag> tags;
  std::size_t names = 0;  ///< index of the line of names behind ***End_of_Header***

  /// The values of a tag; empty if the segment does not have it.
  const std::vector<std::string_view>& operator[](std::string_view tag) const;
};

constexpr std::string_view end_of_header = "***End_of_Header***";

const std::vector<std::string_view>& LabviewSegment::operator[](std::string_view tag) const {
  static const std::vector<std::string_view> none;
  for (const LabviewTag& own : tags)
    if (own.name == tag) return own.values;
  return none;
}

LabviewFile labview_file(const std::vector<std::string_view>& lines) {
  LabviewFile file;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = trimmed(lines[i]);
    file.end = i + 1;
    if (line.starts_with(end_of_header)) break;
    // The line that names the separator uses it already.
    const std::size_t at = line.find_first_of("\t,");
    if (at == std::string_view::npos) continue;
    const std::string_view tag = trimmed(line.substr(0, at)), value = trimmed(line.substr(at + 1));
    if (tag == "Separator")
      file.separator = value.starts_with("Comma") || value.starts_with(',') ? ',' : '\t';
    if (tag != "X_Columns") continue;
    if (value.starts_with("No")) file.times = LabviewFile::Times::none;
    if (value.starts_with("Multi")) file.times = LabviewFile::Times::multi;
  }
  return file;
}

/// The header that begins at or behind line index `from`; its names are at lines.size() if there is none.
LabviewSegment labview_segment(const std::vector<std::string_view>& lines, std::size_t from, char separator) {
  LabviewSegment segment;
  std::vector<std::string_view> cells;
  bool special = false;
  for (std::size_t i = from; i < lines.size(); ++i) {
    if (is_blank(lines[i])) continue;
    split_cells(lines[i], Layout{separator, '.', 1}, cells);
    if (cells.front() == end_of_header) {
      segment.names = i + 1;
      return segment;
    }
    if (cells.front() == "***Start_Special***") special = true;
    if (!special) {
      while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
      segment.tags.push_back({cells.front(), {cells.begin() + 1, cells.end()}});
    }
    if (cells.front() == "***End_Special***") special = false;
  }
  segment.names = lines.size();
  return segment;
}

using Times = LabviewFile::Times;

/// A tag's number; a header may write a comma where the rows have points.
double number_of(const std::vector<std::string_view>& values, std::size_t channel) {
  if (values.empty()) return std::nan("");
  const std::string_view text = values[std::min(channel, values.size() - 1)];
  const Cell point = read_cell(text, '.');
  return point.kind == CellKind::number ? point.value : read_cell(text, ',').value;
}

/// Unit words as LabVIEW's assistants write them.
std::string labview_unit(std::string_view label) {
  struct Word {
    std::string_view word, unit;
  };
  for (const Word& known : {Word{"Volts", "V"}, Word{"Amps", "A"}, Word{"Newtons", "N"}, Word{"Meters", "m"},
                            Word{"Radians", "rad"}, Word{"Degrees", "deg"}, Word{"Seconds", "s"}})
    if (label == known.word) return std::string(known.unit);
  return std::string(label);
}

/// The columns from the line of names: each X_Value is a time, the Comment is left out, the units are those
/// of the channels' tag.
std::vector<Column> labview_columns(std::string_view names, const LabviewSegment& segment,
                                    const LabviewFile& file) {
  std::vector<std::string_view> cells;
  split_cells(names, Layout{file.separator, '.', 1}, cells);
  while (!cells.empty() && (cells.back().empty() || cells.back() == "Comment")) cells.pop_back();
  const auto& y_units = segment["Y_Unit_Label"];
  const auto& x_units = segment["X_Unit_Label"];
  const auto& x_kinds = segment["X_Dimension"];
  const auto at = [](const std::vector<std::string_view>& values, std::size_t channel) {
    return channel < values.size() ? values[channel] : std::string_view{};
  };
  std::vector<Column> columns;
  std::size_t channel = 0;
  for (std::size_t j = 0; j < cells.size(); ++j) {
    const bool x = file.times == Times::multi ? cells[j] == "X_Value" : j == 0;
    Column column;
    if (x) {
      const std::string_view kind = at(x_kinds, channel);
      column.name = cells[j].empty() ? "X_Value" : cells[j];
      column.unit = kind.empty() || kind == "Time" ? "s" : labview_unit(at(x_units, channel));
      column.quantity = quantity_of(column.name, column.unit);
    } else {
      const Heading heading = parse_heading(cells[j]);
      column.name = heading.name.empty() ? concat({"channel ", std::to_string(channel + 1)}) : heading.name;
      column.unit = heading.unit.empty() ? labview_unit(at(y_units, channel)) : heading.unit;
      column.quantity = quantity_of(column.name, column.unit);
      ++channel;
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

/// The header's Decimal_Separator may be missing or wrong: the rows show it.
char labview_decimal(const std::vector<std::string_view>& rows, char separator, const ReadOptions& options) {
  if (separator == ',') return '.';
  ReadOptions known = options;
  known.delimiter = "tab";
  const auto layout = find_layout(rows, known);
  return layout ? layout->decimal : '.';
}

/// Times of rows that carry none.
Result<void> compute_times(Set& set, const LabviewSegment& segment) {
  const double x0 = number_of(segment["X0"], 0), delta = number_of(segment["Delta_X"], 0);
  if (!is_step(delta)) return Error{"labview_without_times"};
  Column& time = set.columns.front();
  for (std::size_t i = 0; i < time.values.size(); ++i)
    time.values[i] = (std::isfinite(x0) ? x0 : 0) + static_cast<double>(i) * delta;
  return {};
}

/// If header and rows contradict each other, the rows count; adds a notice.
void say_contradictions(const Set& set, const LabviewSegment& segment, Times times,
                        std::vector<Notice>& notices) {
  const auto say = [&](Notice notice) {
    constexpr std::size_t enough = 10;
    if (notices.size() < enough) add_once(notices, std::move(notice));
  };
  const double promised = number_of(segment["Samples"], 0);
  if (std::isfinite(promised) && promised != static_cast<double>(set.lines.size()))
    say(Notice{"labview_samples", {{"promised", shortest(promised)}, {"rows", set.lines.size()}}});
  if (times == Times::none) return;
  std::vector<double> steps;
  const auto& t = set.columns.front().values;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (std::isfinite(t[i] - t[i - 1])) steps.push_back(t[i] - t[i - 1]);
  const double step = median(std::move(steps)), delta = number_of(segment["Delta_X"], 0);
  if (std::isfinite(step) && std::isfinite(delta) && std::fabs(step - delta) > 0.01 * std::fabs(step))
    say(Notice{"labview_step",
               {{"promised", shortest(delta)}, {"step", shortest(read_cell(rounded(step, 6), '.').value)}}});
}

/// Whether a segment has the columns of the last set and its times go on behind it: then it is appended.
bool goes_on(const Set& last, const Set& next) {
  if (last.columns.size() != next.columns.size()) return false;
  for (std::size_t j = 0; j < last.columns.size(); ++j)
    if (last.columns[j].name != next.columns[j].name || last.columns[j].unit != next.columns[j].unit)
      return false;
  return next.columns.front().values.front() > last.columns.front().values.back();
}

void append(Set& last, Set&& next) {
  for (std::size_t j = 0; j < last.columns.size(); ++j) {
    auto& values = last.columns[j].values;
    values.insert(values.end(), next.columns[j].values.begin(), next.columns[j].values.end());
  }
  last.lines.insert(last.lines.end(), next.lines.begin(), next.lines.end());
}

bool is_labview(const Source& source) { return source.text.starts_with("LabVIEW Measurement"); }

/// Segments that continue in time are joined; others are runs. The times are the rows' X_Value, whatever
/// Delta_X says; in rows without one they are X0 + i Delta_X.
Result<Sets> read_labview(const Source& source) {
  const auto& lines = source.lines;
  const LabviewFile file = labview_file(lines);
  Sets found{.dialect = "LabVIEW", .separator = file.separator, .decimal = '.', .sets = {}, .notices = {}};
  for (std::size_t from = file.end; from < lines.size();) {
    const LabviewSegment segment = labview_segment(lines, from, file.separator);
    if (segment.names >= lines.size() || (segment.names + 1 == lines.size() && is_blank(lines.back()))) break;
    // The rows end at a blank line, at the next segment's tags, or with the file.
    std::size_t to = segment.names + 1;
    while (to < lines.size() && !trimmed(lines[to]).starts_with("Channels")) ++to;
    from = to;
    Set set;
    set.names_line = static_cast<long>(segment.names) + 1;
    set.columns = labview_columns(lines[segment.names], segment, file);
    if (set.columns.size() < 2) return in_line(set.names_line, Notice{"labview_without_channel"});
    const std::vector<std::string_view> part(lines.begin() + static_cast<std::ptrdiff_t>(segment.names) + 1,
                                             lines.begin() + static_cast<std::ptrdiff_t>(to));
    found.decimal = labview_decimal(part, file.separator, source.options);
    std::vector<std::string> names;
    for (const Column& column : set.columns) names.push_back(column_title(column));
    auto rows = read_rows(part, Layout{file.separator, found.decimal, set.columns.size()}, names,
                          {0, part.size(), source.options.skip_bad_rows, true, segment.names + 1});
    if (!rows) return rows.error();
    if (rows->lines.empty()) continue;
    for (std::size_t j = 0; j < set.columns.size(); ++j) set.columns[j].values = std::move(rows->columns[j]);
    set.lines = std::move(rows->lines);
    if (!rows->last_line.empty()) found.notices.push_back(rows->last_line);
    if (file.times == Times::none)
      if (const auto computed = compute_times(set, segment); !computed) return computed.error();
    say_contradictions(set, segment, file.times, found.notices);
    if (!found.sets.empty() && goes_on(found.sets.back(), set))
      append(found.sets.back(), std::move(set));
    else
      found.sets.push_back(std::move(set));
  }
  if (found.sets.empty()) return Error{"labview_without_rows"};
  return found;
}

}  // namespace

const OwnStructure labview{is_labview, read_labview};

}  // namespace cromer::core::dialects
