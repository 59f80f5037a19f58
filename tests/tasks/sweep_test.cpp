// Sweeps: closed forms against theory and stepping, settling, hysteresis, ends, and what is refused.
#include "cromer/tasks/sweep/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstring>

#include "cromer/analysis/frequency_response.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/sweep/sweep_rows.h"
#include "sweep_options.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Sweep, ExactIsTheResonanceCurve) {
  const SweepResult result = swept(options_with(driven, "exact"));
  EXPECT_THAT(result.plan.rows.columns,
              ElementsAre("drive_frequency (rad/s)", "amplitude (m)", "phase (rad)", "status"));
  ASSERT_EQ(result.rows.size(), 57u * 3);
  for (std::size_t i = 0; i < 57; ++i) {
    const double* row = &result.rows[3 * i];
    EXPECT_NEAR(row[0], 0.2 + static_cast<double>(i) * 0.05, 1e-15);
    const SteadyState theory = frequency_response({.stiffness = 1, .damping = 0.1}, 0.5, row[0]);
    EXPECT_NEAR(row[1], theory.amplitude, 1e-14 * theory.amplitude);
    EXPECT_NEAR(row[2], theory.phase_lag, 1e-14);
  }
}

TEST(Sweep, EulerCromerSettlesWhereItsOwnMapSays) {
  // docs/theory.md: 1/(w^2 - (4/h^2) sin^2(W h/2) + (2 b/h)(1 - 1/z)) for each unit of F/m.
  const double h = 0.1, b = 0.05;
  const SweepResult result = swept(options_with(with(driven, {{"step", "0.1"}}), "euler-cromer"));
  for (std::size_t i = 0; i < 57; ++i) {
    const double* row = &result.rows[3 * i];
    const std::complex<double> z = std::polar(1.0, row[0] * h);
    const double s = std::sin(row[0] * h / 2);
    const std::complex<double> theory = 0.5 / (1 - 4 / (h * h) * s * s + 2 * b / h * (1.0 - 1.0 / z));
    EXPECT_NEAR(row[1], std::abs(theory), 1e-11 * std::abs(theory));
  }
}

TEST(Sweep, ClosedFormAndSteppingAgreeForEveryMethod) {
  for (const MethodInfo& info : method_infos) {
    if (!info.takes_fixed_steps() || info.name == "forward-euler") continue;
    SweepOptions options = options_with(driven, std::string(info.name));
    options.check = true;
    const SweepResult result = swept(options);
    EXPECT_EQ(in_words(result.plan.way), "closed form");
    ASSERT_TRUE(result.check) << info.name;
    EXPECT_EQ(result.check->points, 8u) << info.name;
    EXPECT_LT(result.check->difference, 2e-6) << info.name;
  }
}

TEST(Sweep, SaysWhereNothingSettles) {
  const SweepResult undamped =
      swept(options_with({{"drive-amplitude", "1"}, {"drive-frequency", "0.5,2"}}, "euler-cromer"));
  EXPECT_EQ(undamped.counts.not_settled, 2u);
  EXPECT_TRUE(std::isnan(undamped.rows[1]));
  EXPECT_TRUE(undamped.counts.ok());
  const SweepResult away =
      swept(options_with({{"cubic", "-1"}, {"position", "0.5,1.5"}, {"damping", "0.1"}}));
  EXPECT_EQ(away.counts.not_finite, 1u);
  EXPECT_FALSE(away.counts.ok());
  EXPECT_FALSE(std::isnan(away.rows[1]));
  EXPECT_TRUE(std::isnan(away.rows[width(away) + 1]));
}

TEST(Sweep, RunsToAnEndAsSimulateDoes) {
  // Ends and steps that differ from point to point, the last step a shorter one.
  SweepOptions options = options_with({{"damping", "0.2"},
                                       {"cubic", "0.5"},
                                       {"stiffness", "1,2.3,4.7"},
                                       {"position", "0.3,1"},
                                       {"step", "0.01"},
                                       {"until", "3.333,20"}},
                                      "rk4");
  const SweepResult result = swept(options);
  EXPECT_EQ(in_words(result.plan.way), "stepped to the end");
  EXPECT_THAT(result.plan.rows.columns, ElementsAre("stiffness (N/m)", "position (m)", "until (s)",
                                                    "peak (m)", "x (m)", "v (m/s)", "energy (J)", "status"));
  for (std::size_t at = 0; at < result.rows.size(); at += 7) {
    const double* row = &result.rows[at];
    SimulateOptions one{.stiffness = row[0], .damping = 0.2, .law = {.cubic = 0.5}, .position = row[1]};
    one.method = {"rk4"};
    one.step = 0.01;
    one.until = row[2];
    const auto run = simulate(one);
    ASSERT_TRUE(run);
    EXPECT_NEAR(row[4], run->runs[0].outcome.y.x, 1e-13);
    EXPECT_NEAR(row[5], run->runs[0].outcome.y.v, 1e-13);
    double peak = 0;
    for (const double x : run->runs[0].trajectory.x) peak = std::max(peak, std::abs(x));
    EXPECT_NEAR(row[3], peak, 1e-13);
  }
}

