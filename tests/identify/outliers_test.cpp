#include "cromer/identify/diagnose/outliers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<double> normal_values(std::size_t n, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(n);
  for (double& value : values) value = normal(engine);
  return values;
}

std::vector<std::size_t> outliers_of(const std::vector<double>& residuals) {
  return outliers({even_times(residuals.size(), 0.01), residuals, 0}, residuals);
}

TEST(Outliers, AreTheSamplesThatStandOut) {
  std::vector<double> r = normal_values(2000, 1);
  r[0] = 20;
  r[700] = -9;
  r[701] = 30;
  r[1999] = 1e6;
  EXPECT_THAT(outliers_of(r), ElementsAre(0, 700, 701, 1999));
}

TEST(Outliers, NoiseThatGrowsWithTheMotionHasFew) {
  const std::vector<double> t = even_times(1000, 0.02);
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const std::vector<double> deviates = normal_values(1000, seed), floor = normal_values(1000, 1000 + seed);
    std::vector<double> r, y;
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double x = 0.05 * std::exp(-0.07 * t[i]) * std::cos(6 * t[i]);
      r.push_back(0.05 * x * deviates[i] + 1e-4 * floor[i]);
      y.push_back(x + r.back());
    }
    found += outliers({t, y, 0}, r).size();
    // A spike where the motion is all but over.
    y[900] += 0.01;
    r[900] += 0.01;
    EXPECT_THAT(outliers({t, y, 0}, r), testing::Contains(900)) << seed;
  }
  EXPECT_LE(found, 10u);
}

TEST(Outliers, NormalNoiseHasOneInTenRecordsOrFewer) {
  for (const std::size_t n : {100u, 2000u, 20000u}) {
    std::size_t found = 0;
    for (unsigned seed = 0; seed < 100; ++seed) found += outliers_of(normal_values(n, seed)).size();
    EXPECT_LE(found, 20u) << n;
  }
}

TEST(Outliers, WhatAWrongLawLeavesIsNone) {
  std::vector<double> r = normal_values(4000, 3);
  for (std::size_t i = 0; i < 400; ++i)
    r[i] += 30 * std::sin(0.1 * static_cast<double>(i)) * (1 - static_cast<double>(i) / 400);
  EXPECT_THAT(outliers_of(r), IsEmpty());
}

TEST(Outliers, RoundingIsNone) {
  std::vector<double> r(1000, 0.0);
  for (std::size_t i = 0; i < r.size(); i += 50) r[i] = 1;
  const std::vector<double> t = even_times(r.size(), 0.01);
  EXPECT_THAT(outliers({t, r, 1}, r), IsEmpty());
  EXPECT_EQ(outliers({t, r, 0}, r).size(), 20u);
}

TEST(Outliers, ThatChangeSidesForeverAreNotFollowed) {
  // Without the one sample the other stands out, and the other way round.
  const std::vector<double> noise = normal_values(200, 3);
  const std::vector<double> t = even_times(200, 0.01);
  const Record record{t, noise, 0};
  int fits = 0;
  const auto fit = [&](const Record&) { return ++fits; };
  const auto residuals_of = [&](int made, const Record&) {
    std::vector<double> r = noise;
    r[made % 2 == 0 ? 50 : 60] = 30;
    return r;
  };
  const auto settled = settle_outliers(record, 0, {}, fit, residuals_of);
  EXPECT_EQ(fits, 2);
  EXPECT_EQ(settled.result, 2);
  EXPECT_THAT(settled.aside, ElementsAre(60));
  EXPECT_EQ(settled.residuals[50], 30);
}

TEST(Outliers, MoreThanATenthOfAllAreNone) {
  std::vector<double> r = normal_values(1000, 4);
  for (std::size_t i = 0; i < r.size(); i += 9) r[i] += 40;
  EXPECT_THAT(outliers_of(r), IsEmpty());
}

// Five samples in a hundred are off by up to the amplitude: fifty times the noise.
SyntheticRecord with_outliers(const ViscousTruth& truth, unsigned seed) {
  SyntheticRecord record = viscous_record(truth, even_times(1500, 0.01), 1e-3, 0, seed);
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-0.05, 0.05);
  for (double& y : record.y)
    if (engine() % 20 == 0) y += uniform(engine);
  return record;
}

TEST(Outliers, CostAFitLittleAndItsIntervalsHold) {
  const ViscousTruth truth{.w0 = 6, .g = 0.05, .position = 0.05, .velocity = 0};
  constexpr int trials = 400;
  int covered_g = 0, covered_x = 0;
  double scatter = 0, clean_scatter = 0, aside = 0;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const SyntheticRecord record = with_outliers(truth, seed);
    const LawFit fit = fit_law(record.record(), {});
    ASSERT_EQ(fit.status, FitStatus::converged);
    covered_g += fit.decay_rate().low <= truth.g && truth.g <= fit.decay_rate().high;
    covered_x += fit.position().low <= truth.position && truth.position <= fit.position().high;
    scatter += std::pow(fit.decay_rate().value - truth.g, 2);
    aside += static_cast<double>(fit.outliers.size()) / trials;
    const SyntheticRecord clean = viscous_record(truth, even_times(1500, 0.01), 1e-3, 0, seed);
    clean_scatter += std::pow(fit_law(clean.record(), {}).decay_rate().value - truth.g, 2);
  }
  EXPECT_GE(covered_g, 0.92 * trials);  // 0.95, sd 0.011
  EXPECT_GE(covered_x, 0.92 * trials);
  EXPECT_NEAR(aside, 0.05 * 1500 * 0.91, 4);  // the rest lies within the noise
  EXPECT_LT(scatter, 1.3 * clean_scatter);    // with them 20 times as much
}

TEST(Outliers, LeaveTheChoiceOfTheLawAlone) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const SyntheticRecord record = with_outliers({.w0 = 6, .g = 0.05, .position = 0.05, .velocity = 0}, seed);
    const LawChoice choice = choose_law(record.record(), {});
    EXPECT_EQ(to_text(choice.chosen.law), "viscous") << seed;
    EXPECT_NEAR(choice.chosen.residual.rms, 1e-3, 1e-4);
    EXPECT_GT(choice.chosen.outliers.size(), 40u);
  }
}

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
  const auto runs = [](std::size_t count, std::size_t last = 9) {
    std::vector<double> y = up_and_down(1000);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < (k + 1 < count ? 9 : last); ++i) y[20 + 70 * k + i] = k % 2 == 0 ? 9 : -9;
    return drop_outs({even_times(y.size(), 0.01), y}).size();
  };
  EXPECT_EQ(runs(10), 90u);
  EXPECT_EQ(runs(10, 13), 94u);
  EXPECT_EQ(runs(12), 0u);
}

TEST(DropOuts, OfAVeryLongRecord) {
  std::vector<double> y = up_and_down(410'000);
  for (const std::size_t first : {7u, 250'001u, 409'000u}) std::fill_n(y.begin() + first, 3, 9.0);
  EXPECT_EQ(drop_outs({even_times(y.size(), 0.01), y}),
            (Places{7, 8, 9, 250'001, 250'002, 250'003, 409'000, 409'001, 409'002}));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
