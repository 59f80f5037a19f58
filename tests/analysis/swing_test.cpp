#include "cromer/analysis/swing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cromer/analysis/phase.h"
#include "cromer/base/pi.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/root.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

/// x'' = -k x - k2 x^2 - k3 x^3 - w0^2 sin x, in small steps.
struct Springs {
  double k = 0, k2 = 0, k3 = 0, pendulum = 0;
  double acceleration(double, double x, double) const {
    return -k * x - k2 * x * x - k3 * x * x * x - pendulum * std::sin(x);
  }
};

/// From rest at x until it is at rest again on the other side: half a period, and where that is.
State<double> half_period_and_place(const Springs& springs, double x, double h) {
  const Rk4 method;
  auto memory = method.start(springs, 0.0, State<double>{x, 0});
  State<double> y{x, 0};
  for (double t = 0;; t += h) {
    const State<double> next = method.step(springs, t, h, y, memory).y;
    if (t > 0 && (next.v >= 0) != (x < 0)) {
      // The end of a step that is shorter: by Newton on the velocity.
      double part = h * y.v / (y.v - next.v);
      for (int i = 0; i < 6; ++i) {
        const State<double> there = method.step(springs, t, part, y, memory).y;
        part -= there.v / springs.acceleration(0, there.x, 0);
      }
      return {method.step(springs, t, part, y, memory).y.x, t + part};
    }
    y = next;
  }
}

TEST(Swing, OfALinearSpringHasItsFrequencyAtEveryAmplitude) {
  const Swing<double> swing{{.stiffness = 9}};
  for (const double A : {1e-6, 1.0, 1e6}) EXPECT_NEAR(swing.angular_frequency(A), 3, 1e-14);
  EXPECT_NEAR(swing.amplitude(0.3, 1.2), 0.5, 1e-15);
}

TEST(Swing, OfAPendulumIsTheEllipticIntegral) {
  const Swing<double> swing{{.stiffness = 0, .pendulum = 4}};
  for (const double A : {1e-3, 0.5, 1.5, 2.5, 3.0})
    EXPECT_NEAR(swing.angular_frequency(A) * std::comp_ellint_1(std::sin(A / 2)) / pi, 1, 1e-12) << A;
}

TEST(Swing, OfACubicSpringIsTheEllipticIntegral) {
  // Duffing's: w^2 = w0^2 + k3 A^2, modulus^2 = k3 A^2/(2 w^2).
  for (const double cubic : {0.3, 5.0, 200.0}) {
    const double A = 0.8, square = 4 + cubic * A * A;
    const double exact =
        pi / 2 * std::sqrt(square) / std::comp_ellint_1(std::sqrt(cubic * A * A / (2 * square)));
    EXPECT_NEAR((Swing<double>{{.stiffness = 4, .cubic = cubic}}.angular_frequency(A)) / exact, 1, 1e-12);
  }
  // First order: w0 (1 + 3 k3 A^2/(8 w0^2)).
  EXPECT_NEAR((Swing<double>{{.stiffness = 4, .cubic = -1e-3}}.angular_frequency(0.5)),
              2 * (1 - 3 * 1e-3 * 0.25 / 32), 1e-9);
}

TEST(Swing, IsWhatAnIntegrationOfItsMotionGives) {
  const auto agrees = [](const Swing<double>& swing, double x) {
    const Oscillator<double>& o = swing.per_mass;
    const Springs springs{.k = o.stiffness, .k2 = o.quadratic, .k3 = o.cubic, .pendulum = o.pendulum};
    const State<double> half = half_period_and_place(springs, x, 1e-4);
    const double to_each_side = std::abs(x - half.x) / 2;
    EXPECT_NEAR(swing.angular_frequency(to_each_side), pi / half.v, 1e-9) << x;
  };
  agrees({{.stiffness = 4, .cubic = -1.5}}, 1.2);
  agrees({{.stiffness = 4, .cubic = 1, .quadratic = 1.5}}, 0.9);
  agrees({{.stiffness = 4, .quadratic = -1.5}}, 0.7);
  agrees({{.stiffness = 0, .cubic = 0.7, .pendulum = 4}}, 1.4);
}

