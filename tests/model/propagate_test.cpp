#include "cromer/model/propagate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "cromer/model/driven_oscillator.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Per unit mass, as with_terms does it.
template <class Real>
LinearLaw<Real> linear_law(const Oscillator<Real>& o, const HarmonicDrive<Real>& d) {
  return {o.damping / o.mass / Real(2), o.stiffness / o.mass, d.amplitude / o.mass, d.frequency, d.phase};
}

/// Largest |x| and |v| of the motion up to t, sampled finely enough for the slow motions of the problems.
State<double> largest(const LinearLaw<double>& law, const State<double>& start, double t) {
  State<double> most{std::abs(start.x), std::abs(start.v)};
  const int samples = static_cast<int>(std::min(20000.0, 200 + 50 * t));
  for (int i = 1; i <= samples; ++i) {
    const State<double> y = propagate(law, 0.0, t * i / samples, start);
    most = {std::max(most.x, std::abs(y.x)), std::max(most.v, std::abs(y.v))};
  }
  return most;
}

/// x'' + 2 b x' + s x - f cos(...) with x'' from a central difference of v.
double residual(const LinearLaw<double>& law, const State<double>& start, double t) {
  const double h = 1e-4;
  const State<double> y = propagate(law, 0.0, t, start);
  const double a = (propagate(law, 0.0, t + h, start).v - propagate(law, 0.0, t - h, start).v) / (2 * h);
  return a + 2 * law.decay_rate * y.v + law.stiffness * y.x -
         law.drive_amplitude * std::cos(law.drive_frequency * t + law.drive_phase);
}

