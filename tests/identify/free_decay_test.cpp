#include "cromer/identify/law_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "cromer/documents/words/words.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

bool covers(const Estimate& e, double value) { return e.low <= value && value <= e.high; }

LawFit fit_viscous(const SyntheticRecord& record) { return fit_law(record.record(), {}); }

void expect_truth(const LawFit& fit, const ViscousTruth& truth, double tolerance) {
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  const double A = std::hypot(truth.position, truth.velocity / truth.w0);
  EXPECT_NEAR(fit.angular_frequency().value, truth.w0, tolerance * truth.w0);
  EXPECT_NEAR(fit.decay_rate().value, truth.g, tolerance * truth.w0);
  EXPECT_NEAR(fit.equilibrium().value, truth.equilibrium, tolerance * A);
  EXPECT_NEAR(fit.position().value, truth.position, tolerance * A);
  EXPECT_NEAR(fit.velocity().value, truth.velocity, tolerance * A * truth.w0);
}

TEST(LawFit, RecoversTheLawWithoutNoise) {
  const ViscousTruth truths[] = {{},
                                 {.w0 = 3, .g = 0},
                                 {.w0 = 3, .g = 0.9},      // fades within a period or two
                                 {.w0 = 250, .g = 0.1},    // two and a half samples a period
                                 {.w0 = 0.6, .g = 0.002},  // two periods in all
                                 {.w0 = 8, .g = 0.02, .equilibrium = 1e3},
                                 {.w0 = 8, .g = 0.02, .position = 1e-6, .velocity = -3e-5}};
  for (const ViscousTruth& truth : truths) {
    SCOPED_TRACE(truth.w0);
    expect_truth(fit_viscous(viscous_record(truth, even_times(2000, 0.01))), truth, 1e-9);
  }
}

// No steps, whose error would be a billionth.
TEST(LawFit, TheViscousLawsMotionAndResidualsAreItsClosedForm) {
  constexpr double w0 = 9, g = 0.3;
  const double w = std::sqrt(w0 * w0 - g * g);
  const std::vector<double> t = even_times(1500, 0.01);
  // Position, velocity and acceleration of exp(-g t) cos(w t).
  std::vector<double> of[3];
  for (const double at : t) {
    const double c = std::exp(-g * at) * std::cos(w * at), s = std::exp(-g * at) * std::sin(w * at);
    of[0].push_back(c);
    of[1].push_back(-g * c - w * s);
    of[2].push_back(-w0 * w0 * c - 2 * g * of[1].back());
  }
  for (const int derivative : {0, 1, 2}) {
    const Record record{t, of[derivative], 0, derivative};
    const LawFit fit = fit_law(record, {});
    ASSERT_EQ(fit.status, FitStatus::converged) << derivative;
    const Trajectory motion = motion_of(fit, t);
    ASSERT_EQ(motion.size(), t.size());
    const std::vector<double> residuals = residuals_of(fit, record);
    ASSERT_EQ(residuals.size(), t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
      EXPECT_NEAR(motion.x[i], of[0][i], 1e-11) << derivative;
      EXPECT_NEAR(motion.v[i], of[1][i], 1e-10) << derivative;
      EXPECT_NEAR(residuals[i], 0, 1e-11 * std::pow(w0, derivative)) << derivative;
    }
  }
}

TEST(LawFit, RecoversTheLawFromAnyPhase) {
  for (int i = 0; i < 24; ++i) {
    const double phase = i * std::numbers::pi / 12;
    const ViscousTruth truth{.position = 0.05 * std::cos(phase), .velocity = 0.05 * 8.849 * std::sin(phase)};
    expect_truth(fit_viscous(viscous_record(truth, even_times(1500, 0.01))), truth, 1e-9);
  }
}

TEST(LawFit, RecoversTheLawFromUnevenTimesAndGaps) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> jitter(-0.004, 0.004);
  std::vector<double> uneven = even_times(2000, 0.01), gaps;
  for (double& t : uneven) t += 17 + jitter(engine);
  for (int i = 0; i < 2000; ++i)
    if (i % 50 != 7 && (i < 600 || i > 800)) gaps.push_back(0.01 * i);
  for (const auto& t : {uneven, gaps}) expect_truth(fit_viscous(viscous_record({}, t)), {}, 1e-9);
}

