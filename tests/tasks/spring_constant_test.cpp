#include "cromer/tasks/fit/spring_constant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "cromer/documents/words/words.h"
#include "cromer/model/sensor.h"
#include "cromer/read/recording.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Series held(const std::vector<double>& levels, double seconds_each, double noise, std::uint64_t seed = 5) {
  Series series;
  series.column = "Position (m)";
  series.quantity = "position";
  series.rate = 100;
  NormalDeviates normal(seed);
  double before = levels.front();
  for (const double level : levels) {
    for (int i = 0; i < static_cast<int>(100 * seconds_each); ++i) {
      // The mass is hung on in the first tenth, and swings out.
      const double s = i / 100.0, rest = std::exp(-s / (0.02 * seconds_each)) * std::cos(9 * s);
      series.t.push_back(static_cast<double>(series.t.size()) / 100);
      series.y.push_back(level + (before - level) * rest + noise * normal.next());
    }
    before = level;
  }
  return series;
}

std::vector<Quantity> grams(std::initializer_list<double> values) {
  std::vector<Quantity> masses;
  for (const double value : values) masses.push_back({value / 1000, 0});
  return masses;
}

TEST(StaticStiffness, IsFoundFromThePlateausOfOneRun) {
  const double k = 3.2, g = 9.81;
  std::vector<double> levels;
  const auto masses = grams({40, 60, 80, 100});
  for (const Quantity& mass : masses) levels.push_back(0.5 - mass.value * g / k);
  const auto holds = find_holds({held(levels, 20, 1e-4)}, "hold.csv", masses);
  ASSERT_TRUE(holds.ok()) << in_words(holds.error());
  ASSERT_EQ(holds->size(), 4u);
  const auto result = static_stiffness(*holds, {g, 0});
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(result->stiffness.value, k, 4 * result->stiffness.standard_error);
  EXPECT_LT(result->stiffness.standard_error, 2e-3 * k);
}

// Lowered by hand within a second: between two samples it moves less than the noise.
TEST(StaticStiffness, AMassLoweredSlowlyIsNotHeldOnItsWay) {
  const auto masses = grams({40, 60, 80});
  const std::vector<double> levels{0.40, 0.35, 0.30};
  Series series;
  series.quantity = "position";
  series.rate = 1000;
  NormalDeviates normal(3);
  for (int i = 0; i < 30'000; ++i) {
    const double t = i / 1000.0, since = std::fmod(t, 10), down = std::min(since, 1.0);
    const auto which = static_cast<std::size_t>(t / 10);
    const double from = which == 0 ? levels[0] : levels[which - 1];
    series.t.push_back(t);
    series.y.push_back(from + (levels[which] - from) * down + 1e-4 * normal.next());
  }
  const auto holds = find_holds({series}, "hold.csv", masses);
  ASSERT_TRUE(holds.ok()) << in_words(holds.error());
  ASSERT_EQ(holds->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*holds)[i].position, levels[i], 1e-4);
}

// The way from one to the next is longer than three blocks, and less than the noise goes by in each.
TEST(StaticStiffness, ThePathsBetweenHoldsAreNoneUnderMuchNoise) {
  const auto masses = grams({50, 100, 150, 200, 250, 300, 350, 400});
  for (const double noise : {1e-3, 2e-3, 3e-3})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Series series;
      series.quantity = "position";
      series.rate = 20;
      NormalDeviates normal(seed);
      for (int i = 0; i < 20 * (8 * 3 + 7 * 1.5); ++i) {
        const double t = i / 20.0, since = std::fmod(t, 4.5);
        const double level = 0.1 + 0.041 * (std::floor(t / 4.5) + std::max(0.0, since - 3) / 1.5);
        series.t.push_back(t);
        series.y.push_back(level + noise * normal.next());
      }
      const auto holds = find_holds({series}, "hold.csv", masses);
      ASSERT_TRUE(holds.ok()) << noise << ' ' << in_words(holds.error());
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR((*holds)[i].position, 0.1 + 0.041 * static_cast<double>(i), 0.9 * noise) << noise;
        EXPECT_GE((*holds)[i].from, 4.5 * static_cast<double>(i) - 0.5);
        EXPECT_LE((*holds)[i].to, 4.5 * static_cast<double>(i) + 3.5);
      }
    }
}

