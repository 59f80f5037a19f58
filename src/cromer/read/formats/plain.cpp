#include "cromer/read/formats/plain.h"

#include <cstddef>
#include <string>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"
#include "cromer/read/cells.h"
#include "cromer/read/columns.h"
#include "cromer/read/dialect_name.h"
#include "cromer/read/header.h"
#include "cromer/read/layout.h"
#include "cromer/read/rows.h"
#include "cromer/read/sets.h"

namespace cromer::core::dialects {
namespace {

/// "4684 0.0100" above a single column of 4684 rows: their number and their step.
void take_counted_step(Recording& recording, const Header& header, const ReadOptions& options) {
  auto& columns = recording.table.columns;
  if (columns.size() != 1 || options.rate > 0) return;
  std::vector<std::string_view> cells;
  for (const std::string& title : header.titles) {
    split_cells(title, Layout{' ', '.', 1}, cells);
    if (cells.size() != 2) continue;
    const Cell count = read_cell(cells[0], '.'), step = read_cell(cells[1], '.');
    const bool counts =
        count.kind == CellKind::number && count.value == static_cast<double>(columns.front().values.size());
    if (!counts || step.kind != CellKind::number || !is_step(step.value)) continue;
    Column time{"Time", "time", "s", 1, {}};
    for (std::size_t i = 0; i < columns.front().values.size(); ++i)
      time.values.push_back(static_cast<double>(i) * step.value);
    columns.insert(columns.begin(), std::move(time));
    recording.notices.push_back(
        Notice{"line_counts_rows", {{"text", shown(trimmed(title))}, {"step", shortest(step.value)}}});
    return;
  }
}

void say_bad_rows(const Rows& rows, std::vector<Notice>& notices) {
  if (rows.bad_rows == 0) return;
  const std::size_t kept = rows.lines.size();
  if (rows.bad_rows > kept)
    notices.push_back(Notice{"most_rows_lost",
                             {{"rows", rows.bad_rows},
                              {"kept", kept},
                              {"line", rows.first_bad_line},
                              {"what", rows.first_complaint}}});
  else
    notices.push_back(Notice{"bad_rows_left_out", {{"rows", rows.bad_rows}, {"line", rows.first_bad_line}}});
}

/// Drops the columns that hold text, and says so.
void leave_text_out(const Layout& layout, Recording& recording, Header& header) {
  auto& columns = recording.table.columns;
  std::vector<std::size_t> left_out;
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (layout.is_text(j)) left_out.push_back(j);
  if (left_out.empty()) return;
  recording.notices.push_back(
      Notice{"text_columns_left_out", {{"columns", quoted_titles(columns, left_out)}}});
  for (auto j = left_out.rbegin(); j != left_out.rend(); ++j) {
    columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(*j));
    if (*j < header.headings.size())
      header.headings.erase(header.headings.begin() + static_cast<std::ptrdiff_t>(*j));
  }
}

}  // namespace

Result<Recording> read_plain(const std::vector<std::string_view>& lines, const ReadOptions& options,
                             std::size_t lines_before) {
  auto layout = find_layout(lines, options);
  if (!layout) return no_rows(lines, layout.error(), lines_before);
  layout = settle_commas(lines, *layout, options);
  if (!layout) return layout.error();

  const std::size_t data = find_data(lines, *layout);
  Header header = find_header(lines, data, *layout);
  name_tracks(header);
  name_runs_above(header);
  Recording recording;
  auto& columns = recording.table.columns;
  columns = name_columns(header, layout->columns);
  std::vector<std::string> names;
  std::vector<bool> named_time;
  for (const Column& column : columns) {
    names.push_back(column_title(column));
    named_time.push_back(column.quantity == "time");
  }
  const auto find_text = [&] { layout->text = text_columns(lines, data, *layout, options, named_time); };
  const bool has_text = !layout->text.empty();
  if (has_text) find_text();
  if (has_text && layout->text.empty()) return no_rows(lines, Error{"no_rows_of_numbers"}, lines_before);
  const auto read = [&] {
    return read_rows(lines, *layout, names, {data, lines.size(), options.skip_bad_rows, false, lines_before});
  };
  auto rows = read();
  if (!has_text &&
      (!rows || rows->bad_rows > 0)) {  // words that stand in a column of their own are no bad cells
    find_text();
    if (!layout->text.empty()) rows = read();
  }
  if (!rows) return rows.error();
  if (rows->lines.empty() && rows->bad_rows == 0) return Error{"no_rows_left"};
  if (rows->lines.empty())
    return Error{"no_rows_left_but", {{"what", rows->first_complaint}, {"line", rows->first_bad_line}}};

  recording.dialect.name = dialect_name(header);
  recording.dialect.separator = separator_name(layout->separator);
  recording.dialect.decimal = layout->decimal == ',' ? "comma" : "point";
  for (std::size_t j = 0; j < layout->columns; ++j) columns[j].values = std::move(rows->columns[j]);
  recording.named = !header.headings.empty();
  say_bad_rows(*rows, recording.notices);
  if (!rows->last_line.empty()) recording.notices.push_back(rows->last_line);
  leave_text_out(*layout, recording, header);
  recording.lines = std::move(rows->lines);
  drop_unnamed_empty(columns);
  if (split_stacked_runs(recording))
    recording.dialect.name = "Cromer";
  else
    number_runs(recording, header);
  take_counted_step(recording, header, options);
  return recording;
}

}  // namespace cromer::core::dialects
