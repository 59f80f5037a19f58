#include "cromer/model/general_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cromer::core {
namespace {

TEST(GeneralDrive, JoinsTheLawWithoutLosingATerm) {
  const Oscillator<double> everything{
      .mass = 2, .stiffness = 8, .damping = 0.6, .drag = 0.4, .friction = 0.2, .cubic = 3};
  const GeneralDrive<double> drive = PulseDrive<double>{PulseShape::half_sine, 1.4, 0.5, 2};
  for (int set = 0; set < 16; ++set) {
    Oscillator<double> o = everything;
    if (set & 1) o.damping = 0;
    if (set & 2) o.drag = 0;
    if (set & 4) o.friction = 0;
    if (set & 8) o.cubic = 0;
    const double t = 1.1, x = -0.4, v = -0.9;
    const double a = with_terms(o, drive, [&](const auto& system) { return system.acceleration(t, x, v); });
    const double force = 1.4 * std::sin(std::numbers::pi * 0.6 / 2) - o.stiffness * x - o.cubic * x * x * x -
                         o.damping * v - o.drag * v * std::abs(v) + o.friction;
    EXPECT_NEAR(a, force / o.mass, 2e-15) << set;
  }
}

const SampledDrive two_samples{std::make_shared<const std::vector<double>>(2, 1.0)};

TEST(GeneralDrive, HasAClosedFormWhereLawAndForceHaveOne) {
  const auto exact = [](const Oscillator<double>& o, const GeneralDrive<double>& drive) {
    return with_terms(o, drive, []<class S>(const S&) { return ExactSystem<S, double>; });
  };
  EXPECT_TRUE(exact({}, PulseDrive<double>{PulseShape::half_sine, 1, 0, 2}));
  EXPECT_TRUE(exact({.damping = 1}, two_samples));
  EXPECT_FALSE(exact({.cubic = 1}, PulseDrive<double>{PulseShape::step, 1}));
  EXPECT_FALSE(exact({}, ChirpDrive<double>{.amplitude = 1, .from = 1, .to = 2, .duration = 3}));
}

}  // namespace
}  // namespace cromer::core
