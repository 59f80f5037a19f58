// "Did you mean": the nearest of a list of names to one typed wrong.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cromer {

/// The name of smallest edit distance (insert, delete, substitute, swap neighbours) to `typed`, case ignored, if that distance is at most
/// a third of the longer length plus one; otherwise empty.
std::string nearest(std::string_view typed, std::span<const std::string_view> names);

}  // namespace cromer
