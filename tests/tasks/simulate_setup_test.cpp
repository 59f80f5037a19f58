// From options to runs: defaults, limits, and every refusal and warning word for word.
#include "cromer/tasks/simulate/simulate_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/run/step_control.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// Why no runs are set up; "" if they are.
std::string refused(const SimulateOptions& options) {
  const auto runs = set_up_runs(options);
  return runs ? "" : in_words(runs.error());
}

std::vector<std::string> warned(const SimulateOptions& options) {
  const auto runs = set_up_runs(options);
  EXPECT_TRUE(runs) << (runs ? "" : in_words(runs.error()));
  return runs ? in_words(setup_notices(options, *runs)) : std::vector<std::string>{};
}

TEST(SetUp, StepAndEndComeFromThePeriods) {
  EXPECT_EQ(default_step(2, 0), 0.01);
  EXPECT_EQ(default_step(0, 4), 0.02);
  EXPECT_EQ(default_step(2, 4), 0.01);
  EXPECT_EQ(default_step(4, 2), 0.01);
  EXPECT_EQ(default_step(0, 0), 0);
  EXPECT_EQ(default_end(2, 3), 40);
  EXPECT_EQ(default_end(0, 3), 60);
  EXPECT_EQ(default_end(0, 0), 0);
}

TEST(SetUp, TheNaturalPeriodIsThatOfTheWellItRestsIn) {
  EXPECT_DOUBLE_EQ(natural_period({.mass = 4, .stiffness = 1}), 2 * two_pi);
  EXPECT_EQ(natural_period({.stiffness = 0, .cubic = 1}), 0);
  // k + 3 k3 x^2 at x^2 = -k/k3 is -2 k, wherever the well is.
  for (const double k3 : {1e-12, 1e-3, 1.0, 1e3})
    EXPECT_NEAR(natural_period({.stiffness = -1, .cubic = k3}) / (two_pi / std::sqrt(2)), 1, 1e-9) << k3;
  EXPECT_EQ(natural_period({.stiffness = -1, .cubic = -1}), 0);
}

TEST(SetUp, WhatSetsTheSameThingIsGivenOnce) {
  EXPECT_EQ(refused({.stiffness = 1, .natural_frequency = 1}),
            "--stiffness and --natural-frequency both set the spring; give one of them");
  const std::string damping =
      "--damping, --damping-ratio and --quality-factor all set the damping; give one of them";
  EXPECT_EQ(refused({.damping = 1, .damping_ratio = 1}), damping);
  EXPECT_EQ(refused({.damping = 1, .quality_factor = 1}), damping);
  EXPECT_EQ(refused({.damping_ratio = 1, .quality_factor = 1}), damping);
  EXPECT_EQ(refused({.step = 1, .accuracy = 0.1}),
            "--step and --accuracy both set the step; give one of them");
  EXPECT_EQ(refused({.law = {.friction = 0.5}, .static_friction = 0.5}), "");
  EXPECT_EQ(refused({.law = {.friction = 0.5}, .static_friction = 0.25}),
            "--static-friction: it must be at least --friction (0.5 N), not 0.25 N");
}

TEST(SetUp, RatiosNeedASpring) {
  EXPECT_EQ(refused({.stiffness = 0, .damping_ratio = 1}),
            "--damping-ratio: it needs a positive stiffness, not 0 N/m; give --damping instead");
  EXPECT_EQ(refused({.stiffness = -2, .quality_factor = 1}),
            "--quality-factor: it needs a positive stiffness, not -2 N/m; give --damping instead");
  EXPECT_EQ(refused({.mass = 1e300, .natural_frequency = 1e10}),
            "--natural-frequency: with this mass the stiffness or the damping is beyond the largest number");
  EXPECT_EQ(refused({.damping = -1}), "");
  EXPECT_EQ(refused({.damping = 0}), "");
  EXPECT_DOUBLE_EQ(oscillator_of({.mass = 2, .stiffness = 8, .damping_ratio = 0.25})->damping, 2);
  EXPECT_DOUBLE_EQ(oscillator_of({.mass = 2, .stiffness = 8, .quality_factor = 2})->damping, 2);
  EXPECT_DOUBLE_EQ(oscillator_of({.mass = 2, .natural_frequency = 3})->stiffness, 18);
  EXPECT_EQ(oscillator_of({})->stiffness, 1);
  EXPECT_EQ(oscillator_of({})->damping, 0);
  EXPECT_EQ(oscillator_of({.static_friction = 3})->static_friction, 3);
}

