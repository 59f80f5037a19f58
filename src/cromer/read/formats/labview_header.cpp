#include "cromer/read/formats/labview_header.h"

#include "cromer/read/cells.h"
#include "cromer/read/lines.h"

namespace cromer::core::dialects {
namespace {

constexpr std::string_view end_of_header = "***End_of_Header***";

}  // namespace

const std::vector<std::string_view>& LabviewSegment::operator[](std::string_view tag) const {
  static const std::vector<std::string_view> none;
  for (const LabviewTag& own : tags)
    if (own.name == tag) return own.values;
  return none;
}

LabviewFile labview_file(const std::vector<std::string_view>& lines) {
  LabviewFile file;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = trimmed(lines[i]);
    file.end = i + 1;
    if (line.starts_with(end_of_header)) break;
    // The separator is a tab or a comma already in the line that names it.
    const std::size_t at = line.find_first_of("\t,");
    if (at == std::string_view::npos) continue;
    const std::string_view tag = trimmed(line.substr(0, at)), value = trimmed(line.substr(at + 1));
    if (tag == "Separator")
      file.separator = value.starts_with("Comma") || value.starts_with(',') ? ',' : '\t';
    if (tag != "X_Columns") continue;
    if (value.starts_with("No")) file.times = LabviewFile::Times::none;
    if (value.starts_with("Multi")) file.times = LabviewFile::Times::multi;
  }
  return file;
}

LabviewSegment labview_segment(const std::vector<std::string_view>& lines, std::size_t from, char separator) {
  LabviewSegment segment;
  std::vector<std::string_view> cells;
  bool special = false;
  for (std::size_t i = from; i < lines.size(); ++i) {
    if (is_blank(lines[i])) continue;
    split_cells(lines[i], Layout{separator, '.', 1}, cells);
    if (cells.front() == end_of_header) {
      segment.names = i + 1;
      return segment;
    }
    if (cells.front() == "***Start_Special***") special = true;
    if (!special) {
      while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
      segment.tags.push_back({cells.front(), {cells.begin() + 1, cells.end()}});
    }
    if (cells.front() == "***End_Special***") special = false;
  }
  segment.names = lines.size();
  return segment;
}

}  // namespace cromer::core::dialects
