// From data to what is drawn in px: where points go, which mark they get, where a name faces a curve.
#include "cromer/report/place_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace CROMER_FILE {

const double none = std::nan("");

AxisRange axis(double low, double high, double from, double to) { return {low, high, false, from, to, 0}; }

Panel panel_of(std::size_t curves) {
  Panel panel;
  panel.curves.resize(curves);
  for (Curve& curve : panel.curves) curve.mark = Mark::dots;
  return panel;
}
const Panel alone = panel_of(1), one_of_two = panel_of(2), phase = [] {
  Panel portrait = panel_of(2);
  portrait.phase_portrait = true;
  return portrait;
}();

TEST(SpotsOf, ACurvePassesWhereItsDataAre) {
  Curve curve;
  curve.x = {0, 5, 10, none, 3, 7};
  curve.y = {-1, 1, 0, 0, none, 0.5};
  const auto spots = spots_of(curve, axis(0, 10, 100, 300), axis(-1, 1, 250, 50));
  ASSERT_EQ(spots.size(), 6u);
  EXPECT_EQ(spots[0], (Spot{100, 250}));
  EXPECT_EQ(spots[1], (Spot{200, 50}));
  EXPECT_EQ(spots[2], (Spot{300, 150}));
  for (const std::size_t broken : {3u, 4u})
    EXPECT_TRUE(std::isnan(spots[broken].x) && std::isnan(spots[broken].y));
  EXPECT_EQ(spots[5], (Spot{240, 100}));
  curve.y.resize(2);
  EXPECT_EQ(spots_of(curve, axis(0, 10, 100, 300), axis(-1, 1, 250, 50)).size(), 2u);
}

TEST(SpotsOf, WhatIsFarOutsideIsHeldAtADistance) {
  Curve curve;
  curve.x = {-1e9, 1e9, 5, 5};
  curve.y = {0, 0, 1e9, -1e9};
  const auto spots = spots_of(curve, axis(0, 10, 100, 300), axis(-1, 1, 250, 50));
  EXPECT_EQ(spots[0].x, 100 - 3000);
  EXPECT_EQ(spots[1].x, 300 + 3000);
  EXPECT_EQ(spots[2].y, 50 - 3000);
  EXPECT_EQ(spots[3].y, 250 + 3000);
  curve.mark = Mark::crosses;
  EXPECT_EQ(spots_of(curve, axis(0, 10, 100, 300), axis(-1, 1, 250, 50))[2].y, 54);
  EXPECT_EQ(spots_of(curve, axis(0, 10, 100, 300), axis(-1, 1, 250, 50))[3].y, 246);
}

TEST(PlaceCurve, WidthsAreThoseOfLookMd) {
  Curve curve;
  const std::vector<Spot> spots{{0, 0}, {10, 10}};
  curve.role = "euler-cromer";
  EXPECT_DOUBLE_EQ(place_curve(curve, spots, alone).width, 1.5);
  EXPECT_DOUBLE_EQ(place_curve(curve, spots, one_of_two).width, 1.3);
  EXPECT_EQ(place_curve(curve, spots, one_of_two).colour, "#0072B2");
  curve.dashed = true;
  EXPECT_EQ(place_curve(curve, spots, one_of_two).dash, (std::array<double, 4>{6, 4, 0, 0}));
  curve.role = "newmark";  // dashed already
  EXPECT_EQ(place_curve(curve, spots, one_of_two).dash, (std::array<double, 4>{3, 3, 0, 0}));
  curve.dashed = false;
  EXPECT_EQ(place_curve(curve, spots, one_of_two).dash, (std::array<double, 4>{3, 3, 0, 0}));
  EXPECT_EQ(place_curve(curve, spots, alone).dash, (std::array<double, 4>{}));  // nothing to tell it from
  curve.role = "exact", curve.dashed = false;
  EXPECT_DOUBLE_EQ(place_curve(curve, spots, alone).width, 4.5);
  EXPECT_DOUBLE_EQ(place_curve(curve, spots, phase).width, 3);
  EXPECT_EQ(place_curve(curve, spots, one_of_two).dash, (std::array<double, 4>{}));
  curve.role = "fitted", curve.road = true;
  EXPECT_DOUBLE_EQ(place_curve(curve, spots, one_of_two).width, 3);
}

