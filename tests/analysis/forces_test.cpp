// The forces on the mass: together they accelerate it as the methods' own system does.
#include "cromer/analysis/forces.h"

#include <gtest/gtest.h>

#include <random>

#include "cromer/model/any_terms.h"
#include "cromer/model/driven_oscillator.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Forces, SumToMassTimesAcceleration) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-2, 2);
  for (int i = 0; i < 200; ++i) {
    Oscillator<double> law{.mass = 0.3 + std::abs(any(random))};
    for_each_term([&]<class T>() {
      if constexpr (smooth_terms.has<T>()) law.*T::template members<double>[0] = i % 3 ? any(random) : 0;
    });
    law.stiffness = any(random);
    law.friction = i % 2 ? 0.5 : 0;
    const HarmonicDrive<double> drive{.amplitude = 1.5, .frequency = 3, .phase = 0.2};
    const double t = any(random);
    const State<double> y{any(random), any(random)};
    const Forces forces = forces_on(
        law, law_of(law), HarmonicForce<double>{drive.amplitude, drive.frequency, drive.phase}(t), y);
    const AnyTerms system(divided_by_mass(law), force_of(drive, law.mass));
    const double a = system.sliding(std::copysign(law.friction / law.mass, y.v)).acceleration(t, y.x, y.v);
    EXPECT_NEAR(forces.sum(), law.mass * a, 1e-12 * (1 + std::abs(forces.spring)));
  }
}

TEST(Forces, ActAgainstTheMotion) {
  const Oscillator<double> law{.stiffness = 4, .damping = 0.5, .drag = 2, .friction = 0.3};
  const Forces forces = forces_on(law, law_of(law), 0.7, {.x = 0.25, .v = -2});
  EXPECT_DOUBLE_EQ(forces.spring, -1);
  EXPECT_DOUBLE_EQ(forces.resistance.of<Viscous>(), 1);
  EXPECT_DOUBLE_EQ(forces.resistance.of<Drag>(), 8);
  EXPECT_DOUBLE_EQ(forces.resistance.of<Friction>(), 0.3);
  EXPECT_DOUBLE_EQ(forces.drive, 0.7);
}

TEST(Forces, OfFrictionAtRestBalanceAsFarAsTheyCan) {
  const Oscillator<double> law{.stiffness = 4, .friction = 0.3, .static_friction = 0.5};
  const auto friction = [&](double x) {
    return forces_on(law, law_of(law), 0.1, {.x = x, .v = 0}).resistance.of<Friction>();
  };
  EXPECT_DOUBLE_EQ(friction(0.1), 0.3);     // a pull of -0.3 N is held
  EXPECT_DOUBLE_EQ(friction(0.145), 0.48);  // and one of -0.48 N
  EXPECT_DOUBLE_EQ(friction(1), 0.3);       // one of -3.9 N is not
  EXPECT_DOUBLE_EQ(friction(-1), -0.3);
  EXPECT_DOUBLE_EQ(
      forces_on({.stiffness = 4}, law_with<Spring>, 0.1, {.x = 1, .v = 0}).resistance.of<Friction>(), 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