TEST(Swing, GoesAsFarAsItsEnergyReaches) {
  for (const Swing<double>& swing :
       {Swing<double>{{.stiffness = 4, .cubic = -1}}, Swing<double>{{.stiffness = 4, .cubic = 30}},
        Swing<double>{{.stiffness = 0, .pendulum = 4}},
        Swing<double>{{.stiffness = 0, .cubic = 2, .pendulum = 4}}}) {
    const double x = 0.4, v = 1.1, A = swing.amplitude(x, v);
    const auto potential = [&](double at) {
      const Oscillator<double>& o = swing.per_mass;
      return o.pendulum * (1 - std::cos(at)) + 0.5 * o.stiffness * at * at + 0.25 * o.cubic * std::pow(at, 4);
    };
    EXPECT_NEAR(potential(A), potential(x) + 0.5 * v * v, 1e-13);
  }
  EXPECT_EQ((Swing<double>{{.stiffness = 0, .pendulum = 4}}.amplitude(0, 5)), pi);
}

TEST(Swing, HasNoFrequencyWhereItDoesNotComeBack) {
  EXPECT_TRUE(std::isnan(Swing<double>{{.stiffness = 4, .cubic = -1}}.angular_frequency(2.2)));
}

TEST(Swing, KnowsItsDerivatives) {
  using D = Dual<double, 3>;
  const Swing<D> swing{{.stiffness = D::variable(4, 0), .cubic = D::variable(-0.5, 1)}};
  const D w = swing.angular_frequency(D::variable(1, 2));
  const auto value = [](double k, double cubic, double a) {
    return Swing<double>{{.stiffness = k, .cubic = cubic}}.angular_frequency(a);
  };
  const double e = 1e-5;
  EXPECT_NEAR(w.derivative[0], (value(4 + e, -0.5, 1) - value(4 - e, -0.5, 1)) / (2 * e), 1e-9);
  EXPECT_NEAR(w.derivative[1], (value(4, -0.5 + e, 1) - value(4, -0.5 - e, 1)) / (2 * e), 1e-9);
  EXPECT_NEAR(w.derivative[2], (value(4, -0.5, 1 + e) - value(4, -0.5, 1 - e)) / (2 * e), 1e-9);
}

TEST(Swing, ASpringThatGivesWayBeforeCountsAsLinear) {
  // x'' = -4 x + x^3 holds up to 2, with 4 J/kg.
  const Swing<double> swing{{.stiffness = 4, .cubic = -1}};
  EXPECT_NEAR(swing.amplitude(0, 3), 1.5, 1e-14);
  EXPECT_NEAR(swing.amplitude(0, std::sqrt(2 * 3.75)), std::sqrt(4 - 2 * std::sqrt(0.25)), 1e-13);
  EXPECT_EQ(swing.amplitude(0, 0), 0);
}

TEST(Swing, GoesHalfTheWayBetweenItsTurningPoints) {
  // x^2/2 - 3 x^3/14 is the same at 1 and at -2/3: (r + l)/2 = 9/14 (r^2 + r l + l^2)/3.
  const Swing<double> swing{{.stiffness = 1, .quadratic = -9.0 / 14}};
  EXPECT_NEAR(swing.amplitude(1, 0), 5.0 / 6, 1e-14);
  EXPECT_NEAR(swing.amplitude(-2.0 / 3, 0), 5.0 / 6, 1e-14);
  EXPECT_NEAR(swing.middle(swing.amplitude(1, 0)), 1.0 / 6, 1e-14);
  // With only 2 % of its energy left to the top on the right, it still has a frequency.
  const Swing<double> near_top{{.stiffness = 20.861, .cubic = 30.35, .quadratic = -3.433, .quintic = -63.83}};
  EXPECT_GT(near_top.angular_frequency(near_top.amplitude(0.82097, 0.6599)), 0.5 * std::sqrt(20.861));
}

TEST(Swing, ASpringThatGivesWayOnTheLeftIsSeenOnTheRight) {
  // 2 x^2 + k2 x^3/3 = 1/2 v^2: with k2 = 3 at x = 1 there are 3 J/kg.
  const Swing<double> swing{{.stiffness = 4, .quadratic = 3}};
  EXPECT_NEAR(swing.amplitude(0, std::sqrt(6)), 1, 1e-14);
  EXPECT_NEAR(swing.amplitude(1, 0), 1, 1e-14);
  EXPECT_NEAR(swing.potential(2), 16, 1e-14);
  EXPECT_NEAR(swing.pull(2), 20, 1e-14);
  EXPECT_NEAR(swing.pull(-1), -1, 1e-14);
}

