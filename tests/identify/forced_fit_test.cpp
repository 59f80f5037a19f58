#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "tests/identify/forced_truth.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

const Law linear = law_of("viscous"), with_drag = law_of("viscous+drag"),
          curved = law_of("viscous+quadratic+cubic"), everything = law_of("viscous+drag+quadratic+cubic");

void expect_near(const char* name, const Estimate& estimate, double truth, double largest_error) {
  EXPECT_NEAR(estimate.value, truth, 4 * estimate.standard_error) << name;
  EXPECT_LT(estimate.standard_error, largest_error * std::abs(truth)) << name;
  EXPECT_GT(estimate.standard_error, 0) << name;
}

const ForcedTruth strong{.drag = 0.5, .quadratic = 20, .cubic = 300, .offset = 0.2};

TEST(ForcedFit, FindsEveryParameterWithinItsStandardError) {
  const auto record = forced_synthetic(strong, multisine(40, 1), 6000, 0.03, 2e-4, 1);
  const LawFit fit = fit_forced(record, everything, BetweenSamples::band_limited);
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  expect_near("w0", fit.angular_frequency(), strong.w0, 1e-3);
  expect_near("g", fit.decay_rate(), strong.g, 1e-2);
  expect_near("drag", fit["drag"], strong.drag, 1e-1);
  expect_near("cubic", fit["cubic"], strong.cubic, 1e-2);
  expect_near("quadratic", fit["quadratic"], strong.quadratic, 5e-2);
  expect_near("gain", fit["force_gain"], strong.gain, 1e-3);
  expect_near("offset", fit["force_offset"], strong.offset, 1e-2);
  expect_near("position", fit.position(), strong.position, 1e-2);
  expect_near("velocity", fit.velocity(), strong.velocity, 1e-2);
  EXPECT_NEAR(fit.residual.rms, 2e-4, 1e-5);
  EXPECT_EQ(fit.equilibrium().value, 0);
}

TEST(ForcedFit, WithoutNoiseOnlyTheSeriesEndsAreLeft) {
  const auto force = multisine(25, 2);
  auto record = forced_synthetic({.cubic = 200}, force, 3000, 0.04, 0, 2);
  const LawFit fit = fit_forced(record, curved, BetweenSamples::band_limited);
  // The sinc series is cut off at the record's first and last samples, and is good to 1e-4 elsewhere.
  EXPECT_NEAR(fit.angular_frequency().value, 12, 2e-3);
  EXPECT_NEAR(fit.decay_rate().value, 0.35, 2e-3);
  EXPECT_NEAR(fit["cubic"].value, 200, 1);
}

TEST(ForcedFit, AForceReadAsItWasLeavesTheMethodsErrorOnly) {
  for (const bool hold : {false, true}) {
    const auto samples = forced_synthetic({}, multisine(60, 3), 2001, 0.04, 0, 3).force;
    const ForcedTruth truth{.drag = 0.3, .cubic = 150};
    const auto record = forced_synthetic(truth, read_between(samples, 0.04, hold), 2000, 0.04, 0, 3);
    const LawFit fit = fit_forced(record, everything, hold ? BetweenSamples::hold : BetweenSamples::linear);
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    EXPECT_LT(fit.residual.rms, 1e-6);
    EXPECT_NEAR(fit.angular_frequency().value, truth.w0, 1e-5);
    EXPECT_NEAR(fit["drag"].value, truth.drag, 1e-4);
    EXPECT_NEAR(fit["cubic"].value, truth.cubic, 1e-2);
    EXPECT_NEAR(fit["force_gain"].value, truth.gain, 1e-5);
  }
}

TEST(ForcedFit, TheDataSayWhatLiesBetweenTheSamples) {
  const auto force = multisine(60, 4);
  const auto samples = forced_synthetic({}, force, 2001, 0.04, 0, 4).force;
  const struct {
    BetweenSamples between;
    std::function<double(double)> force;
  } cases[] = {{BetweenSamples::band_limited, force},
               {BetweenSamples::linear, read_between(samples, 0.04, false)},
               {BetweenSamples::hold, read_between(samples, 0.04, true)}};
  for (const auto& [between, acting] : cases) {
    const auto record = forced_synthetic({}, acting, 2000, 0.04, 1e-4, 4);
    const LawChoice choice = choose_forced(record, linear, {});
    EXPECT_EQ(choice.chosen.drive.force.between, between) << name(between);
    EXPECT_EQ(choice.candidates.size(), 3u);
    EXPECT_NEAR(choice.chosen.residual.rms, 1e-4, 1e-5) << name(between);
  }
}

