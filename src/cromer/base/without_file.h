// Notices without the name of their file, "what" for "lab.csv: what", where the name stands beside them.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// Of a notice with two values, this file and the notice `what`: the notice `what`. Any other notice as it
/// is.
inline Notice without_file(const Notice& notice, std::string_view file) {
  if (notice.values.size() != 2 || notice.values[0].name != "file" || notice.values[1].name != "what")
    return notice;
  const auto* named = std::get_if<std::string>(&notice.values[0].value);
  const auto* said = std::get_if<std::vector<Notice>>(&notice.values[1].value);
  return named && *named == file && said && said->size() == 1 ? said->front() : notice;
}

}  // namespace cromer::core