TEST(Swing, APendulumStopsAtTheTop) {
  const Swing<double> swing{{.stiffness = 0, .pendulum = 4}};
  EXPECT_EQ(swing.amplitude(0, 4), pi) << "just its energy";
  EXPECT_EQ(swing.amplitude(3, 3), pi);
  EXPECT_NEAR(swing.amplitude(0, 4 * std::sin(1.5)), 3, 1e-12);
  EXPECT_NEAR(swing.amplitude(0, 4 * std::sin(0.05)), 0.1, 1e-15);
}

TEST(Swing, StiffnessIsThatOfSmallSwings) {
  EXPECT_EQ((Swing<double>{{.stiffness = 3, .cubic = 5, .pendulum = 4}}.stiffness()), 7);
}

TEST(GaussRule, IsExactUpToDegreeFifteen) {
  for (int degree = 0; degree <= 15; ++degree) {
    const double mean = mean_over(1.0, 3.0, [&](double x) { return std::pow(x, degree); });
    const double exact = (std::pow(3, degree + 1) - 1) / (2 * (degree + 1));
    EXPECT_NEAR(mean / exact, 1, 1e-14) << degree;
  }
  EXPECT_GT(std::abs(mean_over(-1.0, 1.0, [](double x) { return std::pow(x, 16); }) - 1.0 / 17), 1e-6);
}

// The averages of Bogoliubov and Mitropolsky as they are printed.
TEST(CycleAverage, FallsAreThePrintedOnes) {
  for (const double A : {0.3, 2.0})
    for (const double w : {0.7, 5.0}) {
      EXPECT_NEAR((cycle_average<Viscous>(A, w).fall) / (A / 2), 1, 1e-13);
      EXPECT_NEAR((cycle_average<Drag>(A, w).fall) / (4 * w * A * A / (3 * pi)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<Friction>(A, w).fall) / (2 / (pi * w)), 1, 1e-12);
      EXPECT_NEAR((cycle_average<VanDerPol>(A, w).fall) / (A * A * A / 8), 1, 1e-10);
      EXPECT_EQ((cycle_average<Viscous>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<Drag>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<Friction>(A, w).shift), 0);
      EXPECT_EQ((cycle_average<VanDerPol>(A, w).shift), 0);
    }
}

TEST(CycleAverage, ShiftsAreThePrintedOnes) {
  for (const double A : {0.3, 2.0})
    for (const double w : {0.7, 5.0}) {
      EXPECT_NEAR((cycle_average<Cubic>(A, w).shift) / (3 * A * A / (8 * w)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<OddQuadratic>(A, w).shift) / (4 * A / (3 * pi * w)), 1, 1e-10);
      EXPECT_NEAR((cycle_average<Quintic>(A, w).shift) / (5 * std::pow(A, 4) / (16 * w)), 1, 1e-10);
      // sin(A cos theta) has the first harmonic 2 J1(A).
      EXPECT_NEAR((cycle_average<Pendulum>(A, w).shift) / (std::cyl_bessel_j(1, A) / (A * w)), 1, 2e-9);
      EXPECT_EQ((cycle_average<Quadratic>(A, w).shift), 0) << "of second order";
      EXPECT_EQ((cycle_average<Cubic>(A, w).fall), 0);
      EXPECT_EQ((cycle_average<Quadratic>(A, w).fall), 0);
      EXPECT_EQ((cycle_average<Pendulum>(A, w).fall), 0);
    }
}

TEST(AmplitudeDecay, IsTheSumOfWhatEachTermTakes) {
  const double w = 3, A = 0.7;
  const AmplitudeDecay law{
      .angular_frequency = w,
      .per_mass = {.stiffness = 9, .damping = 0.04, .drag = 0.02, .friction = 0.05, .van_der_pol = 0.03}};
  const double s = 2 * 0.05 / (pi * w), q = 4 * 0.02 * w / (3 * pi);
  EXPECT_NEAR(law.rate(A) * A, s + 0.02 * A + q * A * A + 0.03 * A * A * A / 8, 1e-12);
  EXPECT_NEAR((AmplitudeDecay{.per_mass = {.friction = 1}}.rate(1)), 2 / pi, 1e-12)
      << "1 rad/s if nobody says";
  EXPECT_EQ((AmplitudeDecay{.angular_frequency = w, .per_mass = {.stiffness = 9, .cubic = 4}}.rate(A)), 0);
}

