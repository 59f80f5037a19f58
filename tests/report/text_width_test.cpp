#include "cromer/report/text_width.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace {

double thousandths(std::string_view text) { return text_width(text, 1000, false, Typeface::dejavu_sans); }

TEST(TextWidth, AddsUpToTheAdvancesInDejaVuSans) {
  // From the font's table hmtx (DejaVuSans.ttf 2.37), each in thousandths of its size, rounded.
  EXPECT_NEAR(thousandths("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), 17490, 1e-6);
  EXPECT_NEAR(thousandths("abcdefghijklmnopqrstuvwxyz"), 14649, 1e-6);
  EXPECT_NEAR(thousandths("0123456789"), 6360, 1e-6);
  EXPECT_NEAR(thousandths(" !\"#$%&'()*+,-./:;<=>?@[]`|~") + thousandths("\\\\\\^\\_\\{\\}"), 18231, 1e-6);
  EXPECT_NEAR(thousandths("\u00A0"), thousandths(" "), 1e-9);
  EXPECT_NEAR(thousandths("ω"), 720, 1e-9);
  EXPECT_NEAR(thousandths("ωω"), 1440, 1e-9);
}

TEST(TextWidth, GrowsWithSizeWeightAndFont) {
  const double one = text_width("Mass", 1, false, Typeface::dejavu_sans);
  EXPECT_DOUBLE_EQ(text_width("Mass", 12, false, Typeface::dejavu_sans), 12 * one);
  EXPECT_DOUBLE_EQ(text_width("Mass", 1, true, Typeface::dejavu_sans), 1.13 * one);
  EXPECT_DOUBLE_EQ(text_width("Mass", 1, false, Typeface::lato), 0.91 * one);
  EXPECT_DOUBLE_EQ(text_width("Mass", 1, true, Typeface::lato), 0.92 * one);
  EXPECT_DOUBLE_EQ(text_width("{/:Bold Mass}Mass", 1, false, Typeface::lato), (0.92 + 0.91) * one);
}

TEST(TextWidth, SubscriptsAreFourFifths) {
  const double x = thousandths("x"), zero = thousandths("0");
  EXPECT_DOUBLE_EQ(thousandths("x_0"), x + 0.8 * zero);
  EXPECT_DOUBLE_EQ(thousandths("x^{00}x"), 2 * x + 1.6 * zero);
  EXPECT_DOUBLE_EQ(thousandths("x_{0{/:Italic 0}}0"), x + 2.6 * zero);
  EXPECT_DOUBLE_EQ(thousandths("{x}0"), x + zero);
  EXPECT_DOUBLE_EQ(thousandths("x_{0}^{0}0"), x + 2.6 * zero);
  EXPECT_DOUBLE_EQ(thousandths("x^{0_0}"), x + (0.8 + 0.64) * zero);
}

TEST(Wrapped, ALineThatJustFitsStays) {
  const double room = text_width("aa bb", 10, false, Typeface::lato);
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("aa bb", 10, false, Typeface::lato, room), Lines{"aa bb"});
  EXPECT_EQ(wrapped("aa bb", 10, false, Typeface::lato, room - 0.01), (Lines{"aa", "bb"}));
  EXPECT_EQ(wrapped("aa bb aa bb", 10, false, Typeface::lato, room), (Lines{"aa bb", "aa bb"}));
  EXPECT_EQ(wrapped("wwwwwwww a", 10, false, Typeface::lato, 1), (Lines{"wwwwwwww", "a"}));
  EXPECT_EQ(wrapped("", 10, false, Typeface::lato, room), Lines{""});
  EXPECT_EQ(wrapped("a\n\nb", 10, false, Typeface::lato, room), (Lines{"a", "", "b"}));
  EXPECT_EQ(wrapped("{a b} {c {d e} f} g", 10, false, Typeface::lato, 1),
            (Lines{"{a b}", "{c {d e} f}", "g"}));
  EXPECT_EQ(wrapped("a\\{ b", 10, false, Typeface::lato, 1), (Lines{"a\\{", "b"}));
  EXPECT_EQ(wrapped("a} b", 10, false, Typeface::lato, 1), (Lines{"a}", "b"}));
  EXPECT_EQ(wrapped("{a\nb c", 10, false, Typeface::lato, 1), (Lines{"{a", "b c"}));
}

}  // namespace
}  // namespace cromer::core
