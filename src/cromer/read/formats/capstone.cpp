#include "cromer/read/formats/capstone.h"

#include <algorithm>

namespace cromer::core::dialects {

void name_runs_above(Header& header) {
  auto& columns = header.headings;
  if (header.titles.empty() || header.separator == ' ') return;  // blanks do not say what stands above what
  if (std::any_of(columns.begin(), columns.end(), [](const Heading& column) { return !column.run.empty(); }))
    return;
  std::vector<std::string_view> cells;
  split_cells(header.titles.back(), Layout{header.separator, '.', 1}, cells);
  if (cells.size() < 2) return;
  while (cells.back().empty() && cells.size() > 1) cells.pop_back();
  if (cells.size() > columns.size()) return;
  std::vector<std::string> runs;
  for (const std::string_view cell : cells) {
    const Heading heading = parse_heading(cell);
    if (!heading.name.empty() || (heading.run.empty() && !cell.empty())) return;
    runs.push_back(heading.run);
  }
  if (std::all_of(runs.begin(), runs.end(), [](const std::string& run) { return run.empty(); })) return;
  std::string run;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (j < runs.size() && !runs[j].empty()) run = runs[j];
    columns[j].run = run;
  }
  header.titles.pop_back();
}

}  // namespace cromer::core::dialects
