#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

struct DrivenTruth {
  double w0 = 7.2, g = 0.04, drive = 7.58, amplitude = 0.25, phase = 1.1, equilibrium = 0.3, position = 0.02,
         velocity = 0.1;
};

struct Driven {
  std::vector<double> t, y;
  double resolution = 0;
  Record record() const { return {t, y, resolution}; }
};

// The closed form.
Driven driven(const DrivenTruth& p, std::size_t n, double h, double noise, unsigned seed,
              double resolution = 0) {
  using namespace std::complex_literals;
  const std::complex<double> steady =
      std::polar(p.amplitude, p.phase) / (p.w0 * p.w0 - p.drive * p.drive + 2i * p.g * p.drive);
  const double w = std::sqrt(p.w0 * p.w0 - p.g * p.g);
  const double x = p.position - steady.real(), v = p.velocity - (1i * p.drive * steady).real();
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  Driven record;
  record.resolution = resolution;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) * h;
    double y = p.equilibrium + (steady * std::exp(1i * p.drive * s)).real() +
               std::exp(-p.g * s) * (x * std::cos(w * s) + (v + p.g * x) / w * std::sin(w * s)) +
               noise * normal(engine);
    if (resolution > 0) y = resolution * std::round(y / resolution);
    record.t.push_back(5 + s);
    record.y.push_back(y);
  }
  return record;
}

void expect_truth(const LawFit& fit, const DrivenTruth& p) {
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  const auto near = [](const char* name, const Estimate& e, double truth) {
    EXPECT_NEAR(e.value, truth, 4 * e.standard_error) << name;
    EXPECT_GT(e.standard_error, 0) << name;
  };
  near("w0", fit.angular_frequency(), p.w0);
  near("g", fit.decay_rate(), p.g);
  near("frequency", fit["drive_frequency"], p.drive);
  near("amplitude", fit["drive_amplitude"], p.amplitude);
  near("phase", fit["drive_phase"], p.phase);
  near("equilibrium", fit.equilibrium(), p.equilibrium);
  near("position", fit.position(), p.position);
  near("velocity", fit.velocity(), p.velocity);
}

// Loops that damp much: the linear law's drive is too weak for a start.
TEST(DrivenFit, AHystereticSpringIsFoundFromRest) {
  struct Loop {
    double stiffness, damping, slope, beta, gamma, drive, frequency;
  };
  const std::vector<double> t = even_times(3000, 0.02);
  for (const Loop& loop :
       {Loop{25.9, 0.110, 20.7, 1.18, 0.41, 5.85, 7.247}, Loop{57.0, 0.060, 28.4, 3.25, 0.67, 3.78, 8.670},
        Loop{45.0, 0.098, 26.9, 3.87, 2.95, 2.00, 8.193}, Loop{53.0, 0.041, 23.4, 75.2, 26.2, 1.38, 6.488}}) {
    Motion motion{.law = law_of("viscous+hysteresis")};
    motion.per_mass.stiffness = loop.stiffness;
    motion.per_mass.damping = loop.damping;
    motion.per_mass.hysteresis_stiffness = loop.slope;
    motion.per_mass.hysteresis_beta = loop.beta;
    motion.per_mass.hysteresis_gamma = loop.gamma;
    motion.sine = loop.drive;
    motion.drive_frequency = loop.frequency;
    std::vector<double> y = observed_motion(motion, Drive::harmonic(), t, 0, 0.001);
    y = noisy(y, 0.01 * sinusoid_amplitude(y));
    const LawFit fit = fit_law({t, y}, {.law = motion.law, .drive = Drive::harmonic()});
    ASSERT_EQ(fit.status, FitStatus::converged) << loop.stiffness << ": " << in_words(fit.message);
    const auto near = [&](const char* name, double truth) {
      EXPECT_NEAR(fit[name].value, truth, 4 * fit[name].standard_error) << name << " of " << loop.stiffness;
    };
    near("hysteresis_stiffness", loop.slope);
    near("hysteresis_beta", loop.beta);
    near("hysteresis_gamma", loop.gamma);
    near("drive_amplitude", loop.drive);
    EXPECT_LT(fit["drive_amplitude"].standard_error, 0.02 * loop.drive);
    EXPECT_LT(fit["hysteresis_stiffness"].standard_error, 0.4 * loop.slope);
  }
}

