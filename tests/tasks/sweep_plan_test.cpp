// The plan of a sweep, and every refusal word for word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/sweep/sweep_rows.h"
#include "tests/tasks/sweep_options.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Why it is not planned; "" if it is.
std::string refused(const SweepOptions& options) {
  const auto plan = plan_sweep(options);
  return plan ? "" : in_words(plan.error());
}

SweepPlan planned(const SweepOptions& options) {
  auto plan = plan_sweep(options);
  EXPECT_TRUE(plan) << (plan ? "" : in_words(plan.error()));
  return plan ? *std::move(plan) : SweepPlan{};
}

std::vector<std::string> names(const SweepPlan& plan) {
  std::vector<std::string> all;
  for (const SweptOption& swept : plan.swept) all.push_back(swept.name);
  return all;
}

const Values harmonic{{"damping", "0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "1:3:3"}};

TEST(SweepPlan, TheFrequencyRunsFastestAndSettingsOfTheMethodSlowest) {
  const Values grids{{"step", "0.01,0.02"},
                     {"drive-amplitude", "1,2"},
                     {"damping", "0.1,0.2"},
                     {"drive-frequency", "1,2,3"},
                     {"beta", "0.25,0.3"}};
  SweepOptions options = options_with(grids, "newmark");
  EXPECT_THAT(names(planned(options)),
              ElementsAre("beta", "damping", "drive-amplitude", "step", "drive-frequency"));
  EXPECT_EQ(planned(options).rows.rows, 48u);
  EXPECT_THAT(planned(options).rows.columns,
              ElementsAre("beta", "damping (kg/s)", "drive_amplitude (N)", "step (s)",
                          "drive_frequency (rad/s)", "amplitude (m)", "phase (rad)", "status"));
  EXPECT_THAT(planned(options).measured, ElementsAre("amplitude (m)", "phase (rad)"));
  const Values amplitudes{
      {"drive-amplitude", "1,2"}, {"damping", "0.1,0.2"}, {"drive-frequency", "1"}, {"step", "0.01,0.02"}};
  options = options_with(amplitudes, "rk4");
  EXPECT_THAT(names(planned(options)), ElementsAre("damping", "drive-amplitude", "step"));
  options.direction = "up";
  EXPECT_THAT(names(planned(options)), ElementsAre("damping", "step", "drive-amplitude"));
  options.direction = "both";
  EXPECT_THAT(names(planned(options)), ElementsAre("direction", "damping", "step", "drive-amplitude"));
  EXPECT_EQ(planned(options).rows.rows, 16u);
}

TEST(SweepPlan, WithoutAGridTheFrequencyIsAGridOfOne) {
  EXPECT_THAT(names(planned(options_with(with(harmonic, {{"drive-frequency", "2"}})))),
              ElementsAre("drive-frequency"));
  EXPECT_THAT(names(planned(options_with({{"position", "1"}, {"stiffness", "2"}, {"damping", ""}}))),
              ElementsAre("stiffness", "position"));
  EXPECT_THAT(names(planned(options_with({{"position", "1"}, {"stiffness", "2:2:1"}}))),
              ElementsAre("stiffness"));
  EXPECT_THAT(names(planned(options_with({{"position", "1"}, {"stiffness", "2,3"}}))),
              ElementsAre("stiffness"));
  EXPECT_EQ(refused(options_with({})),
            "nothing is swept: give at least one numeric option a grid, for instance --drive-amplitude 1 "
            "--drive-frequency 0.1:10:1000, or --position 0.5,1,1.5 --until 20");
}

TEST(SweepPlan, ShowsTheUnitThatWasTyped) {
  const SweepPlan plan = planned(options_with(with(harmonic, {{"drive-frequency", "1:3:3 Hz"}})));
  EXPECT_EQ(plan.swept[0].column, "drive_frequency (rad/s)");
  EXPECT_EQ(plan.swept[0].shown, "drive_frequency (Hz)");
  EXPECT_DOUBLE_EQ(plan.swept[0].shown_unit, 2 * M_PI);
  EXPECT_EQ(plan.swept[0].points, 3u);
}

TEST(SweepPlan, EveryValueOfAGridIsLookedAt) {
  EXPECT_EQ(refused(options_with({{"position", "1,2"}, {"mass", "1,0,2"}})),
            "--mass: it must be positive, not 0 kg");
  EXPECT_EQ(refused(options_with({{"position", "1,2"}, {"mass", "1,2,-1"}})),
            "--mass: it must be positive, not -1 kg");
  EXPECT_EQ(refused(options_with({{"position", "1,2"}, {"mass", "-1,2,1"}})),
            "--mass: it must be positive, not -1 kg");
  EXPECT_THAT(refused(options_with({{"mass", "1,heavy"}})), StartsWith("--mass: "));
  EXPECT_EQ(refused(options_with({{"stiffness", "1,-1"}, {"damping-ratio", "0.1,0.2"}})),
            "--stiffness -1 N/m: --damping-ratio: it needs a positive stiffness, not -1 N/m; give --damping "
            "instead");
  EXPECT_THAT(refused(options_with({{"step", "1:2:100000000"}, {"mass", "1:2:100000000"}})),
              StartsWith("the grids multiply to 1e+16 points, too many to be told apart; take coarser ones"));
}

TEST(SweepPlan, PointsFollowEachOtherAlongTheDrive) {
  SweepOptions options = options_with(harmonic, "rk4");
  options.direction = "sideways";
  EXPECT_EQ(refused(options), "--direction: \"sideways\" is none of up, down and both");
  for (const char* direction : {"up", "down", "both"}) {
    options.direction = direction;
    EXPECT_EQ(refused(options), "") << direction;
  }
  SweepOptions neither =
      options_with({{"damping", "0.1,0.2"}, {"drive-amplitude", "1"}, {"drive-frequency", "1"}}, "rk4");
  EXPECT_EQ(refused(neither), "");
  neither.direction = "up";
  EXPECT_EQ(refused(neither),
            "--direction: the points follow each other along --drive-frequency or --drive-amplitude, and "
            "neither has "
            "a grid");
  options.simulate.method = {"dormand-prince"};
  EXPECT_EQ(
      refused(options),
      "--direction: with dormand-prince each point is a run of its own; take a method of fixed steps, for "
      "instance rk4, and no friction");
  options = options_with(with(harmonic, {{"friction", "0.1"}}), "rk4");
  options.direction = "up";
  EXPECT_EQ(
      refused(options),
      "--direction: with friction each point is a run of its own; take a method of fixed steps, for instance "
      "rk4, and no friction");
  options = options_with(with(harmonic, {{"until", "5"}}), "rk4");
  options.measure = {"peak"};
  EXPECT_EQ(refused(options), "");
  options.direction = "up";
  EXPECT_EQ(refused(options),
            "--direction: points follow each other where the motion has settled; leave --until out");
}

TEST(SweepPlan, ARunToItsEndIsNotSettled) {
  SweepOptions options = options_with(with(harmonic, {{"until", "5"}}), "rk4");
  EXPECT_EQ(
      refused(options),
      "--until: amplitude belongs to the settled motion, which has no end; leave --until out, or measure "
      "peak, final or energy");
  options.measure = {"peak"};
  options.settle = 3;
  EXPECT_EQ(refused(options), "--settle: a run to its end drops no cycles; leave --settle or --until out");
}

TEST(SweepPlan, WhatStandsStillNeverSettles) {
  EXPECT_EQ(refused(options_with(with(harmonic, {{"drive-frequency", "0:2:3"}}))),
            "--drive-frequency: at 0 nothing swings, so nothing settles; begin above it");
  EXPECT_EQ(refused(options_with(with(harmonic, {{"drive-amplitude", "1,0"}}))),
            "--drive-amplitude: at 0 nothing swings, so nothing settles; begin above it");
  SweepOptions to_end = options_with(with(harmonic, {{"drive-frequency", "0:2:3"}, {"until", "5"}}), "rk4");
  to_end.measure = {"peak"};
  EXPECT_EQ(refused(to_end), "");
}

TEST(SweepPlan, HasOneMethodAndADriveThatGoesOn) {
  SweepOptions options = options_with(harmonic);
  options.simulate.method = {"rk4", "verlet", "exact"};
  EXPECT_EQ(refused(options), "--method: a sweep uses one method, not 3; run it once for each");
  EXPECT_EQ(planned(options_with(harmonic)).method, "euler-cromer");
  options = options_with({{"drive-amplitude", "1,2"}}, "rk4");
  options.simulate.drive = "step";
  EXPECT_EQ(refused(options),
            "--drive step: a sweep takes drives that go on: harmonic, unbalance or base; run the others with "
            "simulate");
}

TEST(SweepPlan, TakesTheShortestWayThereIs) {
  const auto way = [](SweepOptions options) { return in_words(planned(options).way); };
  SweepOptions options = options_with(harmonic, "rk4");
  EXPECT_EQ(way(options), "closed form");
  EXPECT_EQ(way(options_with(harmonic, "exact")), "closed form");
  EXPECT_EQ(way(options_with(harmonic, "dormand-prince")), "run one by one");
  EXPECT_EQ(way(options_with(with(harmonic, {{"cubic", "1"}}), "rk4")), "stepped until settled");
  EXPECT_EQ(way(options_with(with(harmonic, {{"cubic", "0,1"}}), "rk4")), "stepped until settled");
  EXPECT_EQ(way(options_with(with(harmonic, {{"friction", "1"}}), "rk4")), "run one by one");
  EXPECT_EQ(way(options_with(with(harmonic, {{"static-friction", "0.1,1"}}), "rk4")), "run one by one");
  EXPECT_EQ(way(options_with(with(harmonic, {{"stiffness", "0"}, {"step", "0.01"}}), "rk4")),
            "stepped until settled");
  options.settle = 2.5;
  EXPECT_EQ(way(options), "stepped, 2.5 cycles dropped");
  options.settle.reset();
  options.direction = "up";
  EXPECT_EQ(way(options), "stepped until settled");
  options.direction = "";
  options.measure = {"final"};
  EXPECT_EQ(way(options), "stepped until settled");
  options = options_with({{"position", "1,2"}}, "rk4");
  EXPECT_EQ(way(options), "stepped to the end");
  options.simulate.method = {"exact"};
  EXPECT_EQ(way(options), "run one by one");
}

TEST(SweepPlan, SaysHowLongStepsAndRunsAreWordForWord) {
  const auto steps = [](Values values, const char* method) {
    return in_words(planned(options_with(values, method)).steps);
  };
  EXPECT_EQ(steps(harmonic, "rk4"), "200 steps in a natural or a drive period, whichever is shorter");
  EXPECT_EQ(steps(harmonic, "exact"), "");
  EXPECT_EQ(steps(harmonic, "dormand-prince"), "");
  EXPECT_EQ(steps(with(harmonic, {{"step", "0.25"}}), "rk4"), "steps of 0.25 s");
  EXPECT_EQ(steps(with(harmonic, {{"step", "0.01,0.02"}}), "rk4"), "");
  EXPECT_EQ(steps({{"position", "1,2"}}, "rk4"), "200 steps in a natural period, for 20 natural periods");
  EXPECT_EQ(steps({{"position", "1,2"}, {"until", "5"}, {"step", "0.5"}}, "rk4"), "steps of 0.5 s, to 5 s");
  EXPECT_EQ(steps({{"position", "1,2"}, {"until", "5,6"}}, "rk4"), "200 steps in a natural period");
}

TEST(SweepPlan, DescribesAllThatRowsDependOn) {
  SweepOptions options = options_with(with(harmonic, {{"damping", ""}}), "newmark");
  options.simulate.beta = 0.3;
  options.settle = 2;
  const SweepPlan plan = planned(options);
  EXPECT_EQ(
      plan.rows.description,
      "{\"method\": \"newmark\", \"way\": \"stepped until settled\", \"direction\": \"\", \"simd\": \"" +
          plan.simd +
          "\", \"settle\": 2, \"tolerance\": 1e-12, \"beta\": 0.3, \"gamma\": 0.5, \"rho_inf\": 0.8, "
          "\"steps_per_period\": 200, \"drive-amplitude\": \"1\", \"drive-frequency\": \"1:3:3\", "
          "\"columns\": [\"drive_frequency (rad/s)\", \"amplitude (m)\", \"phase (rad)\", \"status\"]}");
  options = options_with(with(harmonic, {{"step", "0.5"}}), "exact");
  EXPECT_THAT(planned(options).rows.description, Not(HasSubstr("simd")));
  EXPECT_THAT(planned(options).rows.description, Not(HasSubstr("steps_per_period")));
  EXPECT_THAT(planned(options_with({{"position", "1,2"}}, "rk4")).rows.description,
              HasSubstr("\"periods\": 20"));
  EXPECT_THAT(planned(options_with({{"position", "1,2"}, {"until", "1"}}, "rk4")).rows.description,
              Not(HasSubstr("periods\": 20")));
}

TEST(SweepPlan, SaysWhyThereIsNothingToCheck) {
  const auto none = [](SweepOptions options) {
    options.check = true;
    std::string said;
    for (const std::string& notice : in_words(planned(options).notices))
      if (notice.starts_with("--check: ")) said = notice.substr(9);
    return said;
  };
  const std::string no_form = "there is no closed form to check at any point: ";
  SweepOptions options = options_with(harmonic, "rk4");
  EXPECT_EQ(none(options), "");
  EXPECT_EQ(
      none(options_with(harmonic, "exact")),
      "exact is the closed form of the law itself and takes no steps to check it by; take another method");
  options.settle = 1;
  EXPECT_EQ(none(options), no_form + "--settle asks for stepping");
  options.direction = "up";
  EXPECT_EQ(none(options), no_form + "with --direction each starts where the one before ended");
  EXPECT_EQ(none(options_with({{"position", "1,2"}}, "rk4")),
            no_form + "they are stepped to an end, not settled under a drive");
  options = options_with(harmonic, "rk4");
  options.measure = {"amplitude", "final"};
  EXPECT_EQ(none(options), no_form + "final comes from stepping alone");
  EXPECT_EQ(none(options_with(harmonic, "dormand-prince")), no_form + "dormand-prince chooses its own steps");
  EXPECT_EQ(none(options_with(with(harmonic, {{"cubic", "1"}}), "rk4")), no_form + "the law is not linear");
}

TEST(SweepPlan, WarnsOfADriveThatTheStepsHardlySee) {
  const auto notices = [](const char* frequencies, const char* method) {
    return in_words(
        planned(options_with(with(harmonic, {{"drive-frequency", frequencies}, {"step", "0.1"}}), method))
            .notices);
  };
  // 2 pi/w over 0.1 s is ten at 6.283 rad/s.
  EXPECT_THAT(notices("1,6.28", "rk4"), IsEmpty());
  EXPECT_THAT(notices("6.3,1", "rk4"),
              ElementsAre("--step: at an end of the grid a cycle of the drive has only 10 steps: the result "
                          "there is the method's, not the law's"));
  EXPECT_THAT(notices("1,20,3", "rk4"), Contains(HasSubstr("has only 3.1 steps")));
  EXPECT_THAT(notices("1,20", "exact"), IsEmpty());
  // Steps that do not fill a run are cut at its end in any sweep.
  EXPECT_THAT(
      in_words(planned(options_with({{"position", "1,2"}, {"until", "1"}, {"step", "0.3"}}, "rk4")).notices),
      IsEmpty());
}

TEST(SweepPlan, MeasuresAreKnownOnceAndFitTheMotion) {
  SweepOptions options = options_with(harmonic, "rk4");
  options.measure = {" amplitude , final", "rms"};
  EXPECT_THAT(planned(options).measured, ElementsAre("amplitude (m)", "x (m)", "v (m/s)", "rms (m)"));
  const std::string all = " (amplitude, phase, peak, final, mean, rms, energy, transmissibility)";
  options.measure = {"amplitud"};
  EXPECT_EQ(refused(options), "--measure: there is no measure \"amplitud\"; did you mean amplitude?" + all);
  options.measure = {"zzzzzzzzzzz"};
  EXPECT_EQ(refused(options), "--measure: there is no measure \"zzzzzzzzzzz\"" + all);
  options.measure = {"peak,rms", "peak"};
  EXPECT_EQ(refused(options), "--measure: peak is asked for twice");
  EXPECT_THAT(planned(options_with({{"position", "1,2"}}, "rk4")).measured,
              ElementsAre("peak (m)", "x (m)", "v (m/s)", "energy (J)"));
  options = options_with({{"position", "1,2"}}, "rk4");
  for (const char* settled : {"amplitude", "phase", "mean", "rms"}) {
    options.measure = {settled};
    EXPECT_EQ(refused(options),
              std::string("--measure ") + settled +
                  ": without a drive the motion dies away; measure peak, final or energy, or give "
                  "--drive-amplitude and --drive-frequency");
  }
}

TEST(SweepPlan, ALossFactorIsOfSettledLinearMotion) {
  const auto lossy = [](const Values& more, const char* method = "") {
    return options_with(
        with({{"loss-factor", "0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "1:3:3"}}, more), method);
  };
  const auto refusal_of = [](const std::string& other) {
    return "--loss-factor is for the settled motion of a linear law, in closed form; leave --" + other +
           " out";
  };
  EXPECT_EQ(planned(lossy({})).method, "exact");
  for (const char* other : {"damping", "damping-ratio", "quality-factor", "static-friction", "until",
                            "friction", "drag", "cubic"})
    EXPECT_EQ(refused(lossy({{other, "1"}})), refusal_of(other)) << other;
  EXPECT_EQ(refused(lossy({{"damping", ""}})), "");
  SweepOptions options = lossy({});
  options.settle = 1;
  EXPECT_EQ(refused(options), refusal_of("settle"));
  options = lossy({});
  options.direction = "up";
  EXPECT_EQ(refused(options), refusal_of("direction"));
  options = lossy({});
  options.check = true;
  EXPECT_EQ(refused(options), refusal_of("check"));
  EXPECT_EQ(refused(lossy({}, "rk4")),
            "--loss-factor has no law in time that rk4 could step; leave --method out");
  EXPECT_EQ(refused(options_with({{"loss-factor", "0.1"}})),
            "--loss-factor: nothing drives the motion; give --drive-amplitude and --drive-frequency");
  options = lossy({});
  options.measure = {"final"};
  EXPECT_EQ(refused(options), "--loss-factor is for the settled motion; --measure final looks at another");
  EXPECT_EQ(refused(lossy({{"loss-factor", "-0.1"}})), "--loss-factor: it must not be negative, not -0.1");
}

TEST(SweepRefusal, SaysWhatASweepDoesNotTake) {
  const auto said = [](std::string_view option, std::string_view text = "") {
    return in_words(sweep_refusal(option, text));
  };
  const std::string ends =
      "a sweep takes drives that go on (harmonic, unbalance, base); run pulses and chirps with simulate";
  for (const std::string option : {"drive-to", "drive-start", "drive-duration"})
    EXPECT_EQ(said(option), "--" + option + ": " + ends);
  for (const std::string option : {"drive-file", "base-motion", "drive-column", "between-samples"})
    EXPECT_EQ(
        said(option),
        "--" + option +
            ": a sweep takes drives that go on (harmonic, unbalance, base); run recorded ones with simulate");
  for (const std::string option : {"sensor-noise", "sensor-resolution", "sensor-offset", "seed"})
    EXPECT_EQ(
        said(option),
        "--" + option +
            ": a sweep measures the motion itself, not a sensor's samples; leave it out, or take simulate");
  for (const std::string option :
       {"hysteresis-stiffness", "hysteresis-beta", "hysteresis-gamma", "hysteresis-exponent"})
    EXPECT_EQ(said(option), "--" + option +
                                ": a sweep steps position and velocity alone, not a force with "
                                "memory; run it with simulate, once "
                                "for each value");
  EXPECT_EQ(said("settle", "1:2:3"),
            "--settle: \"1:2:3\" looks like a grid, but this is one number for all points; it says how they "
            "are found, not what they are");
  EXPECT_EQ(said("threads", "1,2"),
            "--threads: \"1,2\" looks like a grid, but this is one number for all points");
  EXPECT_EQ(said("threads", "12"), "");
  EXPECT_EQ(said("measure", "peak,final"), "");
  EXPECT_EQ(said("mass", "1,2"), "");
  SweepOptions options;
  std::vector<std::string> taken;
  for (const Option& option : options_of(options)) {
    EXPECT_EQ(said(option.name), "") << option.name;
    if (!option.is_text() || option.name == "drive") taken.emplace_back(option.name);
  }
  EXPECT_THAT(taken, ElementsAre("drive", "settle", "threads", "check"));
}

/// A sweep of four points over the amplitude and three measures, of which the second is the lag.
SweepPlan counted() {
  SweepPlan plan;
  plan.swept.resize(1);
  plan.rows.columns = {"drive_amplitude (N)", "x (m)", "v (m/s)", "phase (rad)", "peak (m)", "status"};
  plan.rows.rows = 20;
  auto work = std::make_shared<SweepWork>();
  work->driven = true;
  work->measures = *find_measures({"final,phase,peak"}, true);
  plan.work = work;
  return plan;
}

TEST(SweepCounts, CountsEachStatusAndTheWorstLag) {
  const SweepPlan plan = counted();
  SweepCounts counts;
  const auto count = [&](std::uint64_t row, PointStatus status, double lag) {
    const double made[] = {1, 9, 9, lag, 9, static_cast<double>(status)};
    count_row(plan, row, made, counts);
  };
  count(0, PointStatus::done, 0);
  count(1, PointStatus::not_settled, M_PI);
  count(2, PointStatus::not_finite, 1);
  count(3, PointStatus::not_finite, std::nan(""));
  count(4, PointStatus::no_convergence, -0.9e-12);
  for (const std::uint64_t row : {5u, 6u, 7u}) count(row, PointStatus::unstable, 1);
  EXPECT_EQ(counts.phase_outside, 0u);
  EXPECT_EQ(counts.first_own_damping, SweepCounts::none);
  EXPECT_EQ(counts.phase_worst, SweepCounts::none);
  EXPECT_FALSE(counts.ok());
  count(10, PointStatus::own_damping, -0.25);
  EXPECT_EQ(counts.phase_worst, 10u);
  count(9, PointStatus::own_damping, -0.25);
  EXPECT_EQ(counts.phase_worst, 9u);
  count(11, PointStatus::own_damping, -0.25);
  EXPECT_EQ(counts.phase_worst, 9u);
  count(12, PointStatus::done, M_PI + 0.125);
  EXPECT_EQ(counts.phase_worst, 9u);
  EXPECT_EQ(counts.phase_excess, 0.25);
  count(13, PointStatus::done, M_PI + 0.5);
  EXPECT_EQ(counts.phase_worst, 13u);
  EXPECT_NEAR(counts.phase_excess, 0.5, 1e-15);
  EXPECT_EQ(counts.phase_outside, 5u);
  EXPECT_EQ(counts.done, 3u);
  EXPECT_EQ(counts.not_settled, 1u);
  EXPECT_EQ(counts.not_finite, 2u);
  EXPECT_EQ(counts.no_convergence, 1u);
  EXPECT_EQ(counts.unstable, 3u);
  EXPECT_EQ(counts.own_damping, 3u);
  EXPECT_EQ(counts.first_own_damping, 9u);
  EXPECT_EQ(counts.with_numbers(), 6u);
  SweepResult result;
  result.plan = plan;
  result.counts = counts;
  EXPECT_EQ(status_counts(result),
            "20 points: 3 settled, 3 settled_by_own_damping, 1 not_settled, 3 unstable, 2 not_finite, 1 "
            "no_convergence, 7 not_reached");
  result.counts = {};
  result.counts.not_settled = 20;
  EXPECT_EQ(status_counts(result), "20 points: 20 not_settled");
}

TEST(SweepCounts, AreFineWhereNothingFailed) {
  EXPECT_TRUE(SweepCounts{.not_settled = 3}.ok());
  EXPECT_FALSE(SweepCounts{.not_finite = 1}.ok());
  EXPECT_FALSE(SweepCounts{.no_convergence = 1}.ok());
  EXPECT_FALSE(SweepCounts{.unstable = 1}.ok());
}

TEST(SweepCounts, AStatusIsAWord) {
  SweepPlan plan = counted();
  const auto done = static_cast<unsigned char>(PointStatus::done);
  EXPECT_EQ(status_word(plan, done), "settled");
  EXPECT_EQ(status_word(plan, SweepResult::not_reached), "not_reached");
  auto work = std::make_shared<SweepWork>(*plan.work);
  work->settling.dropped = 2;
  plan.work = work;
  EXPECT_EQ(status_word(plan, done), "measured");
  work->base.until = 5;
  EXPECT_EQ(status_word(plan, done), "reached_end");
  work->base.until.reset();
  work->driven = false;
  EXPECT_EQ(status_word(plan, done), "reached_end");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
