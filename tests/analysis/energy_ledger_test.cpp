// The quadratures behind the balances, on powers whose integrals are known.
#include "cromer/analysis/energy_ledger.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/analysis/exact_energy_balance.h"

namespace cromer::core {
namespace {

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

}  // namespace
}  // namespace cromer::core
