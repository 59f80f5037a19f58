// Each element of the SVG, to the letter.
#include "cromer/report/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/heat_map.h"
#include "tests/support/xml.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using testing::StartsWith;

/// Of a 100 x 60 picture; the frame alone is drawn.
PlacedPanel empty_panel() {
  PlacedPanel panel;
  panel.frame = {10, 5, 80, 40};
  return panel;
}

std::string svg_of(const PlacedPanel& panel) {
  const std::string svg = to_svg({100, 60, {panel}}, "t", "serif");
  EXPECT_EQ(test::xml_fault(svg), "");
  return svg;
}

const std::string frame_line = "<path stroke=\"#7B8594\" stroke-width=\"0.8\" d=\"M10 5 10 45 90 45\"/>\n";

/// What is drawn after the frame.
std::string drawn(const PlacedPanel& panel) {
  const std::string svg = svg_of(panel);
  const std::size_t from = svg.find(frame_line) + frame_line.size();
  return svg.substr(from, svg.rfind("</svg>") - from);
}

PlacedCurve line(std::vector<Spot> spots) {
  PlacedCurve curve;
  curve.pieces = {std::move(spots)};
  curve.colour = "#0072B2";
  return curve;
}

std::string drawn(const PlacedCurve& curve) {
  PlacedPanel panel = empty_panel();
  panel.curves = {curve};
  return drawn(panel);
}

PlacedText words(const std::string& text) {
  PlacedText placed;
  placed.text = text;
  placed.at = {20, 30};
  placed.size = 10;
  placed.colour = "#171C24";
  placed.box = {20, 24, 30, 12};
  return placed;
}

std::string drawn(const PlacedText& text) {
  PlacedPanel panel = empty_panel();
  panel.texts = {text};
  return drawn(panel);
}

TEST(Svg, IsOneFlatElementOnWhite) {
  EXPECT_EQ(
      to_svg({100, 60.5, {}}, "x < \"y\"", "'A b', serif"),
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 60.5\" width=\"100\" height=\"60.5\" "
      "role=\"img\" aria-label=\"x &lt; &quot;y&quot;\" font-family=\"'A b', serif\" "
      "stroke-linejoin=\"round\" fill=\"none\" xml:space=\"preserve\">\n"
      "<rect fill=\"#FFFFFF\" x=\"0\" y=\"0\" width=\"100\" height=\"60.5\"/>\n</svg>\n");
}

TEST(Svg, WithoutDataTheFrameAloneIsDrawn) {
  EXPECT_EQ(drawn(empty_panel()), "");
  PlacedCurve nothing;
  EXPECT_EQ(drawn(nothing), "");
  nothing.mark = Mark::dots;
  EXPECT_EQ(drawn(nothing), "");
  nothing.pieces = {{}};
  EXPECT_EQ(drawn(nothing), "");
  nothing.mark = Mark::band;
  EXPECT_EQ(drawn(nothing), "");
  EXPECT_EQ(drawn(words("")), "");
  EXPECT_EQ(drawn(words("{/:Italic }")), "");
}

TEST(Svg, AFrameTooNarrowForAPxOfItsMapHasTheBarAlone) {
  PlacedPanel panel = empty_panel();
  panel.map = PlacedMap{0, 40, {}, {95, 5, 4, 40}};
  EXPECT_THAT(drawn(panel), StartsWith("<image style=\"image-rendering:pixelated\" "
                                       "preserveAspectRatio=\"none\" x=\"95\""));
}

TEST(Svg, TheGridStandsAtNumbersAloneAndTicksPointOutwards) {
  PlacedPanel panel = empty_panel();
  panel.x_ticks = {{30, false}, {40, true}};
  panel.y_ticks = {{20, false}, {25, true}};
  EXPECT_THAT(svg_of(panel),
              HasSubstr("height=\"60\"/>\n"
                        "<path stroke=\"#E4E8ED\" stroke-width=\"0.7\" d=\"M10 20 90 20M30 45 30 5\"/>\n"
                        "<path stroke=\"#7B8594\" stroke-width=\"0.8\" d=\"M10 20 5.1 20M10 25 7.6 25"
                        "M30 45 30 49.9M40 45 40 47.4M10 5 10 45 90 45\"/>\n</svg>"));
}

