// Runs in compensated sums: the same motion by every method and law, and a better one where rounded sums
// limit it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/run_law.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// x after n steps of Euler-Cromer on the undamped linear law from rest at 1: a rotation by theta a step, sin
/// theta/2 = w h/2.
double euler_cromer_position(long double w, long double h, long double n) {
  const long double theta = 2 * std::asin(w * h / 2), first = 1 - h * h * w * w;
  return static_cast<double>((std::sin(n * theta) * first - std::sin((n - 1) * theta)) / std::sin(theta));
}

TEST(Compensated, MeetsTheClosedFormOfAMillionSteps) {
  SimulateOptions options{.stiffness = 36, .step = 0.01, .until = 1e4, .every = 1000};
  const auto worst = [&] {
    const Trajectory kept = run(options).trajectory;
    double off = 0;
    for (std::size_t i = 1; i < kept.size(); ++i)
      off = std::max(off,
                     std::abs(kept.x[i] - euler_cromer_position(6, 0.01, 1000.0 * static_cast<double>(i))));
    return off;
  };
  const double ordinary = worst();
  options.compensated = true;
  const double compensated = worst();
  EXPECT_LT(compensated, 1e-13);
  EXPECT_GT(ordinary, 2 * compensated) << "the phase also suffers from the products, which stay rounded";
}

TEST(Compensated, IsTheSameMotionByEveryFixedStepMethodAndLaw) {
  int compared = 0;
  for (const MethodInfo& info : method_infos) {
    if (!info.takes_fixed_steps()) continue;
    for (const double damping : {0.0, 0.2})
      for (const double cubic : {0.0, 2.0})
        for (const double drag : {0.0, 0.1})
          for (const int drive : {0, 1}) {
            LawRun law{
                .oscillator = {.mass = 2, .stiffness = 9, .damping = damping, .drag = drag, .cubic = cubic},
                .drive = {.amplitude = drive == 1 ? 1.0 : 0.0, .frequency = 2},
                .method = info.name,
                .interval = {0, 10.005},
                .start = {0.5, 0.1},
                .control = 0.01};
            const auto end = [&](bool compensated) {
              law.compensated = compensated;
              KeepEvery keep(1, count_steps(law.interval, 0.01));
              const Outcome outcome = run_law(law, keep);
              EXPECT_EQ(outcome.status, Status::reached_end) << info.name;
              const Trajectory kept = keep.take();
              EXPECT_EQ(kept.size(), 1002u);
              EXPECT_EQ(kept.x.back(), outcome.y.x);
              return outcome.y;
            };
            const State<double> one = end(false), other = end(true);
            EXPECT_NEAR(one.x, other.x, 1e-11) << info.name << ' ' << damping << cubic << drag << drive;
            EXPECT_NEAR(one.v, other.v, 1e-11) << info.name << ' ' << damping << cubic << drag << drive;
            ++compared;
          }
  }
  EXPECT_EQ(compared, 11 * 16);
}

TEST(Compensated, IsRefusedWhereNothingAddsUp) {
  EXPECT_THAT(refusal({.method = {"dormand-prince"}, .compensated = true}),
              AllOf(StartsWith("--compensated: dormand-prince"), HasSubstr("euler-cromer")));
  EXPECT_THAT(refusal({.method = {"exact"}, .compensated = true}), StartsWith("--compensated: exact"));
  EXPECT_THAT(refusal({.law = {.friction = 0.1}, .compensated = true}),
              AllOf(StartsWith("--compensated"), HasSubstr("0.1 N")));
  EXPECT_THAT(refusal({.drive = "step", .drive_amplitude = 1, .compensated = true}),
              AllOf(StartsWith("--compensated: under step"), HasSubstr("leave one of them out")));
  EXPECT_THAT(refusal({.event = {"turning-point"}, .compensated = true}),
              AllOf(StartsWith("--compensated"), HasSubstr("turning-point")));
}

TEST(Compensated, GoesWithAccuracy) {
  // Its reference run is by dormand-prince.
  const auto found =
      run({.stiffness = 9, .law = {.cubic = 2}, .method = {"rk4"}, .accuracy = 1e-4, .compensated = true});
  EXPECT_TRUE(found.accuracy);
  EXPECT_EQ(found.outcome.status, Status::reached_end);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
