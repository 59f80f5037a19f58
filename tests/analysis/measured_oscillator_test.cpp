#include "cromer/analysis/measured_oscillator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/exact.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Of a law of 1 kg.
template <Terms terms = Terms{.law = law_of("viscous")}, class M>
Trajectory run(const M& method, const Oscillator<double>& law, const State<double>& start, double until,
               double step) {
  KeepEvery keep(1, count_steps({0, until}, step));
  const DrivenOscillator<double, terms> system(law, {});
  solve(system, method, {0, until}, start, {step}, keep);
  return keep.take();
}

const Oscillator<double> damped{.mass = 1, .stiffness = 36, .damping = 0.3};  // b = 0.15 1/s

TEST(MeasuredOscillator, FindsTheLinearLaw) {
  const auto measured = measure_oscillator(run(Exact{}, damped, {1, 0}, 20, 0.005));
  ASSERT_TRUE(measured);
  const double wd = std::sqrt(36 - 0.15 * 0.15);
  EXPECT_NEAR(measured->angular_frequency, wd, 1e-9 * wd);
  EXPECT_NEAR(measured->decay_rate, 0.15, 1e-7);
  EXPECT_EQ(measured->half_cycles, 38);
  EXPECT_NEAR(measured->first_amplitude, (1 + std::exp(-0.15 * std::numbers::pi / wd)) / 2, 1e-8);
}

TEST(MeasuredOscillator, TurningPointsKeepToTheirErrors) {
  const double half = std::numbers::pi / 6;
  for (const double h : {0.05, 0.025, 0.0125}) {
    const auto turns = turning_points(run(Exact{}, {.mass = 1, .stiffness = 36}, {0.6, -1.9}, 5, h));
    const double phase = half - std::atan2(1.9 / 6, 0.6) / 6;
    ASSERT_GE(turns.size(), 9u);
    EXPECT_NEAR(turns[8].t, phase + 8 * half, std::pow(6 * h, 5) / 6 / 6);
    EXPECT_NEAR(turns[8].x, -std::hypot(0.6, 1.9 / 6), std::pow(6 * h, 6) / 300);
  }
}

TEST(MeasuredOscillator, FindsTheDuffingOscillatorsFrequency) {
  // x'' + x + x^3 = 0 from x = 1: T = 4 K(m)/sqrt(1 + A^2), m = A^2/(2 (1 + A^2)) = 1/4, K by the arithmetic
  // and geometric mean: pi/(2 agm(1, sqrt(1 - m))).
  double a = 1, g = std::sqrt(0.75);
  for (int i = 0; i < 6; ++i) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  const double period = 4 * std::numbers::pi / (2 * a) / std::sqrt(2);
  const auto measured = measure_oscillator(
      run<Terms{.law = law_of("cubic")}>(Rk4{}, {.mass = 1, .stiffness = 1, .cubic = 1}, {1, 0}, 100, 0.002));
  ASSERT_TRUE(measured);
  EXPECT_NEAR(measured->angular_frequency, 2 * std::numbers::pi / period, 1e-9);
  EXPECT_NEAR(measured->decay_rate, 0, 1e-10);
  EXPECT_NEAR(measured->last_amplitude, 1, 1e-9);
}

TEST(MeasuredOscillator, SeesNoOscillationWhereThereIsNone) {
  EXPECT_FALSE(measure_oscillator(run(Exact{}, {.mass = 1, .stiffness = 1, .damping = 5}, {1, 0}, 10, 0.1)));
  EXPECT_FALSE(measure_oscillator({}));
}

TEST(Recurrence, IsTheMethodsOwnOscillatorToRounding) {
  const double h = 0.01, b = 0.15, w = 6;
  // Euler-Cromer's closed form.
  const auto cromer = measure_recurrence(run(EulerCromer{}, damped, {1, 0}, 20, h).x, h, w);
  ASSERT_TRUE(cromer);
  EXPECT_NEAR(cromer->decay_rate, -std::log(1 - 2 * b * h) / (2 * h), 1e-12);
  EXPECT_NEAR(cromer->angular_frequency,
              std::acos((1 - b * h - w * w * h * h / 2) / std::sqrt(1 - 2 * b * h)) / h, 1e-12 * w);
  // Forward Euler grows.
  const auto forward = measure_recurrence(run(ForwardEuler{}, damped, {1, 0}, 20, h).x, h, w);
  ASSERT_TRUE(forward);
  EXPECT_NEAR(forward->decay_rate, -std::log(1 - 2 * b * h + w * w * h * h) / (2 * h), 1e-12);
}

