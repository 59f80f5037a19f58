#include "cromer/read/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/read/cells.h"
#include "cromer/read/in_file.h"

namespace cromer::core::dialects {
namespace {

Notice complaint(std::string_view cell, const std::string& name, char decimal) {
  if (const Notice seen = bad_cell(cell, decimal); !seen.empty())
    return Notice{"bad_cell_but", {{"column", name}, {"cell", shown(cell)}, {"what", seen}}};
  return Notice{"bad_cell", {{"column", name}, {"cell", shown(cell)}}};
}

/// How a number is written.
struct Written {
  std::size_t length = 0, decimals = 0, exponent = 0;  // characters
};

Written written(std::string_view cell, char decimal) {
  const std::size_t exponent = std::min(cell.find_first_of("eE"), cell.size()),
                    mark = std::min(cell.find(decimal), exponent);
  return {cell.size(), exponent - std::min(mark + 1, exponent),
          cell.size() - std::min(exponent + 1, cell.size())};
}

Notice cut_line(long line, std::string_view text) {
  return Notice{"last_line_cut", {{"line", line}, {"text", shown(text)}}};
}

/// Whether a last line without a line end may be a row cut off: it has digits and ends as numbers do.
bool may_be_cut_row(std::string_view line) {
  constexpr std::string_view digits = "0123456789";
  const auto ends_in = [&line](std::string_view one_of) {
    return one_of.find(line.back()) != std::string_view::npos;
  };
  if (line.find_first_of(digits) == std::string_view::npos) return false;
  if (!ends_in("eE")) return ends_in(digits) || ends_in("+-.,");
  line.remove_suffix(1);  // an exponent's letter stands behind a digit
  return ends_in(digits);
}

/// Compares the last number of a last line without a line end with the numbers above it.
void judge_last_line(Rows& rows, const std::vector<std::string_view>& lines, const Layout& layout,
                     std::size_t lines_before) {
  constexpr std::size_t enough = 1000, fewest = 8;  // rows
  std::vector<std::string_view> cells;
  split_cells(lines.back(), layout, cells);
  if (cells.empty() || read_cell(cells.back(), layout.decimal).kind != CellKind::number) return;
  const std::size_t place = cells.size() - 1;
  const std::string_view number = cells.back();
  const Written last = written(number, layout.decimal);
  Written least{last.length + 1, last.decimals + 1, last.exponent + 1}, first{};
  std::size_t seen = 0;
  bool alike = true;
  for (std::size_t k = rows.lines.size() - 1; k-- > 0 && seen < enough;) {
    split_cells(lines[static_cast<std::size_t>(rows.lines[k]) - 1 - lines_before], layout, cells);
    if (place >= cells.size() || read_cell(cells[place], layout.decimal).kind != CellKind::number) continue;
    const Written one = written(cells[place], layout.decimal);
    if (seen++ == 0) first = one;
    alike = alike && one.decimals == first.decimals && one.exponent == first.exponent;
    least = {std::min(least.length, one.length), std::min(least.decimals, one.decimals),
             std::min(least.exponent, one.exponent)};
  }
  if (seen < fewest) return;
  const long line = rows.lines.back();
  if (alike && (last.decimals < first.decimals || last.exponent < first.exponent)) {
    for (auto& column : rows.columns) column.pop_back();
    rows.lines.pop_back();
    rows.last_line = cut_line(line, number);
  } else if (alike && first.decimals + first.exponent > 0) {
    return;  // all its decimals are there, and a cut takes the last ones first
  } else if (last.length < least.length || last.decimals < least.decimals || last.exponent < least.exponent) {
    rows.last_line = Notice{"last_line_without_end", {{"line", line}, {"text", shown(number)}}};
  }
}

}  // namespace

Result<Rows> read_rows(const std::vector<std::string_view>& lines, const Layout& layout,
                       const std::vector<std::string>& names, const RowRules& rules) {
  // Rows far shorter than the table is wide would cost far more memory than the file has bytes.
  std::size_t count_of_lines = 0, bytes = 0;
  for (std::size_t i = rules.from; i < rules.to; ++i) {
    if (lines[i].empty()) continue;
    ++count_of_lines;
    bytes += lines[i].size() + 1;
  }
  if (layout.columns > 16 && count_of_lines > 16 * bytes / layout.columns + 64)
    return Error{"rows_far_shorter", {{"columns", layout.columns}}};

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
    bool bad = false;
    // Only the first bad row is described: a name may be as long as the file.
    const auto complain = [&](auto&& of) {
      bad = true;
      if (rows.bad_rows == 0) rows.first_complaint = of();
    };
    if (!commas_pair_up(line, layout))
      complain([&] { return Notice{"commas_open", {{"row", shown(line)}}}; });
    for (std::string_view text; !bad;) {
      if (count < layout.columns && reader.next_number(row[count])) {
        ++count;
        continue;
      }
      if (!reader.next(text)) break;
      if (count >= layout.columns) {
        // A number behind the last column is no remark: some number before it contains a separator.
        if (rules.ignore_beyond && read_cell(text, layout.decimal).kind != CellKind::number) break;
        if (text.empty()) continue;
        complain([&] { return Notice{"more_values_than_columns", {{"columns", layout.columns}}}; });
        break;
      }
      const Cell cell = read_cell(text, layout.decimal);
      if (cell.kind == CellKind::word && !layout.is_text(count))
        complain([&] { return complaint(text, names[count], layout.decimal); });
      row[count++] = cell.value;
    }
    const long number = static_cast<long>(rules.lines_before + i) + 1;
    if (bad && i + 1 == lines.size() && !rows.lines.empty() && may_be_cut_row(line)) {
      if (rows.bad_rows == 0) rows.first_complaint = {};
      rows.last_line = cut_line(number, line);
      break;
    }
    if (bad) {
      if (!rules.skip_bad_rows) return in_line(number, Notice{"bad_row", {{"what", rows.first_complaint}}});
      if (rows.bad_rows++ == 0) rows.first_bad_line = number;
      continue;
    }
    for (; count < layout.columns; ++count) row[count] = nan;
    for (std::size_t j = 0; j < layout.columns; ++j) rows.columns[j].push_back(row[j]);
    rows.lines.push_back(number);
  }
  const bool ends_within = rules.to == lines.size() && !lines.empty() && !lines.back().empty();
  if (ends_within && !rows.lines.empty() &&
      rows.lines.back() == static_cast<long>(rules.lines_before + lines.size()))
    judge_last_line(rows, lines, layout, rules.lines_before);
  return rows;
}

