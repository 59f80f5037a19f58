// The tag rows of a LabVIEW measurement file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::dialects {

/// What the head of the file says, as far as reading needs it.
struct LabviewFile {
  enum class Times { none, one, multi };  ///< X_Columns: none in the rows, one column, one for each channel
  char separator = '\t';
  Times times = Times::one;
  std::size_t end = 0;  ///< index of the line behind ***End_of_Header***
};

/// One tag of a segment's header with a value for each channel.
struct LabviewTag {
  std::string_view name;
  std::vector<std::string_view> values;
};

struct LabviewSegment {
  std::vector<LabviewTag> tags;
  std::size_t names = 0;  ///< index of the line of names behind ***End_of_Header***

  /// The values of a tag; empty where the segment has none of that name.
  const std::vector<std::string_view>& operator[](std::string_view tag) const;
};

LabviewFile labview_file(const std::vector<std::string_view>& lines);

/// The header that begins at or behind line index `from`; its names are at lines.size() if there is none.
LabviewSegment labview_segment(const std::vector<std::string_view>& lines, std::size_t from, char separator);

}  // namespace cromer::core::dialects
