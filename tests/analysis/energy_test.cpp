#include "cromer/analysis/energy.h"

#include <gtest/gtest.h>

#include "cromer/base/compensated.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

const Oscillator<double> undamped{.mass = 2, .stiffness = 72};  // w = 6 rad/s
const DrivenOscillator<double, Terms{}> undamped_system(Oscillator<double>{.mass = 1, .stiffness = 36}, {});
const State<double> start{0.7, 0.3};

/// The largest relative change of the modified energy of h over a run by the method.
template <class Number, class M>
double modified_energy_drift(const M& method, long long steps, double h) {
  Drift drift;
  solve(undamped_system, method, {0, static_cast<double>(steps) * h}, State<Number>{start.x, start.v}, {h},
        [&](double, const State<Number>& y) {
          drift(modified_energy(undamped, h, State<double>{value_of(y.x), value_of(y.v)}));
        });
  return drift.largest();
}

TEST(Invariants, EulerCromerKeepsTheModifiedEnergyOverAMillionSteps) {
  // bench_invariants shows 1e8 steps.
  for (const double h : {0.01, 0.1}) {
    const double compensated = modified_energy_drift<Compensated>(EulerCromer{}, 1'000'000, h);
    EXPECT_LT(compensated, 1e-13) << h;
    // Ordinary sums lose more than ten times as much: what the rests are for.
    EXPECT_GT(modified_energy_drift<double>(EulerCromer{}, 1'000'000, h), 10 * compensated) << h;
  }
}

TEST(Invariants, ForwardEulerDoesNotKeepIt) {
  EXPECT_GT(modified_energy_drift<double>(ForwardEuler{}, 100, 0.01), 0.1);
}

TEST(Invariants, TheEnergyItselfSwingsByHalfOmegaH) {
  const double h = 0.01;
  Drift drift;
  solve(undamped_system, EulerCromer{}, {0, 20}, State<double>{1, 0}, {h},
        [&](double, const State<double>& y) { drift(energy(undamped, y)); });
  EXPECT_NEAR(drift.largest(), 6 * h / 2, 0.05 * 6 * h / 2);
}

TEST(Invariants, DriftIsTheLargestChangeFromTheFirstValue) {
  Drift drift;
  EXPECT_EQ(drift.largest(), 0);
  for (const double value : {-2.0, -2.5, -1.0, -2.0}) drift(value);
  EXPECT_EQ(drift.largest(), 0.5);
}

TEST(Invariants, TheModifiedEnergyByHand) {
  EXPECT_EQ(modified_energy(Oscillator<double>{.mass = 2, .stiffness = 3}, 0.5, State<double>{3, 4}),
            16 + 13.5 - 9);
  EXPECT_EQ(modified_energy(Oscillator<double>{.mass = 2, .stiffness = 3}, 0.5, State<double>{3, -4}),
            16 + 13.5 + 9);
}

TEST(Energy, ByHand) {
  EXPECT_DOUBLE_EQ(energy(Oscillator<double>{.mass = 2, .stiffness = 3, .cubic = 4}, State<double>{-1, 3}),
                   9 + 1.5 + 1);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