TEST(Sweep, MeasuresTheSettledMotionOfANonlinearLaw) {
  // Against one long run each, measured over its last cycles.
  SweepOptions options =
      options_with(with(driven, {{"cubic", "0.3"}, {"drive-frequency", "0.7,1.6,2.5"}}), "rk4");
  options.measure = {"amplitude,phase,peak,energy"};
  const SweepResult result = swept(options);
  EXPECT_EQ(in_words(result.plan.way), "stepped until settled");
  for (std::size_t at = 0; at < result.rows.size(); at += 5) {
    const double* row = &result.rows[at];
    const double period = 2 * std::numbers::pi / row[0];
    SimulateOptions one{.damping = 0.1, .law = {.cubic = 0.3}, .drive_amplitude = 0.5};
    one.drive_frequency = {row[0]};
    one.method = {"rk4"};
    one.step = std::min(period, 2 * std::numbers::pi) / 200;
    one.until = 100 * period;
    const auto run = simulate(one);
    ASSERT_TRUE(run);
    // Fourier's integral over the last ten cycles, by the trapezoidal rule.
    const Trajectory& y = run->runs[0].trajectory;
    std::complex<double> sum = 0;
    double peak = 0, weight = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (y.t[i] <= 90 * period + 1e-9) continue;
      sum += y.x[i] * std::polar(1.0, row[0] * y.t[i]);
      peak = std::max(peak, std::abs(y.x[i]));
      ++weight;
    }
    const std::complex<double> sinusoid = 2.0 * sum / weight;
    EXPECT_NEAR(row[1], std::abs(sinusoid), 2e-3 * row[1]);
    EXPECT_NEAR(row[2], std::arg(sinusoid), 2e-3);
    EXPECT_NEAR(row[3], peak, 1e-3 * peak);
  }
}

TEST(Sweep, AveragesOverWholeCycles) {
  // In one of two wells, x = +-1: one long run, averaged over its last ten cycles, is the truth.
  SweepOptions options = options_with({{"stiffness", "-1"},
                                       {"cubic", "1"},
                                       {"damping", "0.2"},
                                       {"drive-amplitude", "0.1"},
                                       {"drive-frequency", "0.8,1.7"},
                                       {"position", "1"},
                                       {"step", "0.01"}},
                                      "rk4");
  options.measure = {"mean,rms,energy"};
  const SweepResult result = swept(options);
  EXPECT_THAT(result.plan.measured, ElementsAre("mean (m)", "rms (m)", "energy (J)"));
  for (std::size_t at = 0; at < result.rows.size(); at += 4) {
    const double* row = &result.rows[at];
    const double period = 2 * std::numbers::pi / row[0];
    SimulateOptions one{.stiffness = -1, .damping = 0.2, .law = {.cubic = 1}};
    one.position = 1;
    one.drive_amplitude = 0.1;
    one.drive_frequency = {row[0]};
    one.method = {"rk4"};
    one.step = period / 500;
    one.until = 100 * period;
    const auto run = simulate(one);
    ASSERT_TRUE(run);
    const Trajectory& y = run->runs[0].trajectory;
    double x = 0, square = 0, energy = 0, count = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (y.t[i] <= 90 * period + 1e-9) continue;
      const double s = y.x[i] * y.x[i];
      x += y.x[i], square += s, energy += (y.v[i] * y.v[i] - s + s * s / 2) / 2, ++count;
    }
    EXPECT_GT(std::abs(row[1]), 0.9);
    EXPECT_NEAR(row[1], x / count, 1e-6);
    EXPECT_NEAR(row[2], std::sqrt(square / count), 1e-6);
    EXPECT_NEAR(row[3], energy / count, 1e-6);
  }
  // In closed form, and stepped.
  SweepOptions linear = options_with(with(driven, {{"drive-frequency", "0.7,1.3"}}), "rk4");
  linear.measure = {"mean,rms,amplitude"};
  const SweepResult known = swept(linear);
  EXPECT_EQ(in_words(known.plan.way), "closed form");
  linear.settle = 100;
  const SweepResult stepped = swept(linear);
  for (const std::size_t at : {0u, 4u}) {
    EXPECT_EQ(known.rows[at + 1], 0);
    EXPECT_NEAR(known.rows[at + 2], known.rows[at + 3] / std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(stepped.rows[at + 1], 0, 1e-6);
    EXPECT_NEAR(stepped.rows[at + 2], known.rows[at + 2], 1e-6);
  }
}