TEST(ForcedFit, WhatLiesBetweenFineSamplesIsLeftOpen) {
  // A slow force sampled finely: linear and band-limited readings differ by less than the noise tells.
  const ForcedTruth truth{.w0 = 9, .g = 0.2, .gain = 2, .position = 0, .velocity = 0};
  const auto record = forced_synthetic(truth, multisine(12, 3), 3000, 0.01, 1e-3, 4);
  const LawChoice choice = choose_forced(record, {}, {});
  EXPECT_EQ(choice.chosen.status, FitStatus::converged);
  EXPECT_EQ(choice.chosen.drive.force.between, BetweenSamples::linear);
  EXPECT_THAT(in_words(choice.chosen.notices),
              testing::Contains(testing::HasSubstr("between its samples is not certain")));
  // Where the samples are coarse it is told, and nothing is open.
  const auto coarse = forced_synthetic(truth, multisine(60, 3), 3000, 0.03, 1e-4, 4);
  const LawChoice told = choose_forced(coarse, {}, {});
  EXPECT_EQ(told.chosen.drive.force.between, BetweenSamples::band_limited);
  EXPECT_THAT(in_words(told.chosen.notices), testing::Not(testing::Contains(testing::HasSubstr("is open"))));
}

// Nobody set the instrument to zero: that the zero lies amid the motion is chance, and the bent spring tells.
TEST(ForcedFit, AZeroAmidTheMotionByChanceIsSeenWhereTheSpringBends) {
  int inside = 0, all = 0;
  for (unsigned seed = 0; seed < cases(24u); ++seed) {
    ForcedTruth truth{.cubic = 400};
    truth.equilibrium = 0.006;
    const auto record = forced_synthetic(truth, multisine(40, seed), 1000, 0.03, 5e-4, seed);
    const LawFit fit = fit_forced(record, law_of("viscous+cubic"), BetweenSamples::band_limited);
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    const auto count = [&](const Estimate& e, double value) {
      inside += e.low <= value && value <= e.high;
      ++all;
    };
    count(fit.angular_frequency(), truth.w0);
    count(fit["cubic"], truth.cubic);
    count(fit.equilibrium(), truth.equilibrium);
    EXPECT_EQ(fit["force_offset"].value, 0) << seed;
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 4 * std::sqrt(0.05 * 0.95 / all));
}

TEST(ForcedFit, TheDataSayWhichTermsThereAre) {
  const struct {
    ForcedTruth truth;
    Law law;
  } cases[] = {{{}, linear},
               {{.drag = 0.6}, with_drag},
               {{.cubic = 200}, law_of("viscous+cubic")},
               {strong, everything}};
  for (const auto& [truth, law] : cases) {
    const auto record = forced_synthetic(truth, multisine(40, 5), 3000, 0.03, 3e-4, 5);
    const LawChoice choice = choose_forced(record, {}, BetweenSamples::band_limited);
    EXPECT_EQ(to_text(choice.chosen.law), to_text(law));
  }
}

TEST(ForcedFit, AZeroFarFromTheMotionIsTheSensorsOwn) {
  const ForcedTruth truth{.quadratic = 30, .cubic = 300, .equilibrium = 0.7};
  const auto record = forced_synthetic(truth, multisine(40, 6), 4000, 0.03, 2e-4, 6);
  const LawFit fit = fit_forced(record, curved, BetweenSamples::band_limited);
  expect_near("equilibrium", fit.equilibrium(), 0.7, 1e-3);
  expect_near("quadratic", fit["quadratic"], 30, 5e-2);
  expect_near("w0", fit.angular_frequency(), 12, 1e-3);
  EXPECT_EQ(fit["force_offset"].value, 0);
  EXPECT_NEAR(fit.position().value, truth.position, 4 * fit.position().standard_error);
}

