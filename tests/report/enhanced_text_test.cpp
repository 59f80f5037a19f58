// What the markup of names means, that any text can be read, and how wide it is.
#include "cromer/report/enhanced_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cromer::core {

// What gtest prints of a run that is not the expected one.
void PrintTo(const TextRun& run, std::ostream* out) {
  *out << '"' << run.text << "\" italic " << run.italic << " bold " << run.bold << " size " << run.size
       << " rise " << run.rise;
}

namespace CROMER_FILE {

using testing::ElementsAre;

TEST(EnhancedText, PlainTextIsOneRun) {
  EXPECT_THAT(runs_of("time (s) × ω"), ElementsAre(TextRun{"time (s) × ω"}));
  EXPECT_THAT(runs_of("{a}{b}c"), ElementsAre(TextRun{"abc"}));
  EXPECT_TRUE(runs_of("").empty());
}

TEST(EnhancedText, ItalicAndBoldEndWithTheirBrace) {
  EXPECT_THAT(runs_of("a {/:Italic b c} d"),
              ElementsAre(TextRun{"a "}, TextRun{.text = "b c", .italic = true}, TextRun{" d"}));
  EXPECT_THAT(runs_of("{/:Bold b{/:Italic c}}d"),
              ElementsAre(TextRun{.text = "b", .bold = true},
                          TextRun{.text = "c", .italic = true, .bold = true}, TextRun{"d"}));
  EXPECT_THAT(runs_of("{/Symbol w}{/*1.2 x}"), ElementsAre(TextRun{"wx"}));
}

TEST(EnhancedText, ScriptsAreFourFifthsAndStandAboveOrBelow) {
  const auto above = [](const char* text) { return TextRun{.text = text, .size = 0.8, .rise = 0.5}; };
  const auto below = [](const char* text) { return TextRun{.text = text, .size = 0.8, .rise = -0.3}; };
  EXPECT_THAT(runs_of("x_{01}y^23"),
              ElementsAre(TextRun{"x"}, below("01"), TextRun{"y"}, above("2"), TextRun{"3"}));
  EXPECT_THAT(runs_of("10^−3"), ElementsAre(TextRun{"10"}, above("−"), TextRun{"3"}));
  EXPECT_THAT(runs_of("_\\{b"), ElementsAre(below("{"), TextRun{"b"}));
  EXPECT_THAT(runs_of("x_{/:Italic i}"),
              ElementsAre(TextRun{"x"}, TextRun{.text = "i", .italic = true, .size = 0.8, .rise = -0.3}));
  const auto nested = runs_of("e^{a_b}");
  ASSERT_EQ(nested.size(), 3u);
  EXPECT_DOUBLE_EQ(nested[2].size, 0.64);
  EXPECT_DOUBLE_EQ(nested[2].rise, 0.5 - 0.8 * 0.3);
}

TEST(EnhancedText, WhatIsNoMarkupIsSeen) {
  for (const char* text : {"a_", "a^", "a\\", "a @ & ~ b"}) EXPECT_EQ(without_markup(text), text);
  EXPECT_EQ(without_markup("}a}"), "a");
  EXPECT_EQ(without_markup("{/Symbol"), "");
  EXPECT_EQ(without_markup("{"), "");
  EXPECT_EQ(without_markup("_{"), "");
  EXPECT_EQ(without_markup("a\nb"), "a b");
  EXPECT_EQ(without_markup("x_{0}y^2\u00e4{/:Bold b c}"), "x0y2\u00e4b c");
  EXPECT_EQ(without_markup("\xC3^\x80"), "\xC3\x80");
}

TEST(EnhancedText, AnyTextCanBeMeantAsItStands) {
  EXPECT_EQ(figure_text("a\\{}_^@&~b"), "a\\\\\\{\\}\\_\\^@&~b");
  EXPECT_THAT(runs_of(figure_text("{/:Bold x}_0^{2}\\")), ElementsAre(TextRun{"{/:Bold x}_0^{2}\\"}));
}

double thousandths(std::string_view text, Typeface typeface = Typeface::dejavu_sans) {
  return text_width(text, 1000, false, typeface);
}

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

TEST(TextWidth, AddsUpToTheAdvancesInLato) {
  // From the font's table hmtx (Lato-Regular.ttf 2.015), likewise.
  EXPECT_NEAR(thousandths("ABCDEFGHIJKLMNOPQRSTUVWXYZ", Typeface::lato), 17241, 1e-6);
  EXPECT_NEAR(thousandths("abcdefghijklmnopqrstuvwxyz", Typeface::lato), 12823, 1e-6);
  EXPECT_NEAR(thousandths("0123456789", Typeface::lato), 5800, 1e-6);
  EXPECT_NEAR(thousandths("\u00A0", Typeface::lato), 256, 1e-9);
}

TEST(TextWidth, GrowsWithSizeWeightAndFont) {
  const double one = text_width("Mass", 1, false, Typeface::dejavu_sans);
  EXPECT_DOUBLE_EQ(text_width("Mass", 12, false, Typeface::dejavu_sans), 12 * one);
  EXPECT_DOUBLE_EQ(text_width("Mass", 1, true, Typeface::dejavu_sans), 1.13 * one);
  const double lato = text_width("Mass", 1, false, Typeface::lato);
  EXPECT_LT(lato, one);
  EXPECT_DOUBLE_EQ(text_width("Mass", 1, true, Typeface::lato), 1.02 * lato);
  EXPECT_DOUBLE_EQ(text_width("{/:Bold Mass}Mass", 1, false, Typeface::lato), 2.02 * lato);
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

}  // namespace CROMER_FILE
}  // namespace cromer::core