TEST(StaticStiffness, ItsIntervalHoldsTheTruthAsOftenAsItSays) {
  const double k = 3.2, g = 9.81;
  const auto masses = grams({40, 60, 80, 100});
  NormalDeviates normal(11);
  int inside = 0;
  constexpr int repetitions = 2000;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<Hold> holds;
    for (const Quantity& mass : masses) {
      Hold hold;
      hold.mass = mass;
      hold.standard_error = 1e-5;  // far less than hanging the mass on again scatters
      hold.position = mass.value * g / k + 5e-4 * normal.next();
      holds.push_back(hold);
    }
    const auto result = static_stiffness(holds, {g, 0});
    inside += result->stiffness.low <= k && k <= result->stiffness.high;
  }
  EXPECT_NEAR(static_cast<double>(inside) / repetitions, 0.95, 0.015);
}

// 100 values at each level with noise of 0.2 mm; `change` is told the second and the value.
std::vector<Series> three_holds(const std::function<double(double, double)>& change) {
  std::vector<Series> runs;
  NormalDeviates normal(7);
  for (int run = 1; run <= 3; ++run) {
    Series& series = runs.emplace_back();
    series.quantity = "position";
    series.run = run;
    series.rate = 25;
    for (int i = 0; i < 100; ++i) {
      series.t.push_back(0.04 * i);
      series.y.push_back(change(0.04 * i, 0.4 - 0.02 * run + 2e-4 * normal.next()));
    }
  }
  return runs;
}

TEST(StaticStiffness, ADriftIsSaidAndInTheUncertainty) {
  const auto still =
      find_holds(three_holds([](double, double x) { return x; }), "held.csv", grams({40, 60, 80}));
  const auto drifting = find_holds(three_holds([](double t, double x) { return x - 1e-4 * t; }), "held.csv",
                                   grams({40, 60, 80}));
  ASSERT_TRUE(still && drifting);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((*still)[i].drift, 0);
    EXPECT_NEAR((*drifting)[i].drift, -4e-4, 1e-4);
    EXPECT_GT((*drifting)[i].standard_error, 4 * (*still)[i].standard_error);
  }
  EXPECT_THAT(in_words(static_stiffness(*drifting, {9.81, 0})->notices),
              Contains(testing::AllOf(HasSubstr("held.csv, run 2, 0 to 3.96 s drifts by 440 µm"),
                                      HasSubstr("wait"))));
}

TEST(StaticStiffness, SamplesFarFromAllOthersAreLeftOut) {
  const auto holds = find_holds(three_holds([](double t, double x) { return t == 2 ? x + 0.05 : x; }),
                                "held.csv", grams({40, 60, 80}));
  ASSERT_TRUE(holds);
  for (const Hold& hold : *holds) {
    EXPECT_EQ(hold.set_aside, 1u);
    EXPECT_EQ(hold.samples, 99u);
    EXPECT_LT(hold.standard_error, 5e-5);
  }
  EXPECT_THAT(in_words(static_stiffness(*holds, {9.81, 0})->notices),
              Contains(HasSubstr("1 sample lies far from all others and is left out")));
}

TEST(StaticStiffness, ValuesThatAreAllTheSameDoNotMove) {
  const auto holds = find_holds(three_holds([](double, double x) { return std::round(100 * x) / 100; }),
                                "held.csv", grams({40, 60, 80}));
  ASSERT_TRUE(holds);
  for (const Hold& hold : *holds) EXPECT_FALSE(hold.moves);
}

// Scatter leaves one degree of freedom, whose interval of 12.7 standard errors is not gravity's.
TEST(StaticStiffness, GravityHasManyDegreesOfFreedom) {
  std::vector<Hold> holds;
  for (const double x : {0.1, 0.201, 0.299}) {
    Hold& hold = holds.emplace_back();
    hold.position = x;
    hold.standard_error = 1e-6;
    hold.mass = {10 * x + (x == 0.201 ? -0.01 : x == 0.299 ? 0.01 : 0), 0};
  }
  const auto exact = static_stiffness(holds, {10, 0}), rough = static_stiffness(holds, {10, 2});
  ASSERT_TRUE(exact && rough);
  EXPECT_NEAR((exact->stiffness.high - exact->stiffness.value) / exact->stiffness.standard_error, 12.706,
              0.01);
  EXPECT_NEAR((rough->stiffness.high - rough->stiffness.value) / rough->stiffness.standard_error, 1.96, 0.05);
}