// 95 % intervals hold the truth about as often as they say: of 60 records, each misses 0 to 9 (probability
// beyond, 1e-3).
TEST(ForcedFit, IntervalsHoldTheTruth) {
  const ForcedTruth truth{.cubic = 250, .offset = 0.1};
  int w0 = 0, g = 0, k3 = 0, gain = 0, offset = 0, velocity = 0;
  const auto misses = [](const Estimate& e, double value) { return value < e.low || value > e.high; };
  for (unsigned seed = 0; seed < 60; ++seed) {
    const auto record = forced_synthetic(truth, multisine(40, 100 + seed), 500, 0.03, 1e-3, seed);
    const LawFit fit = fit_forced(record, curved, BetweenSamples::band_limited);
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    w0 += misses(fit.angular_frequency(), truth.w0);
    g += misses(fit.decay_rate(), truth.g);
    k3 += misses(fit["cubic"], truth.cubic);
    gain += misses(fit["force_gain"], truth.gain);
    offset += misses(fit["force_offset"], truth.offset);
    velocity += misses(fit.velocity(), truth.velocity);
  }
  for (const int missed : {w0, g, k3, gain, offset, velocity}) EXPECT_LE(missed, 9);
  EXPECT_GE(w0 + g + k3 + gain + offset + velocity, 5);  // of 360, where 18 are expected: nor too wide
}

// Near the resonance, 3 % of noise in the force, and of the motion's own hardly any.
ForcedSynthetic near_resonance(const ForcedTruth& truth, unsigned seed, double noise, int derivative) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> part(0, 1);
  const double drive = truth.w0 * (0.97 + 0.06 * part(engine));
  auto record = forced_synthetic(
      truth, [&](double t) { return std::sin(drive * t); }, 1500, 0.04, 2e-3 * std::pow(truth.w0, derivative),
      seed, derivative);
  for (double& force : record.force) force += noise * normal(engine);
  return record;
}

TEST(ForcedFit, IntervalsHoldUnderANoisyForce) {
  struct Case {
    const char* law;
    ForcedTruth truth;
    int derivative;
  };
  const ForcedTruth slow{.w0 = 9, .g = 0.12};
  const Case cases[] = {{"viscous", slow, 0},
                        {"viscous", slow, 1},
                        {"viscous", slow, 2},
                        {"viscous+drag", {.w0 = 9, .g = 0.1, .drag = 0.05}, 0}};
  int all_held = 0;
  for (const Case& c : cases) {
    SCOPED_TRACE(testing::Message() << c.law << " " << c.derivative);
    constexpr int runs = 40;
    int told = 0, held[3]{};
    double noise = 0;
    for (unsigned seed = 0; seed < runs; ++seed) {
      const auto record = near_resonance(c.truth, seed, 0.03, c.derivative);
      const LawFit fit = fit_forced(record, law_of(c.law), BetweenSamples::band_limited);
      ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
      const auto holds = [](const Estimate& e, double truth) { return e.low <= truth && truth <= e.high; };
      held[0] += holds(fit.angular_frequency(), c.truth.w0);
      held[1] += holds(fit.decay_rate(), c.truth.g);
      held[2] += holds(fit["force_gain"], c.truth.gain);
      ASSERT_TRUE(fit.force_noise);
      told += fit.force_noise->shows;
      noise += fit.force_noise->deviation / runs;
    }
    EXPECT_GE(told, runs - 4);
    EXPECT_NEAR(noise, 0.03, 0.006);                  // seen by a few swings of the resonance only
    for (const int each : held) EXPECT_GE(each, 34);  // fewer in 1 of 300 of 95 %
    all_held += held[0] + held[1] + held[2];
  }
  EXPECT_LE(all_held, 472);  // of 480, where 456 are expected: nor too wide
}

TEST(ForcedFit, AnExactForceHasNoNoise) {
  for (const int derivative : {0, 1, 2}) {
    int told = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
      const auto record = near_resonance({.w0 = 9, .g = 0.12}, seed, 0, derivative);
      const LawFit fit = fit_forced(record, linear, BetweenSamples::band_limited);
      ASSERT_TRUE(fit.force_noise);
      told += fit.force_noise->shows;
    }
    EXPECT_LE(told, 3) << derivative;
  }
}

