// How long the next step may be, by the published formulas; and what the loop makes of a method's answers.
#include "cromer/run/step_control.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "cromer/base/coupled.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

Trial<double> trial(State<double> y, State<double> error) { return {.y = y, .error = error}; }

TEST(MotionScale, MeasuresErrorsByTheLargestOfTheMotion) {
  MotionScale scale;
  scale.include(State<double>{-2, 1});
  scale.include(State<double>{1, -3});
  // 2 m, and 1.5 m of way.
  EXPECT_DOUBLE_EQ(scale.norm(trial({1, 1}, {1e-6, 0}), 0.5, 1e-6), 0.5);
  EXPECT_DOUBLE_EQ(scale.norm(trial({1, 1}, {0, -1e-6}), 0.5, 1e-6), 1 / 3.0);
  EXPECT_DOUBLE_EQ(scale.norm(trial({1, 1}, {-1e-6, 2e-6}), 0.5, 1e-6), 2 / 3.0);
  EXPECT_DOUBLE_EQ(scale.norm(trial({-4, 1}, {1e-6, 0}), 0.5, 1e-6), 0.25)
      << "the step's own end is part of it";
  EXPECT_DOUBLE_EQ(scale.norm(trial({1, 6}, {0, 1e-6}), 0.5, 1e-6), 1 / 6.0);
  EXPECT_EQ(scale.norm(trial({1, 1}, {0, 0}), 0.5, 1e-6), 0);
  EXPECT_EQ(MotionScale().norm(trial({0, 0}, {0, 0}), 0.5, 1e-6), 0);
}

TEST(MotionScale, WhatMattersToNeitherIsNoError) {
  MotionScale at_rest, passing;
  at_rest.include(State<double>{2, 0});
  EXPECT_DOUBLE_EQ(at_rest.norm(trial({2, 0}, {0, 4e-9}), 0.5, 1e-6), 1) << "over 1e-3 of 2 m";
  passing.include(State<double>{0, 2});
  EXPECT_DOUBLE_EQ(passing.norm(trial({0, 2}, {1e-9, 0}), 0.5, 1e-6), 1) << "over 1e-3 of 1 m";
}

TEST(MotionScale, AnInnerStateHasAScaleOfItsOwn) {
  using Pair = Coupled<double>;
  MotionScale scale;
  scale.include(State<Pair>{{2, 0}, {3, -5}});
  const auto norm = [&](double inner, double error, double of_v) {
    return scale.norm(Trial<Pair>{.y = {{1, 0}, {1, inner}}, .error = {{0, 0}, {of_v, error}}}, 0.5, 1e-6);
  };
  EXPECT_DOUBLE_EQ(norm(1, 1e-6, 0), 0.2);
  EXPECT_DOUBLE_EQ(norm(-10, -1e-6, 0), 0.1);
  EXPECT_DOUBLE_EQ(norm(1, 1e-6, 3e-6), 1);
  EXPECT_DOUBLE_EQ(norm(1, 1e-5, 3e-6), 2);
  EXPECT_EQ(norm(1, 0, 0), 0);
}

/// Hairer, Norsett & Wanner: 0.9 error^-alpha old^0.04, alpha = 1/5 - 0.75 * 0.04 at order 4.
double factor(double error, double old) { return 0.9 * std::pow(error, -0.17) * std::pow(old, 0.04); }

TEST(PiController, IsThePublishedOne) {
  PiController controller(4);
  EXPECT_NEAR(controller.after_accepted(1e-3) / factor(1e-3, 1e-4), 1, 1e-3);
  EXPECT_NEAR(controller.after_accepted(1e-2) / factor(1e-2, 1e-3), 1, 1e-3);
  EXPECT_NEAR(controller.after_accepted(0.9) / factor(0.9, 1e-2), 1, 1e-3);
  EXPECT_NEAR(controller.after_accepted(1e-6) / factor(1e-6, 0.9), 1, 1e-3);
  // No error before counts as less than 1e-4.
  EXPECT_NEAR(controller.after_accepted(1e-3) / factor(1e-3, 1e-4), 1, 1e-3);
  EXPECT_EQ(controller.after_accepted(0), 10) << "the most";
}

