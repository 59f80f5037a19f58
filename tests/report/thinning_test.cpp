// Thinned curves look the same; lines, dots and bands end where the frame does.
#include "cromer/report/thinning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer::core {
namespace CROMER_FILE {

constexpr double pi = 3.14159265358979323846;

std::vector<Spot> sine(int points, double width, double periods, double amplitude = 100) {
  std::vector<Spot> spots;
  for (int i = 0; i < points; ++i) {
    const double s = static_cast<double>(i) / (points - 1);
    spots.push_back({s * width, amplitude * std::sin(2 * pi * periods * s)});
  }
  return spots;
}

double distance_to_line(const std::vector<Spot>& line, Spot p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double dx = line[i].x - line[i - 1].x, dy = line[i].y - line[i - 1].y, l2 = dx * dx + dy * dy;
    const double s =
        l2 > 0 ? std::clamp(((p.x - line[i - 1].x) * dx + (p.y - line[i - 1].y) * dy) / l2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, std::hypot(p.x - line[i - 1].x - s * dx, p.y - line[i - 1].y - s * dy));
  }
  return nearest;
}

TEST(ThinLine, StaysWithinItsToleranceOfASmoothCurve) {
  const auto full = sine(8000, 640, 12);
  const auto thin = thin_line(full, 0.08);
  EXPECT_LT(thin.size(), full.size() / 5);
  for (const Spot& p : full)
    ASSERT_LT(distance_to_line(thin, p), 0.3);  // half a pixel column of a steep slope, and the tolerance
  EXPECT_EQ(thin.front(), full.front());
  EXPECT_EQ(thin.back(), full.back());
}

TEST(ThinLine, KeepsEveryPeakOfADenseCurve) {
  auto full = sine(200000, 640, 3000);
  full[100001].y = 250;
  const auto thin = thin_line(full);
  EXPECT_LT(thin.size(), 8u * 640);
  EXPECT_NE(std::find(thin.begin(), thin.end(), full[100001]), thin.end());
}

TEST(ThinLine, ThinsASpiralWithoutColumns) {
  std::vector<Spot> spiral;
  for (int i = 0; i < 5000; ++i)
    spiral.push_back({(0.02 * i + 50) * std::cos(0.01 * i), (0.02 * i + 50) * std::sin(0.01 * i)});
  const auto thin = thin_line(spiral, 0.08);
  EXPECT_LT(thin.size(), 1500u);
  for (const Spot& p : spiral) ASSERT_LT(distance_to_line(thin, p), 0.09);
}

TEST(ThinLine, LeavesAStraightLineItsEnds) {
  EXPECT_LE(thin_line(std::vector<Spot>{{0, 0}, {0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}}).size(), 2u);
  EXPECT_EQ(thin_line(std::vector<Spot>{{1, 2}}).size(), 1u);
  EXPECT_TRUE(thin_line(std::vector<Spot>{}).empty());
}

TEST(Unbroken, NanParts) {
  const double nan = std::nan("");
  const auto pieces = unbroken(std::vector<Spot>{{nan, 1}, {0, 0}, {1, 1}, {2, nan}, {3, 3}});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].size(), 2u);
  EXPECT_EQ(pieces[1].front(), (Spot{3, 3}));
}

TEST(MinMaxBand, HoldsEveryPointAndHasNoGaps) {
  const auto points = sine(12000, 340, 170);
  const Band band = min_max_band(points, 3);
  for (const Spot& p : points) {
    const auto column = static_cast<std::size_t>(std::floor(p.x));
    const std::size_t i = std::min(column, band.x.size() - 1);
    ASSERT_LE(band.low[i], p.y + 1e-9);
    ASSERT_GE(band.high[i], p.y - 1e-9);
  }
  for (std::size_t i = 1; i < band.x.size(); ++i) {
    ASSERT_LE(band.low[i], band.high[i - 1]);
    ASSERT_GE(band.high[i], band.low[i - 1]);
  }
  EXPECT_NEAR(*std::min_element(band.high.begin(), band.high.end()), 100,
              2);  // filled up to the envelope, ends included
  EXPECT_TRUE(min_max_band({}, 1).x.empty());
}

