#include "cromer/ensemble/stepped_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cromer/methods/all.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

// So few bits that every angle of a million steps is exact.
constexpr HarmonicForce<double> force{2, 0.75, 0.5};
constexpr double h = 1.0 / 64;

/// At that fraction of the step after n steps.
double exact(double n, double fraction) {
  const long double angle = (static_cast<long double>(n) + fraction) * h * force.frequency + force.phase;
  return static_cast<double>(force.amplitude * std::cos(angle));
}

/// Largest error in a million steps, re-anchored as groups are [of the amplitude].
template <class Drive, class Fractions>
double worst(Drive drive, const Fractions& fractions) {
  double most = 0;
  for (int n = 0; n < 1000000; ++n) {
    n % 128 == 0 ? drive.anchor(n * h) : drive.move_on();
    for (const double fraction : fractions)
      most = std::max(most,
                      std::abs(drive(StepTime<double>{(n + fraction) * h, fraction}) - exact(n, fraction)));
  }
  return most / force.amplitude;
}

template <class M>
double worst_of(const M& method) {
  return worst(RotatedForce<double, M>(force, h, method), method.asked_at());
}

TEST(RotatedForce, IsTheCosineAtEveryFractionAMethodAsksAt) {
  EXPECT_LT(worst_of(Yoshida4{}), 3e-14);
  EXPECT_LT(worst_of(GaussLegendre4{}), 3e-14);
  EXPECT_LT(worst_of(GeneralizedAlpha{}), 3e-14);
  EXPECT_LT(worst_of(GeneralizedAlpha{.newton = {}, .rho_inf = 0}), 3e-14);
}

TEST(SteppedForce, IsTheCosineAtTheNodes) {
  EXPECT_LT(worst(SteppedForce<double, 1>(force, h), std::array{0.0, 1.0}), 3e-14);
  EXPECT_LT(worst(SteppedForce<double, 2>(force, h), std::array{0.0, 0.5, 1.0}), 3e-14);
}

TEST(RotatedForce, EveryMethodOfFixedStepsHasOneOrDivisions) {
  for_each_method({}, []<class M>(const M&) {
    EXPECT_EQ(M::info.takes_fixed_steps(), (M::info.divisions > 0) != AsksAtFractions<M>) << M::info.name;
  });
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