TEST(PlaceCurve, CrossesAreTwoStrokesAboutTheirPoint) {
  Curve curve;
  curve.mark = Mark::crosses;
  const auto placed = place_curve(curve, {{10, 20}, {none, none}, {10.1, 20.1}, {30, 20}}, one_of_two);
  EXPECT_EQ(placed.mark, Mark::line);
  ASSERT_EQ(placed.pieces.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& stroke = placed.pieces[i];
    ASSERT_EQ(stroke.size(), 2u);
    EXPECT_NEAR((stroke[0].x + stroke[1].x) / 2, i < 2 ? 10 : 30, 1e-9);
    EXPECT_NEAR((stroke[0].y + stroke[1].y) / 2, 20, 1e-9);
    EXPECT_NEAR(stroke[1].x - stroke[0].x, 4.4, 1e-9);
    EXPECT_NEAR(stroke[1].y - stroke[0].y, i % 2 ? -4.4 : 4.4, 1e-9);
  }
}

/// `per_column` points in each of 200 px columns, 8 columns a period or what is asked for.
std::vector<Spot> wave(int per_column, double columns, double height) {
  std::vector<Spot> spots;
  for (int i = 0; i < 200 * per_column; ++i) {
    const double x = static_cast<double>(i) / per_column;
    spots.push_back({x, 100 + height * std::cos(2 * 3.14159265358979 * x / columns + 0.1)});
  }
  return spots;
}

TEST(PlaceCurve, DotsBecomeABandOrALineWhereTheyCannotBeToldApart) {
  Curve curve;
  curve.role = "measured";
  curve.mark = Mark::dots;
  const auto mark = [&](const std::vector<Spot>& spots) {
    return place_curve(curve, spots, one_of_two).mark;
  };
  EXPECT_EQ(mark(wave(5, 5.5, 40)), Mark::band);
  EXPECT_EQ(mark(wave(5, 7, 40)), Mark::line);     // periods can be told apart
  EXPECT_EQ(mark(wave(3, 5.5, 40)), Mark::dots);   // points can
  EXPECT_EQ(mark(wave(5, 5.5, 0.2)), Mark::dots);  // thinner than two px
  EXPECT_EQ(place_curve(curve, wave(5, 7, 40), one_of_two).width, 1);
  // Dots of a narrow swing would make a pattern of their own.
  EXPECT_EQ(mark(wave(2, 7, 40)), Mark::line);
  EXPECT_EQ(mark(wave(2, 60, 40)), Mark::dots);
  EXPECT_EQ(place_curve(curve, wave(1, 7, 40), one_of_two).width, 2.6);
  std::vector<Spot> two_high;
  for (int i = 0; i < 1000; ++i) two_high.push_back({0.2 * i, i % 2 ? 102.0 : 100.0});
  EXPECT_EQ(mark(two_high), Mark::dots);
  two_high[500].y = 99;
  EXPECT_EQ(mark(two_high), Mark::band);
  curve.mark = Mark::band;
  EXPECT_EQ(mark(wave(5, 5.5, 40)), Mark::band);
  EXPECT_EQ(mark(wave(3, 5.5, 40)), Mark::line);
  EXPECT_EQ(place_curve(curve, wave(3, 5.5, 40), one_of_two).width, 1);
  curve.mark = Mark::line;
  EXPECT_EQ(mark(wave(5, 5.5, 40)), Mark::line);
  EXPECT_EQ(place_curve(curve, wave(5, 5.5, 40), alone).width, 1);
  EXPECT_EQ(mark({}), Mark::line);
}

TEST(PlaceCurve, DotsOnALineStandApartAndFewAreLarge) {
  Curve curve;
  curve.role = "measured";
  curve.mark = Mark::dots;
  Panel with_law = one_of_two;
  with_law.curves[1].mark = Mark::line;
  with_law.curves[1].role = "fitted";
  const std::vector<Spot> dense = wave(1, 50, 40);
  const PlacedCurve sparse = place_curve(curve, dense, with_law);
  EXPECT_EQ(place_curve(curve, dense, one_of_two).pieces[0].size(), dense.size());
  const std::vector<Spot>& kept = sparse.pieces[0];
  EXPECT_LT(kept.size(), dense.size());
  EXPECT_EQ(kept.front(), dense.front());
  for (std::size_t i = 1; i < kept.size(); ++i)
    EXPECT_GE(std::hypot(kept[i].x - kept[i - 1].x, kept[i].y - kept[i - 1].y), 5);
  EXPECT_EQ(sparse.width, 2.6);
  const std::vector<Spot> few(dense.begin(), dense.begin() + 40), more(dense.begin(), dense.begin() + 41);
  EXPECT_EQ(place_curve(curve, few, one_of_two).width, 5);
  EXPECT_EQ(place_curve(curve, more, one_of_two).width, 2.6);
  // 1 px apart; up to sixty may have error bars.
  const std::vector<Spot> close(dense.begin(), dense.begin() + 60), many(dense.begin(), dense.begin() + 61);
  EXPECT_EQ(place_curve(curve, close, with_law).pieces[0].size(), close.size());
  EXPECT_LT(place_curve(curve, many, with_law).pieces[0].size(), many.size() / 2);
  // Error bars and guide lines hide no dots.
  for (const char* role : {"measured", "grid"}) {
    with_law.curves[1].role = role;
    EXPECT_EQ(place_curve(curve, dense, with_law).pieces[0].size(), dense.size()) << role;
  }
}

