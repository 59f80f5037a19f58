// The script holds the layout's numbers, y upwards, in the words of look/LOOK.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "cromer/report/figure.h"
#include "cromer/report/layout.h"
#include "cromer/report/palette.h"

namespace cromer {
namespace {

using testing::HasSubstr;
using testing::Not;

Figure figure() {
  Figure figure;
  Panel& panel = figure.panels.emplace_back();
  panel.x.name = "time (s)";
  Curve& curve = panel.curves.emplace_back();
  curve.x = {0, 4, 10};
  curve.y = {-0.9, 0.9, 0};
  curve.role = "newmark";
  curve.name = "Newmark";
  return figure;
}

std::vector<std::string> lines_with(const std::string& script, const std::string& begin) {
  std::vector<std::string> found;
  std::istringstream all(script);
  for (std::string line; std::getline(all, line);)
    if (line.starts_with(begin)) found.push_back(line);
  return found;
}

std::vector<double> numbers(const std::string& text) {
  std::vector<double> found;
  for (const char* p = text.c_str(); *p != '\0';) {
    char* end = nullptr;
    const double value = std::strtod(p, &end);
    if (end != p) found.push_back(value);
    p = end != p ? end : p + 1;
  }
  return found;
}

std::vector<std::vector<double>> block(const std::string& script, const std::string& name) {
  std::vector<std::vector<double>> rows;
  const std::size_t at = script.find("$" + name + " << EOD\n");
  if (at == std::string::npos) return rows;
  std::istringstream all(script.substr(at));
  std::string line;
  for (std::getline(all, line); std::getline(all, line) && line != "EOD";) rows.push_back(numbers(line));
  return rows;
}

TEST(Script, APxOfTheLayoutIsAPxOfTheFrame) {
  const std::string script = gnuplot_script(figure(), FigureFormat::svg);
  const Layout layout = lay_out(figure(), Typeface::dejavu_sans);
  const Box& f = layout.panels[0].frame;
  const auto number_of = [&](const std::string& begin, std::size_t i) {
    const auto found = lines_with(script, begin);
    return found.size() == 1 ? numbers(found[0]).at(i) : NAN;
  };
  EXPECT_NEAR(number_of("set lmargin", 0), f.x / 760, 1e-6);
  EXPECT_NEAR(number_of("set rmargin", 0), f.right() / 760, 1e-6);
  EXPECT_NEAR(number_of("set bmargin", 0), 1 - f.bottom() / 440, 1e-6);
  EXPECT_NEAR(number_of("set tmargin", 0), 1 - f.y / 440, 1e-6);
  EXPECT_NEAR(number_of("set xrange", 0), f.x, 1e-3);
  EXPECT_NEAR(number_of("set xrange", 1), f.right(), 1e-3);
  EXPECT_NEAR(number_of("set yrange", 0), 440 - f.bottom(), 1e-3);
  EXPECT_NEAR(number_of("set yrange", 1), 440 - f.y, 1e-3);
  const auto rows = block(script, "curve_1_1");
  ASSERT_EQ(rows.size(), 4u);  // and an empty one that ends the piece
  EXPECT_NEAR(rows[1][0], f.x + 0.4 * f.width, 0.006);
  EXPECT_NEAR(rows[1][1], 440 - (f.y + 0.05 * f.height), 0.006);
  EXPECT_NEAR(number_of("set ytics", 0), 440 - f.bottom(), 0.006);
  EXPECT_NEAR(number_of("set xtics", 1), f.x + 0.2 * f.width, 0.006);
}

TEST(Script, SaysTheLookOfAxesAndGrid) {
  const std::string script = gnuplot_script(figure(), FigureFormat::svg);
  for (const char* line :
       {"set border 3 back lc rgb '#7B8594' lw 0.8\n", "set tics nomirror out scale 0.5,0.25\n",
        "set grid xtics ytics nomxtics nomytics back lt 1 lc rgb '#E4E8ED' lw 0.7 dt solid\n", "unset key\n",
        "background '#ffffff'\n"})
    EXPECT_THAT(script, HasSubstr(line));
  EXPECT_THAT(gnuplot_script(figure(), FigureFormat::png),
              HasSubstr("fontscale 1.5 linewidth 2 rounded background '#ffffff'"));
  EXPECT_THAT(
      gnuplot_script(figure(), FigureFormat::pdf),
      HasSubstr("size 7.9167in,4.5833in enhanced font 'Lato,13' fontscale 0.5625 linewidth 1.5 rounded"));
}

TEST(Script, ADashIsAsLongInEveryFormat) {
  // Newmark's 3 px and 3 px at 1.5 px of width; ends that are round reach 0.8 of the half width further.
  Figure alone = figure();
  const auto dash = [&](FigureFormat format, double unit) {
    const std::string script = gnuplot_script(alone, format);
    const std::size_t at = script.find("dt (");
    std::vector<double> found = numbers(script.substr(at + 3, script.find(')', at) - at));
    for (double& each : found) each *= unit * 1.5;
    return found;
  };
  const auto svg = dash(FigureFormat::svg, 0.5), png = dash(FigureFormat::png, 0.25),
             pdf = dash(FigureFormat::pdf, 0.283);
  EXPECT_THAT(svg, testing::ElementsAre(testing::DoubleNear(3, 0.01), testing::DoubleNear(3, 0.01)));
  for (const auto& rounded : {png, pdf})
    EXPECT_THAT(rounded,
                testing::ElementsAre(testing::DoubleNear(1.8, 0.01), testing::DoubleNear(4.2, 0.02)));
  alone.panels[0].curves[0].role = "dormand-prince";
  EXPECT_THAT(dash(FigureFormat::svg, 0.5),
              testing::Pointwise(testing::DoubleNear(0.03), std::vector<double>{8, 3, 2, 3}));
  alone.panels[0].curves[0].role = "euler-cromer";
  EXPECT_THAT(gnuplot_script(alone, FigureFormat::svg), HasSubstr("lw 1.5 dt solid"));
  EXPECT_THAT(gnuplot_script(alone, FigureFormat::svg), HasSubstr("lc rgb '#0072B2'"));
}

TEST(Script, WordsStandWhereTheLayoutHasThem) {
  Figure noted = figure();
  noted.panels[0].notes = {{"on it", 4, 0.9, 0.38, 0.93, false, false},
                           {"peak", 10, 0, 0.9, 0.2, true, true, true}};
  const std::string script = gnuplot_script(noted, FigureFormat::svg);
  const PlacedPanel panel = lay_out(noted, Typeface::dejavu_sans).panels[0];
  const auto labels = lines_with(script, "set label"), grounds = lines_with(script, "set object rectangle");
  ASSERT_EQ(labels.size(), panel.texts.size());
  std::size_t ground = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const PlacedText& text = panel.texts[i];
    const auto at = numbers(labels[i].substr(labels[i].find(" at first")));
    const double middle = text.box.x + text.box.width / 2;
    EXPECT_NEAR(at[0], text.ground ? middle : text.at.x, 0.006) << labels[i];
    EXPECT_NEAR(at[1], 440 - text.at.y, 0.006) << labels[i];
    EXPECT_THAT(labels[i], HasSubstr(text.bold ? "{/:Bold " + text.text + "}" : "'" + text.text + "'"));
    EXPECT_THAT(labels[i], HasSubstr("tc rgb '" + text.colour + "' front"));
    EXPECT_THAT(labels[i], HasSubstr(text.ground || text.align == Align::centre ? " center"
                                     : text.align == Align::left                ? " left"
                                                                                : " right"));
    if (!text.ground) continue;
    const auto corners = numbers(grounds.at(ground++));
    EXPECT_LE(corners[0], text.box.x);
    EXPECT_NEAR(corners[0] + corners[2], 2 * middle, 0.02);
    EXPECT_NEAR(corners[1], 440 - text.box.bottom(), 0.006);
    EXPECT_NEAR(corners[3], 440 - text.box.y, 0.006);
  }
  EXPECT_EQ(ground, 1u);
  EXPECT_EQ(grounds.size(), 1u);
  const auto circles = lines_with(script, "set object circle");
  ASSERT_EQ(circles.size(), 2u);
  for (const std::string& circle : circles) {
    EXPECT_NEAR(numbers(circle)[0], panel.frame.right(), 0.006);
    EXPECT_NEAR(numbers(circle)[1], 440 - (panel.frame.y + panel.frame.height / 2), 0.006);
    EXPECT_THAT(circle, HasSubstr("fc rgb '#171C24'"));
  }
  const auto arrows = lines_with(script, "set arrow");
  ASSERT_EQ(arrows.size(), 2u);  // the line at zero, and to the peak
  EXPECT_THAT(arrows[0], HasSubstr("nohead back lc rgb '#C3CAD3' lw 0.8"));
  EXPECT_THAT(arrows[1], HasSubstr("nohead front"));
  EXPECT_NEAR(numbers(arrows[1])[3], 440 - panel.leaders[0].to.y, 0.006);
  EXPECT_NEAR(numbers(arrows[1])[1], 440 - panel.leaders[0].from.y, 0.006);
}

TEST(Script, DotsAndBandsAreDrawnAsSuch) {
  Figure dotted = figure();
  Curve& curve = dotted.panels[0].curves[0];
  curve.role = "measured";
  curve.mark = Mark::dots;
  const std::string dots = gnuplot_script(dotted, FigureFormat::png);
  EXPECT_THAT(dots, HasSubstr("$curve_1_1 using 1:2 with points pt 7 ps 0.64 lw 1 lc rgb '#171C24'"));
  curve.mark = Mark::line;
  curve.with_dots = true;
  const std::string both = gnuplot_script(dotted, FigureFormat::png);
  EXPECT_THAT(both, HasSubstr("with lines lc rgb '#171C24'"));
  EXPECT_THAT(both, HasSubstr(", $dots_1_1 using 1:2 with points pt 7 ps 1.28"));
  EXPECT_EQ(block(both, "dots_1_1"), [&] {
    auto rows = block(both, "curve_1_1");
    rows.pop_back();
    return rows;
  }());
  curve.mark = Mark::band;
  curve.x.clear(), curve.y.clear();
  for (int i = 0; i < 20000; ++i) curve.x.push_back(i), curve.y.push_back(std::sin(2.0 * i));
  curve.y[10000] = NAN;
  const std::string band = gnuplot_script(dotted, FigureFormat::svg);
  EXPECT_THAT(band,
              HasSubstr("using 1:2:3 with filledcurves fc rgb '#171C24' fs transparent solid 0.2 noborder"));
  const auto rows = block(band, "curve_1_1");
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.empty(); }), 1);
  for (const auto& row : rows)
    if (!row.empty()) {
      EXPECT_GT(std::abs(row.at(1) - row.at(2)), 300);
    }
}