TEST(Extremes, KeepEveryPeakAndAreFew) {
  std::vector<double> x, y;
  for (int i = 0; i < 100000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(0.37 * i));
  }
  y[77777] = 9;
  y[500] = std::nan("");
  const std::vector<std::size_t> kept = extremes(x, y, 200);
  EXPECT_LE(kept.size(), 4u * 202);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const std::size_t wanted : {0u, 500u, 77777u, 99999u})
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), wanted)) << wanted;
  EXPECT_EQ(extremes(std::span(x).first(700), std::span(y).first(700), 200).size(), 700u);
}

TEST(ColumnsPerPeriod, CountsCrossings) {
  EXPECT_NEAR(columns_per_period(sine(12000, 340, 170)), 2, 0.05);
  EXPECT_NEAR(columns_per_period(sine(2000, 600, 20)), 30, 2);
  EXPECT_TRUE(std::isinf(columns_per_period(std::vector<Spot>{{0, 0}, {1, 1}, {2, 2}})));
}

TEST(ThinDots, OneDotPerQuarterPixel) {
  EXPECT_EQ(thin_dots(std::vector<Spot>{{1, 1}, {1.01, 1}, {1, 1.3}, {std::nan(""), 1}}).size(), 2u);
}

TEST(ThinLine, KeepsOfEachHalfColumnFirstLowestHighestAndLast) {
  const std::vector<Spot> points{{0, 0},      {0.05, -9}, {0.1, 3},  {0.15, 8}, {0.2, 2}, {0.3, 1},
                                 {0.49, 0.5}, {0.5, 40},  {0.6, 41}, {0.99, 0}, {1, 7}};
  const std::vector<Spot> kept{{0, 0},    {0.05, -9}, {0.15, 8}, {0.49, 0.5},
                               {0.5, 40}, {0.6, 41},  {0.99, 0}, {1, 7}};
  EXPECT_EQ(thin_line(points, 0), kept);
}

TEST(ThinLine, LeavesOutWhatIsWithinItsTolerance) {
  const std::vector<Spot> bent{{0, 0}, {10, 1}, {20, 0}};
  EXPECT_EQ(thin_line(bent, 0.99), bent);
  EXPECT_EQ(thin_line(bent, 1), (std::vector<Spot>{{0, 0}, {20, 0}}));
  // Beyond an end the distance to the end counts: a line that goes forth and back keeps its turn.
  const std::vector<Spot> back{{0, 0}, {30, 0}, {10, 0}};
  EXPECT_EQ(thin_line(back, 0.08), back);
  const std::vector<Spot> round{{0, 0}, {5, 5}, {0, 0}};
  EXPECT_EQ(thin_line(round, 0.08), round);
  std::vector<Spot> straight;
  for (int i = 0; i < 300; ++i) straight.push_back({static_cast<double>(i), 0});
  EXPECT_EQ(thin_line(straight).size(), 6u);  // every 64th and both ends
}

TEST(Extremes, KeepOfEachColumnFirstLowestHighestAndLast) {
  std::vector<double> x, y;
  for (int i = 0; i < 20; ++i) x.push_back(i), y.push_back(i % 10 == 3 ? -5 : i % 10 == 6 ? 5 : 0.1 * i);
  EXPECT_EQ(extremes(x, y, 2), (std::vector<std::size_t>{0, 3, 6, 9, 10, 13, 16, 18, 19}));
  EXPECT_EQ(extremes(x, y, 5).size(), 20u);  // four a column
  EXPECT_LT(extremes(x, y, 4).size(), 20u);
  EXPECT_TRUE(extremes({}, {}, 3).empty());
  y[7] = std::nan("");
  EXPECT_EQ(extremes(x, y, 2), (std::vector<std::size_t>{0, 3, 6, 7, 8, 9, 10, 13, 16, 18, 19}));
}