TEST(PiController, AStepThatCouldGrowByLessThanAFifthStays) {
  // Old errors of 0.1: 0.9 0.912 error^-0.17.
  const auto then = [](double error) {
    PiController controller(4);
    controller.after_accepted(0.1);
    return controller.after_accepted(error);
  };
  const double no_growth = std::pow(0.9 * std::pow(0.1, 0.04), 1 / 0.17),
               a_fifth = no_growth * std::pow(1.2, -1 / 0.17);
  EXPECT_LT(then(1.03 * no_growth), 1);
  EXPECT_EQ(then(0.97 * no_growth), 1);
  EXPECT_EQ(then(1.03 * a_fifth), 1);
  EXPECT_NEAR(then(0.97 * a_fifth), 1.2, 0.02);
}

TEST(PiController, AfterARejectedStepItShrinksByTheOrderAndDoesNotGrowAtOnce) {
  PiController controller(4);
  EXPECT_NEAR(controller.after_rejected(32) / (0.9 / 2), 1, 1e-3);
  EXPECT_NEAR(controller.after_rejected(2) / (0.9 * std::pow(2, -0.2)), 1, 1e-3);
  EXPECT_EQ(controller.after_rejected(1e9), 0.2) << "the least";
  EXPECT_EQ(controller.after_rejected(1e300), 0.2);
  EXPECT_EQ(controller.after_rejected(NAN), 0.2);
  EXPECT_EQ(controller.after_accepted(1e-9), 1);
  EXPECT_GT(controller.after_accepted(1e-9), 2) << "later it may";
}

TEST(FirstStep, IsAPartOfTheTimeInWhichTheStateChanges) {
  // 3 T^2 = 2 T + 1: T = 1; 1e-5 to the fifth part is 0.1.
  EXPECT_NEAR(first_step(State<double>{1, 2}, 3.0, 1e-5, 4, 9.0), 0.1, 1e-15);
  EXPECT_NEAR(first_step(State<double>{-1, -2}, -3.0, 1e-5, 4, 9.0), 0.1, 1e-15);
  EXPECT_NEAR(first_step(State<double>{1, 2}, 3.0, 1e-4, 1, 9.0), 0.01, 1e-15);
}

struct Rounding {
  double acceleration_rounding(double t) const { return t == 5 ? 0.25 : 0; }
};

TEST(IsRounding, WhereTheErrorIsNoMoreThanFourTimesThatOfTheForce) {
  // 4 * 0.25 m/s^2 in half a second.
  const auto said = [](double x, double v, double t) {
    return is_rounding(Rounding{}, trial({}, {x, v}), t, 0.5);
  };
  EXPECT_TRUE(said(0.25, 0.5, 5));
  EXPECT_TRUE(said(-0.25, -0.5, 5));
  EXPECT_FALSE(said(0.2501, 0.5, 5));
  EXPECT_FALSE(said(0.25, 0.5001, 5));
  EXPECT_FALSE(said(0.25, 0.5, 6));
  EXPECT_FALSE(is_rounding(0, trial({}, {0, 0}), 5, 0.5)) << "a system that does not say";
}

/// Dormand and Prince's, which tells of its steps, and whose answers may be spoiled.
struct Watched : DormandPrince {
  using See = std::function<void(double t, double h, Trial<double>&)>;
  See see;
  explicit Watched(See see_) : see(std::move(see_)) {}

  template <class S>
  Trial<double> step(const S& system, double t, double h, const State<double>& y,
                     Memory<double>& memory) const {
    Trial<double> trial = DormandPrince::step(system, t, h, y, memory);
    see(t, h, trial);
    return trial;
  }
};

const DrivenOscillator<double, Terms{}> spring({1, 9, 0, 0, 0, 0}, {});

Outcome run(const Watched& method, Interval interval, double row, const Watch& watch = {}) {
  return solve(spring, method, interval, State<double>{1, 0}, StepControl{row, 1e-8}, KeepNone{}, watch);
}

TEST(AdaptiveSteps, WhatIsLeftForOneMoreStepIsSharedBetweenTwo) {
  for (const double until : {3.0, 3.1, 3.2, 3.3, 3.4}) {
    std::vector<double> lengths;
    const auto outcome =
        run(Watched([&](double, double h, Trial<double>&) { lengths.push_back(h); }), {0, until}, 1);
    EXPECT_EQ(outcome.t, until);
    ASSERT_EQ(static_cast<long long>(lengths.size()), outcome.counts.accepted + outcome.counts.rejected);
    const double last = lengths.back(), before = lengths[lengths.size() - 2];
    EXPECT_GT(last, 0.45 * before) << until;
    EXPECT_EQ(outcome.counts.evaluations, 2 + 6 * static_cast<long long>(lengths.size()));
  }
}

