#include "cromer/identify/diagnose/drop_outs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

TEST(DropOuts, RunsOfZerosOutsideTheMotion) {
  SyntheticRecord record = viscous_record({.position = 0.05}, even_times(3000, 0.01), 1e-4, 1e-4);
  std::vector<std::size_t> expected;
  for (const std::size_t first : {500u, 1700u})
    for (std::size_t i = first; i < first + 10; ++i) {
      record.y[i] = 0;
      expected.push_back(i);
    }
  EXPECT_EQ(drop_outs(record.record()), expected);
}

TEST(DropOuts, NoneInAMotion) {
  for (const double g : {0.01, 0.3, 2.0})  // also where most of the record is at rest
    for (const double resolution : {0.0, 1e-4, 5e-3, 2e-2})
      for (const double h : {0.01, 0.08})
        EXPECT_TRUE(
            drop_outs(
                viscous_record({.g = g, .position = 0.05}, even_times(3000, h), 1e-5, resolution).record())
                .empty())
            << g << " " << resolution << " " << h;
}

TEST(DropOuts, ATopThatIsCutOffIsNone) {
  SyntheticRecord record = viscous_record({.position = 0.05}, even_times(3000, 0.01), 0, 1e-4);
  for (double& y : record.y) y = std::min(y, 0.23);
  EXPECT_TRUE(drop_outs(record.record()).empty());
}

/// Up and down between -1 and 1 by so much a sample, resting at both for four samples more.
std::vector<double> up_and_down(std::size_t n, double change = 0.125) {
  std::vector<double> period;
  for (double y = -1; y < 1; y += change) period.push_back(y);
  period.insert(period.end(), 5, 1.0);
  for (double y = 1 - change; y >= -1; y -= change) period.push_back(y);
  period.insert(period.end(), 4, -1.0);
  std::vector<double> y;
  for (std::size_t i = 0; i < n; ++i) y.push_back(period[i % period.size()]);
  return y;
}

std::vector<std::size_t> dropped(std::vector<double> y, std::size_t from, const std::vector<double>& values,
                                 double resolution = 0) {
  std::copy(values.begin(), values.end(), y.begin() + static_cast<std::ptrdiff_t>(from));
  return drop_outs({even_times(y.size(), 0.01), y, resolution});
}

using Places = std::vector<std::size_t>;

TEST(DropOuts, OfThreeEqualValues) {
  const std::vector<double> y = up_and_down(400);
  EXPECT_TRUE(dropped(y, 100, {9, 9}).empty());
  EXPECT_EQ(dropped(y, 100, {9, 9, 9}), (Places{100, 101, 102}));
  EXPECT_EQ(dropped(y, 100, {-9, -9, -9, -9}), (Places{100, 101, 102, 103}));
  EXPECT_TRUE(dropped(y, 100, {9, 9, 9.5, 9.5}).empty());
  EXPECT_EQ(dropped(y, 0, {9, 9, 9}), (Places{0, 1, 2}));
  EXPECT_EQ(dropped(y, 397, {-9, -9, -9}), (Places{397, 398, 399}));
}

TEST(DropOuts, LieOutsideTheMotionByItsWidth) {
  const std::vector<double> y = up_and_down(400);
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(dropped(y, 100, std::vector<double>(3, sign * 3)).empty());
    EXPECT_EQ(dropped(y, 100, std::vector<double>(3, sign * 3.0625)).size(), 3u);
  }
}

// By more than half the motion's width, on both sides.
TEST(DropOuts, AreReachedAndLeftByAJump) {
  const std::vector<double> y = up_and_down(400);
  for (const double sign : {1.0, -1.0}) {
    const auto beside = [&](double before, double after) {
      return dropped(y, 100, {sign * before, sign * 4, sign * 4, sign * 4, sign * after}).size();
    };
    EXPECT_EQ(beside(2.9375, 2.9375), 3u);
    EXPECT_EQ(beside(3, 2.9375), 0u);
    EXPECT_EQ(beside(2.9375, 3), 0u);
    EXPECT_EQ(beside(5, 2.9375), 0u);
  }
}

// By four of the motion's own changes, and by four rounding steps.
TEST(DropOuts, JumpFurtherThanTheMotionAndItsRounding) {
  const auto beside = [](double change, double before, double resolution) {
    return dropped(up_and_down(400, change), 100, {before, 4, 4, 4, 0}, resolution).size();
  };
  EXPECT_EQ(beside(0.5, 1.9375, 0), 3u);
  EXPECT_EQ(beside(0.5, 2, 0), 0u);
  EXPECT_EQ(beside(0.125, 1.9375, 0.5), 3u);
  EXPECT_EQ(beside(0.125, 2, 0.5), 0u);
}

// Nine at a time, high and low by turns: what is more than a twentieth on either side is the motion.
TEST(DropOuts, AreNotMoreThanATenth) {
  const auto runs = [](std::size_t count) {
    std::vector<double> y = up_and_down(1000);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < 9; ++i) y[20 + 70 * k + i] = k % 2 == 0 ? 9 : -9;
    return drop_outs({even_times(y.size(), 0.01), y}).size();
  };
  EXPECT_EQ(runs(10), 90u);
  EXPECT_EQ(runs(12), 0u);
}

TEST(DropOuts, OfAVeryLongRecord) {
  std::vector<double> y = up_and_down(410'000);
  for (const std::size_t first : {7u, 250'001u, 409'000u}) std::fill_n(y.begin() + first, 3, 9.0);
  EXPECT_EQ(drop_outs({even_times(y.size(), 0.01), y}),
            (Places{7, 8, 9, 250'001, 250'002, 250'003, 409'000, 409'001, 409'002}));
}

}  // namespace
}  // namespace cromer::core
