#include "cromer/analysis/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/exact.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/methods/implicit_euler.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

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

// The quadratures behind the balances, on powers whose integrals are known.

const Oscillator<double> unit{.mass = 1, .stiffness = 0, .friction = 1};

/// The work of the force t^degree on what moves at 1 m/s, from the states at these times.
double work(int degree, const std::vector<double>& times, double step) {
  EnergyLedger book([&](double t) { return std::pow(t, degree); }, unit, step);
  for (const double t : times) book(t, {t, 1});
  return book.balance().drive;
}

double integral_of_power(int degree, double from, double until) {
  return (std::pow(until, degree + 1) - std::pow(from, degree + 1)) / (degree + 1);
}

TEST(EnergyLedger, IsExactForAsManyPowersAsItHasStatesForUpToTheFifth) {
  const int exact_up_to[] = {0, 0, 1, 3, 3, 5, 5, 5, 5, 5, 5, 5, 5};
  for (std::size_t count = 2; count <= 12; ++count) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) times.push_back(1 + 0.25 * static_cast<double>(i));
    for (int degree = 0; degree <= exact_up_to[count]; ++degree) {
      const double truth = integral_of_power(degree, 1, times.back());
      EXPECT_NEAR(work(degree, times, 0.25) / truth, 1, 1e-14) << count << ' ' << degree;
    }
    EXPECT_GT(std::abs(work(8, times, 0.25) / integral_of_power(8, 1, times.back()) - 1), 1e-9) << count;
  }
}

TEST(EnergyLedger, LacksGregorysNextTermOfTheSixthPower) {
  // 275/24192 times the sixth difference, 720 h^6, at each end.
  const double h = 0.5;
  std::vector<double> times;
  for (int i = 0; i < 12; ++i) times.push_back(h * i);
  const double lacking = 2 * h * 275.0 / 24192 * 720 * std::pow(h, 6);
  EXPECT_NEAR((work(6, times, h) - integral_of_power(6, 0, times.back())) / lacking, 1, 1e-8);
}

TEST(EnergyLedger, AShorterLastStepIsATrapezium) {
  for (int degree = 0; degree <= 5; ++degree) {
    const double whole = integral_of_power(degree, 1, 3),
                 last = 0.05 * (std::pow(3, degree) + std::pow(3.1, degree));
    EXPECT_NEAR(work(degree, {1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.1}, 0.25), whole + last, 1e-12)
        << degree;
  }
  // A step that is shorter by rounding alone is a whole one.
  EXPECT_NEAR(work(3, {1, 1.25, 1.5 - 1e-8}, 0.25), integral_of_power(3, 1, 1.5), 1e-5);
  EXPECT_NEAR(work(3, {1, 1.25, 1.5 - 1e-8}, 0.25) - integral_of_power(3, 1, 1.5), 0, 2e-7);
}

TEST(EnergyLedger, FrictionTakesItsForceTimesThePath) {
  const auto path = [](const std::vector<State<double>>& states, double step) {
    EnergyLedger book([](double) { return 0.0; }, unit, step);
    for (std::size_t i = 0; i < states.size(); ++i) book(4 + step * static_cast<double>(i), states[i]);
    return book.balance().taken_by<Friction>();
  };
  EXPECT_NEAR(path({{1, 1}, {3, 2}, {2.5, 0}}, 0.5), 2.5, 1e-15);
  EXPECT_NEAR(path({{1, -1}, {-1, -2}}, 0.5), 2, 1e-15);
  // From 2 to -1 m/s in a second: 2/3 s forth at 1 m/s on average, 1/3 s back at 1/2 m/s.
  EXPECT_NEAR(path({{1, 2}, {1.5, -1}}, 1), 2.0 / 3 + 1.0 / 6, 1e-15);
  EXPECT_NEAR(path({{1, -1}, {1.5, 2}}, 0.5), 1.0 / 3 + 1.0 / 12, 1e-15);
}

TEST(EnergyLedger, KnowsStartAndEnd) {
  const Oscillator<double> spring{.mass = 2, .stiffness = 3, .damping = 0.5};
  EnergyLedger book([](double) { return 0.0; }, spring, 1);
  book(0, {1, 2});
  book(1, {3, 4});
  book(1.5, {5, 6});
  const EnergyBalance found = book.balance();
  EXPECT_EQ(found.start, 4 + 1.5);
  EXPECT_EQ(found.end, 36 + 37.5);
  // 0.5 (4 + 16)/2 and 0.5 (16 + 36)/4.
  EXPECT_NEAR(found.taken_by<Viscous>(), 5 + 6.5, 1e-14);
  EXPECT_NEAR(found.method(), 68 + 11.5, 1e-13);
}

TEST(GaussPanel, IsExactUpToDegreeNineteen) {
  for (int degree = 0; degree <= 19; ++degree) {
    const Power found = gauss_panel([&](double t) { return Power{.drive = std::pow(t, degree)}; }, 1, 3);
    EXPECT_NEAR(found.drive / integral_of_power(degree, 1, 3), 1, 1e-14) << degree;
  }
  const Power beyond = gauss_panel([&](double t) { return Power{.drive = std::pow(t, 20)}; }, -1, 1);
  EXPECT_GT(std::abs(beyond.drive - 2.0 / 21), 1e-8);
}

TEST(ExactWork, BeginsWhereItIsToldTo) {
  const auto state = [](double t) { return State<double>{0, std::cos(t)}; };
  const Power found = exact_work([](double t) { return std::sin(t); }, state, 5, 12, 0.7);
  EXPECT_NEAR(found.drive, (std::pow(std::sin(12), 2) - std::pow(std::sin(5), 2)) / 2, 1e-14);
  EXPECT_NEAR(found.taken.of<Viscous>(), 3.5 + (std::sin(24) - std::sin(10)) / 4, 1e-14);
  EXPECT_EQ(exact_work([](double) { return 1.0; }, state, 5, 5, 0.7).drive, 0);
}

TEST(ExactWork, ClosesInOnAJump) {
  const auto state = [](double) { return State<double>{0, 2}; };
  const auto jump = [](double t) { return t < 7.1234 ? 1.0 : -3.0; };
  const Power found = exact_work(jump, state, 5, 12, 0.7);
  EXPECT_NEAR(found.drive, 2 * (2.1234 - 3 * (12 - 7.1234)), 1e-12);
  EXPECT_NEAR(found.taken.of<Friction>(), 14, 1e-13);
}

TEST(EnergyBalance, WhatIsLeftOverIsTheMethods) {
  EnergyBalance balance{.start = 5, .end = 7, .drive = 4, .taken = {}};
  balance.taken.of<Viscous>() = 1;
  balance.taken.of<Drag>() = 0.25;
  EXPECT_EQ(balance.taken.sum(), 1.25);
  EXPECT_EQ(balance.method(), 2 - (4 - 1.25));
  EXPECT_EQ(balance.taken_by<Drag>(), 0.25);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
