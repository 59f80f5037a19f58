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
constexpr std::size_t fewest_with_text = 3;  // rows

/// Lines that may be rows: all of a short file; of a long one its start and every n-th line of the rest.
std::vector<std::string_view> sample(const std::vector<std::string_view>& lines) {
  std::vector<std::string_view> chosen;
  const std::size_t stride = std::max<std::size_t>(1, lines.size() / sampled_in_all);
  for (std::size_t i = 0; i < lines.size(); i += i < sampled_at_start ? 1 : stride)
    if (!is_blank(lines[i]) && !is_comment(lines[i])) chosen.push_back(lines[i]);
  return chosen;
}

/// All cells numbers or missing, at least one a number; what stands in columns of text does not matter.
bool is_row(const std::vector<std::string_view>& cells, const Layout& layout) {
  bool number = false;
  for (std::size_t j = 0; j < cells.size(); ++j) {
    if (layout.is_text(j)) continue;
    const CellKind kind = read_cell(cells[j], layout.decimal).kind;
    if (kind == CellKind::word) return false;
    number = number || kind == CellKind::number;
  }
  return number;
}

/// What the cells of one column are.
struct Seen {
  bool number = false, word = false, date = false;
  bool badly_written = false;  ///< a number that is not written as one

  void look_at(std::string_view cell, char decimal) {
    const CellKind kind = read_cell(cell, decimal).kind;
    if (kind == CellKind::number) number = true;
    if (kind != CellKind::word) return;
    const Notice what = bad_cell(cell, decimal);
    if (what.code == "is_date" || what.code == "is_clock_time")
      date = true;
    else if (!what.empty() || leading_number(cell, decimal))
      badly_written = true;
    else
      word = true;
  }
  bool is_text(bool with_dates) const {
    return !number && !badly_written && (word || date) && (with_dates || !date);
  }
};

std::size_t columns_of_numbers(const std::vector<Seen>& columns) {
  return static_cast<std::size_t>(
      std::count_if(columns.begin(), columns.end(), [](const Seen& column) { return column.number; }));
}

/// Two columns of numbers, or one if the rate of its samples is known; and no fewer than of text.
bool enough_numbers(const std::vector<Seen>& columns, const ReadOptions& options) {
  const std::size_t numbers = columns_of_numbers(columns);
  return numbers >= (options.rate > 0 ? 1u : 2u) && 2 * numbers >= columns.size();
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
  std::size_t rows = 0;     ///< of the sample, with the most frequent number of cells
  std::size_t numbers = 0;  ///< columns that are not text
};

Candidate judge(const std::vector<std::string_view>& chosen, Layout layout) {
  std::map<std::size_t, std::size_t> rows_of_width;
  std::vector<std::string_view> cells;
  layout.paired = layout.separator == ',' && layout.decimal == ',' &&
                  std::none_of(chosen.begin(), chosen.end(), has_quoted_decimal);
  for (const std::string_view line : chosen) {
    if (!commas_pair_up(line, layout)) continue;
    split_cells(line, layout, cells);
    if (is_row(cells, layout)) ++rows_of_width[cells.size()];
  }
  Candidate candidate{layout, 0};
  for (const auto& [width, rows] : rows_of_width) {
    if (rows < candidate.rows) continue;
    candidate.rows = rows;
    candidate.layout.columns = candidate.numbers = width;
  }
  return candidate;
}