TEST(SetUp, StartsMovedOnlyWhereNothingElseMovesIt) {
  EXPECT_EQ(start_of({}), (State<double>{1, 0}));
  EXPECT_EQ(start_of({.position = 0}), (State<double>{0, 0}));
  EXPECT_EQ(start_of({.velocity = 0}), (State<double>{0, 0}));
  EXPECT_EQ(start_of({.drive_amplitude = 1}), (State<double>{0, 0}));
  EXPECT_EQ(start_of({.position = 2, .velocity = 3}), (State<double>{2, 3}));
  EXPECT_EQ(refused({.position = 1e200}),
            "--position: the energy at the start (x = 1e+200 m, v = 0 m/s) is beyond the largest number");
}

TEST(SetUp, AMethodHasItsSettingsOrTheirDefaults) {
  EXPECT_EQ(settings_of({}, "dormand-prince").newton.tolerance, StepControl::default_tolerance);
  EXPECT_EQ(settings_of({}, "implicit-euler").newton.tolerance, NewtonOptions{}.tolerance);
  EXPECT_EQ(settings_of({.tolerance = 1e-5}, "implicit-euler").newton.tolerance, 1e-5);
  const MethodSettings settings = settings_of({.beta = 0.125, .gamma = 0.75, .rho_inf = 0.5}, "newmark");
  EXPECT_EQ(settings.beta, 0.125);
  EXPECT_EQ(settings.gamma, 0.75);
  EXPECT_EQ(settings.rho_inf, 0.5);
  const auto runs = set_up_runs({.method = {"newmark"}, .tolerance = 1e-6, .compensated = false});
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->front().tolerance, 1e-6);
}

TEST(SetUp, RunsAreLabelledByFrequencyWhereTheyDiffer) {
  const auto labels = [](const SimulateOptions& options) {
    std::vector<std::string> all;
    const auto runs = set_up_runs(options);
    for (const SimulatedRun& run : *runs) all.push_back(run.label);
    return all;
  };
  EXPECT_THAT(labels({.drive_amplitude = 1, .drive_frequency = {2}, .method = {"rk4"}}), ElementsAre("rk4"));
  EXPECT_THAT(labels({.drive_amplitude = 1, .drive_frequency = {2, 0.5}, .method = {"rk4", "exact"}}),
              ElementsAre("rk4, 2 rad/s", "rk4, 0.5 rad/s", "exact, 2 rad/s", "exact, 0.5 rad/s"));
}

TEST(SetUp, WithoutAPeriodStepAndEndAreAskedFor) {
  const std::string law = "this law has no natural period (stiffness 0 N/m) and no periodic drive: give ";
  EXPECT_EQ(refused({.stiffness = 0}), law + "--step and --until");
  EXPECT_EQ(refused({.stiffness = 0, .step = 1}), law + "--until");
  EXPECT_EQ(refused({.stiffness = 0, .until = 1}), law + "--step");
  EXPECT_EQ(refused({.stiffness = 0, .step = 1, .until = 1}), "");
  EXPECT_EQ(refused({.stiffness = 0, .law = {.drag = 1, .cubic = 2}}),
            "this law has no natural period (stiffness 0 N/m, cubic 2 N/m^3) and no periodic drive: give "
            "--step and "
            "--until");
  EXPECT_EQ(refused({.stiffness = 0, .drive_amplitude = 1, .drive_frequency = {2}}), "");
}

