// Vernier Format 2 and 3: Logger Pro's text export. A magic line, a line of source, date and time; then sets
// of a name, long names, short names, units, a blank line and rows, all between tabs.
#include "cromer/base/ascii.h"
#include "cromer/read/cells.h"
#include "cromer/read/columns.h"
#include "cromer/read/formats/own_structures.h"
#include "cromer/read/header.h"
#include "cromer/read/in_file.h"
#include "cromer/read/layout.h"
#include "cromer/read/rows.h"

namespace cromer::core::dialects {
namespace {

/// Whether a line is a row or empty: no cell is a word, or it begins with a number (a row with a bad cell).
bool may_be_row(std::string_view line, char decimal) {
  std::vector<std::string_view> cells;
  split_cells(line, Layout{'\t', decimal, 1}, cells);
  if (cells.size() > 1 && read_cell(cells.front(), decimal).kind == CellKind::number) return true;
  for (const std::string_view cell : cells)
    if (read_cell(cell, decimal).kind == CellKind::word) return false;
  return true;
}

/// Columns named by the three lines of a set's header; a unit left empty may stand in the name.
std::vector<Column> vernier_columns(std::string_view long_names, std::string_view units) {
  const Layout tabs{'\t', '.', 1};
  std::vector<std::string_view> names, unit_cells;
  split_cells(long_names, tabs, names);
  split_cells(units, tabs, unit_cells);
  Header header;
  for (std::size_t j = 0; j < names.size(); ++j) {
    header.headings.push_back(parse_heading(names[j]));
    if (j < unit_cells.size() && !unit_cells[j].empty()) header.headings.back().unit = unit_cells[j];
  }
  return name_columns(header, names.size());
}

bool is_vernier_format(const Source& source) { return source.text.starts_with("Vernier Format"); }

/// Each set is a run.
Result<Sets> read_vernier_format(const Source& source) {
  const auto& lines = source.lines;
  Sets found{.dialect = std::string(trimmed(lines[0])),
             .separator = '\t',
             .decimal = '.',
             .sets = {},
             .notices = {}};
  ReadOptions tabs = source.options;
  tabs.delimiter = "tab";
  if (const auto layout = find_layout(lines, tabs); layout) found.decimal = layout->decimal;

  for (std::size_t i = 2; i < lines.size();) {
    if (is_blank(lines[i])) {
      ++i;
      continue;
    }
    if (i + 4 > lines.size()) break;
    Set set;
    set.label = trimmed(lines[i]);
    set.names_line = static_cast<long>(i) + 2;
    if (is_blank(lines[i + 1]))
      return in_line(set.names_line, Notice{"set_without_names", {{"set", shown(set.label)}}});
    set.columns = vernier_columns(lines[i + 1], lines[i + 3]);
    const std::size_t from = i + 4;
    std::size_t to = from;
    while (to < lines.size() && may_be_row(lines[to], found.decimal)) ++to;
    std::vector<std::string> names;
    for (const Column& column : set.columns) names.push_back(column_title(column));
    auto rows = read_rows(lines, Layout{'\t', found.decimal, set.columns.size()}, names,
                          {from, to, source.options.skip_bad_rows});
    if (!rows) return rows.error();
    i = to;
    if (rows->lines.empty()) {
      found.notices.push_back(Notice{"set_without_rows", {{"set", shown(set.label)}}});
      continue;
    }
    for (std::size_t j = 0; j < set.columns.size(); ++j) set.columns[j].values = std::move(rows->columns[j]);
    set.lines = std::move(rows->lines);
    if (!rows->last_line.empty()) found.notices.push_back(rows->last_line);
    found.sets.push_back(std::move(set));
  }
  return found;
}

}  // namespace

const OwnStructure vernier_format{is_vernier_format, read_vernier_format};

}  // namespace cromer::core::dialects