TEST(Svg, EveryPanelIsDrawnFromTheGridToItsWords) {
  PlacedPanel panel = empty_panel();
  panel.zero_lines = {{{10, 25}, {90, 25}, "#C3CAD3", 0.8, {}}};
  panel.curves = {line({{10, 40}, {90, 40}}), line({{10, 41}, {90, 41}})};
  panel.leaders = {{{30, 30}, {40.126, 40}, "#626C7A", 1, {6, 4, 0, 0}}};
  panel.rings = {{50, 20}};
  panel.dots = {{51, 21}};
  panel.texts = {words("a"), words("b")};
  panel.texts[1].ground = true;
  panel.map = PlacedMap{1, 1, {0.5}, {95, 5, 4, 40}};
  const std::string picture =
      "<image style=\"image-rendering:pixelated\" preserveAspectRatio=\"none\" x=\"10\" y=\"5\" width=\"80\" "
      "height=\"40\" href=\"data:image/png;base64," +
      base64(map_png({0.5}, 1, 1)) + "\"/>\n";
  std::vector<double> shares;
  for (int i = 0; i < 255; ++i) shares.push_back(i / 254.0);
  const std::string bar =
      "<image style=\"image-rendering:pixelated\" preserveAspectRatio=\"none\" x=\"95\" y=\"5\" width=\"4\" "
      "height=\"40\" href=\"data:image/png;base64," +
      base64(map_png(shares, 1, 255)) + "\"/>\n";
  const std::string once =
      frame_line + "<path stroke=\"#C3CAD3\" stroke-width=\"0.8\" d=\"M10 25 90 25\"/>\n" + picture +
      "<path stroke=\"#0072B2\" stroke-width=\"1.3\" d=\"M10 40 90 40\"/>\n"
      "<path stroke=\"#0072B2\" stroke-width=\"1.3\" d=\"M10 41 90 41\"/>\n" +
      bar +
      "<path stroke=\"#626C7A\" stroke-width=\"1\" stroke-dasharray=\"6 4\" d=\"M30 30 40.13 40\"/>\n"
      "<circle stroke=\"#171C24\" stroke-width=\"1.3\" cx=\"50\" cy=\"20\" r=\"4.5\"/>\n"
      "<circle fill=\"#171C24\" cx=\"51\" cy=\"21\" r=\"2.6\"/>\n"
      "<rect fill=\"#FFFFFF\" x=\"18\" y=\"24\" width=\"34\" height=\"12\"/>\n"
      "<text x=\"20\" y=\"33.25\" fill=\"#171C24\" font-size=\"10\">a</text>\n"
      "<text x=\"35\" y=\"33.25\" fill=\"#171C24\" font-size=\"10\" text-anchor=\"middle\">b</text>\n";
  EXPECT_THAT(to_svg({100, 60, {panel, panel}}, "t", "serif"), HasSubstr(once + once + "</svg>"));
}

TEST(Svg, NumbersHaveTwoDecimalsAtMost) {
  EXPECT_EQ(drawn(line({{10.004, 20.5}, {30.128, 44.996}})),
            "<path stroke=\"#0072B2\" stroke-width=\"1.3\" d=\"M10 20.5 30.13 45\"/>\n");
  PlacedPanel panel = empty_panel();
  panel.dots = {{-0.001, 100}};
  EXPECT_THAT(drawn(panel), HasSubstr("cx=\"0\" cy=\"100\""));
}

TEST(Svg, ALineIsCutAtTheFrameAndItsPiecesAreOnePath) {
  PlacedCurve curve = line({{20, 40}, {20, 3000}});
  curve.pieces.push_back({{30, 10}});
  curve.pieces.push_back({{40, 10}, {50, 20}, {60, 10}});
  curve.dash = {8, 3, 2, 3};
  curve.width = 1.5;
  EXPECT_EQ(drawn(curve),
            "<path stroke=\"#0072B2\" stroke-width=\"1.5\" stroke-dasharray=\"8 3 2 3\" "
            "d=\"M20 40 20 45.01M40 10 50 20 60 10\"/>\n");
}