/// The same for rows with columns of text. They must be most of the sample: prose has numbers, too.
Candidate judge_with_text(const std::vector<std::string_view>& chosen, Layout layout,
                          const ReadOptions& options) {
  Candidate best{layout, 0};
  if (layout.separator == ',' && layout.decimal == ',') return best;
  std::map<std::size_t, std::vector<std::vector<std::string_view>>> of_width;
  std::vector<std::string_view> cells;
  for (const std::string_view line : chosen) {
    split_cells(line, layout, cells);
    if (cells.size() > 1 && cells.size() <= most_columns) of_width[cells.size()].push_back(cells);
  }
  for (const auto& [width, lines] : of_width) {
    std::vector<Seen> columns(width);
    for (const auto& line : lines)
      for (std::size_t j = 0; j < width; ++j) columns[j].look_at(line[j], layout.decimal);
    if (!enough_numbers(columns, options)) continue;
    Candidate candidate{layout, 0, columns_of_numbers(columns)};
    candidate.layout.columns = width;
    // A date is text only beside a time: text_columns() sees to that when the names are known.
    for (const Seen& column : columns) candidate.layout.text.push_back(column.is_text(true));
    for (const auto& line : lines) candidate.rows += is_row(line, candidate.layout);
    if (candidate.rows >= fewest_with_text && 2 * candidate.rows > chosen.size()) best = candidate;
  }
  return best;
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
  const auto consider = [&](char separator, char decimal, bool with_text) {
    const Layout layout{separator, decimal, 1};
    const Candidate candidate = with_text ? judge_with_text(chosen, layout, options) : judge(chosen, layout);
    const bool more_rows = candidate.rows > best.rows;
    const bool more_columns = candidate.rows == best.rows && candidate.numbers > best.numbers;
    const bool same_but_decimal = candidate.rows == best.rows &&
                                  candidate.layout.separator == best.layout.separator &&
                                  candidate.layout.columns == best.layout.columns;
    if (more_rows || more_columns) {
      best = candidate;
      decimal_open = false;
    } else if (same_but_decimal && candidate.rows > 0) {
      decimal_open = separator != ',';
    }
  };
  for (const bool with_text : {false, true}) {
    if (best.rows >= fewest_with_text) break;  // fewer may be a title's numbers
    for (const char separator : *separators)
      for (const char decimal : *marks) consider(separator, decimal, with_text);
  }
  if (best.rows == 0) {
    for (std::string ReadOptions::*given : {&ReadOptions::delimiter, &ReadOptions::decimal}) {
      if ((options.*given).empty()) continue;
      ReadOptions without = options;
      (without.*given).clear();
      const std::string_view option = given == &ReadOptions::delimiter ? "delimiter" : "decimal";
      if (find_layout(lines, without)) return Error{"no_rows_with_option", {{"option", option}}};
    }
    return Error{"no_rows_of_numbers"};
  }
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
    const bool row = is_row(cells, layout);
    if (row && first_row == lines.size()) first_row = i;
    // A row with a bad cell is a row, not a header: it begins with a number.
    std::size_t first = 0;
    while (layout.is_text(first) && first + 1 < cells.size()) ++first;
    const bool begins_with_number = read_cell(cells[first], layout.decimal).kind == CellKind::number;
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

std::vector<bool> text_columns(const std::vector<std::string_view>& lines, std::size_t data,
                               const Layout& layout, const ReadOptions& options,
                               const std::vector<bool>& named_time) {
  if (layout.paired || layout.separator == 0) return {};
  std::vector<Seen> columns(layout.columns);
  std::vector<std::string_view> cells;
  for (std::size_t i = data; i < lines.size(); ++i) {
    if (is_blank(lines[i]) || is_comment(lines[i])) continue;
    split_cells(lines[i], layout, cells);
    for (std::size_t j = 0; j < std::min(cells.size(), layout.columns); ++j)
      columns[j].look_at(cells[j], layout.decimal);
  }
  const auto is_time = [&](std::size_t j) { return j < named_time.size() && named_time[j]; };
  bool timed = false;
  for (std::size_t j = 0; j < columns.size(); ++j) timed = timed || (columns[j].number && is_time(j));
  std::vector<bool> text;
  for (const Seen& column : columns) text.push_back(column.is_text(timed));
  const bool any = std::find(text.begin(), text.end(), true) != text.end();
  return any && enough_numbers(columns, options) ? text : std::vector<bool>{};
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