TEST(Recurrence, NeedsAnOscillation) {
  EXPECT_FALSE(measure_recurrence({}, 0.1, 1));
  EXPECT_FALSE(measure_recurrence(std::vector<double>(100, 0.0), 0.1, 1));
  EXPECT_FALSE(measure_recurrence(std::vector<double>(100, 1.0), 0.1, 1));
}

// x = sum of c[k] u^k; the turning points of the polynomials are known.
Trajectory along(const std::vector<double>& times, const std::array<double, 4>& c) {
  Trajectory kept;
  for (const double u : times) {
    kept.t.push_back(10 + u);
    kept.x.push_back(c[0] + u * (c[1] + u * (c[2] + u * c[3])));
    kept.v.push_back(c[1] + u * (2 * c[2] + u * 3 * c[3]));
  }
  return kept;
}

TEST(TurningPoints, OfACubicAreExactHoweverFarApartTheStates) {
  // x = u^3 - 3 u turns at -1 and 1.
  for (const double sign : {1.0, -1.0})
    for (const auto& places : {std::vector<double>{-4, -2, -1.5, -0.9, 0, 0.2, 2, 2.5, 4},
                               {-1.3, -1.2, -1.1, -0.9, 0.3, 0.9, 1.1, 7, 8}}) {
      const auto found = turning_points(along(places, {0, -3 * sign, 0, sign}));
      ASSERT_EQ(found.size(), 2u) << places[0];
      EXPECT_NEAR(found[0].t, 9, 1e-13) << places[0];
      EXPECT_NEAR(found[0].x, 2 * sign, 1e-11);
      EXPECT_NEAR(found[1].t, 11, 1e-13);
      EXPECT_NEAR(found[1].x, -2 * sign, 1e-11);
    }
}

TEST(TurningPoints, AreSeenByThreeStatesOnEitherSide) {
  const std::array<double, 4> parabola{3.25, -1, 1, 0};  // turns at 0.5
  for (const double sign : {1.0, -1.0}) {
    std::array<double, 4> c = parabola;
    for (double& each : c) each *= sign;
    const auto found = turning_points(along({-2, -1, 0, 1, 2, 3}, c));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].t, 10.5, 1e-14);
    EXPECT_NEAR(found[0].x, 3 * sign, 1e-14);
    EXPECT_TRUE(turning_points(along({-1, 0, 1, 2, 3}, c)).empty());
    EXPECT_TRUE(turning_points(along({-2, -1, 0, 1, 2}, c)).empty());
  }
}

TEST(TurningPoints, OfAFirstOrderMethodAreThoseOfItsVelocity) {
  // Without damping Euler-Cromer swings at 2/h asin(w h/2), with an even amplitude.
  for (const double h : {0.1, 0.05}) {
    const double wh = 6 * h, own = 2 / h * std::asin(wh / 2);
    const Trajectory kept = run(EulerCromer{}, {.mass = 1, .stiffness = 36}, {1, 0}, 20.03, h);
    const auto measured = measure_oscillator(kept);
    ASSERT_TRUE(measured);
    const double turns = measured->half_cycles;
    EXPECT_NEAR(measured->angular_frequency, own, own * std::pow(wh, 5) / 3 / (turns * std::numbers::pi));
    EXPECT_NEAR(measured->last_amplitude / measured->first_amplitude, 1, std::pow(wh, 4) / 300);
    EXPECT_NEAR(measured->decay_rate, 0, std::pow(wh, 4) / 1000);
  }
}

