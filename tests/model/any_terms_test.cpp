#include "cromer/model/any_terms.h"

#include <gtest/gtest.h>

#include "cromer/model/driven_oscillator.h"

namespace cromer::core {
namespace CROMER_FILE {

// The same law with its terms as a type: what with_terms calls with.
TEST(AnyTerms, AcceleratesAsTheLawWithExactlyItsTermsDoes) {
  for (int bits = 0; bits < 16; ++bits) {
    const Oscillator<double> o{.mass = 0.7,
                               .stiffness = 3.3,
                               .damping = bits & 1 ? 0.37 : 0,
                               .drag = bits & 2 ? 0.21 : 0,
                               .friction = 0,
                               .cubic = bits & 4 ? -1.9 : 0};
    const HarmonicDrive<double> drive{.amplitude = bits & 8 ? 1.3 : 0, .frequency = 2.1, .phase = 0.4};
    const AnyTerms any(divided_by_mass(o), force_of(drive, o.mass));
    for (const double x : {-0.31, 0.0, 1.7})
      for (const double v : {-2.3, 0.0, 0.77}) {
        const double expected = with_terms(o, drive, [&](const auto& system) -> double {
          if constexpr (requires { system.holding(); })
            return 0;
          else
            return system.acceleration(0.9, x, v);
        });
        EXPECT_EQ(any.acceleration(0.9, x, v), expected) << bits << ' ' << x << ' ' << v;
        EXPECT_EQ(any.sliding(0.5).acceleration(0.9, x, v), expected - 0.5);
      }
    EXPECT_EQ(any.resists(), (bits & 3) != 0);
    EXPECT_EQ(any.linear(), (bits & 6) == 0);
    EXPECT_EQ(any.driven(), (bits & 8) != 0);
  }
}

TEST(AnyTerms, SlidesAlongTheArcOfDryFriction) {
  const Oscillator<double> o{.mass = 1, .stiffness = 4, .damping = 0.2, .friction = 0.3};
  const DryFriction typed(DrivenOscillator<double, Terms{.law = law_of("viscous")}>(o, {}), 0.3, 0.3);
  const AnyFriction any(AnyTerms(o, {}), 0.3, 0.3);
  for (const int direction : {-1, 1}) {
    const State<double> y0{0.5, direction * 0.1};
    EXPECT_EQ(any.sliding(direction).propagate(0.1, 0.6, y0),
              typed.sliding(direction).propagate(0.1, 0.6, y0));
    EXPECT_EQ(any.sliding(direction).zero_spacing(), typed.sliding(direction).zero_spacing());
  }
  EXPECT_EQ(any.pull(0, 0.5), typed.pull(0, 0.5));
  EXPECT_EQ(any.holding(), typed.holding());
}

// Overflow of an absent term must not make what is there NaN.
TEST(AnyTerms, AbsentTermsDoNotOverflow) {
  const AnyTerms linear({.mass = 1, .stiffness = 2}, {});
  EXPECT_EQ(linear.acceleration(0, 1e300, 1e300), -2e300);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
