// Names among curves: which places they look at, what they keep clear of, when a list is better.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/axis.h"
#include "cromer/report/layout.h"
#include "cromer/report/place_curve.h"
#include "cromer/report/place_names.h"
#include "tests/report/overlap.h"

namespace cromer::core {
namespace CROMER_FILE {

/// The words of a panel whose axes run from 0 to 1 in a frame of 400 by 300 px at (50, 40).
PlacedPanel words(const Panel& panel) {
  PlacedPanel placed;
  placed.frame = {50, 40, 400, 300};
  const AxisRange x{0, 1, false, 50, 450, 0}, y{0, 1, false, 340, 40, 0};
  std::vector<std::vector<Spot>> spots;
  for (const Curve& curve : panel.curves) spots.push_back(spots_of(curve, x, y));
  place_words(placed, panel, spots, x, y, {0, 0, 600, 400}, {}, Typeface::lato);
  return placed;
}

Panel inside(std::vector<double> x, std::vector<double> y) {
  Panel panel;
  panel.names_inside = true;
  Curve& curve = panel.curves.emplace_back();
  curve.name = "name";
  curve.x = std::move(x);
  curve.y = std::move(y);
  return panel;
}

double distance(const Box& box, Spot p) {
  const Spot edge = box.nearest(p);
  return std::hypot(edge.x - p.x, edge.y - p.y);
}

TEST(InsideNames, FindTheirCurveUpToTheVeryEdgesOfTheFrame) {
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.5, 1.0}) {
      const PlacedPanel placed = words(inside({x}, {y}));
      ASSERT_EQ(placed.texts.size(), 1u);
      EXPECT_LT(distance(placed.texts[0].box, {50 + 400 * x, 340 - 300 * y}), 15) << x << ' ' << y;
      EXPECT_FALSE(placed.crowded);
    }
  // Of a curve out of sight nothing is near.
  EXPECT_EQ(words(inside({2}, {2})).leaders.size(), 0u);
  EXPECT_LT(distance(words(inside({-1, 0.9}, {0.5, 0.9})).texts[0].box, {410, 70}), 15);
}

TEST(InsideNames, FindTheirPlaceOnACurveOfManyPoints) {
  Panel panel = inside({}, {});
  for (int i = 0; i <= 3000; ++i) {
    const double t = i / 3000.0;
    panel.curves[0].x.push_back(0.1 + 0.8 * t), panel.curves[0].y.push_back(0.1 + 0.8 * t);
  }
  const PlacedPanel placed = words(panel);
  EXPECT_TRUE(placed.leaders.empty());
  EXPECT_FALSE(placed.texts[0].ground);
}

TEST(InsideNames, KeepClearOfDotsAndOfEachOther) {
  Panel panel = inside({}, {});
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 12; ++k)
      panel.curves[0].x.push_back(0.0125 + 0.025 * i), panel.curves[0].y.push_back(0.02 + 0.025 * k);
  panel.curves[0].mark = Mark::dots;
  panel.curves.push_back(inside({0, 1}, {0.6, 0.6}).curves[0]);
  panel.curves.push_back(inside({0, 1}, {0.8, 0.8}).curves[0]);
  panel.curves[2].text_x = 0.02, panel.curves[2].text_y = 0.63;  // where the second would like to stand
  panel.curves[2].label_x = 0.02;
  const PlacedPanel placed = words(panel);
  ASSERT_EQ(placed.texts.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Box& box = placed.texts[i].box;
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(box, placed.texts[k].box));
    for (std::size_t k = 0; k < panel.curves[0].x.size(); ++k) {
      const Spot dot{50 + 400 * panel.curves[0].x[k], 340 - 300 * panel.curves[0].y[k]};
      EXPECT_GT(distance(box, dot), 1) << i;
    }
  }
}

