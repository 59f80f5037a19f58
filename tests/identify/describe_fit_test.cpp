#include "cromer/identify/describe_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(DescribeFit, ASingularFitHasNoFiniteStandardErrorAndSaysSo) {
  const SyntheticRecord record = viscous_record({}, even_times(100, 0.01), 1e-3);
  SquareMatrix singular{};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) singular[i][j] = 1;
  for (const SquareMatrix& matrix : {singular, SquareMatrix{}}) {
    LawFit fit;
    const FittedParameters fitted = fitted_parameters(fit.law);
    const Parameters parameters{8.8};
    describe_fit(fit, record.record(),
                 {.fitted = fitted,
                  .parameters = parameters,
                  .without_bounds = parameters,
                  .matrix = matrix,
                  .residuals = record.y});
    EXPECT_EQ(fit.status, FitStatus::undetermined);
    EXPECT_THAT(in_words(fit.message), testing::HasSubstr("does not determine"));
    EXPECT_THAT(in_words(fit.message), testing::Not(testing::HasSubstr("_")));  // names as people write them
    EXPECT_EQ(fit.estimates.size(), 5u);
    for (const Estimate& estimate : fit.estimates) EXPECT_TRUE(std::isinf(estimate.standard_error));
  }
}

TEST(DescribeFit, SlowNoiseLeavesAnEquilibriumFewDegreesOfFreedom) {
  SyntheticRecord record = viscous_record({}, even_times(1000, 0.015));
  std::mt19937_64 engine(4);
  std::normal_distribution<double> normal(0, 1e-3);
  double slow = normal(engine);
  for (double& y : record.y) y += slow = 0.9 * slow + std::sqrt(1 - 0.81) * normal(engine);
  const LawFit fit = fit_law(record.record(), {});
  const double t = (fit.equilibrium().high - fit.equilibrium().value) / fit.equilibrium().standard_error;
  // An AR(1) noise: the logarithm of its density at 0 has the variance (2 + 4 (1 + a)/(1 - a))/n.
  EXPECT_NEAR(t, student_95(1000 / (1 + 2 * 1.9 / 0.1)), 0.03);
  EXPECT_GT(t, fit.student);
}

TEST(DescribeFit, FewerSamplesThanParametersSayNothingOfThem) {
  // A fit wants three samples more than there are parameters, and this law has seven.
  const SyntheticRecord record = viscous_record({}, even_times(9, 0.1));
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+drag+cubic")});
  EXPECT_EQ(fit.status, FitStatus::too_short);
  EXPECT_THAT(in_words(fit.message), testing::HasSubstr("9 samples are too few"));
}

TEST(DescribeFit, EveryParameterHasItsWords) {
  for (std::size_t term = 0; term < term_count; ++term)
    for (const DriveKind drive : {DriveKind::none, DriveKind::harmonic, DriveKind::recorded}) {
      const FittedParameters fitted = fitted_parameters(Law{std::uint32_t{1} << term}, drive);
      for (int i = 0; i < fitted.count; ++i) {
        std::string words(fitted.of[i].name);
        std::replace(words.begin(), words.end(), '_', ' ');
        const Notice named = parameter_named(fitted.of[i].name, fitted.held.law);
        EXPECT_EQ(in_words(named), words);
        EXPECT_NE(in_words(named, {Language::german}), words);
      }
    }
}

// A decay rate of one standard error: in a sixth of the records the best one is negative, and 0 is reported.
TEST(DescribeFit, IntervalsHoldAtABound) {
  const ViscousTruth truth{.w0 = 6, .g = 0.00045, .position = 0.05, .velocity = 0};
  constexpr int trials = 1000;
  int on_bound = 0, covered = 0, covered_w = 0, touching = 0;
  double stated = 0;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const LawFit fit = fit_law(viscous_record(truth, even_times(500, 0.02), 1e-3, 0, seed).record(), {});
    ASSERT_EQ(fit.status, FitStatus::converged);
    on_bound += fit.decay_rate().value == 0;
    touching += fit.decay_rate().low == 0;
    covered += fit.decay_rate().low <= truth.g && truth.g <= fit.decay_rate().high;
    covered_w += fit.angular_frequency().low <= truth.w0 && truth.w0 <= fit.angular_frequency().high;
    EXPECT_GE(fit.decay_rate().low, 0);
    EXPECT_LE(fit.decay_rate().value, fit.decay_rate().high);
    stated += fit.decay_rate().standard_error / trials;
  }
  EXPECT_NEAR(truth.g / stated, 1, 0.5);
  EXPECT_GT(on_bound, 50);
  EXPECT_GT(touching, 500);
  EXPECT_NEAR(covered, 0.95 * trials, 21);  // sd 7
  EXPECT_NEAR(covered_w, 0.95 * trials, 21);
}

TEST(LawFit, HysteresisAddsToTheFrequency) {
  LawFit fit;
  fit.student = 2;
  fit.names = {"angular_frequency", "hysteresis_stiffness"};
  fit.estimates = {make_estimate(4, 0.3, 2), make_estimate(9, 0.5, 2)};
  fit.covariance = {0.09, -0.02, -0.02, 0.25};
  EXPECT_EQ(fit.covariance_of("angular_frequency", "hysteresis_stiffness"), -0.02);
  EXPECT_EQ(fit.covariance_of("hysteresis_stiffness", "hysteresis_stiffness"), 0.25);
  EXPECT_EQ(fit.covariance_of("angular_frequency", "drag"), 0);
  EXPECT_EQ(fit.covariance_of("drag", "angular_frequency"), 0);
  const Estimate both = fit.swing_frequency();
  EXPECT_DOUBLE_EQ(both.value, 5);
  // Of w² + k: 4 w² var(w) + var(k) + 4 w cov(w, k), over the square of twice the frequency.
  EXPECT_DOUBLE_EQ(both.standard_error, std::sqrt(4 * 16 * 0.09 + 0.25 - 4 * 4 * 0.02) / 10);
  EXPECT_DOUBLE_EQ(both.high, both.value + 2 * both.standard_error);
  fit.estimates[1].value = -16;
  EXPECT_EQ(fit.swing_frequency().value, 4);
  EXPECT_EQ(fit.swing_frequency().standard_error, 0.3);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
