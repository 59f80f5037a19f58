#include "cromer/study/make_figure.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

class MakeFigure : public testing::Test {
 protected:
  MakeFigure() {
    results_.set_column("a.t", {0, 1, 2}, "s", "time *t*");
    results_.set_column("a.x", {0.01, 0.02, 0.03}, "m", "position *x*");
    results_.set_column("b.t", {0, 1, 2}, "s", "time *t*");
    results_.set_column("b.x", {0.01, 0.01, 0.01}, "m", "position *x*");
    results_.set_column("short.x", {0.01}, "m", "position *x*");
    spec_.look.id = "figure-1";
    PanelSpec panel;
    panel.x = "t";
    panel.y = "x";
    panel.y_unit = "cm";
    CurveSpec curve;
    curve.of = "a";
    panel.curves = {curve};
    spec_.panels = {panel};
    spec_.place = spec_.panels[0].curves[0].place = {"lab.toml", 7, 1};
  }

  FigureSpec spec_;
  Results results_;
};

TEST_F(MakeFigure, converts_columns_and_names_axes) {
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << figure.error().message;
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.x.name, "time {/:Italic t} (s)");
  EXPECT_EQ(panel.y.name, "position {/:Italic x} (cm)");
  ASSERT_EQ(panel.curves.at(0).y.size(), 3u);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[2], 3);
}

TEST_F(MakeFigure, cuts_by_time) {
  spec_.panels[0].curves[0].from = 1;
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << figure.error().message;
  EXPECT_EQ(figure->panels.at(0).curves.at(0).x, (std::vector<double>{1, 2}));
}

TEST_F(MakeFigure, subtracts_another_result) {
  spec_.panels[0].curves[0].minus = "b";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << figure.error().message;
  EXPECT_DOUBLE_EQ(figure->panels.at(0).curves.at(0).y[2], 2);
  spec_.panels[0].curves[0].minus = "short";
  EXPECT_NE(make_figure(spec_, results_).error().message.find("cannot be subtracted"), std::string::npos);
}

TEST_F(MakeFigure, names_the_place_of_what_is_missing) {
  spec_.panels[0].curves[0].of = "c";
  EXPECT_EQ(make_figure(spec_, results_).error().message.rfind("lab.toml:7:1: \"c.t\" is no column", 0), 0u);
  spec_.panels[0].curves[0].of = "a";
  spec_.panels[0].y_unit = "kg";
  EXPECT_NE(make_figure(spec_, results_).error().message.find("cannot be drawn in \"kg\""),
            std::string::npos);
}

TEST(Enhanced, italics_become_gnuplots) {
  EXPECT_EQ(to_enhanced("position *x* (cm)"), "position {/:Italic x} (cm)");
  EXPECT_EQ(to_enhanced("2 * 3"), "2 * 3");
}

}  // namespace
}  // namespace cromer