TEST(Svg, DotsAreLinesOfNoLengthWithRoundEnds) {
  PlacedCurve curve = line({{20, 40}, {20, 46}, {30.5, 10}});
  curve.mark = Mark::dots;
  curve.width = 2.6;
  EXPECT_EQ(
      drawn(curve),
      "<path stroke=\"#0072B2\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M20 40h0M30.5 10h0\"/>\n");
}

TEST(Svg, DotsOnALineAreLarger) {
  PlacedCurve curve = line({{20, 40}, {30, 10}});
  curve.dots = {{20, 40}, {5, 10}};
  EXPECT_EQ(drawn(curve),
            "<path stroke=\"#0072B2\" stroke-width=\"1.3\" d=\"M20 40 30 10\"/>\n"
            "<path stroke=\"#0072B2\" stroke-width=\"5.2\" stroke-linecap=\"round\" d=\"M20 40h0\"/>\n");
}

TEST(Svg, ABandIsAPolygonForEachPiece) {
  PlacedCurve curve = line({});
  curve.mark = Mark::band;
  curve.band = {
      {20, 30, NAN, 40, 50, NAN, 60}, {40, 41, NAN, 50, 43, NAN, 44}, {10, 11, NAN, 2, 13, NAN, 14}};
  EXPECT_EQ(drawn(curve),
            "<polygon fill=\"#0072B2\" fill-opacity=\"0.2\" points=\"20 40 30 41 30 11 20 10\"/>\n"
            "<polygon fill=\"#0072B2\" fill-opacity=\"0.2\" points=\"40 45 50 43 50 13 40 5\"/>\n");
}

TEST(Svg, AWordStandsOnTheSideItIsSaidTo) {
  PlacedText text = words("a");
  text.align = Align::right;
  EXPECT_THAT(
      drawn(text),
      StartsWith("<text x=\"20\" y=\"33.25\" fill=\"#171C24\" font-size=\"10\" text-anchor=\"end\">"));
  text.align = Align::centre;
  EXPECT_THAT(drawn(text), HasSubstr(" text-anchor=\"middle\">"));
  text.bold = true;
  text.size = 12.345;
  EXPECT_EQ(drawn(text),
            "<text x=\"20\" y=\"34.01\" fill=\"#171C24\" font-size=\"12.35\" font-weight=\"bold\" "
            "text-anchor=\"middle\">a</text>\n");
}

TEST(Svg, AWordThatReadsUpwardsIsTurned) {
  PlacedText text = words("a");
  text.rotated = true;
  EXPECT_EQ(
      drawn(text),
      "<text transform=\"translate(23.25 30) rotate(-90)\" fill=\"#171C24\" font-size=\"10\">a</text>\n");
}

TEST(Svg, RunsAreSpansAndTheBaselineComesBack) {
  EXPECT_THAT(drawn(words("a{/:Italic x}_{0}b^{/:Bold 2}")),
              HasSubstr(">a<tspan font-style=\"italic\">x</tspan><tspan font-size=\"8\" dy=\"3\">0</tspan>"
                        "<tspan dy=\"-3\">b</tspan><tspan font-weight=\"bold\" font-size=\"8\" "
                        "dy=\"-5\">2</tspan></text>"));
  EXPECT_THAT(
      drawn(words("x_0^1")),
      HasSubstr(
          ">x<tspan font-size=\"8\" dy=\"3\">0</tspan><tspan font-size=\"8\" dy=\"-8\">1</tspan></text>"));
}

TEST(Svg, WordsAreEscapedAndWellFormed) {
  EXPECT_THAT(drawn(words("a<b & {/:Italic \"c\"} ]]>")),
              HasSubstr(">a&lt;b &amp; <tspan font-style=\"italic\">&quot;c&quot;</tspan> ]]&gt;</text>"));
  EXPECT_THAT(drawn(words("\x1b[31m \xff")), HasSubstr("\\x1b[31m \uFFFD"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
