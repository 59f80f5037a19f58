// Colour, width and dash of each role of a curve. A role has the same colour on every page, figure and
// report.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace cromer::core {

/// How a role is drawn. Colours are "#RRGGBB": `line` at least 3:1 against its ground, `word` at least 4.5:1.
struct RoleStyle {
  std::string_view role;
  std::string_view line, word;            ///< on the white ground (#FFFFFF)
  std::string_view line_dark, word_dark;  ///< on the dark ground (#171C23)
  double width = 1.5;                     ///< [px]; of dots: twice their radius
  std::array<double, 4> dash{};           ///< [px] on, off, on, off; all 0: solid
};

/// Ground, ink and lines of the surface a figure stands on.
struct SurfaceColours {
  std::string_view ground, ink, text_2, text_3, axis, grid, zero_line;
};
inline constexpr SurfaceColours light_surface{"#FFFFFF", "#171C24", "#4A5361", "#626C7A",
                                              "#7B8594", "#E4E8ED", "#C3CAD3"};
inline constexpr SurfaceColours dark_surface{"#171C23", "#EDF0F4", "#B7C0CC", "#949FAE",
                                             "#76828F", "#2A323D", "#465160"};

/// Dashes of a rejected or constant-rate model, and of any curve marked as dashed [px].
inline constexpr std::array<double, 4> dashes{6, 4, 0, 0};

/// The colours of maps, evenly spaced from low to high: viridis, which rises in lightness and is told apart
/// by every eye (S. van der Walt & N. Smith, matplotlib 1.5, 2015).
inline constexpr std::string_view map_colours[] = {"#440154", "#472D7B", "#3B528B", "#2C728E", "#21918C",
                                                   "#28AE80", "#5EC962", "#ADDC30", "#FDE725"};

/// The colour at a share of the way, 0 to 1, as "#RRGGBB".
std::string map_colour(double share);

/// The colour a share of the way, 0 to 1, from one "#RRGGBB" to another.
std::string mixed_colour(std::string_view from, std::string_view to, double share);

/// All roles: "exact", "measured", "fitted", "drive", "constant-rate", "family:0" to "family:4" and every
/// method's name.
std::span<const RoleStyle> palette();

/// The style of `role`, or of "grid" or "one-of-many", thin lines under the curves; an unknown role is drawn
/// in ink. Between "family:0" and "family:4" there are shades for more than five: "family:2.35".
const RoleStyle& style_of(std::string_view role);

/// The role of the i-th of n in an ordered family, from dark to light as far apart as can be; n > i.
std::string family_role(std::size_t i, std::size_t n);

}  // namespace cromer::core