TEST(ForcedFit, FollowsALongRingingThroughManyCycles) {
  // A quality factor of 3000, struck at the beginning only: a frequency off by 1e-3 would lose step.
  const ForcedTruth truth{.w0 = 30, .g = 0.005, .gain = 50, .position = 0, .velocity = 0};
  const auto strike = [](double t) { return t < 0.5 ? std::sin(2 * t * 3.14159265) : 0.0; };
  const auto record = forced_synthetic(truth, strike, 20000, 0.02, 1e-3, 7);
  const LawFit fit = fit_forced(record, linear, BetweenSamples::linear);
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_NEAR(fit.residual.rms, 1e-3, 3e-5);
  EXPECT_NEAR(fit.angular_frequency().value, 30, 1e-3);
  EXPECT_NEAR(fit.decay_rate().value, 0.005, 2e-4);
}

TEST(ForcedFit, FindsASpringThatIsMostlyCubic) {
  const ForcedTruth truth{.cubic = 1e4, .gain = 4, .position = 0.01, .velocity = 0};
  const auto record = forced_synthetic(truth, multisine(40, 1), 3000, 0.03, 1e-5, 1);
  const LawFit fit = fit_forced(record, curved, BetweenSamples::band_limited);
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_NEAR(fit["cubic"].value, 1e4, 5);
  EXPECT_LT(fit.residual.rms, 1.2e-5);
}

TEST(ForcedFit, MissingSamplesAreLeftOut) {
  const auto record = forced_synthetic({.cubic = 200}, multisine(40, 8), 3000, 0.03, 2e-4, 8);
  ForcedSynthetic there = record;
  there.t.clear(), there.y.clear();
  for (std::size_t i = 0; i < 3000; ++i) {
    if ((i >= 100 && (i - 100) % 7 == 0) || (i >= 1500 && i < 1600)) continue;
    there.t.push_back(record.t[i]);
    there.y.push_back(record.y[i]);
  }
  const LawFit fit = fit_forced(there, curved, BetweenSamples::band_limited);
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  expect_near("w0", fit.angular_frequency(), 12, 1e-3);
  expect_near("cubic", fit["cubic"], 200, 5e-2);
}

TEST(ForcedFit, GoesOnThroughWhatItWasNotShown) {
  const auto record = forced_synthetic(strong, multisine(40, 9), 4000, 0.03, 2e-4, 9);
  ForcedSynthetic part = record;
  part.t.resize(3000);
  part.y.resize(3000);
  const LawFit fit = fit_forced(part, everything, BetweenSamples::band_limited);
  const std::vector<double> motion = observed_motion(fit.motion, fit.drive, record.t, 0, fit.step);
  ASSERT_EQ(motion.size(), 4000u);
  double sum = 0;
  for (std::size_t i = 3000; i < 3980; ++i) sum += std::pow(record.y[i] - motion[i], 2);  // but the end
  EXPECT_NEAR(std::sqrt(sum / 980), 2e-4, 2e-5);
}

TEST(ForcedFit, RefusesWhatItCannotFit) {
  const auto record = forced_synthetic({}, multisine(40, 10), 400, 0.03, 1e-3, 10);
  ForcedSynthetic few = record;
  few.t.resize(20);
  few.y.resize(20);
  EXPECT_EQ(fit_forced(few, linear, BetweenSamples::linear).status, FitStatus::too_short);

  auto still = record;
  std::fill(still.y.begin(), still.y.end(), 0.3);
  EXPECT_EQ(fit_forced(still, linear, BetweenSamples::linear).status, FitStatus::no_oscillation);

  // Another force than the one that acted, on a body so damped that chance explains little.
  auto other =
      forced_synthetic({.g = 4, .position = 0, .velocity = 0}, multisine(40, 11, 900), 2000, 0.03, 1e-3, 10);
  const auto wrong = multisine(40, 12, 900);
  for (std::size_t i = 0; i < other.t.size(); ++i) other.force[i] = wrong(other.t[i]);
  const LawFit fit = choose_forced(other, linear, {}).chosen;
  EXPECT_EQ(fit.status, FitStatus::too_noisy) << fit.explained;
  EXPECT_FALSE(fit.message.empty());
}

