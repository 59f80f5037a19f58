#include "cromer/read/header.h"

#include <algorithm>

#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"

namespace cromer::core::dialects {
namespace {

using Cells = std::vector<std::string_view>;

/// Where the word for a run, with '#' behind it, begins at the end of a heading; npos where there is none. A
/// sensor or a cart may have a number, too.
std::size_t run_in_another_language(std::string_view before_digits) {
  constexpr std::string_view words =
      " Durchgang Durchlauf Lauf Messung Versuch Corsa Esecuzione Prova Essai Ensayo Serie Série Trial ";
  if (!before_digits.ends_with('#')) return std::string_view::npos;
  const std::string_view head = trimmed(before_digits.substr(0, before_digits.size() - 1));
  const std::size_t at = head.rfind(' ') + 1;  // 0 where it is the only word
  const std::string word = concat({" ", head.substr(at), " "});
  return words.find(word) == std::string_view::npos ? words.npos : at;
}

/// Takes " Run #12" from the end of a heading.
std::string take_run(std::string_view& text) {
  const std::size_t digits = text.find_last_not_of("0123456789");
  if (digits == std::string_view::npos || digits + 1 == text.size()) return {};
  std::size_t at = run_in_another_language(text.substr(0, digits + 1));
  if (at == std::string_view::npos) {
    at = text.rfind("Run");
    if (at == std::string_view::npos || (at > 0 && is_digit(text[at - 1]))) return {};
    for (std::size_t i = at + 3; i <= digits; ++i)
      if (text[i] != ' ' && text[i] != '#') return {};
  }
  std::string run(text.substr(at));
  text = trimmed(text.substr(0, at));
  if (text.ends_with(',')) text = trimmed(text.substr(0, text.size() - 1));
  return run;
}

/// Takes "Latest:" or "Run 1:" from the front.
std::string take_prefix(std::string_view& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon + 1 >= text.size() || colon > 60) return {};
  std::string prefix(trimmed(text.substr(0, colon)));
  text = trimmed(text.substr(colon + 1));
  return prefix;
}

/// Takes "(m/s)" or "[m]" from the end.
std::string take_unit(std::string_view& text) {
  if (text.empty() || (text.back() != ')' && text.back() != ']')) return {};
  const std::size_t open = text.rfind(text.back() == ')' ? '(' : '[');
  if (open == std::string_view::npos) return {};
  std::string unit(trimmed(text.substr(open + 1, text.size() - open - 2)));
  const std::string_view name = trimmed(text.substr(0, open));
  if (name.empty()) return {};
  text = name;
  return unit;
}

/// time_s, angle_deg: a unit after the last underscore, if it fits the name.
std::string take_suffix_unit(std::string_view& text) {
  const std::size_t underscore = text.rfind('_');
  if (underscore == std::string_view::npos || underscore == 0 || underscore + 1 == text.size()) return {};
  const std::string_view name = text.substr(0, underscore), unit = text.substr(underscore + 1);
  const std::string quantity = quantity_of(name, "");
  const bool fits = !quantity.empty() && parse_unit(unit).ok() && quantity_of(name, unit) == quantity;
  if (!fits || is_digit(unit[0])) return {};
  text = name;
  return std::string(unit);
}

/// Time/ms, v/(m/s), "t in s": the part behind is a unit if it fits the name; behind a time and a slash it
/// always is one.
std::string take_unit_behind(std::string_view& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos || at == 0) return {};
  const std::string_view name = trimmed(text.substr(0, at));
  std::string_view unit = trimmed(text.substr(at + mark.size()));
  if (unit.size() > 1 && (unit.front() == '(' || unit.front() == '['))
    unit = trimmed(unit.substr(1, unit.size() - 2));
  const std::string quantity = quantity_of(name, "");
  if (unit.empty() || quantity.empty()) return {};
  const bool of_time = mark == "/" && quantity == "time";
  const bool unknown = mark == "/" && !parse_unit(unit).ok();
  const bool of_angle = quantity == "position" && is_unit_of(unit, "angle");  // a displacement in degrees
  if (!is_unit_of(unit, quantity) && !of_angle && !of_time && !unknown) return {};
  text = name;
  return std::string(unit);
}

/// "timestamp ms", "pos cm": a last word that is a unit fitting the name.
std::string take_last_word_unit(std::string_view& text) {
  const std::size_t blank = text.find_last_of(" \t");
  if (blank == std::string_view::npos || blank + 1 == text.size() || is_digit(text[blank + 1])) return {};
  const std::string_view name = trimmed(text.substr(0, blank)), unit = text.substr(blank + 1);
  const std::string quantity = quantity_of(name, "");
  if (quantity.empty() || !is_unit_of(unit, quantity)) return {};
  text = name;
  return std::string(unit);
}

/// "Position (cm) smoothed": a bracket within the name that holds a fitting unit.
std::string take_unit_within(std::string& text) {
  const std::size_t open = text.find_first_of("(["), close = text.find_first_of(")]", open);
  if (open == std::string::npos || open == 0 || close == std::string::npos) return {};
  const std::string unit(trimmed(std::string_view(text).substr(open + 1, close - open - 1)));
  std::string name(trimmed(std::string_view(text).substr(0, open)));
  const std::string_view rest = trimmed(std::string_view(text).substr(close + 1));
  if (unit.empty() || rest.empty() || !is_unit_of(unit, quantity_of(name, ""))) return {};
  text = name.append(" ").append(rest);
  return unit;
}

void drop_trailing_empty(Cells& cells) {
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
}

/// "(m)", "[s]", "m/s": the cells of a line of units below the names. "t" is no unit, "s" and "m" are.
bool is_unit(std::string_view cell) {
  if (cell.empty()) return true;
  const bool bracketed =
      (cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')');
  return bracketed || parse_unit(cell).ok();
}