TEST(StaticStiffness, SaysWhatIsWrong) {
  const auto masses = grams({40, 60, 80});
  const auto two = find_holds({held({0.1, 0.2}, 20, 1e-4)}, "hold.csv", masses);
  EXPECT_THAT(in_words(two.error()), HasSubstr("3 masses are given, and 2 plateaus are found"));
  Series angle = held({0.1}, 5, 1e-4);
  angle.quantity = "angle";
  EXPECT_THAT(in_words(find_holds({angle}, "hold.csv", masses).error()), HasSubstr("needs positions"));
  const Series one = held({0.1}, 5, 1e-4);
  EXPECT_THAT(in_words(find_holds({one, one}, "hold.csv", masses).error()), HasSubstr("for 2 runs"));
  std::vector<Hold> alike(3);
  for (Hold& hold : alike) hold.mass = {0.05, 0};
  EXPECT_FALSE(static_stiffness(alike, {9.8, 0}).ok());
}

/// `samples` values from `first` on, each the same but for a little noise of two values.
Series hold(double level, int samples, int run = 1) {
  Series series;
  series.column = "x (m)";
  series.quantity = "position";
  series.run = run;
  for (int i = 0; i < samples; ++i) {
    series.t.push_back(0.5 * i);
    series.y.push_back(level + (i % 2 ? 0.001 : -0.001));
  }
  return series;
}

std::string refusal(const std::vector<Series>& runs, const std::vector<Quantity>& masses) {
  const auto holds = find_holds(runs, "f.csv", masses);
  return holds ? "" : in_words(holds.error());
}

TEST(Holds, AreTheMeansOfTheirRuns) {
  const auto holds = find_holds({hold(1, 4, 1), hold(2, 6, 2)}, "f.csv", {{0.1, 0.01}, {0.2, 0}});
  ASSERT_TRUE(holds);
  ASSERT_EQ(holds->size(), 2u);
  const Hold& first = (*holds)[0];
  EXPECT_EQ(first.file, "f.csv");
  EXPECT_EQ((*holds)[1].run, 2);
  EXPECT_EQ(first.from, 0);
  EXPECT_EQ(first.to, 1.5);
  EXPECT_EQ(first.samples, 4u);
  EXPECT_DOUBLE_EQ(first.position, 1);
  EXPECT_NEAR(first.scatter, 0.001 * std::sqrt(4.0 / 3), 1e-12);
  EXPECT_FALSE(first.moves);
  EXPECT_EQ(first.mass, (Quantity{0.1, 0.01}));
  EXPECT_EQ((*holds)[1].mass.value, 0.2);
  EXPECT_DOUBLE_EQ((*holds)[1].position, 2);
  EXPECT_EQ((*find_holds({hold(1, 1)}, "f.csv", {{1, 0}}))[0].scatter, 0);
  Series rounded = hold(1, 1);
  rounded.resolution = 0.012;
  EXPECT_NEAR((*find_holds({rounded}, "f.csv", {{1, 0}}))[0].standard_error, 0.012 / std::sqrt(12), 1e-12);
}

TEST(Holds, ThatAreNoneAreRefusedWordForWord) {
  const Quantity kilogram{1, 0};
  EXPECT_EQ(refusal({hold(1, 4), hold(1, 4)}, {kilogram}),
            "f.csv: 1 mass is given for 2 runs; --masses needs one for each");
  Series angle = hold(1, 4), unknown = hold(1, 4), empty = hold(1, 0, 3);
  angle.quantity = "angle";
  unknown.quantity = "";
  EXPECT_EQ(refusal({angle}, {kilogram}),
            "f.csv: --static needs positions, and column \"x (m)\" holds angle");
  EXPECT_EQ(refusal({hold(1, 4), unknown}, {kilogram, kilogram}),
            "f.csv: --static needs positions, and column \"x (m)\" holds no known quantity");
  EXPECT_EQ(refusal({empty}, {kilogram}), "f.csv: run 3 has no values");
  EXPECT_EQ(refusal({hold(1, 40)}, {kilogram, kilogram}),
            "f.csv: 2 masses are given, and 1 plateau is found: 0 to 19.5 s; choose the part with --from and "
            "--to, or "
            "give each hold as a run or file of its own");
}