TEST(Script, AMapHasEveryPxAndItsBarEveryColour) {
  Figure mapped;
  Panel& panel = mapped.panels.emplace_back();
  panel.map = HeatMap{.x = {0, 1}, .y = {0, 1}, .z = {0, 1, 2, NAN}, .name = "z"};
  const std::string script = gnuplot_script(mapped, FigureFormat::svg);
  const PlacedPanel placed = lay_out(mapped, Typeface::dejavu_sans).panels[0];
  const Box &f = placed.frame, &bar = placed.map->bar;
  const std::size_t at = script.find("$map_1 << EOD\n");
  ASSERT_NE(at, std::string::npos);
  std::istringstream all(script.substr(at));
  std::string line, first, last;
  std::getline(all, line);
  int rows = 0;
  for (; std::getline(all, line) && line != "EOD"; ++rows) (rows == 0 ? first : last) = line;
  EXPECT_EQ(rows, placed.map->rows);
  EXPECT_EQ(numbers(first).size(), static_cast<std::size_t>(placed.map->columns));
  EXPECT_THAT(first, testing::StartsWith("0 0 "));
  EXPECT_THAT(first, testing::EndsWith("0.5 0.5 "));
  EXPECT_THAT(last, testing::StartsWith("1 1 "));
  EXPECT_THAT(last, testing::EndsWith("NaN NaN "));
  const auto plot = numbers(lines_with(script, "plot ")[0]);  // 1, x, 1, step, 2, ...
  EXPECT_NEAR(plot[1], f.x + f.width / placed.map->columns / 2, 1e-3);
  EXPECT_NEAR(plot[3], f.width / placed.map->columns, 1e-5);
  EXPECT_NEAR(plot[4], 440 - f.bottom() + f.height / placed.map->rows / 2, 1e-3);
  EXPECT_NEAR(plot[6], f.height / placed.map->rows, 1e-5);
  const auto pieces = lines_with(script, "set object rectangle");
  ASSERT_EQ(pieces.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) {
    const auto corners = numbers(pieces[i]);
    const double share = static_cast<double>(i) / 64;
    EXPECT_NEAR(corners[0], bar.x, 0.006);
    EXPECT_NEAR(corners[2], bar.right(), 0.006);
    EXPECT_NEAR(corners[1], 440 - bar.bottom() + share * bar.height, 0.006);
    EXPECT_GE(corners[3],
              440 - bar.bottom() + (share + 1.0 / 64) * bar.height - 0.006);  // no gap to the next
    EXPECT_LE(corners[3], 440 - bar.y + 0.006);
    EXPECT_THAT(pieces[i], HasSubstr(map_colour((static_cast<double>(i) + 0.5) / 64)));
  }
  EXPECT_THAT(script, HasSubstr("set palette defined (0 '#440154', 1 '#472D7B', 2 "));
  EXPECT_THAT(script, HasSubstr("8 '#FDE725')\n"));
  EXPECT_THAT(script, HasSubstr("set cbrange [0:1]\n"));
}

TEST(Script, WithoutDataAxesAloneAreDrawn) {
  Figure empty;
  empty.panels.emplace_back().curves.emplace_back();
  const std::string script = gnuplot_script(empty, FigureFormat::svg);
  EXPECT_THAT(script, Not(HasSubstr("plot $")));
  const double top = 440 - lay_out(empty, Typeface::dejavu_sans).panels[0].frame.y;
  EXPECT_GT(numbers(lines_with(script, "plot ")[0])[0], top);
}

TEST(FigureFormat, NeedsANameBeforeTheEnding) {
  EXPECT_TRUE(figure_format("a.svg").ok());
  EXPECT_TRUE(figure_format("A.SVG").ok());
  EXPECT_TRUE(figure_format("z.PdF").ok());
  EXPECT_FALSE(figure_format(".pdf").ok());
  EXPECT_FALSE(figure_format("svg").ok());
  EXPECT_FALSE(figure_format("a.svgz").ok());
}

}  // namespace
}  // namespace cromer
