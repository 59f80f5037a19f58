#include "cromer/tasks/simulate/run_effect.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RunEffect, EveryLinearRunSaysWhatItReallySimulates) {
  const auto result = simulated({.stiffness = 36,
                                 .damping = 0.3,
                                 .method = {"forward-euler", "euler-cromer", "exact", "dormand-prince"},
                                 .step = 0.01,
                                 .until = 1});
  EXPECT_NEAR(*result.runs[0].effect->effective.decay_rate, -0.030, 5e-4);
  EXPECT_THAT(in_words(effect_notice(result.runs[0])),
              HasSubstr("turns your damping of 0.15 1/s into growth"));
  EXPECT_NEAR(*result.runs[1].effect->effective.decay_rate, 0.1502, 5e-5);
  EXPECT_EQ(*result.runs[2].effect->effective.decay_rate, 0.15);
  EXPECT_FALSE(result.runs[3].effect) << "it chooses its own steps";
}

TEST(RunEffect, ALawThatRunsAwayIsNotSaidToCreepBackOrToSettle) {
  const auto away = simulated({.stiffness = 1, .damping = -7, .method = {"exact"}, .step = 0.01, .until = 3});
  EXPECT_THAT(in_words(effect_notice(away.runs[0])), HasSubstr("grows without swinging"));
  const auto fed = simulated({.stiffness = 9,
                              .damping = -0.1,
                              .drive_amplitude = 1,
                              .drive_frequency = {2},
                              .method = {"exact", "implicit-euler"},
                              .step = 0.01,
                              .until = 3});
  for (const auto& run : fed.runs) EXPECT_FALSE(run.transmission) << run.method;
}

TEST(RunEffect, ADrivenRunSettlesWhereItIsSaidTo) {
  const auto result = simulated({.stiffness = 36,
                                 .damping = 1.2,
                                 .drive_amplitude = 1.5,
                                 .drive_frequency = {4},
                                 .method = {"euler-cromer"},
                                 .step = 0.05,
                                 .until = 100});
  const auto& steady = *result.runs[0].effect->effective.steady_state;
  EXPECT_NEAR(result.runs[0].outcome.y.x,
              steady.amplitude * std::cos(4 * result.runs[0].outcome.t - steady.phase_lag), 1e-12);
  EXPECT_THAT(in_words(steady_notice(result.runs[0])), HasSubstr("settles at "));
  EXPECT_THAT(in_words(steady_notice(result.runs[0])), HasSubstr("(your law: "));
  EXPECT_EQ(in_words(run_notice(result.runs[0])).find("euler-cromer turns your damping"), 0u);
}

TEST(RunEffect, AStepBeyondTheLimitIsSpokenOf) {
  EXPECT_THAT(
      in_words(simulated({.stiffness = 36, .method = {"euler-cromer"}, .step = 0.34, .until = 3.4}).notices),
      Contains(HasSubstr("--step: 0.34 s is beyond the stability limit of euler-cromer for this law, "
                         "0.333333 s")));
  EXPECT_THAT(
      in_words(simulated({.stiffness = 36, .method = {"euler-cromer"}, .step = 0.33, .until = 3.3}).notices),
      testing::IsEmpty());
  EXPECT_THAT(
      in_words(simulated({.stiffness = 36, .method = {"forward-euler"}, .step = 0.01, .until = 1}).notices),
      Contains(HasSubstr("forward-euler is unstable for this law whatever the step")));
}

/// What is said before a run up to three steps.
std::vector<std::string> warnings(SimulateOptions options, double step) {
  options.step = step;
  options.until = 3 * step;
  return in_words(simulated(std::move(options)).notices);
}

TEST(RunEffect, AHardeningSpringIsWarnedOfWhereTheMotionBegins) {
  // At 1 m the stiffness is 9 + 3 * 1000 N/m: Verlet is stable up to 2/sqrt(3009) s.
  const SimulateOptions stiff{.stiffness = 9, .law = {.cubic = 1000}, .position = 1, .method = {"verlet"}};
  EXPECT_THAT(
      warnings(stiff, 0.05),
      Contains(HasSubstr("stability limit of verlet for motions as wide as at the start under this law, "
                         "0.0364602 s")));
  EXPECT_THAT(warnings(stiff, 0.03), testing::IsEmpty());
}