TEST(Holds, ThatSwingAreSaid) {
  Series swinging = hold(1, 60);
  for (std::size_t i = 0; i < 60; ++i) swinging.y[i] = 1 + 0.1 * std::sin(0.1 * static_cast<double>(i));
  const auto holds =
      find_holds({swinging, hold(2, 60, 2), hold(3, 60, 3)}, "f.csv", {{1, 0}, {2, 0}, {3, 0}});
  ASSERT_TRUE(holds);
  EXPECT_TRUE((*holds)[0].moves);
  EXPECT_FALSE((*holds)[1].moves);
  const auto result = static_stiffness(*holds, {10, 0});
  ASSERT_TRUE(result);
  EXPECT_THAT(in_words(result->notices),
              Contains(testing::StartsWith("f.csv, run 1, 0 to 29.5 s is not at rest: it moves by")));
}

Hold at(double mass, double position, double error = 1e-3) {
  Hold one;
  one.mass = {mass, 0};
  one.position = position;
  one.standard_error = error;
  return one;
}

TEST(StaticLine, IsGravityOverItsSlope) {
  for (const double side : {1.0, -1.0}) {
    const auto result = static_stiffness({at(1, side * 2), at(2, side * 4), at(3, side * 6)}, {10, 0.1});
    ASSERT_TRUE(result);
    EXPECT_NEAR(result->stiffness.value, 5, 1e-12);
    EXPECT_NEAR(result->stiffness.standard_error, 5 * std::hypot(1e-3 / M_SQRT2 / 2, 0.01), 1e-9);
    EXPECT_THAT(in_words(result->notices), IsEmpty());
    EXPECT_EQ(result->holds.size(), 3u);
  }
}

TEST(StaticLine, SaysWhatIsDoubtfulOfIt) {
  const std::string order =
      "the position does not move in one direction as the mass grows; --masses must be in the order of the "
      "holds";
  EXPECT_THAT(in_words(static_stiffness({at(1, 2), at(2, 4)}, {10, 0})->notices),
              ElementsAre("two masses always give a line: nothing shows whether it is one"));
  EXPECT_THAT(in_words(static_stiffness({at(1, 2), at(2, 6), at(3, 4)}, {10, 0})->notices), Contains(order));
  EXPECT_THAT(in_words(static_stiffness({at(1, 2), at(3, 6.01), at(2, 4)}, {10, 0})->notices),
              testing::Not(Contains(order)));
  EXPECT_THAT(in_words(static_stiffness({at(1, 2), at(2, 4.5), at(3, 6)}, {10, 0})->notices),
              ElementsAre(testing::EndsWith(" and the interval is that of 1 degree of freedom")));
  EXPECT_THAT(in_words(static_stiffness({at(1, 2), at(2, 4.5), at(3, 6), at(4, 8)}, {10, 0})->notices),
              ElementsAre(testing::EndsWith(" and the interval is that of 2 degrees of freedom")));
  EXPECT_EQ(
      in_words(static_stiffness({at(1, 2), at(1, 3)}, {10, 0}).error()),
      "--masses: a line needs at least two holds of different masses, and three where their errors are not "
      "known");
}

TEST(Holds, OfFewSamplesAreNotWidenedAndNoneIsAPlateau) {
  const auto three = find_holds({hold(1, 3)}, "f.csv", {{1, 0}});
  ASSERT_TRUE(three);
  const Hold& first = three->front();
  EXPECT_NEAR(first.position, 1 - 0.001 / 3, 1e-15);
  EXPECT_NEAR(first.standard_error, first.scatter / std::sqrt(3.0), 1e-15);
  const Quantity kilogram{1, 0};
  EXPECT_EQ(refusal({hold(1, 4)}, {kilogram, kilogram}),
            "f.csv: 2 masses are given, and 0 plateaus are found; choose the part with --from and --to, or "
            "give each hold as a run or file of its own");
}

Series of_motion(const std::function<double(double)>& x) {
  Series series;
  series.quantity = "position";
  for (int i = 0; i < 2000; ++i) {
    series.t.push_back(0.02 * i);
    series.y.push_back(x(0.02 * i));
  }
  series.rate = 50;
  return series;
}

