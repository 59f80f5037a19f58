#include "cromer/report/html_text.h"

#include <gtest/gtest.h>

#include <string>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Escaped, NothingEndsAnAttributeOrATag) {
  EXPECT_EQ(escaped("a&<>\"'b"), "a&amp;&lt;&gt;&quot;&#39;b");
  for (int c = 1; c < 32; ++c) {
    const bool kept = c == '\n' || c == '\t';
    EXPECT_EQ(well_formed("a" + std::string(1, static_cast<char>(c)) + "b").size(), kept ? 3u : 6u) << c;
  }
  EXPECT_EQ(escaped(" µ"), " µ");
}

TEST(WellFormed, NoncharactersAreReplacedWhereverTheyStand) {
  EXPECT_EQ(well_formed("\xEF\xBF\xBE"
                        "a"
                        "\xEF\xBF\xBF\xEF\xBF\xBE"),
            "\uFFFDa\uFFFD\uFFFD");
  EXPECT_EQ(well_formed("\xEF\xBF\xBD\xff"), "\uFFFD\uFFFD");
}

TEST(WellFormed, WhatIsHiddenOrTurnsTheWritingIsSpelledOut) {
  EXPECT_EQ(well_formed("a\u202Eb\u2066c\u009Bd\x7F"
                        "e\x1B[0m"),
            "a\\u202eb\\u2066c\\x9bd\\x7fe\\x1b[0m");
}

TEST(PageText, AMarkWithoutItsOtherEndIsAStar) {
  for (const char* text :
       {"*", "**", "****", "a *", "* a*", "*a *", "** a**", "**a **", "a * b", "`", "a_", "a^", "x_{a", "x^"})
    EXPECT_EQ(inline_html(text), text);
  EXPECT_EQ(inline_html("*a * b*"), "<em>a * b</em>");
  EXPECT_EQ(inline_html("**a** b*"), "<strong>a</strong> b*");
}

TEST(PageText, MarksNest) {
  EXPECT_EQ(inline_html("*a **b** c*"), "<em>a <strong>b</strong> c</em>");
  EXPECT_EQ(inline_html("*a**b**c*"), "<em>a<strong>b</strong>c</em>");
  EXPECT_EQ(inline_html("*a `*` b*"), "<em>a <code>*</code> b</em>");
  EXPECT_EQ(inline_html("*a`*b`c*"), "<em>a<code>*b</code>c</em>");
  EXPECT_EQ(inline_html("*a ` b*"), "<em>a ` b</em>");
  EXPECT_EQ(inline_html("**a *b* c** d"), "<strong>a <em>b</em> c</strong> d");
  EXPECT_EQ(inline_html("*a*b*c*"), "<em>a</em>b<em>c</em>");
  EXPECT_EQ(inline_html("x_{a_{b}}c"), "x<sub>a<sub>b</sub></sub>c");
  EXPECT_EQ(inline_html("x_{*a*}"), "x<sub><em>a</em></sub>");
}

TEST(PageText, SubAndSuperscriptStandAboveEachOtherInEitherOrder) {
  const std::string both = "<span class=\"both\"><sup>2</sup><sub>d</sub></span>";
  EXPECT_EQ(inline_html("x_{d}^{2}y"), "x" + both + "y");
  EXPECT_EQ(inline_html("x^{2}_{d}y"), "x" + both + "y");
  EXPECT_EQ(inline_html("x_{d}^"), "x<sub>d</sub>^");
  EXPECT_EQ(inline_html("x_{d}^{2"), "x<sub>d</sub>^{2");
  EXPECT_EQ(inline_html("x_{d}_{2}"), "x<sub>d</sub><sub>2</sub>");
  EXPECT_EQ(inline_html("x^{2}^{3}"), "x<sup>2</sup><sup>3</sup>");
}

TEST(PageText, EveryUnitStaysWithItsNumber) {
  for (const char* unit :
       {"m",    "cm",   "mm",   "µm",   "s",    "ms",  "µs",   "min", "kg",    "g",   "mg",  "N",
        "mN",   "N/m",  "J",    "mJ",   "µJ",   "Hz",  "kHz",  "rad", "rad/s", "1/s", "1/m", "m/s",
        "cm/s", "mm/s", "m/s²", "kg/s", "kg/m", "g/s", "N/m³", "°C",  "°",     "V",   "K",   "%"}) {
    const std::string word = unit;
    EXPECT_EQ(inline_html("3 " + word), "3\u00A0" + word);
    EXPECT_EQ(inline_html("a 3 " + word + ", b"), "a 3\u00A0" + word + ", b");
    EXPECT_EQ(inline_html("(17 ± 2) " + word + ".)"), "(17\u00A0±\u00A02)\u00A0" + word + ".)");
    EXPECT_EQ(inline_html("3 " + word + "\nnext"), "3\u00A0" + word + "\nnext");
  }
  for (const char* text : {" m", "3 ", "a m", "3 metres", "m 3", "3 .", "3 (m)"})
    EXPECT_EQ(inline_html(text), text);
  EXPECT_EQ(inline_html("2 × 3"), "2\u00A0×\u00A03");
  EXPECT_EQ(inline_html("± 3"), "±\u00A03");
  EXPECT_EQ(inline_html("0 s 9 s"), "0\u00A0s 9\u00A0s");
}

TEST(PageText, AFormulaStaysOnItsLine) {
  EXPECT_EQ(inline_html("so k = m / C here"), "so k\u00A0=\u00A0m\u00A0/\u00A0C here");
  EXPECT_EQ(inline_html("and/or a =b"), "and/or a\u00A0=b");
}

TEST(PageText, NumbersHaveMinusSignsAndPowersOfTen) {
  EXPECT_EQ(inline_html("-0.199 N/m (-3)"), "−0.199\u00A0N/m (−3)");
  EXPECT_EQ(inline_html("3.5e-05 m"), "3.5\u00A0×\u00A010⁻⁵\u00A0m");
  EXPECT_EQ(inline_html("-2e+10."), "−2\u00A0×\u00A010¹⁰.");
  for (const char* text :
       {"2-3", "2026-11-29", "ISO 18431-4", "a-1", "3e5", "3e-5x", "- 3", "-x", "-3rd", "1e-"})
    EXPECT_EQ(inline_html(text), text);
  EXPECT_EQ(plain_words("3.5e-05 m"), "3.5\u00A0×\u00A010⁻⁵\u00A0m");
}

TEST(PageText, AnOptionIsCodeAndStaysOnItsLine) {
  EXPECT_EQ(inline_html("(--from, --disc-diameter 3 cm)"),
            "(<code>--from</code>, <code>--disc-diameter</code> 3\u00A0cm)");
  EXPECT_EQ(inline_html("`cromer fit --mass 3`"), "<code>cromer fit --mass 3</code>");
  for (const char* text : {"--", "a--b", "-- a", "---", "--5"}) EXPECT_EQ(inline_html(text), text);
}

TEST(PageText, ALineEndIsABlankAndAnEmptyLineAParagraph) {
  EXPECT_EQ(paragraphs_html("a"), "<p>a</p>\n");
  EXPECT_EQ(paragraphs_html("\n\na\r\n b\t\n \t\nc"), "<p>a b</p>\n<p>c</p>\n");
  EXPECT_EQ(paragraphs_html(""), "");
  EXPECT_EQ(plain_words("**a** x_{0} > `b`"), "a x0 &gt; b");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
