// How each term shows itself in amplitude and frequency, as docs/theory.md says, and where its energy goes.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/analysis/energy_balance.h"
#include "cromer/base/pi.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr Terms any_law{.law = any_terms};

using AnyLaw = DrivenOscillator<double, any_law>;

struct Swing {
  double frequency = 0;            // [rad/s]
  double highest = 0, lowest = 0;  // [m] turning points of one cycle
};

/// One cycle of the motion that begins at rest at x [m]: from turn to turn, by parts of steps.
Swing swing_from(const Oscillator<double>& law, double x) {
  const AnyLaw system(law, {});
  const double h = 1e-3;
  State<double> y{x, 0};
  NoMemory none;
  Swing swing{.highest = x, .lowest = x};
  int turns = 0;
  double t = 0;
  for (;; t += h) {
    const State<double> next = Rk4{}.step(system, 0.0, h, y, none).y;
    if (t > 0 && y.v * next.v <= 0) {
      // The zero of the velocity within the step.
      double part = h * y.v / (y.v - next.v);
      for (int i = 0; i < 20; ++i) {
        const State<double> there = Rk4{}.step(system, 0.0, part, y, none).y;
        part -= there.v / system.acceleration(0.0, there.x, there.v);
      }
      const State<double> turn = Rk4{}.step(system, 0.0, part, y, none).y;
      swing.highest = std::max(swing.highest, turn.x);
      swing.lowest = std::min(swing.lowest, turn.x);
      if (++turns == 2) {
        swing.frequency = 2 * pi / (t + part);
        return swing;
      }
    }
    y = next;
  }
}

constexpr double w0 = 3;

/// With the coefficient of T, and the spring.
template <class T>
Oscillator<double> with(double coefficient) {
  Oscillator<double> law{.stiffness = w0 * w0};
  law.*T::template members<double>[0] = coefficient;
  return law;
}

/// What is left of the shift that a formula says [rad/s] falls with that power of the amplitude, the next
/// one.
template <class Shift>
void expect_shift(const Oscillator<double>& law, double amplitude, Shift shift, int next_power) {
  const auto left = [&](double a) { return swing_from(law, a).frequency - w0 - shift(a); };
  EXPECT_NEAR(std::log2(left(amplitude) / left(amplitude / 2)), next_power, 0.1);
}

TEST(TermsShowThemselves, CubicInTheSquareOfTheAmplitude) {
  expect_shift(
      with<Cubic>(2), 0.2, [](double a) { return 3 * 2 * a * a / (8 * w0); }, 4);
}

TEST(TermsShowThemselves, QuinticInItsFourthPower) {
  expect_shift(
      with<Quintic>(2), 0.4, [](double a) { return 5 * 2 * std::pow(a, 4) / (16 * w0); }, 8);
}

TEST(TermsShowThemselves, OddQuadraticInTheAmplitudeItself) {
  expect_shift(
      with<OddQuadratic>(2), 0.1, [](double a) { return 4 * 2 * a / (3 * pi * w0); }, 2);
}

TEST(TermsShowThemselves, QuadraticInAMeanThatMovesAndAFrequencyThatFalls) {
  const double k2 = 2;
  for (const double from : {0.05, 0.1}) {
    const Swing swing = swing_from(with<Quadratic>(k2), from);
    const double amplitude = (swing.highest - swing.lowest) / 2, middle = (swing.highest + swing.lowest) / 2;
    const double shift = -5 * k2 * k2 * amplitude * amplitude / (12 * std::pow(w0, 3));
    EXPECT_NEAR(swing.frequency - w0, shift, 0.02 * std::abs(shift));
    // The mean -k2 A^2/2w0^2 and the second harmonic k2 A^2/6w0^2, which both turning points see.
    const double off = -k2 * amplitude * amplitude / (3 * w0 * w0);
    EXPECT_NEAR(middle, off, 0.02 * std::abs(off));
  }
}

TEST(TermsShowThemselves, PendulumInAFrequencyThatFalls) {
  const Oscillator<double> law{.stiffness = 0, .pendulum = w0 * w0};
  expect_shift(
      law, 0.4, [](double a) { return -w0 * a * a / 16; }, 4);
}

TEST(TermsShowThemselves, VanDerPolInADecayThatGrowsWithTheSquare) {
  const double e = 0.05, a = 0.8;
  const Swing swing = swing_from(with<VanDerPol>(e), a);
  // From a to -lowest in half a cycle; dA/dt = -e A^3/8.
  const double half = pi / w0, expected = a / std::sqrt(1 + e * a * a * half / 4);
  EXPECT_NEAR(-swing.lowest, expected, 0.01 * (a - expected));
  EXPECT_NEAR(swing.frequency, w0, 1e-4);
}

TEST(TermsShowThemselves, EachKeepsOrTakesItsEnergy) {
  for_each_term([]<class T>() {
    if constexpr (smooth_terms.has<T>()) {
      Oscillator<double> law{.stiffness = 9};
      law.*T::template members<double>[0] = 0.7;
      const AnyLaw system(law, {});
      EnergyLedger book([](double) { return 0.0; }, law, 0.002);
      solve(system, Rk4{}, {0, 20}, State<double>{0.5, 0}, 0.002,
            [&](double t, const State<double>& y) { book(t, y); });
      const EnergyBalance b = book.balance();
      EXPECT_LT(std::abs(b.method()), 1e-8 * b.start) << T::info.name;
      if constexpr (resistances.has<T>()) {
        EXPECT_GT(b.taken.of<T>(), 0.05 * b.start) << T::info.name;
        EXPECT_EQ(b.taken.sum(), b.taken.of<T>()) << T::info.name;
      } else {
        EXPECT_EQ(b.taken.sum(), 0) << T::info.name;
        // Its own share is part of what is kept: without it the energy would not be constant.
        if (!std::is_same_v<T, Spring>) {
          EXPECT_NE(energy(law, State<double>{0.5, 0}),
                    energy(Oscillator<double>{.stiffness = 9}, State<double>{0.5, 0}))
              << T::info.name;
        }
      }
    }
  });
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