Series swing() {
  return of_motion([](double t) { return 0.05 * std::exp(-0.02 * t) * std::cos(6 * t); });
}

TEST(Holds, AreLevelsThatARecordRestsAt) {
  EXPECT_EQ(levels_at_rest(held({0.1, 0.2, 0.3}, 20, 1e-4)), 3u);
  EXPECT_EQ(levels_at_rest(held({0.1, 0.1005}, 20, 1e-4)), 0u);  // as near as the noise
  EXPECT_EQ(levels_at_rest(swing()), 0u);
  EXPECT_EQ(levels_at_rest(of_motion([](double t) { return 0.05 * std::exp(-0.3 * t); })), 0u);  // it creeps
  Series angle = held({0.1, 0.2, 0.3}, 20, 1e-4);
  angle.quantity = "angle";
  EXPECT_EQ(levels_at_rest(angle), 0u);
}

TEST(Holds, ASwingIsNoneOfThem) {
  EXPECT_EQ(
      refusal({swing()}, grams({50, 100})),
      "f.csv: --static needs masses at rest, and this moves nearly all the time, by 9.9 cm from one side "
      "to the other; leave --static out to fit its swing");
}

/// Runs of 20 values each, at these levels, that begin at 0 s.
Recording runs_at(const std::vector<double>& levels, const std::string& file = "runs.csv",
                  bool timed = true) {
  std::string bytes = timed ? "Time (s),Position (m)\n" : "Position (m)\n";
  for (const double level : levels)
    for (int i = 0; i < 20; ++i)
      bytes += (timed ? std::to_string(0.5 * i) + "," : "") + std::to_string(level + (i % 2 ? 1e-3 : -1e-3)) +
               "\n";
  const auto recording = read_recording(bytes, file, {});
  EXPECT_TRUE(recording) << in_words(recording.error());
  return *recording;
}

std::string refused(const std::vector<Recording>& recordings, const StaticOptions& options) {
  const auto found = fit_static(recordings, options);
  return found ? "" : in_words(found.error());
}

TEST(StaticFit, TakesTheRunsOfAllFilesInTheirOrder) {
  const std::vector<Recording> both{runs_at({0.1, 0.2}, "one.csv"), runs_at({0.3}, "two.csv")};
  const auto found = fit_static(both, {.masses = {{1, 0}, {2, 0}, {3, 0}}, .gravity = {10, 0}});
  ASSERT_TRUE(found) << in_words(found.error());
  EXPECT_NEAR(found->stiffness.value, 100, 1e-9);
  ASSERT_EQ(found->holds.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found->holds[i].file, i < 2 ? "one.csv" : "two.csv");
    EXPECT_EQ(found->holds[i].run, i == 1 ? 2 : 1);
    EXPECT_NEAR(found->holds[i].position, 0.1 * static_cast<double>(i + 1), 1e-12);
    EXPECT_EQ(found->holds[i].mass.value, static_cast<double>(i + 1));
  }
  EXPECT_EQ(refused(both, {.masses = {{1, 0}, {2, 0}}}),
            "--masses: 2 masses are given, and there are more holds: two.csv has 1 run");
  EXPECT_EQ(refused(both, {.masses = {{1, 0}}}),
            "--masses: 1 mass is given, and there are more holds: one.csv has 2 runs");
  EXPECT_EQ(refused(both, {.masses = {{1, 0}, {2, 0}, {3, 0}, {4, 0}}}),
            "--masses: 4 masses are given for 3 holds");
}