Error no_rows(const std::vector<std::string_view>& lines, const Error& reason, std::size_t lines_before) {
  std::vector<std::string_view> cells;
  const bool about_cells = reason.notice.code == "no_rows_of_numbers";  // and not about a wrong option
  for (std::size_t i = 0; about_cells && i < lines.size(); ++i) {
    const std::string_view line = trimmed(lines[i]);
    if (line.empty() || std::string_view("0123456789+-.,\"").find(line.front()) == std::string_view::npos)
      continue;
    // The separator is not known: takes the one that gives the shortest bad cell.
    std::string_view bad;
    Notice seen;
    for (const char separator : {'\t', ';', ',', ' '}) {
      split_cells(line, Layout{separator, '.', 1}, cells);
      for (const std::string_view cell : cells) {
        const bool number =
            read_cell(cell, '.').kind != CellKind::word || read_cell(cell, ',').kind != CellKind::word;
        if (number || (!bad.empty() && cell.size() >= bad.size())) continue;
        Notice what = bad_cell(cell, '.');
        if (what.empty()) what = bad_cell(cell, ',');
        if (what.empty()) continue;
        bad = cell;
        seen = std::move(what);
      }
    }
    if (!bad.empty())
      return in_line(static_cast<long>(lines_before + i) + 1,
                     Notice{"no_rows_of_numbers_but", {{"cell", shown(bad)}, {"what", seen}}});
  }
  return reason;
}

Result<NumberStream> read_numbers(const std::vector<std::string_view>& lines, std::size_t from,
                                  std::size_t most, bool until_words, long lines_before) {
  NumberStream stream;
  stream.end = std::min(from, lines.size());
  for (std::size_t i = stream.end; i < lines.size() && stream.values.size() < most; ++i) {
    std::string_view rest = lines[i];
    const std::size_t before = stream.values.size();
    const long number_of_line = lines_before + static_cast<long>(i) + 1;
    while (stream.values.size() < most) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r,"), rest.size()));
      if (rest.empty()) break;
      const auto number = leading_number(rest);
      const bool good = number && std::isfinite(number->value);
      const std::string_view behind = good ? rest.substr(number->length) : rest;
      const bool ends =
          good && (behind.empty() || std::string_view(" \t\r,+-").find(behind[0]) != std::string_view::npos);
      if (!ends) {
        if (until_words && stream.values.size() == before) return stream;
        const std::string_view cell = rest.substr(0, rest.find_first_of(" \t\r,"));
        const Notice seen = bad_cell(cell, '.');
        if (seen.empty()) return in_line(number_of_line, Notice{"not_a_number", {{"text", shown(cell)}}});
        return in_line(number_of_line, Notice{"not_a_number_but", {{"text", shown(cell)}, {"what", seen}}});
      }
      stream.values.push_back(number->value);
      stream.lines.push_back(number_of_line);
      rest = behind;
    }
    stream.end = i + 1;
  }
  return stream;
}

}  // namespace cromer::core::dialects
