// Motions under a force, recorded or harmonic, and their derivatives.
#include "cromer/identify/motion/motion_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/identify/motion/motion_system.h"
#include "tests/identify/forced_truth.h"

namespace cromer::core {
namespace CROMER_FILE {

// Half the gradient of the sum of squares, with the sign turned, is what the normal equations hold.
void expect_exact_derivatives(const FittedParameters& fitted, const Motion& motion, const Drive& drive,
                              const Record& record, double h) {
  const Parameters p = fitted.pack(motion);
  const NormalEquations at = motion_equations(fitted, p, drive, record, h);
  for (int i = 0; i < at.size; ++i) {
    const double d = 1e-5 * std::max(1e-2, std::abs(p[i]));
    Parameters up = p, down = p;
    up[i] += d;
    down[i] -= d;
    const double slope = (motion_equations(fitted, up, drive, record, h).sum_of_squares -
                          motion_equations(fitted, down, drive, record, h).sum_of_squares) /
                         (2 * d);
    // The bends of drag and |z| move with the parameters: a short difference sees few of them.
    EXPECT_NEAR(at.right[i], -0.5 * slope, 3e-6 * (1 + std::abs(slope))) << fitted.of[i].name;
    EXPECT_GT(at.matrix[i][i], 0) << fitted.of[i].name;
  }
}

// Every term of the registry, one law for each kind of spring.
TEST(DrivenMotion, DerivativesByAllParametersAreExact) {
  const auto record = forced_synthetic({}, multisine(40, 1), 200, 0.03, 0.02, 1);
  for (const char* text : {"viscous+drag+cubic+quadratic", "viscous+odd-quadratic+quintic+van-der-pol",
                           "viscous+hysteresis", "viscous+drag+pendulum+hysteresis"}) {
    Motion motion{.law = law_of(text), .equilibrium = 0.02, .position = 0.1, .velocity = -0.3};
    for_each_term([&]<class T>() {
      if (!motion.law.has<T>()) return;
      double value = 0.3;
      for (const auto member : T::template members<double>) motion.per_mass.*member = value += 0.1;
    });
    motion.set_angular_frequency(12);
    for (const int derivative : {0, 1, 2}) {
      const Record observed{record.t, record.y, 0, derivative};
      motion.force_gain = 2.4;
      motion.force_offset = 0.1;
      expect_exact_derivatives(fitted_parameters(motion.law, DriveKind::recorded, {}, motion), motion,
                               Drive::recorded(record.recorded(BetweenSamples::band_limited)), observed,
                               0.03 / 4);
      motion.cosine = 2.4;
      motion.sine = -1;
      motion.drive_frequency = 11;
      expect_exact_derivatives(fitted_parameters(motion.law, DriveKind::harmonic, {}, motion), motion,
                               Drive::harmonic(), observed, 0.01);
      expect_exact_derivatives(fitted_parameters(motion.law, DriveKind::none, {}, motion), motion, {},
                               observed, 0.01);
    }
  }
}

// A slow drive holds the body against its friction, and breaks it loose, twice in a period: when it does is
// found within the step.
TEST(DrivenMotion, BreaksLooseWhenThePullExceedsTheFriction) {
  Motion motion{.law = law_of("viscous+friction"), .cosine = 2, .drive_frequency = 1, .position = 0.03};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(0.1);
  motion.per_mass.friction = 0.7;
  std::vector<double> t;
  for (int i = 0; i <= 400; ++i) t.push_back(0.05 * i);
  const std::vector<double> coarse = observed_motion(motion, Drive::harmonic(), t, 0, 0.1),
                            fine = observed_motion(motion, Drive::harmonic(), t, 0, 0.001);
  ASSERT_EQ(coarse.size(), t.size());
  double off = 0, held = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    off = std::max(off, std::abs(coarse[i] - fine[i]));
    if (i > 0 && fine[i] == fine[i - 1]) ++held;
  }
  EXPECT_LT(off, 1e-5);
  EXPECT_GT(held, 100);
}

TEST(DrivenMotion, IsOfFourthOrderUnderARecordedForce) {
  const ForcedTruth truth{.cubic = 200};  // drag's own kink at rest would hide the order
  const auto samples = forced_synthetic({}, multisine(40, 2), 401, 0.05, 0, 2).force;
  const auto record = forced_synthetic(truth, read_between(samples, 0.05, false), 400, 0.05, 0, 2);
  Motion motion{.law = law_of("viscous+cubic"), .force_gain = truth.gain, .position = 0.1, .velocity = -0.4};
  motion.per_mass.cubic = truth.cubic;
  motion.set_angular_frequency(truth.w0);
  motion.set_decay_rate(truth.g);
  const Drive drive = Drive::recorded(record.recorded(BetweenSamples::linear));
  const auto at = [&](int steps) { return observed_motion(motion, drive, record.t, 0, 0.05 / steps); };
  const auto rms = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
  };
  const std::vector<double> fine = at(256);
  EXPECT_LT(rms(fine, record.y), 1e-7);
  const auto error = [&](int steps) { return rms(at(steps), fine); };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4, 0.1);
}

TEST(RecordedColumns, ABlocksEdgeShowsNowhere) {
  std::vector<double> force;
  for (int i = 0; i < 2500; ++i) force.push_back(std::sin(0.7 * i) + 0.3 * std::cos(1.9 * i));
  constexpr int steps = 2;
  const std::vector<double> fine = refine_band_limited(force, 2 * steps);
  const Motion unit{.force_gain = 1};
  RecordedColumns drive(unit, {force, 0, 1, BetweenSamples::band_limited}, 0, steps);
  for (std::size_t k = 100; k + 1 < 2500; ++k) {
    drive.prepare(k);
    for (int j = 0; j <= 2 * steps; ++j) {
      double acceleration = 0;
      drive.add(static_cast<double>(k) + 0.25 * j, acceleration, nullptr);
      ASSERT_NEAR(acceleration, fine[4 * k + static_cast<std::size_t>(j)], 1e-14) << k << " " << j;
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