TEST(AdaptiveSteps, AStepThatOvershootsIsCutToTheEnd) {
  std::vector<double> ends;
  run(Watched([&](double t, double h, Trial<double>&) { ends.push_back(t + h); }), {5, 5.001}, 1);
  EXPECT_NEAR(ends.back(), 5.001, 1e-15);
  for (const double end : ends) EXPECT_LE(end, 5.001 + 1e-15);
}

TEST(AdaptiveSteps, ARejectedStepIsTriedAgainFromWhereItBegan) {
  std::vector<double> from, lengths;
  const Watched spoiled([&](double t, double h, Trial<double>& answer) {
    from.push_back(t);
    lengths.push_back(h);
    if (from.size() == 3) answer.error = {1, 1};
  });
  const auto outcome = run(spoiled, {0, 2}, 1);
  EXPECT_EQ(from[3], from[2]);
  EXPECT_LT(lengths[3], 0.5 * lengths[2]);
  EXPECT_EQ(outcome.counts.rejected, 1);
  EXPECT_EQ(outcome.counts.accepted + 1, static_cast<long long>(from.size()));
  EXPECT_NEAR(outcome.y.x, std::cos(6.0), 1e-7);
}

TEST(AdaptiveSteps, StepsThatNeverSucceedHaveAReason) {
  const auto status = [](std::function<void(Trial<double>&)> spoil) {
    int tried = 0;
    const auto outcome = run(Watched([&](double, double, Trial<double>& answer) {
                               if (++tried > 5) spoil(answer);
                             }),
                             {1, 9}, 1);
    EXPECT_EQ(outcome.counts.accepted, 5);
    EXPECT_GT(outcome.counts.rejected, 10);
    EXPECT_LT(outcome.counts.rejected, 60);
    EXPECT_GT(outcome.t, 1);
    return outcome.status;
  };
  EXPECT_EQ(status([](Trial<double>& answer) { answer.converged = false; }), Status::no_convergence);
  EXPECT_EQ(status([](Trial<double>& answer) { answer.y.v = NAN; }), Status::not_finite);
  EXPECT_EQ(status([](Trial<double>& answer) { answer.error.x = 1; }), Status::step_too_small);
}

TEST(AdaptiveSteps, OfNoLengthTheyEndAtTimeZeroToo) {
  const auto outcome =
      run(Watched([](double, double, Trial<double>& answer) { answer.error.x = 1; }), {0, 9}, 1);
  EXPECT_EQ(outcome.status, Status::step_too_small);
  EXPECT_EQ(outcome.t, 0);
}

TEST(AdaptiveSteps, AnInterruptEndsThemBeforeTheNext) {
  std::atomic<bool> interrupt = true;
  const Watch watch{.interrupt = &interrupt, .progress = {}};
  int tried = 0;
  const auto outcome = run(Watched([&](double, double, Trial<double>&) { ++tried; }), {0, 9}, 1, watch);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(tried, 0);
}

TEST(CoarsePower, LogarithmIsAsGoodAsItSays) {
  double worst = 0;
  for (double x = 1e-300; x < 1e300; x *= 1.0371)
    worst = std::fmax(worst, std::abs(coarse_log2(x) - std::log2(x)));
  EXPECT_LT(worst, 9e-4);
  EXPECT_GT(worst, 8e-4);  // or the contract should say less
  for (const double power : {-40.0, -1.0, 0.0, 1.0, 7.0}) EXPECT_EQ(coarse_log2(std::exp2(power)), power);
}

TEST(CoarsePower, PowerIsAsGoodAsItSays) {
  double worst = 0;
  for (double y = -999; y < 999; y += 0.0371)
    worst = std::fmax(worst, std::abs(coarse_exp2(y) / std::exp2(y) - 1));
  EXPECT_LT(worst, 5e-6);
  EXPECT_GT(worst, 3e-6);
  for (const double whole : {-40.0, -1.0, 0.0, 1.0, 7.0}) EXPECT_EQ(coarse_exp2(whole), std::exp2(whole));
}

TEST(CoarsePower, FarPowersEndAtTheLimits) {
  EXPECT_EQ(coarse_exp2(1e9), std::exp2(1000));
  EXPECT_EQ(coarse_exp2(-1e9), std::exp2(-1000));
  EXPECT_EQ(coarse_exp2(1000.5), std::exp2(1000));
  EXPECT_EQ(coarse_exp2(-1000.5), std::exp2(-1000));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