TEST(SetUp, ExactHasAClosedFormOrSaysWhyNot) {
  EXPECT_EQ(refused({.law = {.drag = 2}, .method = {"exact"}}),
            "--method exact: there is no closed form with drag (2 kg/m); leave it out or choose another "
            "method, for "
            "instance rk4 with a short step");
  EXPECT_EQ(refused({.law = {.friction = 2}, .method = {"exact"}}), "");
  EXPECT_EQ(
      refused({.law = {.friction = 2}, .drive_amplitude = 1, .drive_frequency = {2}, .method = {"exact"}}),
      "--method exact: with friction (2 N) there is no closed form under a drive; leave one of them out or "
      "choose another method, for instance dormand-prince");
  EXPECT_EQ(refused({.law = {.friction = 2}, .drive_amplitude = 1, .drive_frequency = {2}}), "");
}

TEST(SetUp, AForceWithMemoryIsNotRunWithEverything) {
  const auto with_memory = [](SimulateOptions options) {
    options.law.hysteresis_stiffness = 1;
    return refused(options);
  };
  const auto refusal = [](const std::string& other) {
    return "--hysteresis-stiffness and --" + other + " do not go together in one run; leave one of them out";
  };
  EXPECT_EQ(with_memory({}), "");
  EXPECT_EQ(with_memory({.law = {.friction = 1}}), refusal("friction"));
  EXPECT_EQ(with_memory({.static_friction = 1}), refusal("static-friction"));
  EXPECT_EQ(with_memory({.compensated = true}), refusal("compensated"));
  EXPECT_EQ(with_memory({.event = {"turning-point"}}), refusal("event"));
}

TEST(SetUp, CompensatedSumsAreOfFixedStepsThatNothingCutsShort) {
  const auto compensated = [](SimulateOptions options) {
    options.compensated = true;
    return refused(options);
  };
  EXPECT_EQ(compensated({}), "");
  EXPECT_EQ(
      compensated({.method = {"dormand-prince"}}),
      "--compensated: dormand-prince chooses its own steps, whose errors are larger than those of the sums; "
      "leave it out or choose another method, for instance euler-cromer");
  EXPECT_EQ(compensated({.method = {"exact"}}),
            "--compensated: exact adds nothing up, it takes each state from the closed form; leave it out or "
            "choose "
            "another method, for instance euler-cromer");
  EXPECT_EQ(compensated({.law = {.friction = 0.5}, .static_friction = 2}),
            "--compensated: with --friction (2 N) steps end where the mass stops; leave one of them out");
  EXPECT_EQ(compensated({.drive = "step", .drive_amplitude = 1}),
            "--compensated: under step steps end where the drive jumps or bends; leave one of them out");
  EXPECT_EQ(compensated({.event = {"turning-point", "position=1"}}),
            "--compensated: --event \"turning-point\" is looked for in ordinary sums; leave one of them out");
}

TEST(SetUp, StatesFitIntoTheMemory) {
  // 11 states of three numbers, of eight bytes each; with a sensor of four.
  SimulateOptions options{.step = 0.125, .until = 1.25, .memory = 264};
  EXPECT_EQ(refused(options), "");
  options.memory = 263;
  EXPECT_EQ(
      refused(options),
      "--step: keeping 11 states needs 264 bytes of memory, but there are only 263 bytes; take a longer "
      "--step, a shorter --until, or keep every Nth state with --every N");
  options.every = 2;
  EXPECT_EQ(refused(options), "");
  options.every = 1;
  options.sensor.used = true;
  options.memory = 351;
  EXPECT_NE(refused(options), "");
  options.memory = 352;
  EXPECT_EQ(refused(options), "");
  options.method = {"rk4", "exact"};
  options.memory = 703;
  EXPECT_NE(refused(options), "");
  options.memory = 704;
  EXPECT_EQ(refused(options), "");
  EXPECT_EQ(
      refused({.step = 0.5, .until = 4503599627370496.0}),
      "--step: 0.5 s up to 4503599627370496 s are 9.01e+15 steps, too many to be told apart; take a longer "
      "step");
}

