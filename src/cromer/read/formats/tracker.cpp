#include "cromer/read/formats/tracker.h"

#include <algorithm>

#include "cromer/read/lines.h"

namespace cromer::core::dialects {

bool is_tracker(const Header& header) {
  const auto& columns = header.headings;
  const bool bare =
      std::all_of(columns.begin(), columns.end(), [](const Heading& column) { return column.unit.empty(); });
  if (columns.size() < 2 || !bare || columns[0].name != "t" || columns[1].name != "x") return false;
  return header.separator == '\t' || (columns.size() > 2 && columns[2].name == "y");
}

void name_tracks(Header& header) {
  if (!is_tracker(header) || header.titles.empty()) return;
  std::vector<std::string_view> names;
  split_cells(header.titles.back(), Layout{header.separator, '.', 1}, names);
  if (names.size() < 2 || !names.front().empty()) return;
  const auto tracks = std::count_if(names.begin(), names.end(), [](auto name) { return !name.empty(); });
  if (tracks < 2) return;
  std::string_view track;
  for (std::size_t j = 1; j < header.headings.size(); ++j) {
    if (j < names.size() && !names[j].empty()) track = names[j];
    header.headings[j].run = track;
  }
}

}  // namespace cromer::core::dialects