TEST(DrivenFit, BeatsTellSpringAndDrive) {
  const DrivenTruth truth;
  const Driven record = driven(truth, 8000, 0.01, 1e-3, 1);
  for (const std::optional<double> known : {std::optional<double>{}, std::optional<double>{7.58}}) {
    const LawChoice choice = choose_driven(record.record(), {}, known);
    expect_truth(choice.chosen, truth);
    EXPECT_EQ(to_text(choice.chosen.law), "viscous");
    EXPECT_NEAR(choice.chosen.residual.rms, 1e-3, 3e-5);
    EXPECT_LT(choice.chosen["drive_frequency"].standard_error, 2e-4);
  }
}

TEST(DrivenFit, AFrequencyReadOffAGeneratorIsRefined) {
  // Three digits: out of step by half a turn at the end.
  const DrivenTruth truth{.drive = 7.5837};
  const Driven record = driven(truth, 20000, 0.02, 1e-3, 2);
  expect_truth(fit_driven(record.record(), law_of("viscous"), 7.58), truth);
}

// A long record resolves more than a dial: 0.6 % are six times the width of its lines.
TEST(DrivenFit, ADialMayBeOffByManyLinesOfALongRecord) {
  const DrivenTruth truth;
  const Driven record = driven(truth, 8000, 0.1, 1e-4, 6);
  for (const double off : {-0.006, 0.0005, 0.006})
    expect_truth(fit_driven(record.record(), law_of("viscous"), truth.drive * (1 + off)), truth);
  // The drive that is named is not given up for a stronger line beside it.
  DrivenTruth weak;
  weak.drive = weak.w0 * 1.005;
  weak.g = 1e-5;
  weak.amplitude = 0.002;
  weak.position = 0.2;
  expect_truth(fit_driven(driven(weak, 8000, 0.1, 1e-4, 6).record(), law_of("viscous"), weak.drive), weak);
}

TEST(DrivenFit, FarFromResonanceAndAtIt) {
  for (const double w : {2.0, 6.9, 7.2, 7.25, 15.0, 40.0}) {
    const DrivenTruth truth{.g = 0.1, .drive = w, .amplitude = w > 10 ? 5.0 : 0.5};
    const Driven record = driven(truth, 6000, 0.02, 1e-3, 3);
    expect_truth(fit_driven(record.record(), law_of("viscous"), w), truth);
  }
}

TEST(DrivenFit, RoundingToCoarseStepsAddsNoTerms) {
  const DrivenTruth truth{.amplitude = 0.2};
  const Driven record = driven(truth, 20000, 0.01, 0, 4, 0.01);
  const LawChoice choice = choose_driven(record.record(), {}, {});
  EXPECT_EQ(to_text(choice.chosen.law), "viscous");
  expect_truth(choice.chosen, truth);
}

TEST(DrivenFit, FindsDragAndASofteningSpring) {
  const ForcedTruth truth{
      .w0 = 7.2, .g = 0.03, .drag = 0.6, .cubic = -60, .gain = 1, .position = 0.2, .velocity = 0};
  const auto force = [](double t) { return 0.5 * std::cos(7.9 * t + 0.5); };
  const auto record = forced_synthetic(truth, force, 6000, 0.02, 5e-4, 5);
  const LawChoice choice = choose_driven({record.t, record.y, 0}, {}, {});
  const LawFit& fit = choice.chosen;
  ASSERT_EQ(to_text(fit.law), "viscous+drag+cubic");
  EXPECT_NEAR(fit["drag"].value, 0.6, 4 * fit["drag"].standard_error);
  EXPECT_NEAR(fit["cubic"].value, -60, 4 * fit["cubic"].standard_error);
  EXPECT_NEAR(fit["drive_frequency"].value, 7.9, 4 * fit["drive_frequency"].standard_error);
  EXPECT_NEAR(fit["drive_amplitude"].value, 0.5, 4 * fit["drive_amplitude"].standard_error);
}

// Of 60 records, each interval misses 0 to 9 (probability beyond, 1e-3).
TEST(DrivenFit, IntervalsHoldTheTruth) {
  const DrivenTruth truth{.g = 0.08};
  int w0 = 0, g = 0, frequency = 0, amplitude = 0;
  const auto misses = [](const Estimate& e, double value) { return value < e.low || value > e.high; };
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Driven record = driven(truth, 1500, 0.03, 2e-3, 50 + seed);
    const LawFit fit = fit_driven(record.record(), law_of("viscous"), {});
    ASSERT_EQ(fit.status, FitStatus::converged) << seed << in_words(fit.message);
    w0 += misses(fit.angular_frequency(), truth.w0);
    g += misses(fit.decay_rate(), truth.g);
    frequency += misses(fit["drive_frequency"], truth.drive);
    amplitude += misses(fit["drive_amplitude"], truth.amplitude);
  }
  for (const int missed : {w0, g, frequency, amplitude}) EXPECT_LE(missed, 9);
  EXPECT_GE(w0 + g + frequency + amplitude, 2);
}

