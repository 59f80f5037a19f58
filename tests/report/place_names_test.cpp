// Words beside curves, in lists and in free places; what they keep clear of.
#include "cromer/report/place_names.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/labels.h"
#include "cromer/report/palette.h"
#include "cromer/report/place_curve.h"

namespace cromer::core {
namespace CROMER_FILE {

const TextSizes sizes;
const double none = std::nan("");

Curve named(const std::string& name, const std::string& remark = "") {
  Curve curve;
  curve.name = name;
  curve.remark = remark;
  curve.role = "euler-cromer";
  return curve;
}

AxisRange axis(double low, double high, double from, double to) { return {low, high, false, from, to, 0}; }

/// The words of a panel whose axes run from 0 to 1 in a frame of 400 by 300 px at (50, 40).
PlacedPanel words(const Panel& panel) {
  PlacedPanel placed;
  placed.frame = {50, 40, 400, 300};
  const AxisRange x = axis(0, 1, 50, 450), y = axis(0, 1, 340, 40);
  std::vector<std::vector<Spot>> spots;
  for (const Curve& curve : panel.curves) spots.push_back(spots_of(curve, x, y));
  place_words(placed, panel, spots, x, y, {0, 0, 600, 400}, sizes, Typeface::lato);
  return placed;
}

TEST(HeightAt, LiesOnTheLineBetweenTwoPoints) {
  const std::vector<Spot> rising{{0, 0}, {10, 20}, {20, 0}};
  EXPECT_EQ(height_at(rising, 0), 0);
  EXPECT_EQ(height_at(rising, 2.5), 5);
  EXPECT_EQ(height_at(rising, 10), 20);
  EXPECT_EQ(height_at(rising, 17.5), 5);
  EXPECT_EQ(height_at(rising, 20), 0);
  EXPECT_TRUE(std::isnan(height_at(rising, 20.1)));
  EXPECT_TRUE(std::isnan(height_at(rising, -0.1)));
  EXPECT_EQ(height_at({{10, 5}, {0, 25}}, 2.5), 20);
  EXPECT_EQ(height_at({{3, 7}, {3, 9}}, 3), 7);
  EXPECT_TRUE(std::isnan(height_at({{3, 7}}, 3)));
  EXPECT_EQ(height_at({{none, none}, {0, 1}, {2, 3}}, 1), 2);
}

TEST(NameBlock, IsTheNameInBoldAndWhatItDoesBelow) {
  const NameBlock block = name_block(named("slow\nlong steps", "grows"), sizes, Typeface::lato, 500);
  ASSERT_EQ(block.lines.size(), 3u);
  EXPECT_EQ(block.lines[1].text, "long steps");
  EXPECT_TRUE(block.lines[1].bold);
  EXPECT_EQ(block.lines[1].size, 12);
  EXPECT_EQ(block.lines[1].colour, "#0068A3");
  EXPECT_FALSE(block.lines[2].bold);
  EXPECT_EQ(block.lines[2].size, 11);
  EXPECT_EQ(block.lines[2].colour, "#4A5361");
  EXPECT_DOUBLE_EQ(block.height, 1.28 * (12 + 12 + 11));
  EXPECT_DOUBLE_EQ(block.width, text_width("long steps", 12, true, Typeface::lato));
  EXPECT_EQ(name_block(named(""), sizes, Typeface::lato, 500).height, 0);
}

TEST(NamesMargin, HoldsTheWidestName) {
  Panel panel;
  panel.curves = {named("a"), named("long name"), named("")};
  const double width = text_width("long name", 12, true, Typeface::lato);
  EXPECT_DOUBLE_EQ(names_margin(panel, sizes, Typeface::lato, 500), width + 8 + 4);
  panel.names_listed = true;
  EXPECT_DOUBLE_EQ(names_margin(panel, sizes, Typeface::lato, 500), 10 + 26 + 6 + width + 4);
  panel.curves = {named("")};
  EXPECT_EQ(names_margin(panel, sizes, Typeface::lato, 500), 0);
  panel.names_listed = false;
  EXPECT_EQ(names_margin(panel, sizes, Typeface::lato, 500), 0);
}

TEST(StandsOutside, UnlessAnotherPlaceWasAskedFor) {
  Panel panel;
  Curve curve = named("a");
  EXPECT_TRUE(stands_outside(curve, panel));
  EXPECT_FALSE(stands_in_list(curve, panel));
  EXPECT_FALSE(stands_outside(named(""), panel));
  curve.label_x = 1;
  EXPECT_FALSE(stands_outside(curve, panel));
  curve = named("a");
  curve.mark = Mark::band;
  EXPECT_FALSE(stands_outside(curve, panel));
  curve.mark = Mark::line;
  for (bool Panel::*inside : {&Panel::phase_portrait, &Panel::names_inside, &Panel::names_listed}) {
    Panel other;
    other.*inside = true;
    EXPECT_FALSE(stands_outside(curve, other));
    EXPECT_EQ(stands_in_list(curve, other), other.names_listed);
  }
  panel.names_listed = true;
  curve.mark = Mark::band;
  EXPECT_FALSE(stands_in_list(curve, panel));
  EXPECT_FALSE(stands_in_list(named(""), panel));
}

TEST(OutsideNames, StandEightPxOffAtTheHeightOfTheEnd) {
  Panel panel;
  panel.curves = {named("a"), named("b", "decays")};
  panel.curves[0].x = panel.curves[1].x = {0, 1};
  panel.curves[0].y = {0.5, 0.8};
  panel.curves[1].y = {0.5, 0.2};
  const PlacedPanel placed = words(panel);
  ASSERT_EQ(placed.texts.size(), 3u);
  EXPECT_NEAR(placed.texts[0].at.y, 340 - 0.8 * 300, 1e-9);
  EXPECT_NEAR(placed.texts[1].at.y, 340 - 0.2 * 300, 1e-9);  // the name, not what it does, faces the curve
  EXPECT_NEAR(placed.texts[2].at.y, placed.texts[1].at.y + 0.64 * (12 + 11), 1e-9);
  for (const PlacedText& text : placed.texts) {
    EXPECT_EQ(text.at.x, 458);
    EXPECT_EQ(text.box.x, 458);
    EXPECT_EQ(text.align, Align::left);
    EXPECT_FALSE(text.ground);
    EXPECT_NEAR(text.box.y + text.box.height / 2, text.at.y, 1e-9);
  }
  panel.curves[0].y = panel.curves[1].y = {0.5, 0.5};
  const PlacedPanel close = words(panel);
  EXPECT_GE(close.texts[1].at.y - close.texts[0].at.y, 14);
  panel.curves[0].y = {1, 1}, panel.curves[1].y = {0, 0};
  const PlacedPanel ends = words(panel);
  EXPECT_GE(ends.texts[0].box.y, 40 - 6);
  EXPECT_LE(ends.texts[2].box.bottom(), 340 + 2 + 1e-9);
}

TEST(Markers, HaveTheirWordWhereItCoversLeast) {
  const double width = text_width("end", 12, true, Typeface::lato);
  const auto box_of = [](const Panel& panel) { return words(panel).texts.front(); };
  Panel panel;
  panel.markers = {{0.5, "end", "drive"}};
  // A curve right of the line at the top: the word is left of it.
  Curve& curve = panel.curves.emplace_back();
  curve.x = {0.52, 0.53};
  curve.y = {0.99, 0.96};
  EXPECT_LT(box_of(panel).box.right(), 250);
  EXPECT_NEAR(box_of(panel).box.y, 42, 1e-9);
  EXPECT_FALSE(box_of(panel).ground);
  // On both sides: below.
  curve.x = {0.47, 0.53};
  curve.y = {0.98, 0.98};
  EXPECT_GT(box_of(panel).box.x, 250);
  EXPECT_GT(box_of(panel).box.y, 46);
  EXPECT_FALSE(box_of(panel).ground);
  // Another line within its width counts as covered.
  panel.curves.clear();
  panel.markers.push_back({0.5 + 0.5 * width / 400, "", "drive"});
  EXPECT_LT(box_of(panel).box.right(), 250);
  // Where it covers something everywhere it has a ground.
  Curve& full = panel.curves.emplace_back();
  for (int k = 0; k <= 400; ++k) full.x.push_back(0.0025 * k), full.y.push_back(k % 2);
  EXPECT_TRUE(box_of(panel).ground);
}

TEST(Markers, HaveTheirWordAtTheTopBesideTheLine) {
  Panel panel;
  const double width = text_width("end", 12, true, Typeface::lato);
  for (const double x : {0.0, 0.5, 1.0, 1.01, -0.01}) {
    panel.markers = {{x, "end", "drive"}};
    const PlacedPanel placed = words(panel);
    if (x < 0 || x > 1) {
      EXPECT_TRUE(placed.leaders.empty() && placed.texts.empty()) << x;
      continue;
    }
    ASSERT_EQ(placed.leaders.size(), 1u) << x;
    EXPECT_EQ(placed.leaders[0].from, (Spot{50 + 400 * x, 40}));
    EXPECT_EQ(placed.leaders[0].to, (Spot{50 + 400 * x, 340}));
    EXPECT_EQ(placed.leaders[0].colour, style_of("drive").line);
    ASSERT_EQ(placed.texts.size(), 1u);
    const Box& box = placed.texts[0].box;
    EXPECT_NEAR(box.x, x < 1 ? 50 + 400 * x + 5 : 445 - width, 1e-9) << x;
    EXPECT_NEAR(box.width, width, 1e-9);
    EXPECT_NEAR(box.y, 42, 1e-9);
    EXPECT_EQ(placed.texts[0].colour, style_of("drive").word);
  }
  panel.markers = {{1 - (width + 5) / 400 - 1e-9, "end", "drive"}};
  EXPECT_GT(words(panel).texts[0].box.x, words(panel).leaders[0].from.x);  // it just fits
  panel.markers = {{1 - (width + 4) / 400, "end", "drive"}};
  EXPECT_LT(words(panel).texts[0].box.x, words(panel).leaders[0].from.x);
  panel.markers = {{-1, "before", "drive"}, {0.5, "", "drive"}, {0.7, "end", "drive"}};
  EXPECT_EQ(words(panel).leaders.size(), 2u);
  EXPECT_EQ(words(panel).texts.size(), 1u);
  panel.markers = {{0.5, "", "drive"}};
  EXPECT_TRUE(words(panel).texts.empty());
  EXPECT_EQ(words(panel).leaders.size(), 1u);
}

TEST(Notes, PointAtTheirPoint) {
  Panel panel;
  panel.notes = {{"peak", 0.5, 0.5, 0.75, 0.9, true, true, true}};
  PlacedPanel placed = words(panel);
  const Spot point{250, 190};
  ASSERT_EQ(placed.rings.size(), 1u);
  EXPECT_EQ(placed.rings[0], point);
  EXPECT_EQ(placed.dots[0], point);
  ASSERT_EQ(placed.texts.size(), 1u);
  const PlacedText& text = placed.texts[0];
  EXPECT_NEAR(text.box.x, 50 + 0.75 * 400, 1e-9);
  EXPECT_NEAR(text.at.y, 340 - 0.9 * 300, 1e-9);
  EXPECT_TRUE(text.bold);
  EXPECT_EQ(text.size, 12);
  EXPECT_EQ(text.colour, light_surface.ink);
  EXPECT_FALSE(text.ground);
  ASSERT_EQ(placed.leaders.size(), 1u);
  const PlacedLine& leader = placed.leaders[0];
  EXPECT_NEAR(std::hypot(leader.to.x - point.x, leader.to.y - point.y), 5.5, 1e-9);  // at the ring, and 1 px
  EXPECT_DOUBLE_EQ(leader.width, 0.8);
  EXPECT_EQ(leader.colour, light_surface.ink);
  // On the straight line from the word to the point, 3 px off the word.
  const Spot edge{350, std::min(190.0, text.box.bottom() - 6)};
  EXPECT_NEAR(std::hypot(leader.from.x - edge.x, leader.from.y - edge.y), 3, 1e-9);
  EXPECT_NEAR((leader.to.x - edge.x) * (point.y - edge.y), (leader.to.y - edge.y) * (point.x - edge.x), 1e-6);

  panel.notes = {{"peak", 0.5, 0.5, 0.25, 0.9}};  // at the left: the word ends there
  placed = words(panel);
  EXPECT_NEAR(placed.texts[0].box.right(), 150, 1e-9);
  EXPECT_TRUE(placed.rings.empty() && placed.dots.empty());
  EXPECT_FALSE(placed.texts[0].bold);
  EXPECT_EQ(placed.texts[0].size, 11);
  EXPECT_NEAR(std::hypot(placed.leaders[0].to.x - 250, placed.leaders[0].to.y - 190), 3, 1e-9);
  panel.notes = {{"peak", 0.5, 0.5, 0.25, 0.9, false, false}};  // points at nothing
  placed = words(panel);
  EXPECT_NEAR(placed.texts[0].box.x, 150, 1e-9);
  EXPECT_TRUE(placed.leaders.empty());
  panel.notes = {{"peak", 0.5, 0.5, 0.51, 0.5}};  // too near for a line
  EXPECT_TRUE(words(panel).leaders.empty());
  panel.notes = {{"", 0.5, 0.5, 0.9, 0.9, true}};
  EXPECT_TRUE(words(panel).leaders.empty() && words(panel).texts.empty());
  for (const double at : {0.0, 1.0}) {
    panel.notes = {{"peak", 0.5, 0.5, at, 0.9}};
    EXPECT_GE(words(panel).texts[0].box.x, 53);
    EXPECT_LE(words(panel).texts[0].box.right(), 449 + 1e-9);
  }
}

TEST(InsideNames, StandFreeAndPointAtTheirCurve) {
  Panel panel;
  panel.names_inside = true;
  panel.curves = {named("a")};
  for (int i = 0; i <= 100; ++i) panel.curves[0].x.push_back(0.01 * i), panel.curves[0].y.push_back(0.5);
  PlacedPanel placed = words(panel);
  ASSERT_EQ(placed.texts.size(), 1u);
  EXPECT_FALSE(placed.crowded);
  EXPECT_FALSE(placed.texts[0].ground);
  const Box near = placed.texts[0].box;
  EXPECT_LT(std::min(std::abs(near.y - 190), std::abs(near.bottom() - 190)), 14);
  EXPECT_TRUE(placed.leaders.empty());
  // Where it was asked for, at the curve's own height there.
  panel.curves[0].label_x = 0.25;
  panel.curves[0].text_x = 0.5, panel.curves[0].text_y = 0.9;
  placed = words(panel);
  EXPECT_NEAR(placed.texts[0].box.x, 250, 1e-9);
  EXPECT_NEAR(placed.texts[0].at.y, 70, 1e-9);
  ASSERT_EQ(placed.leaders.size(), 1u);
  EXPECT_NEAR(std::hypot(placed.leaders[0].to.x - 150, placed.leaders[0].to.y - 190), 1, 1e-9);
  EXPECT_EQ(placed.leaders[0].colour, style_of("euler-cromer").word);
  panel.curves[0].label_y = 0.25;
  placed = words(panel);
  EXPECT_NEAR(std::hypot(placed.leaders[0].to.x - 150, placed.leaders[0].to.y - 265), 1, 1e-9);
  panel.curves[0].text_x = 0.2, panel.curves[0].text_y = 0.5;  // on the curve: on white
  EXPECT_TRUE(words(panel).texts[0].ground);
}

TEST(InsideNames, OfABandStandInItsMiddle) {
  Panel panel;
  panel.curves = {named("measured")};
  panel.curves[0].mark = Mark::band;
  for (int i = 0; i <= 20000; ++i)
    panel.curves[0].x.push_back(i / 2e4), panel.curves[0].y.push_back(0.6 + 0.2 * std::sin(2.0 * i));
  const PlacedPanel placed = words(panel);
  ASSERT_EQ(placed.texts.size(), 1u);
  const PlacedText& text = placed.texts[0];
  EXPECT_EQ(text.align, Align::centre);
  EXPECT_TRUE(text.ground);
  EXPECT_NEAR(text.at.x, 250, 1e-9);
  EXPECT_NEAR(text.at.y, 160, 1);
  EXPECT_NEAR(text.box.x + text.box.width / 2, 250, 1e-9);
}

TEST(NameLists, StandBesideTheirLinesFromTheTop) {
  Panel panel;
  panel.names_listed = true;
  panel.curves = {named("low"), named("high", "grows"), named("dots")};
  panel.curves[2].mark = Mark::dots;
  panel.curves[2].role = "measured";
  const double y[] = {0.2, 0.8, 0.5};
  for (std::size_t i = 0; i < 3; ++i) panel.curves[i].x = {0, 1}, panel.curves[i].y = {0.5, y[i]};
  const PlacedPanel placed = words(panel);
  ASSERT_EQ(placed.texts.size(), 4u);
  EXPECT_EQ(placed.texts[0].text, "high");
  EXPECT_EQ(placed.texts[1].text, "grows");
  EXPECT_EQ(placed.texts[2].text, "dots");
  EXPECT_EQ(placed.texts[3].text, "low");
  EXPECT_EQ(placed.texts[0].box.y, 40);
  EXPECT_EQ(placed.texts[1].box.y, placed.texts[0].box.bottom());
  EXPECT_NEAR(placed.texts[2].box.y, placed.texts[1].box.bottom() + 6, 1e-9);
  for (const PlacedText& text : placed.texts) {
    EXPECT_EQ(text.box.x, 450 + 10 + 26 + 6);
    EXPECT_EQ(text.at.x, text.box.x);
    EXPECT_NEAR(text.at.y, text.box.y + text.box.height / 2, 1e-9);
    EXPECT_NEAR(text.box.height, 1.28 * text.size, 1e-9);
  }
  ASSERT_EQ(placed.leaders.size(), 2u);
  EXPECT_EQ(placed.leaders[0].from, (Spot{460, placed.texts[0].at.y}));
  EXPECT_EQ(placed.leaders[0].to, (Spot{486, placed.texts[0].at.y}));
  EXPECT_EQ(placed.leaders[1].from.y, placed.texts[3].at.y);
  ASSERT_EQ(placed.dots.size(), 1u);
  EXPECT_EQ(placed.dots[0], (Spot{473, placed.texts[2].at.y}));
}

TEST(NameLists, TakeTheOrderWhereTheCurvesAreFurthestApart) {
  const Box frame{0, 0, 120, 100};
  const std::vector<std::size_t> both{0, 1};
  EXPECT_EQ(order_from_top({{{0, 10}, {120, 60}}, {{0, 20}, {120, 20}}}, both, frame),
            (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(order_from_top({{{0, 5}, {120, 30}}, {{0, 20}, {120, 20}}}, both, frame),
            (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(order_from_top({{{0, 5}, {50, 5}}, {{60, 2}, {120, 2}}}, both, frame), both);  // nowhere both
  EXPECT_EQ(order_from_top({{{0, 5}, {60, 5}}, {{60, 2}, {120, 2}}}, both, frame),
            (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(order_from_top({{{119.5, 5}, {120, 5}}, {{119.5, 2}, {120, 2}}}, both, frame),
            (std::vector<std::size_t>{1, 0}));  // at the very end
}

TEST(NameLists, TooLongNameEveryFewOnesAndSaySo) {
  const auto listed = [](std::size_t count, const std::string& remark) {
    Panel panel;
    panel.names_listed = true;
    for (std::size_t i = 0; i < count; ++i) {
      panel.curves.push_back(named("n" + std::to_string(i), remark));
      panel.curves.back().x = {0, 1};
      panel.curves.back().y.assign(2, 1 - static_cast<double>(i) / 100);
    }
    return words(panel);
  };
  // 300 px hold 19 names of 15.36 px, with what they do 10.
  EXPECT_EQ(listed(19, "").texts.size(), 19u);
  EXPECT_EQ(listed(8, "grows").texts.size(), 16u);
  EXPECT_EQ(listed(10, "grows").texts.size(), 10u);  // not with 6 px between them
  for (const std::size_t count : {20u, 35u, 36u, 60u}) {
    const PlacedPanel placed = listed(count, "");
    const PlacedText& last = placed.texts.back();
    const std::size_t stride = count <= 35 ? 2 : count == 36 ? 3 : 4;
    EXPECT_EQ(placed.texts.size(), (count + stride - 1) / stride + 1) << count;
    EXPECT_EQ(placed.texts[1].text, "n" + std::to_string(stride));
    EXPECT_EQ(last.text, "one of " + std::to_string(stride) + " is named");
    EXPECT_EQ(last.at.x, 460);
    EXPECT_EQ(last.size, 11);
    EXPECT_DOUBLE_EQ(last.box.width, text_width(last.text, 11, false, Typeface::lato));
    EXPECT_NEAR(last.at.y, last.box.y + last.box.height / 2, 1e-9);
    EXPECT_NEAR(last.box.y, placed.texts[placed.texts.size() - 2].box.bottom(), 1e-9);
    EXPECT_LE(last.box.bottom(), 340);
  }
}

TEST(OutsideNames, GoBelowThePlotOnlyWhereItIsTooLow) {
  Panel panel;
  for (int i = 0; i < 9; ++i) {
    panel.curves.push_back(named("n", i < 8 ? "r" : ""));
    panel.curves.back().x = {0, 1};
    panel.curves.back().y = {0, 0};
  }
  const double all = 8 * (1.28 * 23 + 6) + 1.28 * 12;  // 299 px beside 308
  ASSERT_LT(all, 308);
  const auto lowest = [&] {
    double bottom = 0;
    for (const PlacedText& text : words(panel).texts) bottom = std::max(bottom, text.box.bottom());
    return bottom;
  };
  EXPECT_LE(lowest(), 342 + 1e-9);
  panel.curves.push_back(panel.curves.back());
  EXPECT_GT(lowest(), 390);  // all the room there is
  EXPECT_LE(lowest(), 400);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
