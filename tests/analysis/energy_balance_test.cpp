#include "cromer/analysis/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/analysis/energy_ledger.h"
#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/exact.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/methods/implicit_euler.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace {

constexpr Terms everything{.drive = true, .law = law_of("viscous+drag+cubic")};
constexpr double quarter = std::numbers::pi / 2 / 3;  // of the natural period of 9 N/m and 1 kg

auto force_of(const HarmonicDrive<double>& drive) {
  return [force = HarmonicForce<double>{drive.amplitude, drive.frequency, drive.phase}](double t) {
    return force(t);
  };
}

/// The exact balance of the linear law.
EnergyBalance exact(const Oscillator<double>& law, const HarmonicDrive<double>& drive,
                    const State<double>& start, double until, double panel) {
  const LinearLaw<double> linear{law.damping / (2 * law.mass), law.stiffness / law.mass,
                                 drive.amplitude / law.mass, drive.frequency, drive.phase};
  return exact_energy_balance(
      force_of(drive), law, [&](double t) { return propagate(linear, 0.0, t, start); }, until, panel);
}

/// The balance of a run of a law of 1 kg, from its states.
template <Terms terms = Terms{.drive = true, .law = law_of("viscous")}, class M>
EnergyBalance ledger(const M& method, const Oscillator<double>& law, const HarmonicDrive<double>& drive,
                     const State<double>& start, double until, double step) {
  const DrivenOscillator<double, terms> system(law,
                                               {drive.amplitude / law.mass, drive.frequency, drive.phase});
  EnergyLedger book(force_of(drive), law, step);
  solve(system, method, {0, until}, start, {step}, [&](double t, const State<double>& y) { book(t, y); });
  return book.balance();
}

double largest(const EnergyBalance& b) {
  return std::max({std::abs(b.start), std::abs(b.end), std::abs(b.drive), b.taken_by<Viscous>()});
}

TEST(EnergyBalance, ClosesToRoundingForTheExactMotion) {
  struct Case {
    Oscillator<double> law;
    HarmonicDrive<double> drive;
    double until;
  };
  for (const Case& c : {Case{{.mass = 1, .stiffness = 9, .damping = 0.2}, {1, 3, 0}, 80},
                        Case{{.mass = 1, .stiffness = 9, .damping = 0}, {1, 3, 0.3}, 200},
                        Case{{.mass = 2, .stiffness = 9, .damping = 0.01}, {0, 0, 0}, 3000},
                        Case{{.mass = 1, .stiffness = 9, .damping = 6}, {2, 0.1, 1}, 10},
                        Case{{.mass = 1, .stiffness = 9, .damping = 500}, {2, 5, 1}, 10},
                        Case{{.mass = 1, .stiffness = -1, .damping = 0.5}, {0, 0, 0}, 5}}) {
    const EnergyBalance b = exact(c.law, c.drive, {0.4, -0.3}, c.until, quarter);
    EXPECT_LT(std::abs(b.method()), 3e-14 * largest(b)) << c.law.damping << " " << c.drive.frequency;
    EXPECT_EQ(b.taken_by<Drag>(), 0);
    EXPECT_EQ(b.taken_by<Friction>(), 0);
  }
}

TEST(EnergyBalance, DampingTakesWhatTheClosedFormSays) {
  // Undriven, all that is lost goes into the damper.
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.2};
  const EnergyBalance b = exact(law, {}, {1, 0}, 1000, quarter);
  EXPECT_EQ(b.start, 4.5);
  EXPECT_NEAR(b.taken_by<Viscous>(), 4.5, 1e-13);
  EXPECT_EQ(b.drive, 0);
}

TEST(EnergyBalance, LedgerOfExactStatesClosesLikeItsQuadrature) {
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.2};
  const HarmonicDrive<double> drive{1, 2.5, 0.4};
  const EnergyBalance truth = exact(law, drive, {0.4, -0.3}, 50, quarter);
  double before = 0;
  for (const double step : {0.1, 0.05, 0.025}) {
    const EnergyBalance b = ledger(Exact{}, law, drive, {0.4, -0.3}, 50, step);
    EXPECT_NEAR(b.drive, truth.drive, 5e-4 * std::pow(step * 10, 7));
    const double error = std::abs(b.method());
    EXPECT_LT(error, 1e-3 * std::pow(step * 10, 6));
    // At least sixth order: halving the step leaves less than a 32nd.
    if (before > 0) {
      EXPECT_LT(error, before / 32);
    }
    before = error;
  }
}

TEST(EnergyBalance, SaysWhatAMethodMakesAndLoses) {
  const Oscillator<double> undamped{.mass = 1, .stiffness = 9};
  const double h = 0.01, growth = std::pow(1 + 9 * h * h, 1000);
  EXPECT_NEAR(ledger(ForwardEuler{}, undamped, {}, {1, 0}, 10, h).method(), 4.5 * (growth - 1), 1e-11);
  EXPECT_NEAR(ledger(ImplicitEuler{}, undamped, {}, {1, 0}, 10, h).method(), 4.5 * (1 / growth - 1), 1e-11);
  EXPECT_NEAR(ledger(Rk4{}, undamped, {}, {1, 0}, 10, h).method(), 0, 1e-7);
}

TEST(EnergyBalance, DragAndCubicCloseWithAFineMethod) {
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.1, .drag = 0.3, .cubic = 4};
  const EnergyBalance b = ledger<everything>(Rk4{}, law, {1, 4, 0}, {0.5, 0}, 20, 0.002);
  EXPECT_GT(b.taken_by<Drag>(), 0.01 * b.start);
  EXPECT_LT(std::abs(b.method()), 1e-9 * b.start);
}

TEST(EnergyBalance, AShorterLastStepIsCounted) {
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.2};
  const EnergyBalance whole = ledger(Exact{}, law, {1, 3, 0}, {0, 0}, 10, 0.001);
  const EnergyBalance cut = ledger(Exact{}, law, {1, 3, 0}, {0, 0}, 10, 0.0011);
  EXPECT_NEAR(cut.drive, whole.drive, 1e-8);
  EXPECT_NEAR(cut.taken_by<Viscous>(), whole.taken_by<Viscous>(), 1e-8);
}

TEST(EnergyBalance, OfOneStateIsThatState) {
  const Oscillator<double> law{.mass = 1, .stiffness = 9, .damping = 0.2};
  const EnergyBalance b = ledger(EulerCromer{}, law, {}, {1, 0}, 0, 0.01);
  EXPECT_EQ(b.start, 4.5);
  EXPECT_EQ(b.end, 4.5);
  EXPECT_EQ(b.method(), 0);
}

}  // namespace
}  // namespace cromer::core
