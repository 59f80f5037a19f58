// Figures of every kind as they are drawn, attribute for attribute: tests/report/pictures/*.txt.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cromer/report/layout.h"
#include "cromer/report/palette.h"
#include "cromer/report/svg.h"
#include "tests/report/example_figures.h"
#include "tests/support/written_down.h"

namespace cromer::core {
namespace CROMER_FILE {

struct DrawnFigure {
  std::string name;
  Figure figure;
  Typeface typeface = Typeface::dejavu_sans;
  double smaller_by = 0;
};

void PrintTo(const DrawnFigure& drawn, std::ostream* out) { *out << drawn.name; }

Curve points(const std::string& role, std::vector<double> x, std::vector<double> y,
             const std::string& name = "") {
  Curve curve;
  curve.role = role, curve.name = name;
  curve.x = std::move(x), curve.y = std::move(y);
  return curve;
}

Panel map_panel(bool decades, std::vector<double> reach = {}) {
  Panel panel;
  panel.title = decades ? "Amplitudes in decades" : "Amplitudes";
  panel.x.name = "drive frequency (Hz)", panel.y.name = "damping {/:Italic b} (1/s)";
  HeatMap map;
  map.name = "amplitude (cm)";
  map.decades = decades, map.reach = std::move(reach);
  map.x = {1, 1.5, 2, 2.5}, map.y = {0.1, 0.3, 0.5};
  map.z = {0.2, 1, 7, 1.5, 0.3, 0.9, 3, 1, 0.1, std::nan(""), 2, 0.8};
  panel.map = map;
  return panel;
}

Figure maps() {
  Figure figure = of({map_panel(false, {0, 10}), map_panel(true)}, FigureSize::wide);
  figure.columns = 2;
  figure.note = "White: no motion was found.";
  return figure;
}

/// So many curves beside each other, dark to light.
Panel family(std::size_t count, double apart, bool remarks) {
  Panel panel;
  panel.x.name = "time (s)", panel.y.name = "position (cm)";
  for (std::size_t i = 0; i < count; ++i) {
    Curve curve = swing(family_role(i, count), 0.2, 4, 0.02);
    for (double& y : curve.y) y += apart * static_cast<double>(i);
    curve.name = "start " + std::to_string(i);
    if (remarks) curve.remark = "decays, 0.200 1/s";
    panel.curves.push_back(curve);
  }
  return panel;
}

/// Every role and mark, and what they are drawn over.
Panel all_looks() {
  Panel panel;
  panel.x.name = "time (s)", panel.y.name = "position (cm)";
  panel.names_listed = true;
  for (const char* role : {"constant-rate", "measured", "fitted", "euler-cromer", "exact", "grid",
                           "one-of-many", "no such role"}) {
    Curve curve = swing(role, 0.15, 6, 0.05);
    for (double& y : curve.y) y += static_cast<double>(panel.curves.size());
    curve.name = role;
    panel.curves.push_back(curve);
  }
  panel.curves[1].mark = Mark::dots;
  panel.curves[3].dashed = true;
  panel.curves[7].road = true;
  Curve crosses = points("rejected", {1, 1.001, 2, 3, 5}, {2, 2, 40, -20, 3}, "left out");
  crosses.mark = Mark::crosses, crosses.sets_axes = false;
  crosses.remark = "5 samples", crosses.remark_outside = ", 2 of them outside";
  panel.curves.push_back(crosses);
  Curve few = points("forward-euler", {0.5, 1.5, 2.5, std::nan(""), 5}, {4, 5, 6, 0, 7}, "dots on a line");
  few.with_dots = true;
  panel.curves.push_back(few);
  return panel;
}

/// Words asked for at places, at points and on a band; marks and markers.
Panel words_inside() {
  Panel panel;
  panel.x.name = "time (s)", panel.y.name = "position (cm)";
  panel.names_inside = true;
  panel.x.low = 0, panel.x.high = 8;
  panel.curves = {swing("exact", 0.12), swing("euler-cromer", 0.3), dense(Mark::band).curves[0]};
  panel.curves[0].name = "asked for", panel.curves[0].remark = "at a place";
  panel.curves[0].label_x = 2, panel.curves[0].text_x = 0.55, panel.curves[0].text_y = 0.93;
  panel.curves[1].name = "at its height", panel.curves[1].label_x = 1;
  for (double& x : panel.curves[2].x) x /= 15;
  panel.curves[2].name = "band";
  panel.markers = {{2, "end of part 1", "drive"}, {7.8, "too far right", "fitted"}, {99, "unseen", "drive"}};
  panel.notes = {{"start", 0, 3, 0.2, 0.9, true, true, false},
                 {"a dot\nin two lines", 5, -1, 0.8, 0.1, false, true, true},
                 {"no line", 4, 0, 0.5, 0.05, false, false, false},
                 {"", 6, 1, 0.5, 0.5, true, false, true}};
  return panel;
}

Figure with_key() {
  Figure figure = of({three_methods(), phase_portrait(), three_methods()}, FigureSize::wide);
  figure.columns = 3;
  for (Curve& curve : figure.panels[0].curves) curve.name = curve.remark = "";
  figure.panels[0].title = "Positions against time, by all methods at once";
  figure.panels[1].title = "Phases";
  for (const char* role : {"exact", "measured", "fitted", "constant-rate", "drive", "forward-euler",
                           "euler-cromer", "implicit-euler"}) {
    Curve curve = points(role, {}, {}, "the " + std::string(role) + " curve");
    if (curve.role == "measured") curve.mark = Mark::dots;
    if (curve.role == "drive") curve.mark = Mark::crosses;
    figure.key.push_back(curve);
  }
  figure.note = "Of all starts.";
  return figure;
}

Figure portraits_below() {
  Figure figure = of({three_methods(), three_methods(), phase_portrait(), three_methods()});
  figure.shared_x = true;
  figure.panels[0].y.decimal_comma = true, figure.panels[0].y.low = -2.5, figure.panels[0].y.high = 2.5;
  figure.panels[1].x.step = 0.5, figure.panels[1].y.step = 2;
  figure.panels[3].x.logarithmic = true, figure.panels[3].x.low = 0.1, figure.panels[3].x.high = 9;
  return figure;
}

Figure drawing() {
  Figure figure = of({Panel{}}, FigureSize::half);
  Panel& panel = figure.panels[0];
  panel.bare = true;
  panel.x.low = 0, panel.x.high = 10, panel.y.low = 0, panel.y.high = 10;
  panel.curves = {points("measured", {1, 9, 9, 1, 1}, {1, 1, 9, 9, 1}, "wall")};
  return figure;
}

Figure small_rows(FigureSize size) {
  Figure figure = of({three_methods(), family(3, 0.4, false)}, size);
  figure.shared_x = size == FigureSize::tall;
  return figure;
}

std::vector<DrawnFigure> pictures() {
  std::vector<DrawnFigure> all;
  const char* names[] = {"methods", "half", "phase",  "dots",  "band",
                         "log",     "grid", "shared", "empty", "no_curves"};
  const std::vector<Figure> figures = examples();
  for (std::size_t i = 0; i < figures.size(); ++i) all.push_back({names[i], figures[i]});
  Figure dots_on_line = of({dense(Mark::dots)});
  dots_on_line.panels[0].curves.push_back(swing("fitted", 0.01, 120));
  dots_on_line.panels[0].curves[0] = swing("measured", 0.01, 120, 0.2);
  dots_on_line.panels[0].curves[0].mark = Mark::dots;
  for (auto& [name, figure] : std::vector<std::pair<std::string, Figure>>{
           {"maps", maps()},
           {"one_map", of({map_panel(true)})},
           {"family_of_7", of({family(7, 1, true)})},
           {"family_of_40", of({family(40, 0.3, true)})},
           {"all_looks", of({all_looks()})},
           {"words_inside", of({words_inside()})},
           {"small_words_inside", of({words_inside()}, FigureSize::half)},
           {"dots_on_line", dots_on_line},
           {"key", with_key()},
           {"portraits_below", portraits_below()},
           {"drawing", drawing()},
           {"half_rows", small_rows(FigureSize::half)},
           {"tall_rows", small_rows(FigureSize::tall)}})
    all.push_back({name, figure});
  all.push_back({"methods_lato", figures[0], Typeface::lato});
  all.push_back({"grid_smaller", figures[6], Typeface::dejavu_sans, 1});
  return all;
}

class Picture : public testing::TestWithParam<DrawnFigure> {};

TEST_P(Picture, IsAsWrittenDown) {
  const auto& [name, figure, typeface, smaller_by] = GetParam();
  const std::string svg = to_svg(lay_out(figure, typeface, smaller_by), "what is seen", "sans-serif");
  test::expect_as_written_down(test::drawing_in(svg),
                               std::string(CROMER_SOURCE_DIR) + "/tests/report/pictures/" + name + ".txt");
}
INSTANTIATE_TEST_SUITE_P(Of, Picture, testing::ValuesIn(pictures()),
                         [](const auto& each) { return each.param.name; });

}  // namespace CROMER_FILE
}  // namespace cromer::core