TEST(TurningPoints, FrictionDoesNotMoveThem) {
  // From 1 m, each half swing about the place +-F/k where friction holds the spring.
  for (const double h : {0.1, 0.05, 0.02}) {
    Trajectory kept;
    for (double t = 0.3 * h; t < 7.3; t += h) {
      const double half = std::floor(6 * t / std::numbers::pi), sign = std::fmod(half, 2) == 0 ? 1 : -1;
      const double A = 1 - 0.06 * half - 0.03, phase = 6 * t - half * std::numbers::pi;
      kept.t.push_back(t);
      kept.x.push_back(sign * (0.03 + A * std::cos(phase)));
      kept.v.push_back(-6 * sign * A * std::sin(phase));
    }
    const auto found = turning_points(kept);
    ASSERT_EQ(found.size(), 13u);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double turn = static_cast<double>(i + 1);
      EXPECT_NEAR(found[i].t, turn * std::numbers::pi / 6, std::pow(6 * h, 5) / 6 / 6) << h;
      EXPECT_NEAR(std::abs(found[i].x), 1 - 0.06 * turn,
                  0.06 * std::pow(6 * h, 2) / 60 + std::pow(6 * h, 6) / 300);
    }
  }
}

TEST(TurningPoints, AMassThatComesToRestTurnsOnce) {
  const auto times = [](std::vector<double> v) {
    Trajectory kept{{}, {}, std::move(v)};
    for (std::size_t i = 0; i < kept.v.size(); ++i) {
      kept.t.push_back(5 + static_cast<double>(i));
      kept.x.push_back(static_cast<double>(i * i));
    }
    std::vector<double> found;
    for (const TurningPoint& turn : turning_points(kept)) {
      found.push_back(turn.t);
      EXPECT_EQ(turn.x, (turn.t - 5) * (turn.t - 5));
    }
    return found;
  };
  EXPECT_EQ(times({1, 1, 0, 0, 0}), std::vector<double>{7});
  EXPECT_EQ(times({0, -1, 0, 1, 1}), (std::vector<double>{5, 7}));
  EXPECT_EQ(times({0, 0, 0, 1, 1}), std::vector<double>{}) << "it rested from the start";
  EXPECT_EQ(times({-1, -1, -1, -1, 0, 1, 1, 1}), std::vector<double>{9}) << "far from both ends";
  EXPECT_EQ(times({1, 1, 1, 1, -0.0, -1, -1, -1}), std::vector<double>{9});
  EXPECT_EQ(times({1, 2, 3}), std::vector<double>{});
}

TEST(TurningPoints, AMassCameToRestBetweenTheStates) {
  // x = 3 - (1.25 - t)^2 until 1.25 s, then at rest.
  const Trajectory kept{{0, 1, 2, 3}, {3 - 1.5625, 3 - 0.0625, 3, 3}, {2.5, 0.5, 0, 0}};
  const auto found = turning_points(kept);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].t, 1.25, 1e-14);
  EXPECT_EQ(found[0].x, 3);
}

/// Turns at 5, 6, 7, ... s, a state between two of them.
Trajectory turning_at(const std::vector<double>& places) {
  Trajectory kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = 5 + static_cast<double>(i);
    kept.t.insert(kept.t.end(), {t, t + 0.5});
    kept.x.insert(kept.x.end(), {places[i], 0});
    kept.v.insert(kept.v.end(), {0, i % 2 == 0 ? -1.0 : 1.0});
  }
  return kept;
}

TEST(MeasuredOscillator, IsReadFromItsTurningPoints) {
  const auto found = measure_oscillator(turning_at({8, -4, 2, -1}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->angular_frequency, std::numbers::pi, 1e-14);
  EXPECT_NEAR(found->decay_rate, std::numbers::ln2, 1e-14);
  EXPECT_NEAR(found->first_amplitude, 6, 1e-14);
  EXPECT_NEAR(found->last_amplitude, 1.5, 1e-14);
  EXPECT_EQ(found->half_cycles, 3);
  EXPECT_EQ(measure_oscillator(turning_at({8, -4, 2}))->half_cycles, 2) << "three are enough";
  EXPECT_FALSE(measure_oscillator(turning_at({8, -4})));
  EXPECT_FALSE(measure_oscillator(turning_at({8, 8, 2, -1}))) << "no way from one to the next";
}

/// States of a decaying swing, with 1/2 rad from each to the next.
std::vector<double> swing(std::size_t n) {
  std::vector<double> x;
  for (std::size_t i = 0; i < n; ++i)
    x.push_back(std::exp(-0.1 * static_cast<double>(i)) * std::cos(0.5 * static_cast<double>(i) + 0.3));
  return x;
}

void expect_swing(const std::optional<Recurrence>& found) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->angular_frequency, 0.5 / 0.2, 1e-12);
  EXPECT_NEAR(found->decay_rate, 0.1 / 0.2, 1e-12);
}

