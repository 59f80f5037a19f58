// From a figure to the bytes of its picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "cromer/documents/words/words.h"
#include "cromer/report/figure.h"
#include "cromer/report/layout.h"
#include "cromer/report/librsvg.h"
#include "tests/report/example_figures.h"
#include "tests/support/xml.h"

// fontconfig reaches its patterns by offsets, which the leak sanitizer cannot follow.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::vector<double>> paths_of(const std::string& svg, const std::string& colour) {
  std::vector<std::vector<double>> paths;
  const std::string begin = "<path stroke=\"" + colour + "\"";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos; ++at) {
    const std::size_t d = svg.find(" d=\"M", at) + 5;
    std::vector<double>& numbers = paths.emplace_back();
    for (const char* p = svg.c_str() + d; *p != '"';) {
      char* end = nullptr;
      const double value = std::strtod(p, &end);
      if (end != p) numbers.push_back(value);
      p = end != p ? end : p + 1;
    }
  }
  return paths;
}

TEST(Draw, TheCurvePassesWhereTheDataAre) {
  Figure figure;
  Panel& panel = figure.panels.emplace_back();
  Curve& curve = panel.curves.emplace_back();
  curve.role = "euler-cromer";
  curve.x = {0, 2, 5, 10};
  curve.y = {-0.9, 0.9, 0.1, 0.5};
  const auto svg = draw(figure, FigureFormat::svg);
  ASSERT_TRUE(svg.ok());
  const Box f = lay_out(figure, Typeface::dejavu_sans).panels[0].frame;
  const auto paths = paths_of(*svg, "#0072B2");
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(paths[0][2 * i], f.x + f.width * curve.x[i] / 10, 0.01) << i;
    EXPECT_NEAR(paths[0][2 * i + 1], f.y + f.height * (1 - curve.y[i]) / 2, 0.01) << i;
  }
}

TEST(Draw, EveryExampleIsASmallSvgThatCanStandInAPage) {
  for (const Figure& figure : examples()) {
    const auto svg = draw(figure, FigureFormat::svg);
    ASSERT_TRUE(svg.ok()) << in_words(svg.error());
    EXPECT_EQ(test::xml_fault(*svg), "");
    EXPECT_LT(svg->size(), 150000u);
    EXPECT_THAT(*svg, HasSubstr("aria-label=\"What is seen: x &amp; more\""));
    EXPECT_THAT(
        *svg, HasSubstr("font-family=\"'Segoe UI', -apple-system, Roboto, 'Noto Sans', Lato, sans-serif\""));
    EXPECT_THAT(*svg, Not(HasSubstr(" id=")));
    for (const Panel& panel : figure.panels)
      for (const Curve& curve : panel.curves) EXPECT_THAT(*svg, HasSubstr(curve.name));
  }
}

TEST(Draw, ABlankAfterAnExponentIsSeen) {
  Figure figure = of({three_methods()});
  const auto picture = [&](const char* note) {
    figure.note = note;
    return draw(figure, FigureFormat::png);
  };
  if (!picture("")) GTEST_SKIP() << in_words(picture("").error());
  EXPECT_NE(*picture("10^{-3} s"), *picture("10^{-3}s"));
}

TEST(Draw, AFigureWithoutTitleIsCalledByItsId) {
  Figure figure = of({three_methods()});
  figure.title = "";
  EXPECT_THAT(*draw(figure, FigureFormat::svg), HasSubstr("aria-label=\"figure-1\""));
}

TEST(Draw, IsWellFormedWhateverTheNames) {
  for (const std::string name :
       {"a]]>b", "x<y>z & \"q\"", "\x1b[31mred\a", "broken \xff\xc3", "\xEF\xBF\xBE", "it's `x` $(y)"}) {
    Figure figure = of({three_methods()});
    figure.title = name;
    for (std::string* text :
         {&figure.panels[0].curves[0].name, &figure.panels[0].x.name, &figure.panels[0].title})
      *text = name;
    const auto svg = draw(figure, FigureFormat::svg);
    ASSERT_TRUE(svg.ok()) << in_words(svg.error());
    EXPECT_EQ(test::xml_fault(*svg), "") << name;
  }
}

/// Its big-endian number at `at`.
unsigned png_number(const std::string& png, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(png.at(i));
  return value;
}

bool is_missing(const Result<std::string>& picture) {
  return !picture && picture.error().notice.code == "librsvg_is_missing";
}

TEST(Draw, APngHasTwoPxForEachOfTheFigures) {
  const auto png = draw(examples()[2], FigureFormat::png);
  if (is_missing(png)) GTEST_SKIP() << in_words(png.error());
  ASSERT_TRUE(png.ok()) << in_words(png.error());
  EXPECT_THAT(*png, StartsWith("\x89PNG\r\n"));
  EXPECT_EQ(png_number(*png, 16), 960u);
  EXPECT_EQ(png_number(*png, 20), 880u);
  EXPECT_GT(png->size(), 20000u);
}

TEST(Draw, APdfHasThreeQuartersOfAPointForEachPx) {
  const auto pdf = draw(examples()[0], FigureFormat::pdf);
  if (is_missing(pdf)) GTEST_SKIP() << in_words(pdf.error());
  ASSERT_TRUE(pdf.ok()) << in_words(pdf.error());
  EXPECT_THAT(*pdf, StartsWith("%PDF-"));
  EXPECT_THAT(*pdf, HasSubstr("/MediaBox [ 0 0 570 330 ]"));
  EXPECT_THAT(*pdf, HasSubstr(is_installed("Lato") ? "+Lato" : "+DejaVu"));
  EXPECT_THAT(*pdf, testing::EndsWith("%%EOF\n"));
}

TEST(Draw, AMapIsAPictureOfAFewBytesForEachCell) {
  Figure mapped;
  Panel& panel = mapped.panels.emplace_back();
  panel.map = HeatMap{.x = {0, 1}, .y = {0, 1}, .z = {0, 1, 2, NAN}, .name = "z"};
  const auto svg = draw(mapped, FigureFormat::svg);
  ASSERT_TRUE(svg.ok());
  EXPECT_THAT(*svg, HasSubstr("href=\"data:image/png;base64,"));
  EXPECT_LT(svg->size(), 10000u);
}

TEST(InstalledFont, IsNoneThatHasAnInventedName) { EXPECT_FALSE(is_installed("No Such Font 7")); }

TEST(SharedLibrary, WhatIsMissingIsNotFound) {
  int (*function)() = nullptr;
  EXPECT_FALSE(find_function("libno-such-library.so.7", "f", function));
  EXPECT_FALSE(find_function("libc.so.6", "no_such_function_7", function));
  EXPECT_TRUE(find_function("libc.so.6", "getpid", function));
  EXPECT_GT(function(), 0);
}

TEST(FigureFormat, IsTheEndingOfTheName) {
  EXPECT_EQ(*figure_format("a.b/plot.svg"), FigureFormat::svg);
  EXPECT_EQ(*figure_format("A.SVG"), FigureFormat::svg);
  EXPECT_EQ(*figure_format("PLOT.PNG"), FigureFormat::png);
  EXPECT_EQ(*figure_format("z.PdF"), FigureFormat::pdf);
}

TEST(FigureFormat, NeedsANameBeforeAKnownEnding) {
  for (const char* path : {"x.jpg", ".svg", ".pdf", "svg", "a.svgz"})
    EXPECT_FALSE(figure_format(path).ok()) << path;
  EXPECT_EQ(in_words(figure_format("x.jpg").error()),
            "\"x.jpg\" names no figure: end it with .svg, .png or .pdf");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