/// Where a Duffing oscillator jumps by harmonic balance (docs/theory.md), m = k = 1: going up, and down.
struct Jumps {
  double up, down;  // [rad/s]
};
Jumps jumps_by_theory(double c, double cubic, double force) {
  const auto frequency = [&](double a) {
    const double s = 1 + 0.75 * cubic * a * a;
    return std::sqrt(s - c * c / 2 + std::sqrt(force * force / (a * a) - c * c * s + c * c * c * c / 4));
  };
  double top = force / c;  // the largest amplitude that has a frequency
  for (int i = 0; i < 200; ++i) top = force / (c * std::sqrt(1 + 0.75 * cubic * top * top - c * c / 4));
  Jumps jumps{};
  double a = top * (1 - 1e-9);
  const double less = 1 - 1e-5;
  while (frequency(a * less) > frequency(a)) a *= less;
  jumps.up = frequency(a);
  while (frequency(a * less) < frequency(a)) a *= less;
  jumps.down = frequency(a);
  return jumps;
}

TEST(Sweep, DuffingJumpsWhereHarmonicBalancePutsIt) {
  const double c = 0.02, cubic = 0.05, force = 0.05;
  const Jumps theory = jumps_by_theory(c, cubic, force);
  const std::size_t points = cases(1000u);
  const Values law{{"damping", "0.02"},
                   {"cubic", "0.05"},
                   {"drive-amplitude", "0.05"},
                   {"drive-frequency", "1:1.2:" + std::to_string(points)}};
  for (const bool up : cases({true, false})) {
    SweepOptions options = options_with(law, "rk4");
    options.direction = up ? "up" : "down";
    const SweepResult result = swept(options);
    EXPECT_EQ(result.counts.not_settled, 0u);
    double jump = 0, largest = 0;
    for (std::size_t i = 1; i < points; ++i) {
      const double change = std::abs(result.rows[3 * i + 1] - result.rows[3 * (i - 1) + 1]);
      if (change > largest) largest = change, jump = (result.rows[3 * i] + result.rows[3 * (i - 1)]) / 2;
    }
    EXPECT_GT(largest, 0.2);
    EXPECT_NEAR(jump, up ? theory.up : theory.down, 2e-3) << (up ? "up" : "down");
  }
  EXPECT_GT(theory.up, theory.down + 0.02);  // there is hysteresis to be seen
}

TEST(Sweep, BothDirectionsAreThatUpAndThenThatDown) {
  const Values law{{"damping", "0.1,0.12"},
                   {"cubic", "0.3"},
                   {"drive-amplitude", "0.3"},
                   {"drive-frequency", "0.8:2:60"},
                   {"step", "0.05"}};
  SweepOptions options = options_with(law, "rk4");
  options.direction = "both";
  const SweepResult both = swept(options);
  EXPECT_THAT(both.plan.rows.columns, ElementsAre("direction", "damping (kg/s)", "drive_frequency (rad/s)",
                                                  "amplitude (m)", "phase (rad)", "status"));
  ASSERT_EQ(both.plan.rows.rows, 240u);
  bool differ = false;
  for (const bool up : {true, false}) {
    options.direction = up ? "up" : "down";
    const SweepResult one = swept(options);
    for (std::size_t i = 0; i < 120; ++i) {
      const double *row = &both.rows[(i + (up ? 0 : 120)) * 5], *alone = &one.rows[i * 4];
      EXPECT_EQ(row[0], up ? 1 : -1);
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(row[k + 1], alone[k], 1e-5) << i;
      differ = differ || std::abs(row[3] - both.rows[(i + (up ? 120 : 0)) * 5 + 3]) > 0.2;
    }
  }
  EXPECT_TRUE(differ);  // there is hysteresis
}

TEST(Sweep, BasinsOfASymmetricWellAreSymmetric) {
  SweepOptions options = options_with({{"stiffness", "-1"},
                                       {"cubic", "1"},
                                       {"damping", "0.1"},
                                       {"position", "-1.5:1.5:21"},
                                       {"velocity", "-1:1:11"},
                                       {"until", "150"}},
                                      "euler-cromer");
  options.measure = {"final"};
  const SweepResult result = swept(options);
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 21 * 11; ++i) {
    const double x = result.rows[4 * i + 2], mirrored = result.rows[4 * (21 * 11 - 1 - i) + 2];
    EXPECT_NEAR(x, -mirrored, 1e-9);
    left += x<-0.9, right += x> 0.9;
  }
  EXPECT_EQ(left, right);
  EXPECT_GE(left + right, 21 * 11 - 1);  // all but the one at rest on the ridge
}

