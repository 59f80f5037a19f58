#include "cromer/read/dialect_name.h"

#include <algorithm>
#include <array>

#include "cromer/read/cells.h"
#include "cromer/read/column_kind.h"

namespace cromer::core::dialects {
namespace {

bool is_datastudio(const Header& header) {
  return std::any_of(header.titles.begin(), header.titles.end(), [](const std::string& title) {
    return title.find(", Run #") != std::string::npos || title.find(", Ch") != std::string::npos;
  });
}

bool is_capstone(const Header& header) {
  return std::any_of(header.headings.begin(), header.headings.end(), [](const Heading& heading) {
    return heading.prefix.empty() && heading.run.find(" #") != std::string::npos;
  });
}

bool has_prefix(const Header& header, std::string_view beginning) {
  return std::any_of(header.headings.begin(), header.headings.end(),
                     [&](const Heading& heading) { return heading.prefix.starts_with(beginning); });
}

bool is_phyphox(const Header& header) {
  constexpr std::array<std::string_view, 6> sensors{"gyroscope",    "rotation",      "linearacceleration",
                                                    "acceleration", "magneticfield", "absolute"};
  if (header.headings.size() < 2 || header.headings[0].name != "Time" || header.headings[0].unit != "s")
    return false;
  return std::any_of(header.headings.begin() + 1, header.headings.end(), [&](const Heading& heading) {
    const std::string name = plain_name(heading.name);
    return std::any_of(sensors.begin(), sensors.end(), [&](std::string_view sensor) {
      const bool component =
          name.size() == sensor.size() + 1 && name.find_first_of("xyz", sensor.size()) == sensor.size();
      return name.starts_with(sensor) && (component || (header.quoted && sensor == "absolute"));
    });
  });
}

bool is_tracker(const Header& header) {
  const auto& columns = header.headings;
  const bool bare =
      std::all_of(columns.begin(), columns.end(), [](const Heading& column) { return column.unit.empty(); });
  if (columns.size() < 2 || !bare || columns[0].name != "t" || columns[1].name != "x") return false;
  return header.separator == '\t' || (columns.size() > 2 && columns[2].name == "y");
}

}  // namespace

std::string_view dialect_name(const Header& header) {
  if (is_datastudio(header)) return "DataStudio";
  if (has_prefix(header, "Data Set")) return "Graphical Analysis";
  if (has_prefix(header, "Latest") || has_prefix(header, "Run ") || has_prefix(header, "Remote Data"))
    return "Logger Pro";
  if (is_capstone(header)) return "PASCO Capstone";
  if (is_tracker(header)) return "Tracker";
  if (is_phyphox(header)) return "phyphox";
  return "plain";
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
