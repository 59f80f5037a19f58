#include "cromer/record/dialects/rows.h"

#include <algorithm>
#include <limits>

#include "cromer/base/concat.h"
#include "cromer/record/dialects/bad_cell.h"
#include "cromer/record/dialects/lines.h"

namespace cromer::dialects {
namespace {

constexpr std::string_view cure = "; --skip-bad-rows drops such rows";

std::string complaint(std::string_view cell, const std::string& name, char decimal) {
  std::string text = concat({"column \"", name, "\": ", quoted(cell), " is not a number"});
  if (const std::string seen = bad_cell(cell, decimal); !seen.empty()) text += concat({"; ", seen});
  return text.append(cure);
}

}  // namespace

Result<Rows> read_rows(const std::vector<std::string_view>& lines, const Layout& layout,
                       const std::vector<std::string>& names, const RowRules& rules) {
  // Rows much shorter than the table is wide would cost memory that the file's size does not announce.
  std::size_t count_of_lines = 0, bytes = 0;
  for (std::size_t i = rules.from; i < rules.to; ++i) {
    if (lines[i].empty()) continue;
    ++count_of_lines;
    bytes += lines[i].size() + 1;
  }
  if (layout.columns > 16 && count_of_lines > 16 * bytes / layout.columns + 64)
    return Error{concat(
        {": most rows are far shorter than the widest of ", std::to_string(layout.columns), " columns"})};

  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Rows rows;
  rows.columns.resize(layout.columns);
  // A row has a byte for each column, and more.
  const std::size_t expected = std::min(count_of_lines, bytes / (layout.columns + 1) + 64);
  for (auto& column : rows.columns) column.reserve(expected);
  rows.lines.reserve(expected);
  std::vector<double> row(layout.columns);
  for (std::size_t i = rules.from; i < rules.to; ++i) {
    const std::string_view line = lines[i];
    if (is_blank(line) || is_comment(line)) continue;
    CellReader reader(line, layout);
    std::size_t count = 0;
    std::string bad;
    // Only the first bad row is spoken of: a name may be as long as the file.
    const auto complain = [&](auto&& of) { bad = rows.bad_rows == 0 ? of() : std::string(cure); };
    if (!commas_pair_up(line, layout))
      complain([&] {
        return concat({quoted(line), ": it is open which commas are decimal marks; write the file with ",
                       "another separator, or with points", cure});
      });
    for (std::string_view text; bad.empty();) {
      if (count < layout.columns && reader.next_number(row[count])) {
        ++count;
        continue;
      }
      if (!reader.next(text)) break;
      if (count >= layout.columns) {
        if (rules.ignore_beyond) break;
        if (text.empty()) continue;
        complain([&] {
          return concat(
              {"there are more values than the ", std::to_string(layout.columns), " columns", cure});
        });
        break;
      }
      const Cell cell = read_cell(text, layout.decimal);
      if (cell.kind == CellKind::word)
        complain([&] { return complaint(text, names[count], layout.decimal); });
      row[count++] = cell.value;
    }
    const long number = static_cast<long>(rules.lines_before + i) + 1;
    if (!bad.empty()) {
      if (!rules.skip_bad_rows) return Error{concat({":", std::to_string(number), ": ", bad})};
      if (rows.bad_rows++ == 0) {
        rows.first_bad_line = number;
        rows.first_complaint = bad.substr(0, bad.size() - cure.size());
      }
      continue;
    }
    for (; count < layout.columns; ++count) row[count] = nan;
    for (std::size_t j = 0; j < layout.columns; ++j) rows.columns[j].push_back(row[j]);
    rows.lines.push_back(number);
  }
  return rows;
}

std::string no_rows(const std::vector<std::string_view>& lines, std::string_view reason,
                    std::size_t lines_before) {
  std::vector<std::string_view> cells;
  const bool about_cells = reason.starts_with("no rows");  // and not about a wrong option
  for (std::size_t i = 0; about_cells && i < lines.size(); ++i) {
    const std::string_view line = trimmed(lines[i]);
    if (line.empty() || std::string_view("0123456789+-.,\"").find(line.front()) == std::string_view::npos)
      continue;
    // The separator is not known: the one that leaves the shortest bad cell.
    std::string_view bad;
    std::string seen;
    for (const char separator : {'\t', ';', ',', ' '}) {
      split_cells(line, Layout{separator, '.', 1}, cells);
      for (const std::string_view cell : cells) {
        const bool number =
            read_cell(cell, '.').kind != CellKind::word || read_cell(cell, ',').kind != CellKind::word;
        if (number || (!bad.empty() && cell.size() >= bad.size())) continue;
        std::string what = bad_cell(cell, '.');
        if (what.empty()) what = bad_cell(cell, ',');
        if (what.empty()) continue;
        bad = cell;
        seen = std::move(what);
      }
    }
    if (!bad.empty())
      return concat({":", std::to_string(lines_before + i + 1),
                     ": no rows of numbers are found: ", quoted(bad), " is not a number; ", seen});
  }
  return concat({": ", reason});
}

}  // namespace cromer::dialects
