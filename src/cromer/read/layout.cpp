#include "cromer/read/layout.h"

#include <algorithm>
#include <map>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/header.h"

namespace cromer::core::dialects {
namespace {

constexpr std::size_t sampled_at_start = 50;
constexpr std::size_t sampled_in_all = 250;

/// Lines that may be rows: all of a short file; of a long one its start and every n-th line of the rest.
std::vector<std::string_view> sample(const std::vector<std::string_view>& lines) {
  std::vector<std::string_view> chosen;
  const std::size_t stride = std::max<std::size_t>(1, lines.size() / sampled_in_all);
  for (std::size_t i = 0; i < lines.size(); i += i < sampled_at_start ? 1 : stride)
    if (!is_blank(lines[i]) && !is_comment(lines[i])) chosen.push_back(lines[i]);
  return chosen;
}

/// All cells numbers or missing, at least one a number.
bool is_row(const std::vector<std::string_view>& cells, char decimal) {
  bool number = false;
  for (const std::string_view cell : cells) {
    const CellKind kind = read_cell(cell, decimal).kind;
    if (kind == CellKind::word) return false;
    number = number || kind == CellKind::number;
  }
  return number;
}

/// "1,5" in quotes: how spreadsheets keep a decimal comma apart from the separator.
bool has_quoted_decimal(std::string_view line) {
  for (std::size_t at = line.find('"'); at != std::string_view::npos; at = line.find('"', at + 1)) {
    const auto number = leading_number(line.substr(at + 1), ',');
    if (number && line.substr(at + 1, number->length).find(',') != std::string_view::npos &&
        line.substr(at + 1 + number->length).starts_with('"'))
      return true;
  }
  return false;
}

struct Candidate {
  Layout layout;
  std::size_t rows = 0;  ///< of the sample, with the most frequent number of cells
};

Candidate judge(const std::vector<std::string_view>& chosen, Layout layout) {
  std::map<std::size_t, std::size_t> rows_of_width;
  std::vector<std::string_view> cells;
  layout.paired = layout.separator == ',' && layout.decimal == ',' &&
                  std::none_of(chosen.begin(), chosen.end(), has_quoted_decimal);
  for (const std::string_view line : chosen) {
    if (!commas_pair_up(line, layout)) continue;
    split_cells(line, layout, cells);
    if (is_row(cells, layout.decimal)) ++rows_of_width[cells.size()];
  }
  Candidate candidate{layout, 0};
  for (const auto& [width, rows] : rows_of_width) {
    if (rows < candidate.rows) continue;
    candidate.rows = rows;
    candidate.layout.columns = width;
  }
  return candidate;
}

/// If the sample has whole numbers only, the rest of the file may show the decimal mark.
char decimal_of(const std::vector<std::string_view>& lines) {
  bool comma = false;
  for (const std::string_view line : lines) {
    if (is_comment(line)) continue;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (!is_digit(line[i - 1]) || !is_digit(line[i + 1])) continue;
      if (line[i] == '.') return '.';
      comma = comma || line[i] == ',';
    }
  }
  return comma ? ',' : '.';
}

Result<std::string> delimiters(const ReadOptions& options) {
  const std::string& given = options.delimiter;
  if (given.empty()) return std::string("\t;, ");
  if (given == "tab" || given == "\\t") return std::string("\t");
  if (given == "blank" || given == "blanks" || given == "space") return std::string(" ");
  if (given == "comma") return std::string(",");
  if (given == "semicolon") return std::string(";");
  if (given == "," || given == ";" || given == "\t" || given == " ") return given;
  return Error{"unknown_delimiter", {{"given", shown(given)}}};
}

Result<std::string> decimals(const ReadOptions& options) {
  if (options.decimal.empty()) return std::string(".,");
  if (options.decimal == "." || options.decimal == "point") return std::string(".");
  if (options.decimal == "," || options.decimal == "comma") return std::string(",");
  return Error{"unknown_decimal", {{"given", shown(options.decimal)}}};
}

}  // namespace

