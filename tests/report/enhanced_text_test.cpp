// What the markup of names means, and that any text can be read.
#include "cromer/report/enhanced_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cromer::core {

// What gtest prints of a run that is not the expected one.
void PrintTo(const TextRun& run, std::ostream* out) {
  *out << '"' << run.text << "\" italic " << run.italic << " bold " << run.bold << " size " << run.size
       << " rise " << run.rise;
}

namespace {

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

}  // namespace
}  // namespace cromer::core
