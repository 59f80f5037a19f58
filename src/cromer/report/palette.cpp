#include "cromer/report/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace cromer::core {
namespace {

constexpr std::array<double, 4> solid{}, long_dash{8, 3, 0, 0}, short_dash{3, 3, 0, 0}, dots{2, 2, 0, 0},
    dash_dot{8, 3, 2, 3}, longer_dash{11, 4, 0, 0};

// The hue is the family, the dash the member. Where a line's colour is too faint for a word,
// the word's is that one darkened (lightened) to 4.5:1.
constexpr std::array<RoleStyle, 27> roles{{
    {"exact", "#8A93A0", "#5B6573", "#7F8A98", "#AAB4C0", 4, solid},
    {"measured", "#171C24", "#171C24", "#EDF0F4", "#EDF0F4", 2.6, solid},
    {"fitted", "#AA4488", "#983A79", "#E08CC0", "#EBA3CF", 2, solid},
    {"drive", "#6A55C7", "#6A55C7", "#A99BF5", "#A99BF5", 1.5, solid},
    {"set-aside", "#626C7A", "#626C7A", "#949FAE", "#949FAE", 1, solid},
    {"constant-rate", "#626C7A", "#626C7A", "#949FAE", "#949FAE", 1.5, dashes},

    {"forward-euler", "#D55E00", "#B84E00", "#F2803B", "#F79A60", 1.5, solid},
    {"euler-cromer", "#0072B2", "#0068A3", "#4AA8E8", "#6DBBF0", 1.5, solid},
    {"implicit-euler", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5, solid},

    {"verlet", "#2E8FBF", "#1F759F", "#8CCBF2", "#8CCBF2", 1.5, longer_dash},
    {"yoshida4", "#2E8FBF", "#1F759F", "#8CCBF2", "#8CCBF2", 1.5, long_dash},
    {"rk4", "#A06A00", "#A06A00", "#E3B04B", "#E3B04B", 1.5, longer_dash},
    {"heun", "#A06A00", "#A06A00", "#E3B04B", "#E3B04B", 1.5, short_dash},
    {"dormand-prince", "#A06A00", "#A06A00", "#E3B04B", "#E3B04B", 1.5, dash_dot},
    {"implicit-midpoint", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5, long_dash},
    {"newmark", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5, short_dash},
    {"generalized-alpha", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5, dash_dot},
    {"gauss-legendre4", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5, dots},

    {"family:0", "#00304D", "#00304D", "#C4E4FB", "#C4E4FB", 1.5, solid},
    {"family:1", "#005A8C", "#005A8C", "#9AD1F7", "#9AD1F7", 1.5, solid},
    {"family:2", "#0072B2", "#0068A3", "#4AA8E8", "#6DBBF0", 1.5, solid},
    {"family:3", "#2E86BE", "#2A76A6", "#3F97D3", "#5AAEE6", 1.5, solid},
    {"family:4", "#5596C2", "#3A7296", "#3985B9", "#4F9FD6", 1.5, solid},
    {"positive", "#0072B2", "#0068A3", "#4AA8E8", "#6DBBF0", 1.5, long_dash},
    {"negative", "#0072B2", "#0068A3", "#4AA8E8", "#6DBBF0", 1.5, short_dash},
    {"implicit-family:0", "#003D2C", "#003D2C", "#BFF0DF", "#BFF0DF", 1.5, solid},
    {"implicit-family:4", "#469F84", "#2A7560", "#2FA583", "#4DBB99", 1.5, solid},
}};

// One of many motions, under what they have in common.
constexpr RoleStyle one_of_many{"one-of-many", "#8A93A0", "#5B6573", "#7F8A98", "#AAB4C0", 0.8, solid};

// Guide lines, to read by and not to look at: they need no contrast.
constexpr RoleStyle grid_line{"grid", "#D5DAE1", "#626C7A", "#323B47", "#949FAE", 0.8, solid};

constexpr RoleStyle unknown{"", "#171C24", "#171C24", "#EDF0F4", "#EDF0F4", 1.5, solid};

constexpr int family_members = 5, shades_between = 20;

/// Every shade of the family; between two members their colours are mixed.
const RoleStyle& family_shade(double member) {
  constexpr std::size_t count = (family_members - 1) * shades_between + 1;
  static const auto colours = [] {
    std::array<std::array<std::string, 4>, count> made;
    const auto* first = std::find_if(roles.begin(), roles.end(),
                                     [](const RoleStyle& style) { return style.role == "family:0"; });
    for (std::size_t i = 0; i < made.size(); ++i) {
      const auto below = std::min<std::size_t>(i / shades_between, family_members - 2);
      const double share = static_cast<double>(i) / shades_between - static_cast<double>(below);
      const RoleStyle &a = first[below], &b = first[below + 1];
      made[i] = {mixed_colour(a.line, b.line, share), mixed_colour(a.word, b.word, share),
                 mixed_colour(a.line_dark, b.line_dark, share),
                 mixed_colour(a.word_dark, b.word_dark, share)};
    }
    return made;
  }();
  static const auto styles = [] {
    std::array<RoleStyle, count> made;
    for (std::size_t i = 0; i < made.size(); ++i) {
      const auto& c = colours[i];
      made[i] = {"family", c[0], c[1], c[2], c[3], 1.5, solid};
    }
    return made;
  }();
  const double at = std::clamp(member * shades_between, 0.0, static_cast<double>(styles.size() - 1));
  return styles[static_cast<std::size_t>(std::lround(at))];
}

}  // namespace

std::span<const RoleStyle> palette() { return roles; }

const RoleStyle& style_of(std::string_view role) {
  for (const RoleStyle& style : roles) {
    if (style.role == role) return style;
  }
  for (const RoleStyle* thin : {&one_of_many, &grid_line})
    if (role == thin->role) return *thin;
  constexpr std::string_view family = "family:";
  if (role.starts_with(family)) {
    const std::string member(role.substr(family.size()));
    char* end = nullptr;
    const double number = std::strtod(member.c_str(), &end);
    if (end != member.c_str() && *end == '\0' && number >= 0) return family_shade(number);
  }
  return unknown;
}

std::string family_role(std::size_t i, std::size_t n) {
  if (n < 2) return "family:0";
  return fmt::format("family:{:.4g}",
                     (family_members - 1) * static_cast<double>(i) / static_cast<double>(n - 1));
}

std::string mixed_colour(std::string_view from, std::string_view to, double share) {
  std::string mixed = "#";
  for (std::size_t at = 1; at < 7; at += 2) {
    const auto part = [at](std::string_view colour) {
      return static_cast<double>(std::strtol(std::string(colour.substr(at, 2)).c_str(), nullptr, 16));
    };
    mixed += fmt::format("{:02X}", std::lround(part(from) + share * (part(to) - part(from))));
  }
  return mixed;
}

std::string map_colour(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(std::size(map_colours) - 1);
  const auto below = std::min(static_cast<std::size_t>(at), std::size(map_colours) - 2);
  return mixed_colour(map_colours[below], map_colours[below + 1], at - static_cast<double>(below));
}

}  // namespace cromer::core
