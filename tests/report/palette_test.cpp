#include "cromer/report/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace cromer::core {
namespace CROMER_FILE {

double channel(std::string_view colour, std::size_t at) {
  const double c = std::stoi(std::string(colour.substr(at, 2)), nullptr, 16) / 255.0;
  return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Contrast as WCAG 2 defines it, 1 to 21.
double contrast(std::string_view a, std::string_view b) {
  const auto luminance = [](std::string_view c) {
    return 0.2126 * channel(c, 1) + 0.7152 * channel(c, 3) + 0.0722 * channel(c, 5);
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Palette, ContrastIsMeasuredAsWcagDefinesIt) {
  EXPECT_NEAR(contrast("#000000", "#FFFFFF"), 21, 1e-9);
  EXPECT_NEAR(contrast("#171C24", "#FFFFFF"), 17.1, 0.05);  // the ink
}

TEST(Palette, HasItsColours) {
  struct Row {
    const char *role, *line, *word, *line_dark, *word_dark;
    double width;
  };
  for (const Row& row : {Row{"exact", "#8A93A0", "#5B6573", "#7F8A98", "#AAB4C0", 4},
                         Row{"measured", "#171C24", "#171C24", "#EDF0F4", "#EDF0F4", 2.6},
                         Row{"fitted", "#AA4488", "#983A79", "#E08CC0", "#EBA3CF", 2},
                         Row{"forward-euler", "#D55E00", "#B84E00", "#F2803B", "#F79A60", 1.5},
                         Row{"euler-cromer", "#0072B2", "#0068A3", "#4AA8E8", "#6DBBF0", 1.5},
                         Row{"implicit-euler", "#009E73", "#007A59", "#2CC295", "#45D0A6", 1.5},
                         Row{"drive", "#6A55C7", "#6A55C7", "#A99BF5", "#A99BF5", 1.5},
                         Row{"constant-rate", "#626C7A", "#626C7A", "#949FAE", "#949FAE", 1.5}}) {
    const RoleStyle& style = style_of(row.role);
    EXPECT_EQ(style.line, row.line) << row.role;
    EXPECT_EQ(style.word, row.word) << row.role;
    EXPECT_EQ(style.line_dark, row.line_dark) << row.role;
    EXPECT_EQ(style.word_dark, row.word_dark) << row.role;
    EXPECT_EQ(style.width, row.width) << row.role;
  }
  const char* family[] = {"#00304D", "#005A8C", "#0072B2", "#2E86BE", "#5596C2"};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(style_of("family:" + std::to_string(i)).line, family[i]);
}

TEST(Palette, AnOrderedFamilyOfAnySizeGoesFromDarkToLight) {
  for (const std::size_t count : {2u, 3u, 5u, 7u, 14u, 40u}) {
    EXPECT_EQ(style_of(family_role(0, count)).line, "#00304D");
    EXPECT_EQ(style_of(family_role(count - 1, count)).line, "#5596C2");
    double last = 1e9;
    for (std::size_t i = 0; i < count; ++i) {
      const RoleStyle& style = style_of(family_role(i, count));
      const double against_white = contrast(style.line, light_surface.ground);
      EXPECT_LT(against_white, last) << i << " of " << count;
      EXPECT_GE(contrast(style.word, light_surface.ground), 4.5);
      last = against_white;
    }
  }
  EXPECT_EQ(style_of("family:x").line, light_surface.ink);
}

TEST(Palette, HueIsTheFamilyAndDashTheMember) {
  const std::array<double, 4> solid{}, long_dash{8, 3, 0, 0}, short_dash{3, 3, 0, 0}, dots{2, 2, 0, 0},
      dash_dot{8, 3, 2, 3}, longer_dash{11, 4, 0, 0};
  EXPECT_EQ(style_of("verlet").line, "#2E8FBF");
  // Told apart from euler-cromer and forward-euler without their hues.
  EXPECT_EQ(style_of("euler-cromer").dash, solid);
  EXPECT_EQ(style_of("verlet").dash, longer_dash);
  EXPECT_EQ(style_of("rk4").dash, longer_dash);
  EXPECT_EQ(style_of("yoshida4").dash, long_dash);
  EXPECT_EQ(style_of("rk4").line, "#A06A00");
  EXPECT_EQ(style_of("heun").dash, short_dash);
  EXPECT_EQ(style_of("dormand-prince").dash, dash_dot);
  EXPECT_EQ(style_of("implicit-midpoint").dash, long_dash);
  EXPECT_EQ(style_of("newmark").dash, short_dash);
  EXPECT_EQ(style_of("generalized-alpha").dash, dash_dot);
  EXPECT_EQ(style_of("gauss-legendre4").dash, dots);
  EXPECT_EQ(style_of("constant-rate").dash, dashes);
  EXPECT_EQ(style_of("no such role").line, light_surface.ink);
}

TEST(Palette, EveryColourCanBeSeenAndEveryWordRead) {
  for (const RoleStyle& style : palette()) {
    EXPECT_GE(contrast(style.line, light_surface.ground), 3) << style.role;
    EXPECT_GE(contrast(style.line_dark, dark_surface.ground), 3) << style.role;
    EXPECT_GE(contrast(style.word, light_surface.ground), 4.5) << style.role;
    EXPECT_GE(contrast(style.word_dark, dark_surface.ground), 4.5) << style.role;
  }
}

TEST(Palette, NoTwoRolesLookTheSame) {
  std::set<std::string> looks;
  for (const RoleStyle& style : palette()) {
    std::string look(style.line);
    for (const double d : style.dash) look += ' ' + std::to_string(d);
    if (style.role != "family:2") {  // Euler-Cromer's own blue
      EXPECT_TRUE(looks.insert(look).second) << style.role;
    }
  }
}

TEST(Palette, MixesColoursChannelByChannel) {
  EXPECT_EQ(mixed_colour("#000000", "#FFFFFF", 0), "#000000");
  EXPECT_EQ(mixed_colour("#000000", "#FFFFFF", 1), "#FFFFFF");
  EXPECT_EQ(mixed_colour("#001020", "#406080", 0.5), "#203850");
  EXPECT_EQ(mixed_colour("#FF0A80", "#000A00", 0.25), "#BF0A60");
  EXPECT_EQ(style_of("family:0.5").line, mixed_colour("#00304D", "#005A8C", 0.5));
  EXPECT_EQ(style_of("family:3.75").word, mixed_colour("#2A76A6", "#3A7296", 0.75));
  EXPECT_EQ(style_of("family:1.25").line_dark, mixed_colour("#9AD1F7", "#4AA8E8", 0.25));
  EXPECT_EQ(style_of("family:1.25").word_dark, mixed_colour("#9AD1F7", "#6DBBF0", 0.25));
  EXPECT_EQ(style_of("family:99").line, "#5596C2");
  EXPECT_EQ(style_of("family:0.5").width, 1.5);
  EXPECT_EQ(style_of("family:-1").line, light_surface.ink);
  EXPECT_EQ(style_of("family:").line, light_surface.ink);
  EXPECT_EQ(style_of("family:1x").line, light_surface.ink);
  EXPECT_EQ(family_role(0, 1), "family:0");
  EXPECT_EQ(family_role(0, 0), "family:0");
  EXPECT_EQ(family_role(1, 3), "family:2");
  EXPECT_EQ(family_role(1, 2), "family:4");
}

TEST(Palette, MapsGoFromDarkToLightThroughEveryColour) {
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(map_colour(static_cast<double>(i) / 8), map_colours[i]);
  EXPECT_EQ(map_colour(-1), map_colours[0]);
  EXPECT_EQ(map_colour(2), map_colours[8]);
  EXPECT_EQ(map_colour(1.0 / 16), mixed_colour(map_colours[0], map_colours[1], 0.5));
  double last = 0;
  for (int i = 0; i <= 100; ++i) {
    const double light = contrast(map_colour(i / 100.0), "#000000");
    EXPECT_GT(light, last);
    last = light;
  }
}

TEST(Palette, CurvesAreOneAndAHalfPxWideAndGridLinesThin) {
  for (const RoleStyle& style : palette()) {
    if (style.role == "exact" || style.role == "measured" || style.role == "fitted" ||
        style.role == "set-aside")
      continue;
    EXPECT_EQ(style.width, 1.5) << style.role;
  }
  EXPECT_EQ(style_of("set-aside").width, 1);
  EXPECT_EQ(style_of("grid").width, 0.8);
  EXPECT_EQ(style_of("no such role").width, 1.5);
  EXPECT_EQ(style_of("positive").dash[0], 8);
  EXPECT_EQ(style_of("negative").dash[0], 3);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
