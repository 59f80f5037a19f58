#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "cromer/analysis/frequency_response.h"

namespace cromer::core {
namespace CROMER_FILE {

using namespace std::complex_literals;

const Oscillator<double> mount{.mass = 3, .stiffness = 108, .damping = 5};  // w0 = 6

TEST(Transmissibility, IsTheRatioOfPhasors) {
  for (const double w : {0.1, 3.0, 5.9, 6.0, 6.1, 20.0}) {
    const std::complex<double> coupling = 108.0 + 5i * w, all = coupling - 3 * w * w;
    const std::complex<double> truth = coupling / all;
    const Transmission found = transmissibility(mount, w);
    EXPECT_NEAR(found.amplitude / std::abs(truth), 1, 1e-14) << w;
    EXPECT_NEAR(found.phase_lag, -std::arg(truth), 1e-14) << w;
  }
}

TEST(Transmissibility, MeetsItsLandmarks) {
  // At w = 0 all of it passes; whatever the damping, at sqrt(2) w0 as much as comes in.
  EXPECT_EQ(transmissibility(mount, 0).amplitude, 1);
  for (const double c : {0.0, 1.0, 5.0, 30.0})
    EXPECT_NEAR(transmissibility({.mass = 3, .stiffness = 108, .damping = c}, 6 * std::sqrt(2)).amplitude, 1,
                1e-14);
  EXPECT_GT(transmissibility(mount, 6).amplitude, 3);
}

TEST(Transmissibility, FollowsFromTheMotionThatPassesItOn) {
  for (const double w : {0.1, 3.0, 6.0, 6.1, 20.0}) {
    const Transmission exact = transmissibility(mount, w);
    // A base with Y = 2: the force on the mass is m w^2 Y.
    const Transmission motion = transmitted_motion(2, frequency_response(mount, 3 * w * w * 2, w));
    EXPECT_NEAR(motion.amplitude / exact.amplitude, 1, 1e-13) << w;
    EXPECT_NEAR(motion.phase_lag, exact.phase_lag, 1e-13) << w;
    const SteadyState x = frequency_response(mount, 7, w),
                      v{w * x.amplitude, x.phase_lag - std::numbers::pi / 2};
    const Transmission force = transmitted_force(mount, 7, x, v);
    EXPECT_NEAR(force.amplitude / exact.amplitude, 1, 1e-13) << w;
    EXPECT_NEAR(force.phase_lag, exact.phase_lag, 1e-13) << w;
  }
  // A lag just short of nothing stays just short of nothing.
  EXPECT_NEAR(transmission(1, -1e-3).phase_lag, -1e-3, 1e-9);
  EXPECT_NEAR(transmission(-1, -1e-3).phase_lag, std::numbers::pi + 1e-3, 1e-9);
}

TEST(Transmissibility, TheLagBeginsAtMinusHalfPi) {
  EXPECT_EQ(transmission(0, -1).phase_lag, -std::numbers::pi / 2);
  EXPECT_EQ(transmission(0, 1).phase_lag, std::numbers::pi / 2);
  EXPECT_NEAR(transmission(-1e-9, -1).phase_lag, 3 * std::numbers::pi / 2 - 1e-9, 1e-14);
  EXPECT_EQ(transmission(3, -4).amplitude, 5);
}

TEST(Transmissibility, ResonanceIsBelowTheNaturalFrequency) {
  // w0^2 = 36, b = 5/6.
  EXPECT_NEAR(resonance_frequency(mount), std::sqrt(36 - 2 * 25.0 / 36), 1e-14);
  // 2 b^2 = w0^2 leaves none.
  EXPECT_EQ(resonance_frequency({.mass = 1, .stiffness = 2, .damping = 2}), 0);
  EXPECT_GT(resonance_frequency({.mass = 1, .stiffness = 2.001, .damping = 2}), 0.01);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
