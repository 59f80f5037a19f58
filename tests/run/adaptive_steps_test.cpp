#include "cromer/run/adaptive_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

struct Run {
  Outcome outcome;
  Trajectory trajectory;
};

Run run(const Oscillator<double>& oscillator, const HarmonicDrive<double>& drive, double until,
        StepControl control, State<double> start, const Limits& limits = {}) {
  KeepEvery keep(1, count_steps({0, until}, control.step));
  const Outcome outcome = with_terms(oscillator, drive, [&](const auto& system) {
    return solve(system, DormandPrince{}, {0, until}, start, control, keep, {}, limits);
  });
  return {outcome, keep.take()};
}

TEST(AdaptiveSteps, MeetTheDuffingTruths) {
  const auto truth = problems::read("duffing.json");
  ASSERT_EQ(truth.size(), 3u);
  for (const auto& entry : truth) {
    const problems::Problem p(entry.at("parameters"));
    const double t = problems::number(entry, "t"), x = problems::number(entry, "x"),
                 v = problems::number(entry, "v");
    const State<double> y = run(p.oscillator, p.drive, t, {0.01, 1e-13}, p.start).outcome.y;
    EXPECT_NEAR(y.x, x, 1e-10);
    EXPECT_NEAR(y.v, v, 1e-10);
  }
}

TEST(AdaptiveSteps, TheErrorFollowsTheTolerance) {
  for (const auto& entry : problems::read("duffing.json")) {
    const problems::Problem p(entry.at("parameters"));
    const double t = problems::number(entry, "t"), x = problems::number(entry, "x"),
                 v = problems::number(entry, "v");
    // Along the whole run, where errors of one moment that happen to cancel do not count.
    const auto fine = run(p.oscillator, p.drive, t, {0.01, 1e-15}, p.start);
    ASSERT_LT(std::hypot(fine.outcome.y.x - x, fine.outcome.y.v - v), 1e-13);
    // The slope of log(error) over log(tolerance), by least squares.
    double n = 0, sum_a = 0, sum_b = 0, sum_aa = 0, sum_ab = 0;
    for (double exponent = -6; exponent >= -12; exponent -= 0.5) {
      const double tolerance = std::pow(10, exponent);
      const Trajectory kept = run(p.oscillator, p.drive, t, {0.01, tolerance}, p.start).trajectory;
      double error = 0;
      for (std::size_t i = 0; i < kept.size(); ++i)
        error =
            std::max(error, std::hypot(kept.x[i] - fine.trajectory.x[i], kept.v[i] - fine.trajectory.v[i]));
      EXPECT_LT(error, 25 * tolerance) << tolerance;
      EXPECT_GT(error, tolerance / 50) << tolerance << ": steps wasted";
      n += 1, sum_a += exponent, sum_b += std::log10(error);
      sum_aa += exponent * exponent, sum_ab += exponent * std::log10(error);
    }
    EXPECT_NEAR((n * sum_ab - sum_a * sum_b) / (n * sum_aa - sum_a * sum_a), 1, 0.25) << entry;
  }
}

TEST(AdaptiveSteps, AreTheSameInAnyUnits) {
  // The same motion in millimetres and milliseconds takes the same steps.
  const auto metres = run({.mass = 1, .stiffness = 9, .damping = 0.2}, {}, 20, {0.01, 1e-9}, {1, 0});
  const auto small = run({.mass = 1, .stiffness = 9e6, .damping = 200}, {}, 0.02, {1e-5, 1e-9}, {1e-3, 0});
  EXPECT_EQ(metres.outcome.counts.accepted, small.outcome.counts.accepted);
  EXPECT_EQ(metres.outcome.counts.rejected, small.outcome.counts.rejected);
  EXPECT_NEAR(metres.outcome.y.x, 1e3 * small.outcome.y.x, 1e-10);
}

TEST(AdaptiveSteps, ManyEqualStepsKeepTheTime) {
  // A time that is added up from equal steps would be off by half a rounding each, always the same way: here
  // by some 1e-9 s in the end, which the phase would show.
  const Oscillator<double> o{.mass = 1, .stiffness = 36};
  const double until = 3000;
  const auto [outcome, kept] = run(o, {}, until, {until, 1e-14}, {1, 0});
  EXPECT_GT(outcome.counts.accepted, 1'000'000);
  EXPECT_NEAR(outcome.y.x, std::cos(6 * until), 2e-9);
}

