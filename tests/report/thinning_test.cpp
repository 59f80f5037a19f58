#include "cromer/report/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer {
namespace {

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

}  // namespace
}  // namespace cromer