TEST(SetUp, WarnsOfStatesTooFarApartToShowTheSwing) {
  const double period = two_pi;  // of 1 kg on 1 N/m
  EXPECT_THAT(
      warned({.method = {"exact"}, .step = 0.9 * period, .until = 45 * period}),
      ElementsAre(
          "a state every 5.655 s is less than two in a period of 6.283 s: drawn, they show a "
          "slower swing that is not there; a shorter --step or a smaller --every shows the real one"));
  EXPECT_THAT(warned({.method = {"exact"}, .step = 0.49 * period, .until = 49 * period}), IsEmpty());
  EXPECT_THAT(warned({.method = {"exact"}, .step = 0.1 * period, .until = 50 * period, .every = 9}),
              SizeIs(1));
  // Start and end alone are asked for; a drive swings as well; what creeps back does not.
  EXPECT_THAT(warned({.method = {"exact"}, .step = 0.1 * period, .until = 50 * period, .every = 500}),
              IsEmpty());
  EXPECT_THAT(
      warned({.drive_amplitude = 1, .drive_frequency = {9}, .method = {"exact"}, .step = 0.4, .until = 40}),
      SizeIs(1));
  EXPECT_THAT(warned({.damping = 3, .method = {"exact"}, .step = 6, .until = 60}), IsEmpty());
}

TEST(SetUp, WarnsOfWhatHasNoEffectWordForWord) {
  EXPECT_THAT(warned({}), IsEmpty());
  EXPECT_THAT(warned({.drive_frequency = {1}}),
              ElementsAre("--drive-frequency has no effect without a --drive-amplitude"));
  EXPECT_THAT(warned({.drive_amplitude = 1, .drive_frequency = {2}}), IsEmpty());
  EXPECT_THAT(warned({.method = {"rk4", "exact", "rk4"}, .tolerance = 1e-9}),
              ElementsAre("--tolerance has no effect on rk4", "--tolerance has no effect on exact"));
  for (const char* uses : {"dormand-prince", "implicit-euler", "verlet", "newmark", "generalized-alpha"})
    EXPECT_THAT(warned({.method = {uses}, .tolerance = 1e-9}), IsEmpty()) << uses;
  EXPECT_THAT(warned({.method = {"rk4"}, .beta = 0.25}), ElementsAre("--beta has no effect on rk4"));
  EXPECT_THAT(warned({.method = {"rk4"}, .gamma = 0.5}), ElementsAre("--gamma has no effect on rk4"));
  EXPECT_THAT(warned({.method = {"newmark"}, .beta = 0.25, .gamma = 0.5}), IsEmpty());
  EXPECT_THAT(warned({.method = {"newmark"}, .rho_inf = 0.5}),
              ElementsAre("--rho-inf has no effect on newmark"));
  EXPECT_THAT(warned({.method = {"generalized-alpha"}, .rho_inf = 0.5}), IsEmpty());
  EXPECT_THAT(warned({.step = 0.25, .until = 1.125}),
              ElementsAre("1.125 s are not a whole number of steps of 0.25 s: the last step is 0.125 s"));
  EXPECT_THAT(warned({.step = 0.25, .until = 1}), IsEmpty());
  EXPECT_THAT(warned({.until = 1}), IsEmpty());
  EXPECT_THAT(warned({.step = 0.01}), IsEmpty());
  SimulateOptions memory;
  memory.law.hysteresis_exponent = 2;
  EXPECT_THAT(warned(memory),
              ElementsAre("--hysteresis-exponent has no effect without --hysteresis-stiffness"));
  memory.law.hysteresis_stiffness = 1;
  EXPECT_THAT(warned(memory), IsEmpty());
  SimulateOptions late{.drive = "step", .drive_amplitude = 1, .drive_start = 2, .step = 0.5, .until = 2};
  EXPECT_THAT(warned(late), ElementsAre("--drive-start: the drive begins at 2 s, and the run ends at 2 s"));
  late.drive_start = 1.5;
  EXPECT_THAT(warned(late), IsEmpty());
}