TEST(DrivenFit, RefusesNoise) {
  std::mt19937_64 engine(6);
  std::normal_distribution<double> normal;
  Driven record;
  for (int i = 0; i < 2000; ++i) {
    record.t.push_back(0.01 * i);
    record.y.push_back(normal(engine));
  }
  EXPECT_NE(choose_driven(record.record(), {}, {}).chosen.status, FitStatus::converged);
}

// Sixty records of each, as of a gyroscope or an accelerometer on what is driven.
TEST(DrivenFit, VelocitiesAndAccelerationsAreFittedAsThat) {
  const ForcedTruth truth{
      .w0 = 7.2, .g = 0.1, .gain = 1, .equilibrium = 0.3, .position = 0.02, .velocity = 0.1};
  const auto force = [](double t) { return 0.25 * std::cos(7.58 * t + 1.1); };
  for (const int derivative : {1, 2}) {
    int inside = 0, all = 0;
    for (unsigned seed = 0; seed < cases(60u); ++seed) {
      const auto record =
          forced_synthetic(truth, force, 2000, 0.02, 1e-3 * std::pow(truth.w0, derivative), seed, derivative);
      const LawFit fit = fit_driven({record.t, record.y, 0, derivative}, law_of("viscous"), {});
      ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
      const auto count = [&](const Estimate& e, double value) {
        inside += e.low <= value && value <= e.high;
        ++all;
      };
      count(fit.angular_frequency(), truth.w0);
      count(fit.decay_rate(), truth.g);
      count(fit["drive_frequency"], 7.58);
      count(fit["drive_amplitude"], 0.25);
      count(fit["drive_phase"], 1.1);
      count(fit.equilibrium(), truth.equilibrium);
      count(fit.position(), truth.position);
      count(fit.velocity(), truth.velocity);
    }
    EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 4 * std::sqrt(0.05 * 0.95 / all)) << derivative;
  }
}

// A steady motion of a few rounding steps: rounding makes harmonics, and none of them is a body.
TEST(DrivenFit, AHarmonicOfTheRoundingIsNoBody) {
  for (const double amplitude : {0.0065, 0.012, 0.02})
    for (const double w : {5.07, 3.3}) {
      Driven record;
      record.resolution = 0.01;
      for (int i = 0; i < 4000; ++i) {
        record.t.push_back(0.01 * i);
        record.y.push_back(0.01 * std::round(amplitude * std::cos(w * record.t.back() + 0.4) / 0.01));
      }
      const LawFit fit = fit_driven(record.record(), law_of("viscous"), w);
      EXPECT_NE(fit.status, FitStatus::converged)
          << amplitude << ' ' << w << ": w0 " << fit.angular_frequency().value << " ± "
          << fit.angular_frequency().standard_error << ", decay " << fit.decay_rate().value;
    }
}

TEST(DrivenFit, DryFrictionIsToldFromDamping) {
  const Oscillator<double> body{.mass = 1, .stiffness = 36, .damping = 0.2, .friction = 0.4};
  for (const unsigned seed : {1u, 2u, 3u}) {
    KeepEvery keep(10, count_steps({0, 60}, 0.002));
    with_dry_friction(body, HarmonicDrive<double>{1.5, 5.2, 0.3}, [&](const auto& system) {
      return solve(system, DormandPrince{}, Interval{0, 60}, State<double>{0.1, 0}, {0.002, 1e-10}, keep);
    });
    const Trajectory motion = keep.take();
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 2e-4);
    std::vector<double> y = motion.x;
    for (double& each : y) each += normal(engine);
    const LawFit fit = fit_driven({motion.t, y}, law_of("viscous+friction"), 5.2);
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    EXPECT_NEAR(fit["decay_rate"].value, 0.1, 4.5 * fit["decay_rate"].standard_error);
    EXPECT_NEAR(fit["friction"].value, 0.4, 4.5 * fit["friction"].standard_error);
    EXPECT_NEAR(fit["angular_frequency"].value, 6, 4.5 * fit["angular_frequency"].standard_error);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