TEST(Recurrence, NeedsThreeStridesAndTwoStates) {
  // A radian is two states here.
  std::vector<double> x = swing(8);
  x.push_back(1e9);
  x.pop_back();
  expect_swing(measure_recurrence(x, 0.2, 2.5));
  EXPECT_FALSE(measure_recurrence(swing(7), 0.2, 2.5));
  // Less than two, more than a half: one.
  expect_swing(measure_recurrence(swing(5), 0.2, 4));
  EXPECT_FALSE(measure_recurrence(swing(4), 0.2, 4));
  expect_swing(measure_recurrence(swing(5), 0.2, 50));
  EXPECT_FALSE(measure_recurrence(swing(50), 0.2, 0.05)) << "a radian longer than the run";
  EXPECT_FALSE(measure_recurrence(swing(50), 0.2, -2.5));
  EXPECT_FALSE(measure_recurrence(swing(50), 0.2, 0));
}

TEST(Recurrence, PassesOverStatesOfNothing) {
  std::vector<double> late = swing(60);
  for (std::size_t i = 0; i < 10; ++i) late[i] = 0;
  const auto found = measure_recurrence(late, 0.2, 4);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->angular_frequency, 2.5, 0.5);
}

TEST(Recurrence, OfWhatDoesNotSwingIsNone) {
  std::vector<double> dies, grows, alternates;
  for (int i = 0; i < 40; ++i) {
    dies.push_back(std::pow(0.9, i) + std::pow(0.7, i));
    grows.push_back(std::pow(1.1, i) - std::pow(0.8, i));
    alternates.push_back(std::pow(0.9, i) + std::pow(-0.8, i));
  }
  for (const auto& x : {dies, grows, alternates}) EXPECT_FALSE(measure_recurrence(x, 0.2, 5));
}

const Oscillator<double> spring{.mass = 0.2, .stiffness = 16.6};
const double w = std::sqrt(16.6 / 0.2);

template <class M>
Trajectory free_motion(const M& method, const Oscillator<double>& o, double h) {
  KeepEvery keep(1, count_steps({0, 20}, h));
  with_terms(o, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, method, {0, 20}, State<double>{0.05, 0}, h, keep);
  });
  return keep.take();
}

TEST(EnergyGrowth, OfForwardEulerIsKnown) {
  // Each step multiplies the energy by exactly 1 + (w h)^2.
  const double h = 0.002;
  const auto growth = energy_growth(spring, free_motion(ForwardEuler{}, spring, h));
  const double rate = std::log1p(w * w * h * h) / h, period = 2 * std::numbers::pi / w;
  EXPECT_NEAR(growth.rate, rate, 1e-9 * rate);
  EXPECT_NEAR(growth.factor_per_cycle(period), std::exp(rate * period), 1e-9);
  EXPECT_NEAR(growth.doubling_time(), std::numbers::ln2 / rate, 1e-8);
}

TEST(EnergyGrowth, OfTheExactMotion) {
  EXPECT_NEAR(energy_growth(spring, free_motion(Exact{}, spring, 0.01)).rate, 0, 1e-15);
  // Decays with c/m; the swing within a cycle leaves a trace of its size over the number of cycles.
  const Oscillator<double> decaying{.mass = 0.2, .stiffness = 16.6, .damping = 0.02};
  EXPECT_NEAR(energy_growth(decaying, free_motion(Exact{}, decaying, 0.01)).rate, -0.1, 1e-4);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