TEST(LawFit, RecoversTheLawOfShortAndLongRecords) {
  const ViscousTruth truth{.w0 = 2 * std::numbers::pi, .g = 0.05};
  expect_truth(fit_viscous(viscous_record(truth, even_times(160, 0.01))), truth, 1e-8);  // 1.6 periods
  expect_truth(fit_viscous(viscous_record(truth, even_times(24, 0.1))), truth, 1e-8);    // 24 samples
  expect_truth(fit_viscous(viscous_record({.w0 = 7, .g = 1e-4}, even_times(300000, 0.01))),
               {.w0 = 7, .g = 1e-4}, 1e-9);
  // Hundreds of thousands of samples and a few periods only.
  expect_truth(fit_viscous(viscous_record({.w0 = 0.01, .g = 1e-4}, even_times(300000, 0.01))),
               {.w0 = 0.01, .g = 1e-4}, 1e-7);
}

// var(g) = var(w) >= (2 sigma² h/A²)/(M2 - M1²/M0), M_k the moments of exp(-2 g t).
double least_standard_error(double sigma, double h, double A, double g, double T) {
  double m[3]{};
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * T / n, e = std::exp(-2 * g * t) * T / n;
    m[0] += e;
    m[1] += t * e;
    m[2] += t * t * e;
  }
  return std::sqrt(2 * sigma * sigma * h / (A * A) / (m[2] - m[1] * m[1] / m[0]));
}

// The first 8192 samples show less than two periods: a line in their noise is none of the motion's.
TEST(LawFit, FindsTheMotionOfAFastRecord) {
  for (const double h : {0.00013, 0.00012, 0.0001}) {
    SCOPED_TRACE(h);
    const LawFit fit = fit_viscous(viscous_record({}, even_times(150000, h), 0.0003, 0, 7));
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    EXPECT_NEAR(fit.angular_frequency().value, ViscousTruth{}.w0, 5 * fit.angular_frequency().standard_error);
    EXPECT_NEAR(fit.decay_rate().value, ViscousTruth{}.g, 5 * fit.decay_rate().standard_error);
  }
}

TEST(LawFit, ScattersAsLittleAsCanBeAndSaysSo) {
  const ViscousTruth truth{.w0 = 6, .g = 0.05, .position = 0.05, .velocity = -0.0025};
  const double noise = 1e-3, h = 0.01, T = 20;
  const double bound = least_standard_error(noise, h, 0.05, truth.g, T);
  constexpr int trials = 400;
  double scatter_g = 0, scatter_w = 0, stated = 0;
  int covered_g = 0, covered_w = 0, covered_x = 0, covered_E = 0;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const LawFit fit = fit_viscous(viscous_record(truth, even_times(2000, h), noise, 0, seed));
    ASSERT_EQ(fit.status, FitStatus::converged);
    scatter_g += std::pow(fit.decay_rate().value - truth.g, 2) / trials;
    scatter_w += std::pow(fit.angular_frequency().value - truth.w0, 2) / trials;
    stated += fit.decay_rate().standard_error / trials;
    covered_g += covers(fit.decay_rate(), truth.g);
    covered_w += covers(fit.angular_frequency(), truth.w0);
    covered_x += covers(fit.position(), truth.position);
    covered_E += covers(fit.equilibrium(), truth.equilibrium);
  }
  EXPECT_NEAR(bound / truth.g, 0.0037, 0.0001);            // the Cramér-Rao bound after 20 s
  EXPECT_NEAR(std::sqrt(scatter_g), bound, 0.12 * bound);  // sampling error of 400 fits: 3.5 %
  EXPECT_NEAR(std::sqrt(scatter_w), bound, 0.12 * bound);
  EXPECT_NEAR(stated, bound, 0.05 * bound);
  for (int covered : {covered_g, covered_w, covered_x, covered_E})
    EXPECT_NEAR(covered, 0.955 * trials, 13);  // sd 4
}

TEST(LawFit, IntervalsHoldForCorrelatedNoise) {
  // Noise of a sensor that smooths: correlated over many samples. Intervals that assume white noise would
  // hold in half of the cases.
  const ViscousTruth truth{.w0 = 6, .g = 0.05, .position = 0.05, .velocity = 0};
  int covered = 0, covered_equilibrium = 0;
  constexpr int trials = 300;
  for (unsigned seed = 0; seed < trials; ++seed) {
    SyntheticRecord record = viscous_record(truth, even_times(3000, 0.01));
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 3e-4);
    double noise = 0;
    for (double& y : record.y) y += noise = 0.95 * noise + normal(engine);
    const LawFit fit = fit_viscous(record);
    covered += fit.decay_rate().low <= truth.g && truth.g <= fit.decay_rate().high;
    covered_equilibrium +=
        fit.equilibrium().low <= truth.equilibrium && truth.equilibrium <= fit.equilibrium().high;
    EXPECT_FALSE(fit.residual.white);
  }
  EXPECT_GE(covered, 0.91 * trials);
  EXPECT_GE(covered_equilibrium, 0.88 * trials);
}