Result<Layout> find_layout(const std::vector<std::string_view>& lines, const ReadOptions& options) {
  const auto separators = delimiters(options);
  if (!separators) return separators.error();
  const auto marks = decimals(options);
  if (!marks) return marks.error();

  const auto chosen = sample(lines);
  Candidate best;
  bool decimal_open = false;
  for (const char separator : *separators)
    for (const char decimal : *marks) {
      const Candidate candidate = judge(chosen, Layout{separator, decimal, 1});
      const bool more_rows = candidate.rows > best.rows;
      const bool more_columns = candidate.rows == best.rows && candidate.layout.columns > best.layout.columns;
      const bool same_but_decimal = candidate.rows == best.rows &&
                                    candidate.layout.separator == best.layout.separator &&
                                    candidate.layout.columns == best.layout.columns;
      if (more_rows || more_columns) {
        best = candidate;
        decimal_open = false;
      } else if (same_but_decimal && candidate.rows > 0) {
        decimal_open = separator != ',';
      }
    }
  if (best.rows == 0) return Error{"no_rows_of_numbers"};
  if (best.layout.columns > most_columns) return too_many_columns();
  if (decimal_open) best.layout.decimal = decimal_of(lines);
  if (best.layout.columns == 1 && options.delimiter.empty()) best.layout.separator = 0;
  if (best.layout.separator == 0) best.layout.paired = false;
  return best.layout;
}

std::size_t find_data(const std::vector<std::string_view>& lines, const Layout& layout) {
  std::vector<std::string_view> cells;
  std::size_t first_row = lines.size();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_blank(lines[i]) || is_comment(lines[i])) continue;
    split_cells(lines[i], layout, cells);
    const bool row = is_row(cells, layout.decimal);
    if (row && first_row == lines.size()) first_row = i;
    // A row with a bad cell is a row, not a header: it begins with a number.
    const bool begins_with_number = read_cell(cells.front(), layout.decimal).kind == CellKind::number;
    if (cells.size() == layout.columns && (row || (begins_with_number && cells.size() > 1))) return i;
  }
  return first_row;
}

Result<Layout> settle_commas(const std::vector<std::string_view>& lines, const Layout& layout,
                             const ReadOptions& options) {
  const bool may_be_decimal = layout.separator == ',' && layout.decimal == '.' && layout.columns % 2 == 0;
  if (!may_be_decimal || !options.delimiter.empty() || !options.decimal.empty()) return layout;
  const std::size_t data = find_data(lines, layout);
  std::vector<std::string_view> cells;
  const auto whole = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  for (std::size_t i = data; i < lines.size(); ++i) {
    if (is_blank(lines[i]) || is_comment(lines[i])) continue;
    if (lines[i].find('"') != std::string_view::npos) return layout;
    split_cells(lines[i], layout, cells);
    if (cells.size() != layout.columns) continue;
    for (std::size_t j = 0; j < cells.size(); ++j) {
      const bool sign = j % 2 == 0 && (cells[j].starts_with('-') || cells[j].starts_with('+'));
      const std::size_t exponent =
          j % 2 == 1 ? std::min(cells[j].find_first_of("eE"), cells[j].size()) : cells[j].size();
      if (!whole(cells[j].substr(sign ? 1 : 0, exponent - (sign ? 1 : 0)))) return layout;
    }
  }
  // The line above may hold names: as many as there are cells, or half as many.
  for (std::size_t i = data; i-- > 0;) {
    if (is_blank(lines[i])) continue;
    std::string_view names = lines[i];
    if (is_comment(names)) names.remove_prefix(names.find_first_of("#%") + 1);
    for (const char separator : {',', ';', '\t'}) {
      split_cells(names, Layout{separator, '.', 1}, cells);
      if (cells.size() == layout.columns) return layout;
      const bool half = 2 * cells.size() == layout.columns && (separator != ',' || layout.columns == 2);
      const auto speaks = [](std::string_view cell) {
        const Heading heading = parse_heading(cell);
        return !heading.unit.empty() || !quantity_of(heading.name, "").empty();
      };
      if (half && std::all_of(cells.begin(), cells.end(), speaks))
        return Layout{layout.columns == 2 ? '\0' : ',', ',', layout.columns / 2, layout.columns > 2};
    }
    break;
  }
  return Error{"rows_read_in_two_ways",
               {{"row", shown(lines[data])}, {"whole", layout.columns}, {"decimal", layout.columns / 2}}};
}

std::string_view separator_name(char separator) {
  switch (separator) {
    case ',':
      return "comma";
    case ';':
      return "semicolon";
    case '\t':
      return "tab";
    case ' ':
      return "blanks";
    default:
      return "none";
  }
}

}  // namespace cromer::core::dialects
