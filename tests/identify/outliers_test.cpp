#include "cromer/identify/diagnose/outliers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

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
SyntheticRecord with_outliers(const Truth& truth, unsigned seed) {
  SyntheticRecord record = viscous_record(truth, even_times(1500, 0.01), 1e-3, 0, seed);
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-0.05, 0.05);
  for (double& y : record.y)
    if (engine() % 20 == 0) y += uniform(engine);
  return record;
}

TEST(Outliers, CostAFitLittleAndItsIntervalsHold) {
  const Truth truth{.w0 = 6, .g = 0.05, .position = 0.05, .velocity = 0};
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

}  // namespace
}  // namespace cromer::core