TEST(LawFit, IntervalsHoldForQuantisedValues) {
  int covered = 0;
  constexpr int trials = 100;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const ViscousTruth truth{.g = 0.03 + 1e-4 * seed, .position = 0.05 + 1e-5 * seed};
    const LawFit fit = fit_viscous(viscous_record(truth, even_times(1500, 0.01), 3e-3, 0.01,
                                                  seed));  // steps of a fifth of the amplitude
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    covered += fit.decay_rate().low <= truth.g && truth.g <= fit.decay_rate().high;
  }
  EXPECT_GE(covered, 90);
}

// It dies down within a period: hardly one cycle is seen.
TEST(LawFit, IntervalsHoldForStrongDamping) {
  int refused = 0, covered_w = 0, covered_g = 0;
  constexpr int trials = 200;
  for (unsigned seed = 0; seed < trials; ++seed) {
    std::mt19937_64 engine(1000 + seed);
    std::uniform_real_distribution<double> share(0, 1);
    const double w0 = 6, ratio = 0.7 + 0.2 * share(engine), duration = (1 + 3 * share(engine)) * 1.047,
                 noise = 0.05 * 0.002 * std::pow(10, share(engine));
    const ViscousTruth truth{.w0 = w0, .g = ratio * w0, .position = 0.05, .velocity = 0};
    const LawFit fit = fit_viscous(viscous_record(truth, even_times(300, duration / 299), noise, 0, seed));
    if (fit.status != FitStatus::converged) {
      ++refused;
      EXPECT_THAT(in_words(fit.message), testing::AnyOf(testing::HasSubstr("nearly so"),
                                                        testing::HasSubstr("the frequency is known only to")))
          << ratio << ' ' << duration << ' ' << noise;
      continue;
    }
    covered_w += covers(fit.angular_frequency(), truth.w0);
    covered_g += covers(fit.decay_rate(), truth.g);
  }
  EXPECT_LT(refused, 0.25 * trials);
  EXPECT_GT(covered_w, 0.91 * (trials - refused));
  EXPECT_GT(covered_g, 0.91 * (trials - refused));
}

// Even samples do not tell a frequency from its mirror at half the rate: the lower one is taken.
TEST(LawFit, FewSamplesGiveNoMirroredFrequency) {
  int found = 0, all = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const std::size_t n = 8 + seed % 4;
    const double duration = static_cast<double>(n - 1),
                 periods = 1.6 + share(engine) * (0.4 * duration - 1.6),
                 w0 = 2 * std::numbers::pi * periods / duration;
    const LawFit fit = fit_viscous(viscous_record({.w0 = w0, .g = 0.02, .position = 0.05, .velocity = 0.01},
                                                  even_times(n, 1), 2e-4, 0, seed));
    if (fit.status != FitStatus::converged) continue;
    ++all;
    found += std::abs(fit.angular_frequency().value - w0) < 0.1 * w0;
  }
  EXPECT_GT(all, 100);
  EXPECT_EQ(found, all);
}

TEST(LawFit, UndampedMotionIsFittedUnderTheBound) {
  int on_bound = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const LawFit fit =
        fit_viscous(viscous_record({.g = 0, .velocity = 0}, even_times(1000, 0.01), 1e-3, 0, seed));
    ASSERT_EQ(fit.status, FitStatus::converged);
    EXPECT_GE(fit.decay_rate().value, 0);
    on_bound += fit.decay_rate().value == 0 && !in_words(fit.notices).empty();
  }
  EXPECT_GT(on_bound, 3);
  EXPECT_LT(on_bound, 17);
}

TEST(LawFit, ShiftScaleAndTimeUnitChangeNothingElse) {
  const SyntheticRecord one = viscous_record({}, even_times(1200, 0.01), 3e-4);
  SyntheticRecord other = one;
  for (double& y : other.y) y = -1000 * y + 7;
  for (double& t : other.t) t = 50 + 2 * t;
  const LawFit a = fit_viscous(one), b = fit_viscous(other);
  EXPECT_NEAR(b.angular_frequency().value, a.angular_frequency().value / 2, 1e-9);
  EXPECT_NEAR(b.decay_rate().value, a.decay_rate().value / 2, 1e-9);
  EXPECT_NEAR(b.decay_rate().standard_error, a.decay_rate().standard_error / 2,
              1e-6 * a.decay_rate().standard_error);
  EXPECT_NEAR(b.equilibrium().value, -1000 * a.equilibrium().value + 7, 1e-6);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
