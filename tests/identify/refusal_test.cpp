// Records that must be refused, each with its reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

FitStatus status_of(const SyntheticRecord& record) {
  const LawFit fit = fit_law(record.record(), {});
  EXPECT_EQ(fit.message.empty(), fit.status == FitStatus::converged);
  return fit.status;
}

SyntheticRecord noise_record(std::size_t n, double correlation, unsigned seed) {
  SyntheticRecord record = viscous_record({.position = 0, .velocity = 0}, even_times(n, 0.01));
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  double noise = 0;
  for (double& y : record.y) y += noise = correlation * noise + normal(engine);
  return record;
}

TEST(Refusal, NoiseIsNoOscillation) {
  for (double correlation : {0.0, 0.9, 0.99, 1.0})
    for (std::size_t n : {200u, 3000u})
      for (unsigned seed = 1; seed <= 10; ++seed)
        EXPECT_NE(status_of(noise_record(n, correlation, seed)), FitStatus::converged)
            << correlation << ' ' << n << ' ' << seed;
}

TEST(Refusal, LeavesUnsaidWhatTheParametersWouldWarnOf) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const SyntheticRecord record = noise_record(3000, 0.99, seed);
    const LawFit fit = fit_law(record.record(), {});
    ASSERT_NE(fit.status, FitStatus::converged) << seed;
    EXPECT_TRUE(in_words(fit.notices).empty()) << seed << ": " << in_words(fit.notices).front();
  }
}

TEST(Refusal, DriftAndStepsAreNoOscillation) {
  SyntheticRecord ramp{even_times(500, 0.01), {}, 0}, step = ramp, spike = ramp;
  for (double t : ramp.t) {
    ramp.y.push_back(3 * t);
    step.y.push_back(t > 2.2);
    spike.y.push_back(t == ramp.t[100]);
  }
  for (const auto& record : {ramp, step, spike}) EXPECT_NE(status_of(record), FitStatus::converged);
}

TEST(Refusal, FewSamplesAndConstants) {
  EXPECT_EQ(status_of(viscous_record({}, even_times(7, 0.01))), FitStatus::too_short);
  EXPECT_EQ(status_of({{}, {}, 0}), FitStatus::too_short);
  EXPECT_EQ(status_of(viscous_record({.position = 0, .velocity = 0}, even_times(100, 0.01))),
            FitStatus::no_oscillation);
}

TEST(Refusal, LessThanOneAndAHalfPeriods) {
  EXPECT_EQ(status_of(viscous_record({.w0 = 6.28, .g = 0.05}, even_times(110, 0.01))), FitStatus::too_short);
}

TEST(Refusal, MotionWithoutReturn) {
  SyntheticRecord record{even_times(1000, 0.01), {}, 0};
  for (double t : record.t)
    record.y.push_back(0.1 + 0.05 * (1.2 * std::exp(-1.0 * t) - 0.2 * std::exp(-6.0 * t)));
  EXPECT_EQ(status_of(record), FitStatus::overdamped);
}

// Without damping the motion cannot follow a decay, and the frequency is lost with it: 1 ± 6 Hz is no result.
// A first-order decay lies on the border to creeping, where the uncertainties of frequency and damping
// vanish.
TEST(Refusal, ADecayOfFirstOrderHasNoFrequency) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SyntheticRecord record = viscous_record({.equilibrium = 0, .position = 0, .velocity = 0},
                                            even_times(900, 0.04), 2e-4, 0, seed);
    for (std::size_t i = 0; i < record.t.size(); ++i)
      record.y[i] += 0.08 * std::exp(-record.t[i] / (1 + 0.2 * seed));
    EXPECT_EQ(status_of(record), FitStatus::overdamped) << seed;
  }
}

TEST(Refusal, ALawThatLeavesTheFrequencyUnknown) {
  const SyntheticRecord record =
      viscous_record({.w0 = 8.168, .position = 0.05, .velocity = 0}, even_times(3000, 0.01), 5e-4);
  const LawFit fit = fit_law(record.record(), {.law = law_of("cubic")});
  EXPECT_TRUE(fit.status == FitStatus::too_noisy || fit.angular_frequency().standard_error < 0.05 * 8.168)
      << fit.angular_frequency().standard_error;
  EXPECT_NE(fit.status, FitStatus::converged);
}

TEST(Refusal, TopsCutOff) {
  SyntheticRecord record =
      viscous_record({.equilibrium = 0, .position = 0.05}, even_times(2000, 0.01), 1e-4, 1e-4);
  EXPECT_EQ(status_of(record), FitStatus::converged);
  for (double& y : record.y) y = std::min(y, 0.03);
  EXPECT_EQ(status_of(record), FitStatus::clipped);
}

TEST(Refusal, CoarseRoundingIsNotClipping) {
  for (double resolution : {0.002, 0.005, 0.01, 0.02})
    EXPECT_EQ(
        status_of(viscous_record({.g = 0.001, .position = 0.05}, even_times(3000, 0.01), 0, resolution)),
        FitStatus::converged)
        << resolution;
}

TEST(Refusal, ALineFarBelowTheNoise) {
  const FitStatus status =
      status_of(viscous_record({.g = 0, .position = 0.0125, .velocity = 0}, even_times(10000, 0.01), 0.1));
  EXPECT_TRUE(status == FitStatus::too_noisy || status == FitStatus::no_oscillation);
  EXPECT_EQ(
      status_of(viscous_record({.g = 0, .position = 0.05, .velocity = 0}, even_times(10000, 0.01), 0.1)),
      FitStatus::converged);
}

TEST(Refusal, HoldsForEveryLaw) {
  const SyntheticRecord noise = noise_record(2000, 0.5, 3);
  EXPECT_EQ(fit_law(noise.record(), {.law = law_of("viscous+drag")}).status, FitStatus::no_oscillation);
  EXPECT_EQ(choose_law(noise.record(), {}).chosen.status, FitStatus::no_oscillation);
}

// A law other than the viscous one begins with that: it goes on only where that accounts for most.
TEST(Refusal, WhatIsTooNoisyIsSoForEveryLaw) {
  const SyntheticRecord record = viscous_record({}, even_times(1000, 0.02), 0.066);
  const LawFit viscous = fit_law(record.record(), {.law = law_of("viscous")});
  EXPECT_EQ(viscous.status, FitStatus::too_noisy);
  EXPECT_LT(viscous.explained, 0.3);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+drag")});
  EXPECT_EQ(fit.status, FitStatus::too_noisy);
  EXPECT_EQ(to_text(fit.law), "viscous+drag");
  EXPECT_EQ(in_words(fit.message), in_words(viscous.message));
  EXPECT_EQ(fit.explained, viscous.explained);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