TEST(RunEffect, EveryMethodIsWarnedOfAtItsLimit) {
  // k = 36 N/m, c = 0.3 kg/s: as the method itself says.
  const LinearLaw<double> law{.decay_rate = 0.15, .stiffness = 36};
  for (const double beta : {0.25, 0.0})
    for (const MethodInfo& info : method_infos) {
      if (info.is_adaptive() || (beta == 0 && info.name != "newmark")) continue;
      SimulateOptions options{.stiffness = 36, .damping = 0.3, .method = {std::string(info.name)}};
      if (beta == 0) options.beta = 0;
      const auto limit = visit_method(info.name, MethodSettings{.newton = {}, .beta = beta},
                                      [&](const auto& method) { return stability_limit(method, law); });
      EXPECT_EQ(limit.has_value(), !info.a_stable || beta == 0) << info.name;
      if (!limit) {
        EXPECT_THAT(warnings(options, 1e3), IsEmpty()) << info.name;
        continue;
      }
      ASSERT_GT(*limit, 0) << info.name;
      const std::string said = fmt::format("stability limit of {} for this law, {:.6g} s", info.name, *limit);
      EXPECT_THAT(warnings(options, 1.001 * *limit), Contains(HasSubstr(said)));
      EXPECT_THAT(warnings(options, 0.999 * *limit), IsEmpty()) << info.name;
      // A drive changes nothing about it.
      options.drive_amplitude = 1;
      options.drive_frequency = {3};
      EXPECT_THAT(warnings(options, 1.001 * *limit), Contains(HasSubstr(said)));
      options.drive = "step";
      options.drive_frequency.clear();
      EXPECT_THAT(warnings(options, 1.001 * *limit), Contains(HasSubstr(said)));
    }
}

TEST(RunEffect, LawsThatAreNotLinearAreWarnedOfBySmallMotions) {
  const auto limit = HasSubstr("stability limit of verlet for small motions under this law, 0.333333 s");
  SimulateOptions law{.stiffness = 36, .method = {"verlet"}};
  law.law.friction = 0.1;
  EXPECT_THAT(warnings(law, 0.34), Contains(limit));
  EXPECT_THAT(warnings(law, 0.33), IsEmpty());
  law.law.friction = 0;
  law.law.cubic = 0.1;
  EXPECT_THAT(warnings(law, 0.34), Contains(limit));
  EXPECT_THAT(warnings(law, 0.33), IsEmpty());
  law.law.drag = 0.1;
  EXPECT_THAT(warnings(law, 0.34), Contains(limit));
  // At the bottom of a double well k = -18 N/m counts twice.
  EXPECT_THAT(warnings({.stiffness = -18, .law = {.cubic = 1}, .method = {"verlet"}}, 0.34), Contains(limit));
  // Friction outweighs what forward Euler adds to small swings, if the step is short; cubic stiffness does
  // not.
  law = {.law = {.friction = 0.1}, .method = {"forward-euler"}};
  EXPECT_THAT(warnings(law, 0.001), IsEmpty());
  law = {.law = {.cubic = 0.1}, .method = {"forward-euler"}};
  EXPECT_THAT(warnings(law, 0.001), Contains(HasSubstr("forward-euler is unstable for small motions")));
}

TEST(RunEffect, NonlinearLawsHaveNone) {
  EXPECT_FALSE(simulated({.law = {.drag = 0.1}, .step = 0.01, .until = 0.1}).runs[0].effect);
  EXPECT_FALSE(simulated({.law = {.cubic = 1}, .step = 0.01, .until = 0.1}).runs[0].effect);
}

TEST(RunEffect, OfNonlinearLawsWhatWasMeasuredIsSaid) {
  const auto result = simulated(
      {.law = {.drag = 0.2}, .method = {"implicit-euler", "dormand-prince"}, .step = 0.03, .until = 120});
  const std::string lossy = in_words(effect_notice(result.runs[0])),
                    exact = in_words(effect_notice(result.runs[1]));
  EXPECT_THAT(exact, HasSubstr("swung at 0.9994"));
  EXPECT_THAT(exact, HasSubstr("the method itself nothing"));
  EXPECT_THAT(exact, HasSubstr("had 0.5 J, of which drag took 99."));
  // Energy that implicit Euler takes is no longer there for drag to take.
  const auto& balance = *result.runs[0].energy_balance;
  EXPECT_LT(balance.method(), -0.1 * balance.start);
  EXPECT_THAT(lossy, HasSubstr("the method itself 2"));
  const auto spring =
      simulated({.law = {.cubic = 1}, .method = {"euler-cromer", "rk4"}, .step = 0.02, .until = 60});
  EXPECT_THAT(in_words(effect_notice(spring.runs[1])), HasSubstr("m to each side; kept its 0.75 J"));
  EXPECT_THAT(in_words(effect_notice(spring.runs[0])), HasSubstr("which comes and goes"));
  const auto driven = simulated({.damping = 0.1,
                                 .law = {.cubic = 1},
                                 .drive_amplitude = 1,
                                 .drive_frequency = {1.2},
                                 .method = {"implicit-euler"},
                                 .step = 0.02,
                                 .until = 60});
  EXPECT_EQ(in_words(effect_notice(driven.runs[0])).find("had "), 0u);
  EXPECT_THAT(in_words(effect_notice(driven.runs[0])),
              HasSubstr("with what the drive gave, of which damping took "));
}

