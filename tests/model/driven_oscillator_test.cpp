#include "cromer/model/driven_oscillator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

const Oscillator<double> everything{
    .mass = 2, .stiffness = 8, .damping = 0.6, .drag = 0.4, .friction = 0.2, .cubic = 3};
const HarmonicDrive<double> drive{.amplitude = 1.4, .frequency = 2.5, .phase = 0.3};

/// The law as its header writes it.
double force(const Oscillator<double>& o, const HarmonicDrive<double>& d, double t, double x, double v) {
  const double smooth = d.amplitude * std::cos(d.frequency * t + d.phase) - o.stiffness * x -
                        o.cubic * x * x * x - o.damping * v - o.drag * v * std::abs(v);
  if (v == 0 && std::abs(smooth) <= o.friction) return 0;  // it sticks
  return smooth - o.friction * (v != 0 ? std::copysign(1, v) : std::copysign(1, smooth));
}

TEST(DrivenOscillator, IsTheLawForEverySetOfTerms) {
  for (int set = 0; set < 32; ++set) {
    Oscillator<double> o = everything;
    HarmonicDrive<double> d = drive;
    if (set & 1) o.damping = 0;
    if (set & 2) o.drag = 0;
    if (set & 4) o.friction = 0;
    if (set & 8) o.cubic = 0;
    if (set & 16) d.amplitude = 0;
    for (const auto& [t, x, v] :
         {std::array{0.0, 0.5, 0.7}, std::array{1.3, -0.4, -0.9}, std::array{7.0, 0.1, 0.0}}) {
      const double a = with_terms(
          o, d, [&, t = t, x = x, v = v](const auto& system) { return system.acceleration(t, x, v); });
      EXPECT_NEAR(a, force(o, d, t, x, v) / o.mass, 2e-15) << set;
    }
  }
}

TEST(DrivenOscillator, SaysWhetherTheForceDependsOnVelocity) {
  const auto depends = [](const Oscillator<double>& o) {
    return with_terms(o, HarmonicDrive<double>{},
                      [](const auto& system) { return system.depends_on_velocity; });
  };
  EXPECT_FALSE(depends({}));
  EXPECT_FALSE(depends({.cubic = 1}));
  EXPECT_TRUE(depends({.damping = 1}));
  EXPECT_TRUE(depends({.drag = 1}));
  EXPECT_TRUE(depends({.friction = 1}));
}

TEST(DrivenOscillator, OnlyTheLinearLawHasAClosedForm) {
  const auto exact = [](const Oscillator<double>& o) {
    return with_terms(o, drive, []<class S>(const S&) { return ExactSystem<S, double>; });
  };
  EXPECT_TRUE(exact({}));
  EXPECT_TRUE(exact({.damping = 1}));
  for (const Oscillator<double>& o : {Oscillator<double>{.drag = 1}, {.friction = 1}, {.cubic = 1}}) {
    EXPECT_FALSE(exact(o));
    EXPECT_FALSE(why_not_exact(o).empty());
  }
  EXPECT_EQ(why_not_exact(Oscillator<double>{.drag = 1}), "drag");
  EXPECT_EQ(why_not_exact(Oscillator<double>{.hysteresis_stiffness = 1}), "hysteresis-stiffness");
  EXPECT_EQ(why_not_exact(Oscillator<double>{.damping = 1}), "");
}

TEST(TabulatedForce, AgreesWithTheCosineAfterAMillionSteps) {
  for (const double frequency : {0.1, 3.0, 400.0}) {
    const HarmonicForce<double> exact{1.3, frequency, 0.4};
    const double h = 0.01;
    TabulatedForce<double> table(exact, h);
    for (const long long first : {0LL, 1'000'000LL}) {
      const double t0 = static_cast<double>(first) * h;
      table.move_to(t0);
      for (int j = 0; j <= TabulatedForce<double>::block; ++j) {
        const double t = static_cast<double>(first + j) * h;
        // The time itself is rounded: w t eps is what the cosine cannot know either.
        EXPECT_NEAR(table(t), exact(t), 1e-14 + 4e-16 * frequency * t) << frequency << ' ' << first + j;
      }
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
