#include "cromer/study/write_report.h"

#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
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
  ASSERT_TRUE(figure) << in_words(figure.error());
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.x.name, "time {/:Italic t} (s)");
  EXPECT_EQ(panel.y.name, "position {/:Italic x} (cm)");
  ASSERT_EQ(panel.curves.at(0).y.size(), 3u);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[2], 3);
}

TEST_F(MakeFigure, cuts_by_time) {
  spec_.panels[0].curves[0].from = 1;
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_EQ(figure->panels.at(0).curves.at(0).x, (std::vector<double>{1, 2}));
}

TEST_F(MakeFigure, subtracts_another_result) {
  spec_.panels[0].curves[0].minus = "b";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_DOUBLE_EQ(figure->panels.at(0).curves.at(0).y[2], 2);
  spec_.panels[0].curves[0].minus = "short";
  EXPECT_NE(in_words(make_figure(spec_, results_).error()).find("cannot be subtracted"), std::string::npos);
}

TEST_F(MakeFigure, names_the_place_of_what_is_missing) {
  spec_.panels[0].curves[0].of = "c";
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()).rfind("lab.toml:7:1: \"c.t\" is no column", 0),
            0u);
  spec_.panels[0].curves[0].of = "a";
  spec_.panels[0].y_unit = "kg";
  EXPECT_NE(in_words(make_figure(spec_, results_).error()).find("cannot be drawn in \"kg\""),
            std::string::npos);
}

TEST_F(MakeFigure, keeps_rows_from_the_first_time_to_the_last) {
  const auto drawn = [&] { return make_figure(spec_, results_)->panels.at(0).curves.at(0); };
  spec_.panels[0].to = 1;
  EXPECT_EQ(drawn().x, (std::vector<double>{0, 1}));
  EXPECT_EQ(drawn().y.size(), 2u);
  EXPECT_DOUBLE_EQ(drawn().y[1], 2);
  spec_.panels[0].from = 1;
  EXPECT_EQ(drawn().x, (std::vector<double>{1}));
  spec_.panels[0].curves[0].to = 5;
  EXPECT_EQ(drawn().x, (std::vector<double>{1, 2}));
  spec_.panels[0].curves[0].from = 0;
  EXPECT_EQ(drawn().x, (std::vector<double>{0, 1, 2}));
}

TEST_F(MakeFigure, a_range_needs_as_many_times_as_rows) {
  results_.set_column("odd.x", {1, 2}, "m", "x");
  results_.set_column("odd.u", {1, 2}, "m", "u");
  results_.set_column("odd.t", {1}, "s", "t");
  spec_.panels[0].x = "u";
  spec_.panels[0].curves[0].of = "odd";
  EXPECT_TRUE(make_figure(spec_, results_));
  spec_.panels[0].curves[0].from = 0;
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()),
            "lab.toml:7:1: \"odd\": from and to need a column t as long as the ones drawn");
}

TEST_F(MakeFigure, a_curves_own_columns_come_first) {
  results_.set_column("a.v", {7, 8, 9}, "", "speed");
  spec_.panels[0].y_unit = "";
  spec_.panels[0].curves[0].y = "v";
  spec_.panels[0].curves[0].x = "x";
  spec_.panels[0].curves.push_back(spec_.panels[0].curves[0]);
  spec_.panels[0].curves[1].x = "t";
  spec_.panels[0].curves[1].y = "x";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.x.name, "position {/:Italic x} (m)");
  EXPECT_EQ(panel.y.name, "speed");
  EXPECT_EQ(panel.curves.at(0).y, (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(panel.curves.at(0).x, (std::vector<double>{0.01, 0.02, 0.03}));
  EXPECT_EQ(panel.curves.at(1).x, (std::vector<double>{0, 1, 2}));
}

TEST_F(MakeFigure, fills_every_text) {
  results_.set("n", 3, "m");
  spec_.look.title = "*t* {n}";
  spec_.look.caption = "*c* {n}";
  PanelSpec& panel = spec_.panels[0];
  panel.look.title = "*p* {n}";
  panel.look.x.name = "*x* {n}";
  panel.look.y.name = "*y* {n}";
  panel.look.notes.resize(2);
  panel.look.notes[1].text = "*n* {n}";
  panel.curves[0].look.name = "*k* {n}";
  panel.curves[0].look.remark = "*r* {n}";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_EQ(figure->title, "*t* 3\u00a0m");
  EXPECT_EQ(figure->caption, "*c* 3\u00a0m");
  EXPECT_EQ(figure->panels[0].title, "{/:Italic p} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].x.name, "{/:Italic x} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].y.name, "{/:Italic y} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].notes[1].text, "{/:Italic n} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].curves[0].name, "{/:Italic k} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].curves[0].remark, "{/:Italic r} 3\u00a0m");
}

TEST_F(MakeFigure, says_what_cannot_be_filled) {
  spec_.panels[0].place = {"lab.toml", 5, 2};
  const auto said = [&](std::string& text) {
    text = "{missing}";
    const auto figure = make_figure(spec_, results_);
    text.clear();
    return figure ? "" : in_words(figure.error());
  };
  EXPECT_EQ(said(spec_.look.caption), "lab.toml:7:1: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].look.y.name), "lab.toml:5:2: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].curves[0].look.remark),
            "lab.toml:7:1: \"missing\" is no result of this study");
  spec_.panels[0].look.notes.resize(1);
  EXPECT_EQ(said(spec_.panels[0].look.notes[0].text), "lab.toml:5:2: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].curves[0].minus),
            "lab.toml:7:1: \"{missing}.x\" is no column of this study");
  spec_.panels[0].curves[0].minus = "short";
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()),
            "lab.toml:7:1: \"short\" has 1 rows, \"a\" has 3: they cannot be subtracted");
}

TEST(Enhanced, italics_become_those_of_figures) {
  EXPECT_EQ(to_enhanced("position *x* (cm)"), "position {/:Italic x} (cm)");
  EXPECT_EQ(to_enhanced("2 * 3"), "2 * 3");
}

}  // namespace
}  // namespace cromer::core