// Euler-Cromer's energy comes and goes; where in its cycle the motion began is no loss.
TEST(RunEffect, TheStartOfACycleIsNoLoss) {
  for (const double velocity : {0.0, 0.7, -0.7}) {
    const auto result = simulated({.damping = 0.02,
                                   .law = {.drag = 0.2},
                                   .position = 0.7,
                                   .velocity = velocity,
                                   .method = {"euler-cromer"},
                                   .step = 0.03,
                                   .until = 60});
    const auto method = method_energy_of(result.runs[0]);
    ASSERT_TRUE(method);
    EXPECT_LT(std::abs(method->lasting), 0.001 * result.runs[0].energy_balance->start) << velocity;
  }
  // A loss in each step stays one.
  const auto lossy = simulated(
      {.law = {.drag = 0.02}, .velocity = 0.7, .method = {"implicit-euler"}, .step = 0.001, .until = 60});
  const auto& balance = *lossy.runs[0].energy_balance;
  EXPECT_NEAR(method_energy_of(lossy.runs[0])->lasting / balance.method(), 1, 0.02);
}

// Forward Euler's gain, of which most comes while the swing is wide: against the sum over its own states.
TEST(RunEffect, WhatAMethodGaveADyingSwingIsAllThere) {
  const auto result = simulated({.mass = 1,
                                 .stiffness = 36,
                                 .damping = 0.02,
                                 .law = {.drag = 20},
                                 .position = 0.3,
                                 .method = {"forward-euler"},
                                 .step = 0.005,
                                 .until = 20});
  EXPECT_NEAR(method_energy_of(result.runs[0])->lasting / result.runs[0].energy_balance->start, 0.0184,
              0.0002);
}

TEST(RunEffect, WhatAMethodAddsMayBeTakenToo) {
  const auto result = simulated({.law = {.drag = 2}, .method = {"forward-euler"}, .step = 0.1, .until = 60});
  EXPECT_THAT(
      in_words(effect_notice(result.runs[0])),
      HasSubstr("began with 0.5 J; measured by that, drag took 116 %, the method itself added 16.5 %"));
}

TEST(RunEffect, ASwingThatIsFedSaysWhatItGot) {
  const auto result = simulated({.damping = -0.2,
                                 .law = {.van_der_pol = 0.2},
                                 .position = 0.1,
                                 .method = {"rk4"},
                                 .step = 0.01,
                                 .until = 120});
  EXPECT_THAT(in_words(result.notices), testing::IsEmpty());
  const std::string words = in_words(effect_notice(result.runs[0]));
  EXPECT_THAT(words, HasSubstr("with what the damping gave, of which van-der-pol took 9"));
  EXPECT_NEAR(result.runs[0].outcome.y.x * result.runs[0].outcome.y.x +
                  result.runs[0].outcome.y.v * result.runs[0].outcome.y.v,
              4, 0.3);  // A = sqrt(4 c/e) = 2
}

TEST(RunEffect, OptionsOfTheMethodReachIt) {
  // The central difference is Verlet's method.
  const auto result =
      simulated({.stiffness = 36, .method = {"newmark", "verlet"}, .step = 0.1, .until = 1, .beta = 0.0});
  EXPECT_NEAR(result.runs[0].outcome.y.x, result.runs[1].outcome.y.x, 1e-13);
  EXPECT_THAT(in_words(result.notices), Contains("--beta has no effect on verlet"));
  const auto damped = simulated(
      {.stiffness = 36, .method = {"generalized-alpha"}, .step = 1000, .until = 2000, .rho_inf = 0.3});
  EXPECT_NEAR(damped.runs[0].effect->effective.spectral_radius, 0.3, 0.02);

  const auto refused = simulate({.method = {"generalized-alpha"}, .rho_inf = 1.2});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()), HasSubstr("--rho-inf: it must lie between 0 and 1, not 1.2"));
}