TEST(Propagate, MeetsThePublishedStates) {
  int compared = 0;
  const auto truth_file = problems::read("exact_linear.json");
  for (const auto& [name, problem] : truth_file.items()) {
    const problems::Problem p(problem.at("parameters"));
    const auto law = linear_law(p.oscillator, p.drive);
    for (const auto& entry : problem.at("exact")) {
      const double t = problems::number(entry, "t");
      const State<double> truth{problems::number(entry, "x"), problems::number(entry, "v")};
      const State<double> most = largest(law, p.start, t);
      const double tolerance = t <= 80 ? 1e-12 : 1e-11;
      const State<double> y = propagate(law, 0.0, t, p.start);
      EXPECT_LE(std::abs(y.x - truth.x), tolerance * most.x) << name << " t = " << t;
      EXPECT_LE(std::abs(y.v - truth.v), tolerance * most.v) << name << " t = " << t;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 80);
}

TEST(Propagate, RelativeAccuracyWhileTheSignalLives) {
  // Decaying motions also keep their digits relative to what is left of them.
  const auto truth_file = problems::read("exact_linear.json");
  for (const auto& [name, problem] : truth_file.items()) {
    const problems::Problem p(problem.at("parameters"));
    if (p.drive.amplitude != 0) continue;
    const auto law = linear_law(p.oscillator, p.drive);
    for (const auto& entry : problem.at("exact")) {
      const double t = problems::number(entry, "t"), x = problems::number(entry, "x");
      if (std::abs(x) < 1e-250) continue;
      // nearly-critical: 5.99999999 has no double of its own, which moves (b^2 - s) t^2 and b t
      EXPECT_NEAR(propagate(law, 0.0, t, p.start).x / x, 1, 1e-11) << name << " t = " << t;
    }
  }
}

TEST(Propagate, TruthItselfSolvesTheEquation) {
  const auto truth_file = problems::read("exact_linear.json");
  for (const auto& [name, problem] : truth_file.items()) {
    const problems::Problem p(problem.at("parameters"));
    const auto law = linear_law(p.oscillator, p.drive);
    const auto& first = problem.at("exact").at(0);
    EXPECT_EQ(problems::number(first, "x"), p.start.x) << name;
    EXPECT_EQ(problems::number(first, "v"), p.start.v) << name;
    for (const double t : {0.3, 1.7, 4.9}) {
      const double scale = largest(law, p.start, t).x * (1 + law.stiffness) + law.drive_amplitude;
      EXPECT_NEAR(residual(law, p.start, t), 0, 1e-6 * scale) << name << " t = " << t;
    }
  }
}

TEST(Propagate, StartsAtTheStart) {
  const LinearLaw<double> law{0.3, 7, 2, 1.5, 0.4};
  const State<double> start{0.2, -0.7};
  EXPECT_EQ(propagate(law, 3.0, 3.0, start), start);
}

TEST(Propagate, FreeParticle) {
  const LinearLaw<double> law{0, 0, 0, 0, 0};
  const State<double> y = propagate(law, 1.0, 4.0, {2, 0.5});
  EXPECT_DOUBLE_EQ(y.x, 3.5);
  EXPECT_DOUBLE_EQ(y.v, 0.5);
}

TEST(Propagate, FreeFall) {
  const LinearLaw<double> law{0, 0, 9.8, 0, 0};
  const State<double> y = propagate(law, 0.0, 3.0, {0, 0});
  EXPECT_NEAR(y.x, 44.1, 44.1 * 1e-15);
  EXPECT_NEAR(y.v, 29.4, 29.4 * 1e-15);
}

TEST(Propagate, FallWithViscousResistance) {
  const double b = 0.35, f = 9.8;
  const LinearLaw<double> law{b, 0, f, 0, 0};
  for (const double t : {0.01, 0.5, 5.0, 50.0}) {
    const State<double> y = propagate(law, 0.0, t, {0, 0});
    const double v = f * -std::expm1(-2 * b * t) / (2 * b);
    EXPECT_NEAR(y.v, v, 1e-14 * v) << t;
    EXPECT_NEAR(y.x, (f * t - v) / (2 * b), 2e-15 * f * t / b) << t;
  }
}

TEST(Propagate, InvertedPendulumGrowsAsCosh) {
  const LinearLaw<double> law{0, -4, 0, 0, 0};
  for (const double t : {0.1, 0.5, 1.0, 20.0}) {
    const State<double> y = propagate(law, 0.0, t, {1, 0});
    EXPECT_NEAR(y.x / std::cosh(2 * t), 1, 1e-13) << t;
    EXPECT_NEAR(y.v / (2 * std::sinh(2 * t)), 1, 1e-13) << t;
  }
}

TEST(Propagate, ConstantForceMovesTheEquilibrium) {
  const LinearLaw<double> law{0.2, 9, 3, 0, 0};
  const LinearLaw<double> free{0.2, 9, 0, 0, 0};
  for (const double t : {0.02, 0.4, 3.0, 30.0}) {
    const State<double> y = propagate(law, 0.0, t, {0, 0});
    const State<double> shifted = propagate(free, 0.0, t, {-1.0 / 3, 0});
    EXPECT_NEAR(y.x, shifted.x + 1.0 / 3, 1e-15) << t;
    EXPECT_NEAR(y.v, shifted.v, 2e-15) << t;
  }
}

TEST(Propagate, UndampedResonanceGrowsLinearly) {
  const LinearLaw<double> law{0, 9, 1, 3, 0};
  for (const double t : {0.01, 0.3, 0.34, 2.0, 80.0}) {
    const State<double> y = propagate(law, 0.0, t, {0, 0});
    EXPECT_NEAR(y.x, t * std::sin(3 * t) / 6, 1e-15 * (1 + t * t)) << t;
  }
}

TEST(Propagate, NothingJumpsNearMeetingNodes) {
  // Detuning and damping through zero: 1e-9 more of either moves the motion by about t * 1e-9 of its size,
  // never by a lost digit.
  const State<double> start{0.3, -0.2};
  for (const double t : {0.5, 5.0, 50.0})
    for (double w = 3 - 4e-9; w < 3 + 4.5e-9; w += 1e-9) {
      const State<double> here = propagate(LinearLaw<double>{0, 9, 1, w, 0.3}, 0.0, t, start);
      const State<double> there = propagate(LinearLaw<double>{1e-9, 9, 1, 3, 0.3}, 0.0, t, start);
      EXPECT_NEAR(here.x, there.x, 2e-8 * (1 + t * t)) << w << ' ' << t;
    }
  // b = w0 and a hair beside it, by the analytic derivative with respect to b.
  for (const double t : {0.2, 1.0, 3.0})
    for (const double e : {-1e-7, -1e-9, 1e-9, 1e-7}) {
      const double here = propagate(LinearLaw<double>{3 + e, 9, 0, 0, 0}, 0.0, t, {1, 0}).x;
      const double at = propagate(LinearLaw<double>{3, 9, 0, 0, 0}, 0.0, t, {1, 0}).x;
      const auto D = Dual<double, 1>::variable(3, 0);
      const double slope =
          propagate<Dual<double, 1>>({D, 9.0, 0.0, 0.0, 0.0}, 0.0, t, {1.0, 0.0}).x.derivative[0];
      EXPECT_NEAR(here - at, slope * e, 1e-13 * std::abs(e) / 1e-9 * 1e-1 + 30 * e * e + 2e-16)
          << t << ' ' << e;
    }
}

TEST(Propagate, DerivativesAgreeWithDifferences) {
  using D = Dual<double, 5>;
  struct Point {
    double b, s, w;
  };
  // generic, critical, critical and driven, resonance, free particle, overdamped, inverted, long wave
  for (const Point p : {Point{0.2, 9, 2}, Point{3, 9, 0}, Point{3, 9, 2}, Point{0, 9, 3}, Point{0, 0, 0},
                        Point{5, 9, 2.5}, Point{0.1, -2, 1}, Point{0.3, 0, 0}})
    for (const double t : {0.05, 0.7, 6.0}) {
      const auto at = [&](std::array<double, 5> u) {
        return propagate(LinearLaw<double>{u[0], u[1], 1.3, u[2], 0.4}, 0.0, t, {u[3], u[4]});
      };
      const std::array<double, 5> u{p.b, p.s, p.w, 0.3, -0.6};
      std::array<D, 5> d;
      for (std::size_t i = 0; i < 5; ++i) d[i] = D::variable(u[i], i);
      const State<D> y = propagate<D>({d[0], d[1], 1.3, d[2], 0.4}, 0.0, t, {d[3], d[4]});
      EXPECT_EQ(value_of(y.x), at(u).x);
      for (std::size_t i = 0; i < 5; ++i) {
        std::array<double, 5> up = u, down = u;
        const double e = 1e-5;
        up[i] += e;
        down[i] -= e;
        const double scale =
            1 + std::abs(y.x.value) + std::abs(y.v.value) + std::abs(y.x.derivative[i]) + t * t * t * t;
        EXPECT_NEAR(y.x.derivative[i], (at(up).x - at(down).x) / (2 * e), 3e-9 * scale)
            << p.b << ' ' << p.s << ' ' << p.w << " t = " << t << " parameter " << i;
        EXPECT_NEAR(y.v.derivative[i], (at(up).v - at(down).v) / (2 * e), 3e-8 * scale)
            << p.b << ' ' << p.s << ' ' << p.w << " t = " << t << " parameter " << i;
      }
    }
}

double between(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6; }

TEST(Propagate, TwoFlightsAreOne) {
  EXPECT_TRUE(rc::check("propagate(0, t2) = propagate(t1, t2) after propagate(0, t1)", [] {
    const LinearLaw<double> law{between(0, 6), between(-1, 12), between(0, 2), between(0, 7), between(-3, 3)};
    const State<double> start{between(-1, 1), between(-1, 1)};
    const double t1 = between(0, 4), t2 = t1 + between(0, 4);
    const State<double> once = propagate(law, 0.0, t2, start);
    const State<double> twice = propagate(law, t1, t2, propagate(law, 0.0, t1, start));
    const double scale = 1 + std::abs(once.x) + std::abs(once.v);
    // An inverted oscillator magnifies the rounding of the first flight.
    const double magnified = law.stiffness < 0 ? std::exp(std::sqrt(-law.stiffness) * t2) : 1;
    RC_ASSERT(std::abs(once.x - twice.x) < 1e-13 * scale * magnified);
    RC_ASSERT(std::abs(once.v - twice.v) < 3e-13 * scale * magnified);
  }));
}

TEST(Propagate, BackwardUndoesForward) {
  EXPECT_TRUE(rc::check("there and back", [] {
    const LinearLaw<double> law{between(0, 1), between(0, 12), between(0, 2), between(0, 7), between(-3, 3)};
    const State<double> start{between(-1, 1), between(-1, 1)};
    const double t = between(0, 4);
    const State<double> back = propagate(law, t, 0.0, propagate(law, 0.0, t, start));
    const double magnified = std::exp(2 * law.decay_rate * t);
    RC_ASSERT(std::abs(back.x - start.x) < 1e-13 * magnified);
    RC_ASSERT(std::abs(back.v - start.v) < 3e-13 * magnified);
  }));
}

TEST(Propagate, EnergyIsConservedWithoutDampingAndDrive) {
  EXPECT_TRUE(rc::check("v^2 + s x^2", [] {
    const LinearLaw<double> law{0, between(0.01, 100), 0, 0, 0};
    const State<double> start{between(-1, 1), between(-1, 1)};
    const State<double> y = propagate(law, 0.0, between(0, 100), start);
    const auto energy = [&](const State<double>& u) { return u.v * u.v + law.stiffness * u.x * u.x; };
    RC_ASSERT(std::abs(energy(y) - energy(start)) <= 1e-13 * energy(start));
  }));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
