// What of gnuplot's SVG stays, and in which words.
#include "cromer/report/tidy_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cromer {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string tidied(const std::string& inner) {
  const std::string svg = tidy_svg("<svg viewBox=\"0 0 100.00 50.50\">" + inner + "</svg>", "t");
  const std::size_t from = svg.find(">\n") + 2;
  return svg.substr(from, svg.rfind("</svg>") - from);
}

TEST(TidySvg, KeepsTheSize) {
  const std::string svg = tidy_svg("<svg width='9' viewBox='0 0 100.00 50.50'></svg>", "t");
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 100 50.5\" width=\"100\" height=\"50.5\" role=\"img\""));
  EXPECT_THAT(tidy_svg("<svg viewBox='0 0 1'></svg>", "t"), HasSubstr("viewBox=\"0 0 0 0\""));
}

TEST(TidySvg, ShapesKeepTheirPlaceAndColour) {
  EXPECT_EQ(tidied("<rect x='1.50' y='2' width='3' height='4' fill='rgb(255, 0, 10)' id='x'/>"),
            "<rect fill=\"#FF000A\" x=\"1.50\" y=\"2\" width=\"3\" height=\"4\"/>\n");
  EXPECT_EQ(tidied("<circle cx='1' cy='2' r='3' fill='none' stroke='black'/>"),
            "<circle cx=\"1\" cy=\"2\" r=\"3\"/>\n");
  EXPECT_EQ(tidied("<g stroke='black' stroke-width='0.80'><circle cx='1' cy='2' r='3' fill='none'/></g>"),
            "<circle stroke=\"#000000\" stroke-width=\"0.8\" cx=\"1\" cy=\"2\" r=\"3\"/>\n");
  EXPECT_EQ(tidied("<polygon points='1.00,2.50 -0.001,4 7,8' fill='#abc' fill-opacity='0.20'/>"),
            "<polygon fill=\"#abc\" fill-opacity=\"0.2\" points=\"1 2.5 0 4 7 8\"/>\n");
  EXPECT_EQ(tidied("<g stroke='none'><polyline points='1,2'/></g>"), "<polyline points=\"1 2\"/>\n");
  EXPECT_EQ(tidied("<g stroke='none'><path stroke='rgb(1,2,3)' stroke-dasharray='3,4' d='M0,0'/></g>"),
            "<path stroke=\"#010203\" stroke-width=\"1\" stroke-dasharray=\"3,4\" d=\"M0 0\"/>\n");
  EXPECT_EQ(tidied("<g color='rgb(1,2,3)' stroke='currentColor'><path d='M0,0'/></g>"),
            "<path stroke=\"#010203\" stroke-width=\"1\" d=\"M0 0\"/>\n");
  EXPECT_EQ(tidied("<rect fill='rgb(1,2)'/>"), "<rect fill=\"rgb(1,2)\"/>\n");
}

TEST(TidySvg, PathsLoseWhatTheyDoNotNeed) {
  const auto path = [](const std::string& d) {
    const std::string out = tidied("<path d='" + d + "'/>");
    return out.substr(9, out.rfind('"') - 9);
  };
  EXPECT_EQ(path("M1.00,2.50 L3.25,-4.00 L10,20 Z M5,6 l7,8"), "M1 2.5 3.25 -4 10 20ZM5 6l7 8");
  EXPECT_EQ(path("M0,0z"), "M0 0z");
  EXPECT_EQ(path("M0,0 A1,2"), "M0 0A1 2");
  EXPECT_EQ(path("M-0.001,0.004 100,1000"), "M0 0 100 1000");
}

TEST(TidySvg, GroupsHandDownAndEnd) {
  const std::string out = tidied(
      "<g stroke='rgb(1,1,1)' stroke-width='2'><g stroke='rgb(2,2,2)'><path d='M1,1'/></g><path "
      "d='M2,2'/></g>"
      "<path d='M3,3'/></g></g><g/><path d='M4,4'/>");
  EXPECT_EQ(
      out,
      "<path stroke=\"#020202\" stroke-width=\"2\" d=\"M1 1\"/>\n"
      "<path stroke=\"#010101\" stroke-width=\"2\" d=\"M2 2\"/>\n<path d=\"M3 3\"/>\n<path d=\"M4 4\"/>\n");
}

TEST(TidySvg, DotsOfOneColourAreOnePath) {
  const auto dot = [](const std::string& place, const std::string& colour) {
    return "<use xlink:href='#p' transform='translate(" + place + ") scale(1)' color='" + colour + "'/>";
  };
  EXPECT_EQ(tidied(dot("1,2", "black") + dot("3,4", "black") + dot("5,6", "rgb(1,2,3)") + "<rect/>" +
                   dot("7,8", "black")),
            "<path stroke=\"#000000\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M1 2h0M3 4h0\"/>\n"
            "<path stroke=\"#010203\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M5 6h0\"/>\n<rect/>\n"
            "<path stroke=\"#000000\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M7 8h0\"/>\n");
  EXPECT_EQ(tidied("<use transform='scale(1)'/>"), "");
  EXPECT_EQ(tidied("<use transform='translate(1,2)'/>"),
            "<path stroke=\"#000000\" stroke-width=\"2.6\" stroke-linecap=\"round\" d=\"M1 2h0\"/>\n");
}

TEST(TidySvg, WordsKeepPlaceSizeAndSlant) {
  EXPECT_EQ(tidied("<g transform='translate(5,6)' fill='rgb(1,2,3)' font-size='11.50' text-anchor='end'>"
                   "<text><tspan font-family='x' xml:space='preserve'>a > b</tspan></text></g>"),
            "<text transform=\"translate(5,6)\" fill=\"#010203\" font-size=\"11.5\" text-anchor=\"end\">a "
            "&gt; b</text>\n");
  EXPECT_EQ(tidied("<g fill='black'><text x='1'><tspan dy=' 2.00 ' font-weight=' bold '>a</tspan>\n"
                   "<tspan>b</tspan><other>c</other></text></g>"),
            "<text transform=\"\" fill=\"#000000\" font-size=\"13\" text-anchor=\"start\">"
            "<tspan dy=\"2.00\" font-weight=\"bold\">a</tspan>b</text>\n");
  // A group's place is its own, not that of the groups in it.
  EXPECT_THAT(tidied("<g transform='translate(5,6)'><g><text><tspan>a</tspan></text></g></g>"),
              HasSubstr("<text transform=\"\""));
}

TEST(TidySvg, DropsWhatIsNotDrawn) {
  EXPECT_EQ(tidied("<!-- <rect/> --><title><rect/></title><desc>a</desc><defs><rect/><g></g></defs><a/>"),
            "");
  EXPECT_EQ(tidied("<defs/><rect/>"), "<rect/>\n");
  EXPECT_EQ(tidied("<rect x='1' broken"), "<rect x=\"1\"/>\n");
  EXPECT_EQ(tidied("<rect x = '1' y='2/>"), "<rect x=\"1\"/>\n");
}

TEST(TidySvg, AMapKeepsItsPictureInside) {
  EXPECT_EQ(tidied("<image x='1' y='2' width='3' height='4' xlink:href='data:x'/>"),
            "<image style=\"image-rendering:pixelated\" x=\"1\" y=\"2\" width=\"3\" height=\"4\" "
            "href=\"data:x\"/>\n");
}

}  // namespace
}  // namespace cromer