TEST(SetUp, ARecordedDriveDividesItsSpacing) {
  SimulateOptions options{.drive_file = "f.csv"};
  options.drive_record =
      DriveRecord{{0, 1, 0, 0, 0}, 0.5, {Notice{"careful"}, Notice{"careful"}, Notice{"twice"}}};
  // 2 pi/200 into 0.5 s: 16 steps.
  SimulatedRun run = set_up_runs(options)->front();
  EXPECT_DOUBLE_EQ(run.step, 0.5 / 16);
  EXPECT_DOUBLE_EQ(run.until, 2);
  EXPECT_THAT(warned(options), ElementsAre("careful", "twice"));
  options.stiffness = 0;
  EXPECT_EQ(set_up_runs(options)->front().step, 0.5);
  options.step = 0.25;
  options.until = 1;
  EXPECT_EQ(set_up_runs(options)->front().step, 0.25);
  EXPECT_EQ(set_up_runs(options)->front().until, 1);
}

TEST(SetUp, MethodsAndEventsAreKnown) {
  EXPECT_THAT(refused({.method = {"rk4", "rk5"}}), StartsWith("--method: "));
  EXPECT_THAT(refused({.event = {"turning-point", "noon"}}), StartsWith("--event \"noon\": "));
  EXPECT_EQ(set_up_runs({.event = {"turning-point", "position=1"}})->front().events.events.size(), 2u);
}

// Each option of simulate at the ends of its range: what the table says, not what ranges are.
TEST(SetUp, EveryOptionKeepsToItsRange) {
  SimulateOptions options;
  const auto table = options_of(options);
  const auto takes = [&](std::string_view name, const char* text) {
    for (const Option& option : table)
      if (option.name == name) return assign(option, text).ok();
    ADD_FAILURE() << name;
    return false;
  };
  for (const char* name : {"mass", "natural-frequency", "quality-factor", "drive-duration", "unbalance-mass",
                           "eccentricity", "base-displacement", "step", "until", "every", "rate"}) {
    EXPECT_TRUE(takes(name, "1")) << name;
    EXPECT_FALSE(takes(name, "0")) << name;
    EXPECT_FALSE(takes(name, "-1")) << name;
  }
  for (const char* name : {"damping-ratio", "drive-amplitude", "drive-frequency", "drive-to", "drive-start",
                           "sensor-noise", "sensor-resolution", "friction", "static-friction", "drag"}) {
    EXPECT_TRUE(takes(name, "0")) << name;
    EXPECT_FALSE(takes(name, "-1")) << name;
  }
  for (const char* name :
       {"position", "velocity", "drive-phase", "sensor-offset", "stiffness", "cubic", "damping"}) {
    EXPECT_TRUE(takes(name, "-1")) << name;
    EXPECT_FALSE(takes(name, "inf")) << name;
  }
  for (const char* name : {"beta", "gamma", "rho-inf"}) {
    EXPECT_TRUE(takes(name, "0") && takes(name, "1")) << name;
    EXPECT_FALSE(takes(name, "-0.1") || takes(name, "1.1")) << name;
  }
  EXPECT_TRUE(takes("tolerance", "1e-15") && takes("tolerance", "0.01"));
  EXPECT_FALSE(takes("tolerance", "1e-16") || takes("tolerance", "0.02"));
  EXPECT_TRUE(takes("accuracy", "1e-9") && takes("accuracy", "50 %"));
  EXPECT_FALSE(takes("accuracy", "1e-10") || takes("accuracy", "51 %"));
  EXPECT_TRUE(takes("hysteresis-exponent", "1"));
  EXPECT_FALSE(takes("hysteresis-exponent", "0.9"));
  for (const char* of_sensor : {"sensor-noise", "sensor-resolution", "sensor-offset", "seed"}) {
    options.sensor.used = false;
    EXPECT_TRUE(takes(of_sensor, "1"));
    EXPECT_TRUE(options.sensor.used) << of_sensor;
  }
}