TEST(StaticFit, TakesOneRunOfAFileAndNeedsNoTimes) {
  const std::vector<Recording> three{runs_at({0.1, 0.2, 0.3})};
  EXPECT_EQ(refused(three, {.fit = {.run = 2}, .masses = {{1, 0}}}),
            "--masses: a line needs at least two holds of different masses, and three where their errors are "
            "not known");
  EXPECT_EQ(refused(three, {.fit = {.run = 4}, .masses = {{1, 0}}}),
            "runs.csv: there is no run 4: the file has 3 runs");
  EXPECT_EQ(refused(three, {.fit = {.from = 90}, .masses = {{1, 0}, {2, 0}, {3, 0}}}),
            "--from 90: no sample is left, the recording goes from 0 to 9.5 s");
  const std::vector<Recording> untimed{runs_at({0.2}, "one.csv", false), runs_at({0.1}, "two.csv", false)};
  const auto found = fit_static(untimed, {.masses = {{1, 0}, {2, 0}}, .gravity = {10, 0}});
  ASSERT_TRUE(found) << in_words(found.error());
  EXPECT_NEAR(found->stiffness.value, 100, 1e-9);
  EXPECT_EQ(found->holds[1].to, 19);  // a sample a second
  const auto by_rate =
      fit_static(untimed, {.fit = {.read = {.rate = 4}}, .masses = {{1, 0}, {2, 0}}, .gravity = {10, 0}});
  ASSERT_TRUE(by_rate);
  EXPECT_EQ(by_rate->holds[1].to, 4.75);
}

TEST(StaticFit, TakesNoOptionOfAMotion) {
  const Quantity some{1, 0};
  const std::vector<std::pair<std::string, FitOptions>> options{
      {"mass", {.mass = {some}}},
      {"spring-mass", {.spring_mass = some}},
      {"law", {.law = "viscous"}},
      {"disc-diameter", {.disc_diameter = some}},
      {"temperature", {.temperature = some}},
      {"segment", {.segment = 1.0}},
      {"segments", {.segments = 2}},
      {"force-column", {.force_column = "F"}},
      {"hold-out", {.hold_out = 0.2}},
      {"drive-frequency", {.drive_frequency = "auto"}},
      {"no-spring", {.no_spring = true}},
      {"hysteresis-exponent", {.hysteresis_exponent = 2}},
      {"goal", {.goal = "decay_rate 1 %"}},
      {"textbook", {.textbook = true}},
      {"seed", {.seed_given = true}},
      {"monte-carlo", {.monte_carlo = 1000}},
  };
  for (const auto& [option, fit] : options)
    EXPECT_EQ(refused({}, {.fit = fit}),
              "--" + option +
                  " has no meaning with --static: a mass at rest has no motion; leave it out, or "
                  "leave out --static");
}

FittedRecording fitted(double w, double error) {
  FittedRecording result;
  result.file = "lab.csv";
  result.fit.student = 1.96;
  result.fit.names = {"angular_frequency"};
  result.fit.estimates = {make_estimate(w, error, 1.96)};
  return result;
}

TEST(MassLine, FindsTheSpringAndItsOwnMass) {
  const double k = 16, spring = 0.015;
  std::vector<FittedRecording> fits;
  std::vector<Quantity> masses;
  NormalDeviates normal(3);
  for (const double m : {0.1, 0.15, 0.2, 0.25}) {
    const double w = std::sqrt(k / (m + spring / 3)), error = 1e-4 * w;
    fits.push_back(fitted(w + error * normal.next(), error));
    masses.push_back({m, 1e-5});
  }
  const auto line = mass_line(fits, masses);
  ASSERT_TRUE(line.ok()) << in_words(line.error());
  EXPECT_NEAR(line->stiffness.value, k, 4 * line->stiffness.standard_error);
  EXPECT_LT(line->stiffness.standard_error, 1e-3 * k);
  EXPECT_NEAR(line->spring_mass.value, spring, 4 * line->spring_mass.standard_error);
  EXPECT_NEAR(line->effective_mass.value * 3, line->spring_mass.value, 1e-15);
}

TEST(MassLine, LeavesOutWhatFailedAndRefusesTheRest) {
  std::vector<FittedRecording> fits{fitted(10, 0.01), fitted(9, 0.01), fitted(8, 0.01)};
  fits[1].fit.status = FitStatus::too_noisy;
  fits[1].fit.message = Notice{"too noisy"};
  const std::vector<Quantity> masses{{0.1, 0}, {0.12, 0}, {0.16, 0}};
  const auto line = mass_line(fits, masses);
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->points.size(), 2u);
  EXPECT_THAT(in_words(line->notices).front(), HasSubstr("left out of the line: too noisy"));
  EXPECT_THAT(in_words(mass_line(fits, {{0.1, 0}}).error()), HasSubstr("1 mass is given for 3"));
  EXPECT_THAT(in_words(mass_line(fits, {{0.2, 0}, {0.15, 0}, {0.1, 0}}).error()), HasSubstr("in the order"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