TEST(PlaceCurve, ABandFillsUpToTheEnvelope) {
  Curve curve;
  curve.mark = Mark::band;
  const Band band = place_curve(curve, wave(20, 5.5, 40), one_of_two).band;
  ASSERT_EQ(band.x.size(), 200u);
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    EXPECT_NEAR(band.low[i], 60, 1);
    EXPECT_NEAR(band.high[i], 140, 1);
  }
  std::vector<Spot> parted = wave(20, 5.5, 40);
  parted[2000] = {none, none};
  const Band two = place_curve(curve, parted, one_of_two).band;
  ASSERT_EQ(two.x.size(), two.low.size());
  ASSERT_EQ(two.x.size(), two.high.size());
  EXPECT_TRUE(std::isnan(two.x[100]));
}

TEST(PlaceCurve, LoneAndAskedForPointsGetDots) {
  Curve curve;
  const std::vector<Spot> spots{{0, 0}, {none, none}, {10, 10}, {20, 30}, {30, 0}};
  PlacedCurve placed = place_curve(curve, spots, one_of_two);
  EXPECT_EQ(placed.dots, (std::vector<Spot>{{0, 0}}));
  ASSERT_EQ(placed.pieces.size(), 2u);
  EXPECT_EQ(placed.pieces[1], (std::vector<Spot>{{10, 10}, {20, 30}, {30, 0}}));
  curve.with_dots = true;
  placed = place_curve(curve, spots, one_of_two);
  EXPECT_EQ(placed.dots, (std::vector<Spot>{{0, 0}, {10, 10}, {20, 30}, {30, 0}}));
}

TEST(HeightAtEnd, IsTheLastPointsOrTheLastPeakOfASwing) {
  const Box frame{0, 0, 300, 200};
  EXPECT_EQ(height_at_end({{0, 10}, {300, 70}}, frame), 70);
  EXPECT_EQ(height_at_end({{0, 10}, {300, 70}, {none, none}}, frame), 70);
  EXPECT_EQ(height_at_end({{0, 10}, {250, 30}, {301, 70}}, frame), 30);  // the last in sight
  EXPECT_EQ(height_at_end({{0, 10}, {250, 30}, {300.5, 70}}, frame), 70);
  EXPECT_EQ(height_at_end({{-1, 10}, {500, 1}}, frame), 100);  // none: the middle
  EXPECT_EQ(height_at_end({}, frame), 100);
  EXPECT_EQ(height_at_end({{0, 10}, {300, 900}}, frame), 200);
  EXPECT_EQ(height_at_end({{0, 10}, {300, -900}}, frame), 0);
  EXPECT_EQ(height_at_end({{300, 70}, {0, 10}}, frame), 70);  // at the right, however the data run
  // Two turns in the last third: a swing, whose last peak (upwards: small y) counts.
  EXPECT_EQ(
      height_at_end({{0, 100}, {205, 100}, {220, 40}, {240, 160}, {260, 50}, {280, 150}, {300, 100}}, frame),
      50);
  // One turn is no swing, nor is noise of 2 px, nor what lies before the last third.
  EXPECT_EQ(height_at_end({{0, 100}, {250, 40}, {300, 100}}, frame), 100);
  EXPECT_EQ(height_at_end({{0, 100}, {220, 98}, {240, 100}, {260, 98}, {280, 100}, {300, 99}}, frame), 99);
  EXPECT_EQ(height_at_end({{0, 100}, {120, 40}, {140, 160}, {160, 40}, {180, 150}, {300, 100}}, frame), 100);
  EXPECT_EQ(height_at_end({{0, 100}, {200, 100}, {220, 160}, {240, 40}, {270, 150}, {300, 90}}, frame), 40);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