TEST(EventOption, IsAThresholdADirectionAndAStop) {
  const Event event = *parse_event("position=1 cm:falling:stop");
  EXPECT_EQ(event.quantity, Event::Quantity::position);
  EXPECT_DOUBLE_EQ(event.value, 0.01);
  EXPECT_EQ(event.crossing, Crossing::falling);
  EXPECT_TRUE(event.stop);
  const Event turning = *parse_event("turning-point");
  EXPECT_EQ(turning.quantity, Event::Quantity::velocity);
  EXPECT_EQ(turning.value, 0);
  EXPECT_EQ(turning.crossing, Crossing::any);
  EXPECT_FALSE(turning.stop);
  EXPECT_EQ(parse_event("velocity=-0.2:rising")->value, -0.2);
}

TEST(EventOption, RefusesWhatItCannotWatch) {
  const auto refusal = [](const char* text) {
    const auto event = parse_event(text);
    return event.ok() ? std::string() : in_words(event.error());
  };
  EXPECT_THAT(refusal(""), HasSubstr("--event"));
  EXPECT_THAT(refusal("speed=1"), HasSubstr("\"speed\""));
  EXPECT_THAT(refusal("position"), HasSubstr("value is missing"));
  EXPECT_THAT(refusal("turning-point=0"), HasSubstr("no value"));
  EXPECT_THAT(refusal("position=1 kg"), HasSubstr("length"));
  EXPECT_THAT(refusal("position=1:up"), HasSubstr("\"up\""));
  EXPECT_THAT(refusal("position=1:rising:falling"), HasSubstr("only one"));
}

TEST(EventOption, ARunReportsItsEventsAndStopsWhenAsked) {
  const auto result = simulate({.stiffness = 9,
                                .method = {"exact", "dormand-prince", "rk4"},
                                .step = 0.01,
                                .until = 10,
                                .tolerance = 1e-12,
                                .event = {"position=0", "turning-point:rising:stop"}});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->ok()) << "a stop that was asked for is a success";
  for (const SimulatedRun& run : result->runs) {
    EXPECT_EQ(run.outcome.status, Status::stopped_by_event);
    EXPECT_TRUE(run.message.empty());
    EXPECT_NEAR(run.outcome.t, 1.0471975511965976, 1e-7) << run.method;
    ASSERT_EQ(run.events.found.size(), 2u);
    EXPECT_EQ(run.events.found[0].event, 0u);
    EXPECT_EQ(run.trajectory.t.back(), run.outcome.t);
  }
}

TEST(EventOption, FrictionNeedsNoSmallerStaticFriction) {
  const auto refused = simulate({.law = {.friction = 0.2}, .static_friction = 0.1});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()),
              HasSubstr("--static-friction: it must be at least --friction (0.2 N)"));
  const auto held = simulate({.law = {.friction = 0.1}, .static_friction = 1.1, .method = {"rk4", "exact"}});
  ASSERT_TRUE(held.ok());
  for (const SimulatedRun& run : held->runs) EXPECT_EQ(run.outcome.y, (State<double>{1, 0}));
  const auto driven =
      simulate({.law = {.friction = 0.1}, .drive_amplitude = 1, .drive_frequency = {2}, .method = {"exact"}});
  ASSERT_FALSE(driven.ok());
  EXPECT_THAT(in_words(driven.error()), HasSubstr("friction"));
  EXPECT_THAT(in_words(driven.error()), HasSubstr("drive"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