/// What is transmitted, measured on the last cycles of a run.
MeasuredSteadyState measured(const SimulatedRun& run, double base) {
  Trajectory arriving = run.trajectory;
  for (std::size_t i = 0; i < arriving.size(); ++i) {
    const double t = arriving.t[i], x = run.trajectory.x[i], v = run.trajectory.v[i];
    arriving.x[i] = base > 0 ? x + base * std::cos(run.drive.frequency * t + run.drive.phase)
                             : run.oscillator.stiffness * x + run.oscillator.damping * v;
  }
  return measure_steady_state(arriving, run.drive).value();
}

SimulateOptions mount(double w) {
  SimulateOptions options{.mass = 3, .natural_frequency = 6.0, .damping_ratio = 0.15};
  options.drive_frequency = {w};
  options.step = 0.02;
  options.until = 60;
  for (const MethodInfo& info : method_infos)
    if (info.name != "forward-euler") options.method.emplace_back(info.name);
  return options;
}

/// Long runs by every method but forward Euler, which grows: each reaches the steady state that its effect
/// predicts, near the exact one.
void check(const SimulateOptions& options, double sent) {
  for (const SimulatedRun& run : simulated(options).runs) {
    ASSERT_TRUE(run.transmission) << run.method;
    const RunTransmission& found = *run.transmission;
    const bool base = options.base_displacement.has_value();
    EXPECT_EQ(found.of_motion, base);
    EXPECT_NEAR(found.sent / sent, 1, 1e-14);
    const double r = options.drive_frequency[0] / 6, damper = 2 * 0.15 * r;
    EXPECT_NEAR(found.frequency_ratio, r, 1e-15);
    EXPECT_NEAR(found.exact.amplitude, std::hypot(1, damper) / std::hypot(1 - r * r, damper), 1e-13);
    const auto last = measured(run, options.base_displacement.value_or(0));
    if (run.method == "dormand-prince") {
      EXPECT_FALSE(found.simulated) << "it chooses its own steps";
      EXPECT_NEAR(last.amplitude / sent, found.exact.amplitude, 1e-5);
      continue;
    }
    ASSERT_TRUE(found.simulated) << run.method;
    EXPECT_NEAR(last.amplitude / sent / found.simulated->amplitude, 1, 1e-9) << run.method;
    EXPECT_NEAR(last.phase_lag, found.simulated->phase_lag, 1e-9) << run.method;
    // The test tells methods apart: those of first order are off by far more than it allows.
    if (find_method(run.method)->order >= 4) {
      EXPECT_LT(std::abs(*found.error()), 1e-3) << run.method;
    }
    if (run.method == "implicit-euler") {
      EXPECT_GT(std::abs(*found.error()), 1e-3);
    }
  }
}

TEST(RunTransmission, IsWhatALongRunPassesOn) {
  for (const double w : {3.0, 6.0, 12.0}) {
    auto force = mount(w);
    force.drive_amplitude = 5;
    force.drive_phase = 0.4;
    check(force, 5);
    auto unbalance = mount(w);
    unbalance.drive = "unbalance";
    unbalance.unbalance_mass = 0.2;
    unbalance.eccentricity = 0.05;
    check(unbalance, 0.2 * 0.05 * w * w);
    auto base = mount(w);
    base.drive = "base";
    base.base_displacement = 0.003;
    base.drive_phase = 0.4;
    check(base, 0.003);
  }
}

TEST(RunTransmission, ThereIsNoneWhereNothingSettlesOrShakes) {
  SimulateOptions options{.natural_frequency = 3.0};
  options.until = 1;
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "nothing drives";
  options.drive_amplitude = 1;
  options.drive_frequency = {3};
  options.method = {"exact", "forward-euler", "implicit-euler"};
  options.step = 0.01;
  const auto undamped = simulated(options);
  EXPECT_FALSE(undamped.runs[0].transmission->bounded());
  EXPECT_FALSE(undamped.runs[0].transmission->simulated);
  EXPECT_FALSE(undamped.runs[1].transmission->simulated) << "it grows";
  // Implicit Euler damps by itself: it settles where the law does not, and is off by more than any
  // percentage.
  EXPECT_TRUE(undamped.runs[2].transmission->simulated);
  EXPECT_FALSE(undamped.runs[2].transmission->error());
  options.method = {"rk4"};
  options.law.drag = 0.1;
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "not linear";
  options.law.drag = 0;
  options.drive_frequency = {0};
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "a constant force";
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