// Sixty records of each; every interval is counted.
TEST(ForcedFit, VelocitiesAndAccelerationsAreFittedAsThat) {
  const ForcedTruth truth{.offset = 0, .equilibrium = 0.3};  // the sensor's offset
  for (const int derivative : {1, 2}) {
    int inside = 0, all = 0;
    for (unsigned seed = 0; seed < cases(60u); ++seed) {
      const auto record = forced_synthetic(truth, multisine(20, seed + 1), 400, 0.03,
                                           5e-3 * std::pow(truth.w0, derivative), seed, derivative);
      const LawFit fit = fit_forced(record, linear, BetweenSamples::band_limited);
      ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
      EXPECT_EQ(fit.find("force_offset"), nullptr);
      const auto count = [&](const Estimate& e, double value) {
        inside += e.low <= value && value <= e.high;
        ++all;
      };
      count(fit.angular_frequency(), truth.w0);
      count(fit.decay_rate(), truth.g);
      count(fit["force_gain"], truth.gain);
      count(fit.equilibrium(), truth.equilibrium);
      count(fit.position(), truth.position);
      count(fit.velocity(), truth.velocity);
      EXPECT_NEAR(motion_of(fit, record.t).x.front(), fit.position().value, 1e-12);
    }
    EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 4 * std::sqrt(0.05 * 0.95 / all)) << derivative;
  }
}

// Where it is, a velocity does not show; what moves it, it does.
TEST(ForcedFit, ABodyWithoutASpringMayBeSeenByItsVelocity) {
  const ForcedTruth truth{.w0 = 0, .g = 0.8, .position = 0, .velocity = 0.2};
  int inside = 0, all = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto record = forced_synthetic(truth, multisine(20, seed + 1), 800, 0.02, 5e-3, seed, 1);
    const LawFit fit = fit_forced(record, law_with<Viscous>, BetweenSamples::band_limited);
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    EXPECT_EQ(fit.find("position"), nullptr);
    EXPECT_NEAR(fit.residual.rms, 5e-3, 1e-3);
    const auto count = [&](const Estimate& e, double value) {
      inside += e.low <= value && value <= e.high;
      ++all;
    };
    count(fit.decay_rate(), truth.g);
    count(fit["force_gain"], truth.gain);
    count(fit["force_offset"], 0);
    count(fit.velocity(), truth.velocity);
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 4 * std::sqrt(0.05 * 0.95 / all));
}

TEST(ForcedFit, ACurvedSpringShowsInAccelerations) {
  const ForcedTruth truth{.quadratic = 40, .cubic = 900};
  for (const int derivative : {1, 2}) {
    const auto record = forced_synthetic(truth, multisine(40, 3), 3000, 0.03,
                                         1e-3 * std::pow(truth.w0, derivative), 3, derivative);
    const LawChoice choice = choose_forced(record, {}, {});
    ASSERT_EQ(to_text(choice.chosen.law), "viscous+cubic+quadratic");
    const LawFit& fit = choice.chosen;
    EXPECT_NEAR(fit["cubic"].value, 900, 4 * fit["cubic"].standard_error);
    EXPECT_NEAR(fit["quadratic"].value, 40, 4 * fit["quadratic"].standard_error);
    EXPECT_LT(fit["cubic"].standard_error, 50);
  }
}

// At resonance and steady, gain and damping can be traded for each other: only their ratio shows.
TEST(ForcedFit, WhatTheRecordDoesNotDetermineIsNamed) {
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  for (const double noise : {0.0, 1e-4, 1e-3}) {
    ForcedSynthetic record;
    record.spacing = 0.02;
    for (int i = 0; i < 2000; ++i) {
      const double t = 0.02 * i;
      record.t.push_back(t);
      record.force.push_back(std::cos(6 * t));
      record.y.push_back(std::sin(6 * t) / 6 + noise * normal(engine));
    }
    const LawFit fit = fit_forced(record, linear, BetweenSamples::band_limited);
    EXPECT_EQ(fit.status, FitStatus::undetermined) << noise << ": " << in_words(fit.message);
    EXPECT_THAT(in_words(fit.message),
                testing::AllOf(testing::HasSubstr("force gain"), testing::HasSubstr("decay rate")))
        << noise;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
