// "Did you mean": the nearest of a list of names to one typed wrong.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cromer::core {

/// The name of smallest edit distance (insert, delete, substitute, swap neighbours) to `typed`, case ignored,
/// if that distance is at most a third of the longer length plus one; otherwise empty.
///
/// Names that contain what was typed come before names that merely resemble it, unless one of those is a
/// single slip away: "euler" means forward-euler or euler-cromer rather than verlet.
std::string nearest(std::string_view typed, std::span<const std::string_view> names);

/// The nearest name, or all that contain what was typed, in their order: "euler" may mean forward-euler,
/// euler-cromer and implicit-euler. Empty where nothing is near.
std::vector<std::string> nearest_names(std::string_view typed, std::span<const std::string_view> names);

}  // namespace cromer::core