TEST(ThinDots, QuartersAreTold) {
  const std::vector<Spot> kept =
      thin_dots(std::vector<Spot>{{0, 0}, {0.25, 0}, {0.5, 0}, {0, 0.25}, {0.1, 0.1}});
  EXPECT_EQ(kept, (std::vector<Spot>{{0, 0}, {0.25, 0}, {0.5, 0}, {0, 0.25}}));
  EXPECT_TRUE(thin_dots(std::vector<Spot>{{1, std::nan("")}}).empty());
}

TEST(MinMaxBand, HasOneColumnPerPixel) {
  const std::vector<Spot> points{{2.25, 5}, {0.25, 1}, {0.75, 3}, {1.1, 9}, {1.9, 7}, {std::nan(""), 0}};
  const Band band = min_max_band(points, 1);
  EXPECT_EQ(band.x, (std::vector<double>{0.25, 1.5, 2.25}));
  EXPECT_EQ(band.low, (std::vector<double>{1, 3, 5}));  // joined to the column before
  EXPECT_EQ(band.high, (std::vector<double>{3, 9, 5}));
  const Band falling = min_max_band(std::vector<Spot>{{0.5, 9}, {1.5, 4}, {2.5, 2}}, 1);
  EXPECT_EQ(falling.high, (std::vector<double>{9, 9, 4}));
  EXPECT_EQ(falling.low, (std::vector<double>{9, 4, 2}));
}

TEST(MinMaxBand, LooksAtTheNeighboursEvenlyAndAtAsManyAtTheEnds) {
  std::vector<Spot> points;
  for (int i = 0; i < 7; ++i) points.push_back({i + 0.5, static_cast<double>(i * i)});
  const Band three = min_max_band(points, 3);
  EXPECT_EQ(three.low, (std::vector<double>{0, 0, 1, 4, 9, 16, 16}));
  EXPECT_EQ(three.high, (std::vector<double>{4, 4, 9, 16, 25, 36, 36}));
  const Band two = min_max_band(points, 2);
  EXPECT_EQ(two.low, (std::vector<double>{0, 1, 4, 9, 16, 25, 25}));
  EXPECT_EQ(two.high, (std::vector<double>{1, 4, 9, 16, 25, 36, 36}));
  const Band many = min_max_band(points, 50);
  EXPECT_EQ(many.low, std::vector<double>(7, 0));
  EXPECT_EQ(many.high, std::vector<double>(7, 36));
}

TEST(ColumnsPerPeriod, NoiseAboutTheMiddleIsNoCrossing) {
  std::vector<Spot> points;
  for (int i = 0; i <= 100; ++i) points.push_back({static_cast<double>(i), i % 50 < 25 ? 1.0 : -1.0});
  EXPECT_DOUBLE_EQ(columns_per_period(points), 50);  // four crossings in 100 columns
  for (int i = 0; i <= 100; ++i)
    if (i % 25 >= 5 && i % 25 < 20) points[static_cast<std::size_t>(i)].y = i % 2 ? 0.02 : -0.02;
  EXPECT_DOUBLE_EQ(columns_per_period(points), 50);
  EXPECT_TRUE(std::isinf(columns_per_period(std::vector<Spot>{{0, 0}, {1, 1}})));
  EXPECT_DOUBLE_EQ(columns_per_period(std::vector<Spot>{{0, 1}, {1, -1}, {2, 1}}), 2);
  EXPECT_TRUE(std::isinf(columns_per_period(std::vector<Spot>{{0, 1}, {1, 1}, {2, -1}, {3, -1}})));
  // A gap takes no columns.
  EXPECT_DOUBLE_EQ(columns_per_period(std::vector<Spot>{
                       {0, 1}, {1, -1}, {2, 1}, {std::nan(""), std::nan("")}, {90, 1}, {91, -1}}),
                   2);
}

TEST(Extremes, ColumnsAreAsWideWhereverTheyBegin) {
  std::vector<double> x, y;
  for (int i = 0; i < 40; ++i) x.push_back(1000 + i), y.push_back(i % 2);
  const auto moved = extremes(x, y, 4);
  for (double& each : x) each -= 1000;
  EXPECT_EQ(moved, extremes(x, y, 4));
}

using Pieces = std::vector<std::vector<Spot>>;

