#include "cromer/read/sets_below.h"

#include <algorithm>

#include "cromer/base/ascii.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/formats/plain.h"
#include "cromer/read/header.h"
#include "cromer/read/lines.h"

namespace cromer::core::dialects {
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

}  // namespace cromer::core::dialects