/// ln of the ratio of the turning points a period apart, over the period: the amplitude falls by its mean
/// rate.
double simulated_rate(const Oscillator<double>& law, double A, double periods) {
  const double period = 2 * std::numbers::pi;
  KeepEvery keep(1, count_steps({0, periods * period}, period / 1000));
  with_terms(law, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, Rk4{}, Interval{0, periods * period}, State<double>{A, 0}, period / 1000, keep);
  });
  const Trajectory motion = keep.take();
  const double last = std::hypot(motion.x.back(), motion.v.back());
  return std::log(A / last) / (motion.t.back());
}

TEST(AmplitudeDecay, IsTheMeanOverACycleOfEveryTerm) {
  const double A = 0.5;
  const AmplitudeDecay viscous{.angular_frequency = 1, .per_mass = {.damping = 0.002}};
  EXPECT_NEAR(simulated_rate({.mass = 1, .stiffness = 1, .damping = 0.002}, A, 1) / viscous.rate(A), 1, 2e-3);
  const AmplitudeDecay drag{.angular_frequency = 1, .per_mass = {.drag = 0.001}};
  EXPECT_NEAR(simulated_rate({.mass = 1, .stiffness = 1, .drag = 0.001}, A, 1) / drag.rate(A), 1, 3e-3);
  EXPECT_NEAR(drag.rate(2 * A) / drag.rate(A), 2, 1e-14);
}

/// By the turning points of a swing from x = A, in steps of 1e-4 s: the amplitude in the middle of the period
/// after the first of them, and the rate at which it falls there.
struct OfTurningPoints {
  double amplitude, rate;
};
OfTurningPoints of_turning_points(const Oscillator<double>& law, double A) {
  KeepEvery keep(1, count_steps({0, 40}, 1e-4));
  with_terms(law, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, Rk4{}, Interval{0, 40}, State<double>{A, 0}, 1e-4, keep);
  });
  const Trajectory motion = keep.take();
  std::vector<double> x, t;
  for (std::size_t i = 1; i + 1 < motion.t.size() && x.size() < 4; ++i)
    if (motion.v[i] * motion.v[i + 1] < 0) x.push_back(motion.x[i]), t.push_back(motion.t[i]);
  const double before = 0.5 * std::abs(x[1] - x[0]), after = 0.5 * std::abs(x[3] - x[2]);
  return {std::sqrt(before * after), std::log(before / after) / (t[2] - t[0])};
}

TEST(AmplitudeDecay, OfABentSpringIsThatOfItsTurningPoints) {
  const Oscillator<double> spring{.mass = 1, .stiffness = 9, .damping = 0.004};
  const auto with = [&](double Oscillator<double>::*term, double value) {
    Oscillator<double> law = spring;
    law.*term = value;
    return law;
  };
  const Oscillator<double> pendulum{.mass = 1, .stiffness = 0, .damping = 0.004, .pendulum = 9};
  Oscillator<double> damped_by_all = with(&Oscillator<double>::cubic, 18);
  damped_by_all.drag = 0.003;
  damped_by_all.friction = 0.004;
  for (const Oscillator<double>& law :
       {pendulum, with(&Oscillator<double>::cubic, 18), with(&Oscillator<double>::quintic, 9),
        with(&Oscillator<double>::odd_quadratic, 9), with(&Oscillator<double>::quadratic, 4),
        damped_by_all}) {
    const OfTurningPoints seen = of_turning_points(law, law.pendulum > 0 ? 2.07 : 1);
    EXPECT_NEAR(AmplitudeDecay{.per_mass = law}.rate(seen.amplitude), seen.rate, 2e-3 * seen.rate);
  }
  EXPECT_NEAR(AmplitudeDecay{.per_mass = pendulum}.rate(2.07), 1.36 * 0.002, 0.01 * 0.002);
  EXPECT_NEAR(AmplitudeDecay{.per_mass = pendulum}.rate(1e-3), 0.002, 1e-8);
}

