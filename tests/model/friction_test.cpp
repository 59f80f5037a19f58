#include "cromer/model/friction.h"

#include <gtest/gtest.h>

#include "cromer/model/driven_oscillator.h"

namespace cromer::core {
namespace CROMER_FILE {

using Smooth = DrivenOscillator<double, Terms{.law = law_of("viscous")}>;
const Smooth smooth({.mass = 1, .stiffness = 9, .damping = 0.2}, {});
const DryFriction friction(smooth, 0.5, 0.8);

TEST(Friction, SlidingIsAConstantForceAgainstTheDirection) {
  EXPECT_DOUBLE_EQ(friction.sliding(1).acceleration(0.0, 0.1, 2.0), -0.9 - 0.4 - 0.5);
  EXPECT_DOUBLE_EQ(friction.sliding(-1).acceleration(0.0, 0.1, -2.0), -0.9 + 0.4 + 0.5);
  EXPECT_DOUBLE_EQ(friction.sliding(1).acceleration(0.0, 0.1, 0.0), -0.9 - 0.5) << "also where v vanishes";
}

TEST(Friction, HoldsAtRestUpToTheStaticFriction) {
  EXPECT_EQ(friction.acceleration(0.0, 0.08, 0.0), 0);
  EXPECT_DOUBLE_EQ(friction.acceleration(0.0, 0.1, 0.0), -0.9 + 0.5);
  EXPECT_DOUBLE_EQ(friction.acceleration(0.0, -0.1, 0.0), 0.9 - 0.5);
  EXPECT_DOUBLE_EQ(friction.pull(0.0, 0.08), -0.72);
  EXPECT_EQ(friction.holding(), 0.8);
  EXPECT_EQ(DryFriction(smooth, 0.5, 0.0).holding(), 0.5) << "never below the kinetic friction";
}

TEST(Friction, AnArcSolvesTheEquationOfItsPhase) {
  for (const double k : {9.0, 0.0, -2.0}) {
    const Smooth law({.mass = 1, .stiffness = k, .damping = 0.2}, {});
    const auto arc = DryFriction(law, 0.5, 0.5).sliding(1);
    const State<double> y0{0.3, 2};
    EXPECT_EQ(arc.propagate(1, 1, y0).x, 0.3);
    EXPECT_EQ(arc.propagate(1, 1, y0).v, 2);
    const double t = 1.4, h = 1e-5;
    const auto before = arc.propagate(1, t - h, y0), now = arc.propagate(1, t, y0),
               after = arc.propagate(1, t + h, y0);
    EXPECT_NEAR((after.x - before.x) / (2 * h), now.v, 1e-9) << k;
    EXPECT_NEAR((after.v - before.v) / (2 * h), arc.acceleration(t, now.x, now.v), 1e-9) << k;
  }
}

TEST(Friction, IsInTheLawAsATermOfItsOwn) {
  EXPECT_TRUE(terms_of(Oscillator<double>{.friction = 1}, HarmonicDrive<double>{}).law.has<Friction>());
  EXPECT_TRUE(
      terms_of(Oscillator<double>{.static_friction = 1}, HarmonicDrive<double>{}).law.has<Friction>());
  EXPECT_FALSE(terms_of(Oscillator<double>{}, HarmonicDrive<double>{}).law.has<Friction>());
  // Per unit mass: 1 N on 2 kg.
  const double holding = with_terms(Oscillator<double>{.mass = 2, .friction = 1}, HarmonicDrive<double>{},
                                    [](const auto& system) {
                                      if constexpr (requires { system.holding(); }) return system.holding();
                                      return 0.0;
                                    });
  EXPECT_EQ(holding, 0.5);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