TEST(Sweep, RubbingMassesAreRunOneByOne) {
  SweepOptions options =
      options_with({{"friction", "0.05,0.2"}, {"position", "1"}, {"until", "12"}, {"step", "0.01"}}, "rk4");
  const SweepResult result = swept(options);
  EXPECT_EQ(in_words(result.plan.way), "run one by one");
  // Exact: each half swing takes 2 f/k off the amplitude; after 12 s three and a bit.
  for (const std::size_t i : {0u, 1u}) {
    const double f = i ? 0.2 : 0.05;
    EXPECT_NEAR(result.rows[i * 5 + 1], 1, 1e-12);
    SimulateOptions one{.law = {.friction = f}, .position = 1};
    one.method = {"exact"};
    one.step = 0.01;
    one.until = 12;
    EXPECT_NEAR(result.rows[i * 5 + 2], simulate(one)->runs[0].outcome.y.x, 1e-8);
  }
}

TEST(Sweep, TheSameBitsOnAnyNumberOfThreads) {
  for (const Values& more : {Values{}, Values{{"cubic", "0.2"}}}) {
    SweepOptions options = options_with(with(driven, more));
    options.values["damping"] = "0.05:0.4:11";
    options.values["tolerance"] = "1e-12,1e-9";
    options.threads = 1;
    const SweepResult one = swept(options);
    for (const int threads : {2, 3, 7}) {
      options.threads = threads;
      const SweepResult other = swept(options);
      ASSERT_EQ(one.rows.size(), other.rows.size());
      EXPECT_EQ(std::memcmp(one.rows.data(), other.rows.data(), one.rows.size() * sizeof(double)), 0);
    }
  }
}

TEST(Sweep, APointDoesNotDependOnWhatElseIsInTheGrid) {
  const Values law{{"damping", "0.1"}, {"drive-amplitude", "1"}, {"cubic", "0.1"}};
  const SweepResult many = swept(options_with(with(law, {{"drive-frequency", "0.5:2:16"}}), "rk4"));
  EXPECT_EQ(many.counts.not_settled, 0u);
  for (std::size_t i = 0; i < 16; ++i) {
    const std::string w = std::to_string(many.rows[3 * i]);
    const SweepResult alone = swept(options_with(with(law, {{"drive-frequency", w + "," + w}}), "rk4"));
    EXPECT_NEAR(alone.rows[1] / many.rows[3 * i + 1], 1, 3e-6) << w;
  }
}

TEST(Sweep, RefusesWhatCannotBe) {
  EXPECT_THAT(refusal(options_with({})),
              HasSubstr("nothing is swept: give at least one numeric option a grid"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"damping", "0.1:"}}))), HasSubstr("--damping"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "1:2:0"}}))), HasSubstr("no points"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "1:2:0"}}))), HasSubstr("--mass"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "-1:2:10"}}))), HasSubstr("be positive"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "1,2,-3"}}))), HasSubstr("be positive"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "1:2:1e15"}}))), HasSubstr("points"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"mass", "1:2:1e9"}, {"damping", "0.1:1:1e9"}}))),
              HasSubstr("too many"));
  EXPECT_THAT(refusal(options_with(driven, "heum")), HasSubstr("did you mean heun"));
  SweepOptions unknown = options_with(driven);
  unknown.measure = {"amplitud"};
  EXPECT_THAT(refusal(unknown), HasSubstr("did you mean amplitude"));
  SweepOptions free = options_with({{"position", "0.5,1"}});
  free.measure = {"amplitude"};
  EXPECT_THAT(refusal(free), HasSubstr("without a drive"));
  SweepOptions direction = options_with({{"cubic", "1"}, {"position", "0.5,1"}, {"damping", "0.1"}});
  direction.direction = "up";
  EXPECT_THAT(refusal(direction), HasSubstr("--direction"));
  direction.direction = "left";
  EXPECT_THAT(refusal(direction), HasSubstr("none of up, down and both"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"drive-frequency", "0:1:5"}}))),
              HasSubstr("nothing swings"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"until", "5"}}))), HasSubstr("--until"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"tolerance", "1e-6,0.5"}}))), HasSubstr("lie between"));
  EXPECT_THAT(refusal(options_with(with(driven, {{"beta", "0.1:1.5:3"}}))), HasSubstr("between 0 and 1"));
  SweepOptions small = options_with(with(driven, {{"mass", "1:2:100000"}}));
  small.memory = 1e6;
  EXPECT_THAT(refusal(small), HasSubstr("memory"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