TEST(Leaders, RunStraightToTheSideTheyComeFrom) {
  Panel panel;
  panel.notes = {{"peak", 0.5, 0.5, 0.9, 0.5}};  // at the right, as high
  PlacedLine leader = words(panel).leaders.at(0);
  EXPECT_NEAR(leader.from.x, 50 + 360 - 3, 1e-9);
  EXPECT_NEAR(leader.to.x, 250 + 3, 1e-9);
  EXPECT_NEAR(leader.from.y, 190, 1e-9);
  EXPECT_NEAR(leader.to.y, 190, 1e-9);
  panel.notes = {{"peak", 0.5, 0.5, 0.1, 0.5}};
  leader = words(panel).leaders.at(0);
  EXPECT_NEAR(leader.from.x, 90 + 3, 1e-9);
  EXPECT_NEAR(leader.to.x, 250 - 3, 1e-9);
  for (const double text_y : {0.8, 0.2}) {
    panel.notes = {{"peak", 0.5, 0.5, 0.5, text_y}};  // above, below
    const PlacedPanel placed = words(panel);
    const double way = text_y > 0.5 ? 1 : -1;
    const Box& box = placed.texts.at(0).box;
    EXPECT_NEAR(placed.leaders.at(0).from.x, 250, 1e-9);
    EXPECT_NEAR(placed.leaders.at(0).from.y, (way > 0 ? box.bottom() : box.y) + 3 * way, 1e-9);
    EXPECT_NEAR(placed.leaders.at(0).to.y, 190 - 3 * way, 1e-9);
  }
  // Beside and above: at least 6 px from the corner.
  panel.notes = {{"peak", 0.5, 0.1, 0.9, 0.9}};
  const PlacedPanel above = words(panel);
  const Spot corner{above.texts.at(0).box.x, above.texts.at(0).box.bottom() - 6};
  const PlacedLine& down = above.leaders.at(0);
  EXPECT_NEAR(std::hypot(down.from.x - corner.x, down.from.y - corner.y), 3, 1e-9);
}

Figure of(const Panel& panel, FigureSize size) {
  Figure figure;
  figure.panels = {panel};
  figure.size = size;
  return figure;
}

/// Of `count` level curves, told apart or all on one another.
Panel levels(int count, double apart) {
  Panel panel;
  panel.names_inside = true;
  for (int k = 0; k < count; ++k) {
    Curve& curve = panel.curves.emplace_back();
    curve.name = "level " + std::to_string(k);
    for (int i = 0; i <= 50; ++i) curve.x.push_back(i), curve.y.push_back(1 + apart * k);
  }
  Curve& scale = panel.curves.emplace_back();  // without a name
  scale.x = {0, 0};
  scale.y = {0, 9};
  return panel;
}

bool listed(const Figure& figure) {
  const PlacedPanel panel = lay_out(figure, Typeface::lato).panels[0];
  for (const PlacedText& text : panel.texts)
    if (text.text == "level 0") return text.box.x > panel.frame.right();
  ADD_FAILURE() << "no name";
  return false;
}

TEST(InsideNames, OfASmallFigureStandAboveCurvesThatLeaveNoPlace) {
  Panel panel;
  Curve law, dots;
  for (int i = 0; i <= 300; ++i) {
    law.x.push_back(0.01 * i);
    law.y.push_back(std::cos(2 * 3.14159265358979 * 1.7 * law.x.back()));
  }
  dots.x = law.x, dots.y = law.y;
  law.role = "fitted", law.name = "law";
  dots.role = dots.name = "measured";
  dots.mark = Mark::dots;
  panel.curves = {law, dots};
  Figure figure;
  figure.size = FigureSize::half;
  figure.panels = {panel};
  const Layout layout = lay_out(figure, Typeface::lato);
  for (const PlacedText& text : layout.panels[0].texts) EXPECT_FALSE(text.ground) << text.text;
}

TEST(NameLists, AreForMoreThanSixNamesOrWhereNoPlaceIsGood) {
  EXPECT_FALSE(listed(of(levels(6, 1), FigureSize::single)));
  EXPECT_TRUE(listed(of(levels(7, 1), FigureSize::single)));
  EXPECT_TRUE(listed(of(levels(3, 0.0001), FigureSize::single)));
  EXPECT_FALSE(listed(of(levels(3, 0.0001), FigureSize::half)));  // no room for one
  EXPECT_FALSE(listed(of(levels(3, 0.0001), FigureSize::tall)));
  Panel phase = levels(7, 1);
  phase.phase_portrait = true;
  EXPECT_FALSE(listed(of(phase, FigureSize::phase)));
  Panel outside = levels(7, 1);
  outside.names_inside = false;
  const PlacedPanel placed = lay_out(of(outside, FigureSize::single), Typeface::lato).panels[0];
  EXPECT_TRUE(placed.leaders.empty());  // beside their ends, without pieces of lines
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
