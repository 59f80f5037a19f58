#include "cromer/analysis/exact_energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/base/pi.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/friction.h"

namespace cromer::core {
namespace CROMER_FILE {

EnergyBalance balance(const Oscillator<double>& law, const State<double>& start, double until) {
  const Oscillator<double> per_mass{
      .mass = 1, .stiffness = law.stiffness / law.mass, .damping = law.damping / law.mass};
  using System = DrivenOscillator<double, Terms{.law = law_of("viscous")}>;
  const DryFriction system(System(per_mass, {}), law.friction / law.mass, law.static_friction / law.mass);
  return exact_friction_balance(system, law, start, until);
}

TEST(ExactFrictionBalance, FrictionTakesItsForceTimesThePath) {
  // From 1 m by 0.2 m less each half cycle of pi/2 s: to 0.
  const Oscillator<double> law{.mass = 2, .stiffness = 8, .friction = 0.8};
  const double paths[] = {0, 1.8, 3.2, 4.2, 4.8, 5, 5};
  for (int n = 0; n < 7; ++n) {
    const EnergyBalance found = balance(law, {1, 0}, n * pi / 2);
    EXPECT_NEAR(found.taken_by<Friction>(), 0.8 * paths[n], 1e-13) << n;
    EXPECT_EQ(found.start, 4);
    EXPECT_NEAR(found.end, 4 - 0.8 * paths[n], 1e-13) << n;
    EXPECT_EQ(found.taken_by<Viscous>(), 0);
    EXPECT_EQ(found.drive, 0);
  }
  // Half way through the first half cycle it is at 0.1 m.
  EXPECT_NEAR(balance(law, {1, 0}, pi / 4).taken_by<Friction>(), 0.8 * 0.9, 1e-13);
}

TEST(ExactFrictionBalance, ClosesWhateverTheDamping) {
  for (const double damping : {0.01, 0.4, 5.9, 6.0, 6.1, 60.0, 600.0})
    for (const double until : {0.3, 5.0, 200.0}) {
      const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = damping, .friction = 0.05};
      const EnergyBalance found = balance(law, {1, -3}, until);
      EXPECT_LT(std::abs(found.method()), 3e-14 * found.start) << damping << ' ' << until;
      EXPECT_GT(found.taken_by<Viscous>(), 0) << damping;
    }
}

TEST(ExactFrictionBalance, ClosesWhereNothingPullsBack) {
  // A sledge: v' = -0.5 v - 1 from 2 m/s stops after 2 ln 2 s.
  const Oscillator<double> sledge{.mass = 1, .stiffness = 0, .damping = 0.5, .friction = 1};
  const EnergyBalance found = balance(sledge, {0, 2}, 10);
  const double path = 4 - 4 * std::numbers::ln2;
  EXPECT_NEAR(found.taken_by<Friction>(), path, 1e-14);
  EXPECT_NEAR(found.taken_by<Viscous>(), 2 - path, 1e-13);
}

TEST(ExactFrictionBalance, ADamperThatFeedsTakesLessThanNothing) {
  for (const double damping : {-0.1, -7.0}) {
    const Oscillator<double> fed{.mass = 1, .stiffness = 9, .damping = damping, .friction = 0.01};
    const EnergyBalance found = balance(fed, {1, 0}, 3);
    EXPECT_LT(found.taken_by<Viscous>(), -0.1) << damping;
    EXPECT_LT(std::abs(found.method()), 1e-12 * found.end) << damping;
  }
}

TEST(SquareOverArc, IsTheIntegralOfTheSquareOfTheVelocity) {
  // v = -e^{-2 b t} falls from 1: the integral is (1 - e^{-4 b T})/(4 b).
  const double b = 7, from = 3, until = 3.4;
  const LinearLaw<double> law{.decay_rate = b, .stiffness = 0};
  const DrivenOscillator<double, Terms{.law = law_of("viscous")}> arc({1, 0, 2 * b, 0, 0, 0}, {});
  EXPECT_NEAR(square_over_arc(arc, law, State<double>{0, 1}, from, until),
              (1 - std::exp(-4 * b * 0.4)) / (4 * b), 1e-16);
  // Undamped, x = cos 3t: 9 (T/2 - sin(6 T)/12).
  const LinearLaw<double> free{.decay_rate = 0, .stiffness = 9};
  const DrivenOscillator<double, Terms{}> swing({1, 9, 0, 0, 0, 0}, {});
  EXPECT_NEAR(square_over_arc(swing, free, State<double>{1, 0}, 5, 12), 9 * (3.5 - std::sin(42.0) / 12),
              1e-13);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