TEST(AdaptiveSteps, RowsDoNotChangeThem) {
  const Oscillator<double> o{.mass = 1, .stiffness = 9, .damping = 0.2};
  const auto fine = run(o, {}, 20, {0.001, 1e-9}, {1, 0});
  const auto coarse = run(o, {}, 20, {0.5, 1e-9}, {1, 0});
  EXPECT_EQ(fine.outcome.counts, coarse.outcome.counts);
  EXPECT_EQ(fine.outcome.y, coarse.outcome.y);
  ASSERT_EQ(coarse.trajectory.size(), 41u);
  ASSERT_EQ(fine.trajectory.size(), 20001u);
  EXPECT_EQ(coarse.trajectory.t.back(), 20);
}

TEST(AdaptiveSteps, EveryRowIsAsGoodAsTheTolerance) {
  const Oscillator<double> o{.mass = 1, .stiffness = 9, .damping = 0.2};
  const auto kept = run(o, {}, 20.003, {0.01, 1e-9}, {1, 0}).trajectory;
  const DrivenOscillator<double, Terms{.law = law_of("viscous")}> system(o, {});
  ASSERT_EQ(kept.size(), 2002u);
  EXPECT_NEAR(kept.t.back(), 20.003, 1e-14);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_NEAR(kept.t[i], std::min(static_cast<double>(i) * 0.01, 20.003), 1e-14);
    const State<double> y = system.propagate(0, kept.t[i], {1, 0});
    EXPECT_NEAR(kept.x[i], y.x, 1e-7) << kept.t[i];
    EXPECT_NEAR(kept.v[i], y.v, 3e-7) << kept.t[i];
  }
}

TEST(AdaptiveSteps, WakeUpFromRest) {
  // No position, no velocity, no force at t = 0: nothing to choose a step by.
  const auto y = run({.mass = 1, .stiffness = 4}, {1, 3, -std::acos(0.0)}, 10, {0.01, 1e-10}, {0, 0}).outcome;
  // x'' + 4 x = sin 3t from rest: (sin 2t 3/2 - sin 3t)/5.
  EXPECT_NEAR(y.y.x, (1.5 * std::sin(20.0) - std::sin(30.0)) / 5, 1e-7);
  EXPECT_LT(y.counts.accepted, 2000);
}

TEST(AdaptiveSteps, ARestThatIsOnlyRoundingIsCheap) {
  const auto outcome =
      run({.mass = 1, .stiffness = 7, .damping = 0.1}, {0.3, 0, 0}, 100, {0.1, 1e-13}, {0.3 / 7, 0}).outcome;
  EXPECT_EQ(outcome.status, Status::reached_end);
  EXPECT_NEAR(outcome.y.x, 0.3 / 7, 1e-12);
  EXPECT_LT(outcome.counts.accepted, 20000);
}

TEST(AdaptiveSteps, AnEscapeToInfinityIsAStatus) {
  // x'' = x + x^3 reaches infinity in finite time.
  const auto [outcome, kept] = run({.mass = 1, .stiffness = -1, .cubic = -1}, {}, 20, {0.01, 1e-9}, {1, 0});
  EXPECT_TRUE(outcome.status == Status::step_too_small || outcome.status == Status::not_finite);
  EXPECT_GT(outcome.t, 1);
  EXPECT_LT(outcome.t, 3);
  EXPECT_TRUE(std::isfinite(outcome.y.x) && std::isfinite(outcome.y.v));
  EXPECT_LE(kept.t.back(), outcome.t);
}

TEST(AdaptiveSteps, TheStepLimitIsAStatus) {
  const auto outcome = run({.mass = 1, .stiffness = 9}, {}, 100, {0.01, 1e-9}, {1, 0}, {.steps = 50}).outcome;
  EXPECT_EQ(outcome.status, Status::step_limit);
  EXPECT_EQ(outcome.counts.accepted, 50);
}

TEST(PiController, ShrinksAfterRejectionAndDoesNotGrowJustAfter) {
  PiController controller(4);
  EXPECT_LT(controller.after_rejected(100), 0.5);
  EXPECT_EQ(controller.after_rejected(INFINITY), 0.2);
  EXPECT_LE(controller.after_accepted(1e-6), 1.0);
  EXPECT_GT(controller.after_accepted(1e-6), 2.0);
  EXPECT_LE(controller.after_accepted(0), 10.0);
}

TEST(FirstStep, FollowsTheMotionNotTheUnits) {
  // Spring of w = 3: the time is 2/(w) up to a factor, whatever the amplitude.
  EXPECT_DOUBLE_EQ(first_step(State<double>{1, 0}, -9.0, 1e-5, 4, 1.0), 0.1 / 3);
  EXPECT_DOUBLE_EQ(first_step(State<double>{1e-9, 0}, -9e-9, 1e-5, 4, 1.0), 0.1 / 3);
  EXPECT_EQ(first_step(State<double>{0, 0}, 0.0, 1e-5, 4, 0.25), 0.25) << "nothing moves";
  EXPECT_EQ(first_step(State<double>{0, 1}, 0.0, 1e-5, 4, 0.25), 0.25);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