TEST(AmplitudeDecay, FrictionTakesTheSameAmplitudeEveryCycle) {
  // Exactly 4 f/(m w^2) a cycle.
  const AmplitudeDecay friction{.angular_frequency = 2, .per_mass = {.friction = 0.003}};
  const double period = std::numbers::pi, a_cycle = 4 * 0.003 / 4;
  EXPECT_NEAR(friction.rate(0.1) * 0.1 * period, a_cycle, 1e-15);
  EXPECT_NEAR(friction.rate(0.2) * 0.2 * period, a_cycle, 1e-15);
}

// Of van der Pol's equation x'' - mu (1 - x²) x' + x = 0 the largest displacement is hardly more than 2:
// 2.00862 at mu = 1, from a run of our own in steps of 1e-4.
constexpr double period = 2 * std::numbers::pi;

Oscillator<double> van_der_pol(double mu) {
  return {.mass = 1, .stiffness = 1, .damping = -mu, .van_der_pol = mu};
}

TEST(LimitCycle, IsTwoWhereTheDampingIsSmall) {
  for (const double near : {1.0, 1.9, 4.0}) {
    const auto amplitude = limit_cycle_amplitude(van_der_pol(1e-3), near, period);
    ASSERT_TRUE(amplitude);
    EXPECT_NEAR(*amplitude, 2, 1e-6);
  }
}

TEST(LimitCycle, IsALittleMoreWhereItIsLarge) {
  const auto amplitude = limit_cycle_amplitude(van_der_pol(1), 2, period);
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(*amplitude, 2.00862, 1e-5);
}

TEST(LimitCycle, NoneWithoutABound) {
  EXPECT_FALSE(limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = -0.1}, 1, period));
  EXPECT_FALSE(limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = 0.1}, 1, period));
}

TEST(LimitCycle, MayBeHeldUpByFriction) {
  // x'' - 2 b x' + x + f sgn x' = 0: A - f grows by exp(pi b/wd) in half a cycle, and f is lost again.
  const double b = 0.05, f = 0.1, growth = std::exp(std::numbers::pi * b / std::sqrt(1 - b * b));
  const auto amplitude =
      limit_cycle_amplitude({.mass = 1, .stiffness = 1, .damping = -2 * b, .friction = f}, 1.2, period);
  ASSERT_TRUE(amplitude);
  EXPECT_NEAR(*amplitude, f * (growth + 1) / (growth - 1), 1e-3);
}

TEST(LimitCycle, IsLookedForWithinTenPeriods) {
  const auto found = [](double periods) {
    return limit_cycle_amplitude(van_der_pol(1e-3), 1.9, period / periods);
  };
  ASSERT_TRUE(found(9.9));
  EXPECT_NEAR(*found(9.9), 2, 1e-6);
  EXPECT_FALSE(found(10.1));
}

TEST(LimitCycle, IsOfTheSideThatItBeginsOn) {
  // The quadratic spring is weaker there: the turn is further out than the other one.
  const Oscillator<double> law{
      .mass = 1, .stiffness = 1, .damping = -0.01, .quadratic = -0.2, .van_der_pol = 0.01};
  const auto right = limit_cycle_amplitude(law, 2.2, period);
  Oscillator<double> mirrored = law;
  mirrored.quadratic = 0.2;
  const auto left = limit_cycle_amplitude(mirrored, 1.8, period);
  ASSERT_TRUE(right && left);
  // To second order of k2 A the middle is at -k2 A^2/3 for turning points, A = 2.
  EXPECT_NEAR(*right - *left, 2 * 0.2 * 4 / 3, 0.15);
  EXPECT_GT(*right, 2);
}

TEST(Phase, EndsWhereTheMotionStandsStillForGood) {
  const std::vector<double> x{1, 0, -1, 0, 0.2, 0.2, 0.2}, v{0, -1, 0, 1, 0, 0, 0};
  const std::vector<double> phase = followed_phase(x, v, 1);
  ASSERT_EQ(phase.size(), x.size());
  EXPECT_NEAR(phase[3], 1.5 * two_pi / 2, 1e-12);
  EXPECT_TRUE(std::isfinite(phase[4]));
  EXPECT_TRUE(std::isnan(phase[5]) && std::isnan(phase[6]));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