constexpr Box frame{10, 20, 100, 50};

void expect_near(const Pieces& pieces, const Pieces& expected) {
  ASSERT_EQ(pieces.size(), expected.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_EQ(pieces[i].size(), expected[i].size()) << i;
    for (std::size_t k = 0; k < pieces[i].size(); ++k) {
      EXPECT_NEAR(pieces[i][k].x, expected[i][k].x, 0.03) << i << " " << k;
      EXPECT_NEAR(pieces[i][k].y, expected[i][k].y, 0.03) << i << " " << k;
    }
  }
}

TEST(Clip, WhatLiesInsideStaysToTheBit) {
  std::vector<Spot> line{{10, 20}, {110, 70}};
  for (int i = 0; i < 100; ++i)
    line.push_back({60 + 49.9 * std::cos(0.7 * i), 45 + 24.9 * std::sin(0.3 * i)});
  EXPECT_EQ(pieces_inside(line, frame), Pieces{line});
}

TEST(Clip, ALineIsCutAtEachEdge) {
  expect_near(pieces_inside({{0, 30}, {20, 30}}, frame), {{{10, 30}, {20, 30}}});
  expect_near(pieces_inside({{100, 30}, {120, 40}}, frame), {{{100, 30}, {110, 35}}});
  expect_near(pieces_inside({{50, 0}, {50, 40}}, frame), {{{50, 20}, {50, 40}}});
  expect_near(pieces_inside({{50, 60}, {50, 3000}}, frame), {{{50, 60}, {50, 70}}});
}

TEST(Clip, ALineThatCrossesTheFrameBetweenTwoSpotsIsSeen) {
  expect_near(pieces_inside({{0, 45}, {120, 45}}, frame), {{{10, 45}, {110, 45}}});
  expect_near(pieces_inside({{0, 10}, {120, 70}}, frame), {{{20, 20}, {110, 65}}});
}

TEST(Clip, ALineThatComesBackHasTwoPieces) {
  expect_near(pieces_inside({{20, 60}, {30, 80}, {40, 60}, {50, 60}}, frame),
              {{{20, 60}, {25, 70}}, {{35, 70}, {40, 60}, {50, 60}}});
}

TEST(Clip, NothingIsLeftOfWhatPassesBeside) {
  EXPECT_EQ(pieces_inside({{0, 28}, {20, 10}}, frame), Pieces{});  // round a corner
  EXPECT_EQ(pieces_inside({{0, 80}, {120, 80}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside({{0, 19.98}, {120, 19.98}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside({{50, 50}}, frame), Pieces{});
  EXPECT_EQ(pieces_inside(std::vector<Spot>{}, frame), Pieces{});
}

TEST(Clip, ALineAlongTheEdgeIsSeenInSpiteOfRounding) {
  expect_near(pieces_inside({{10, 70 + 1e-9}, {110, 70 + 1e-9}}, frame), {{{10, 70}, {110, 70}}});
  EXPECT_TRUE(inside({10 - 1e-9, 70 + 1e-9}, frame));
  EXPECT_TRUE(inside({110, 20}, frame));
}

TEST(Clip, DotsBeyondAnyEdgeAreOutside) {
  for (const Spot p : {Spot{9.9, 40}, {110.1, 40}, {50, 19.9}, {50, 70.1}, {NAN, 40}})
    EXPECT_FALSE(inside(p, frame)) << p.x << " " << p.y;
}

TEST(Clip, ABandIsHeldAtTheUpperAndLowerEdge) {
  const Band band =
      band_inside(Band{{0, 20, NAN, 30, 120}, {90, 65, NAN, 80, 60}, {10, 30, NAN, 15, 30}}, frame);
  ASSERT_EQ(band.x.size(), 3u);
  EXPECT_EQ(band.x[0], 20);
  EXPECT_TRUE(std::isnan(band.x[1]));
  EXPECT_EQ(band.x[2], 30);
  EXPECT_EQ(band.low[0], 65);
  EXPECT_EQ(band.high[0], 30);
  EXPECT_EQ(band.low[2], 70);
  EXPECT_EQ(band.high[2], 20);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