/// "Time (s)  Position (m)" between blanks: a bracket belongs to the word before it.
Cells split_at_blanks(std::string_view line) {
  Cells joined;
  bool opened = false, closed = false;  // brackets of the last name
  CellReader words(line, Layout{' ', '.', 1});
  for (std::string_view cell; words.next(cell);) {
    const bool belongs = cell.starts_with('(') || cell.starts_with('[');
    const bool open = opened && !closed;
    if (joined.empty() || (!belongs && !open)) {
      joined.push_back(cell);
      opened = closed = false;
    } else {
      joined.back() = {joined.back().data(),
                       static_cast<std::size_t>(cell.data() + cell.size() - joined.back().data())};
    }
    opened = opened || cell.find_first_of("([") != std::string_view::npos;
    closed = closed || cell.find_first_of(")]") != std::string_view::npos;
  }
  return joined;
}

/// The names of a header line, if some separator gives as many as the rows have columns; else empty.
Cells split_names(std::string_view line, const Layout& layout, char& separator) {
  Cells cells;
  if (layout.columns == 1) {
    split_cells(line, Layout{0, '.', 1}, cells);
    separator = 0;
    return cells;
  }
  for (const char candidate : {layout.separator, '\t', ';', ',', ' '}) {
    if (candidate == ' ')
      cells = split_at_blanks(line);
    else
      split_cells(line, Layout{candidate, '.', 1}, cells);
    const std::size_t written = cells.size();
    drop_trailing_empty(cells);
    separator = candidate;
    if (cells.size() == layout.columns || (written == layout.columns && !cells.empty())) return cells;
  }
  // Fewer names than columns: a delimiter that ends each row makes one column without a name.
  split_cells(line, Layout{layout.separator, '.', 1}, cells);
  drop_trailing_empty(cells);
  separator = layout.separator;
  return cells.size() > 1 || layout.columns == 2 ? cells : Cells{};
}

std::string unquoted(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    plain += text[i];
    if (text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') ++i;
  }
  return plain;
}

}  // namespace

Heading parse_heading(std::string_view cell) {
  Heading heading;
  const std::string whole = unquoted(trimmed(cell));
  std::string_view text = whole;
  // An apostrophe keeps spreadsheets from reading =, + or - as a formula.
  if (text.size() > 1 && text[0] == '\'' && std::string_view("=+-@").find(text[1]) != std::string_view::npos)
    text.remove_prefix(1);
  heading.run = take_run(text);
  heading.prefix = take_prefix(text);
  if (heading.run.empty()) heading.run = heading.prefix;
  heading.unit = take_unit(text);
  if (heading.run.empty()) heading.run = take_run(text);
  if (text.size() > 1 && text.ends_with('/')) text = trimmed(text.substr(0, text.size() - 1));  // of v/(m/s)
  for (const std::string_view mark : {"/", " in ", ","})
    if (heading.unit.empty()) heading.unit = take_unit_behind(text, mark);
  if (heading.unit.empty()) heading.unit = take_suffix_unit(text);
  if (heading.unit.empty()) heading.unit = take_last_word_unit(text);
  heading.name = text;
  if (heading.unit.empty()) heading.unit = take_unit_within(heading.name);
  if (heading.unit.empty()) heading.unit = unit_as_name(heading.name);
  return heading;
}

Header find_header(const std::vector<std::string_view>& lines, std::size_t data, const Layout& layout) {
  Header header;
  std::vector<std::string_view> above, comments;
  for (std::size_t i = 0; i < data; ++i) {
    if (is_blank(lines[i])) continue;
    if (is_comment(lines[i])) {
      comments.push_back(trimmed(lines[i].substr(lines[i].find_first_of("#%") + 1)));
    } else {
      above.push_back(lines[i]);
    }
  }
  // Names in a comment line count only if they match the columns one for one.
  const bool commented = above.empty();
  if (commented) {
    for (const std::string_view line : comments) {
      char separator = 0;
      if (layout.columns > 1 && split_names(line, layout, separator).size() == layout.columns)
        above.push_back(line);
      else
        above.clear();
    }
  }
  // A line of numbers names nothing: it is one more title (a count of rows, a date).
  std::vector<std::string_view> words;
  while (!above.empty()) {
    split_cells(above.back(), Layout{layout.columns == 1 ? ' ' : layout.separator, '.', 1}, words);
    if (std::any_of(words.begin(), words.end(),
                    [](auto cell) { return read_cell(cell, '.').kind == CellKind::word; }))
      break;
    header.titles.emplace_back(above.back());
    above.pop_back();
  }
  if (above.empty()) return header;

  Cells names = split_names(above.back(), layout, header.separator);
  above.pop_back();
  Cells units;
  const bool all_units = !names.empty() && std::all_of(names.begin(), names.end(), is_unit) && !above.empty();
  if (all_units) {
    char separator = 0;
    Cells before = split_names(above.back(), layout, separator);
    if (before.size() >= names.size()) {
      units = std::move(names);
      names = std::move(before);
      above.pop_back();
    }
  }
  for (const std::string_view title : above) header.titles.emplace_back(title);
  for (std::size_t j = 0; j < names.size() && j < layout.columns; ++j) {
    header.quoted = header.quoted || (names[j].data() > lines[0].data() && names[j].data()[-1] == '"');
    header.headings.push_back(parse_heading(names[j]));
    if (j < units.size() && header.headings.back().unit.empty()) {
      std::string_view unit = units[j];
      if (!unit.empty() && (unit.front() == '[' || unit.front() == '('))
        unit = trimmed(unit.substr(1, unit.size() - 2));
      header.headings.back().unit = unit;
    }
  }
  return header;
}

}  // namespace cromer::core::dialects
