// The options of fit at, below and above each limit, and the messages for those that are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/interrupt.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/law_force.h"
#include "cromer/read/in_file.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string said(const FitOptions& options) {
  const auto checked = check_fit_options(options);
  return checked ? "" : in_words(checked.error());
}

const Quantity kilogram{1, 0};

TEST(FitOptions, KnownQuantitiesArePositive) {
  EXPECT_EQ(said({}), "");
  EXPECT_EQ(said({.mass = {Quantity{1e-300, 0}}}), "");
  EXPECT_EQ(said({.mass = {Quantity{0, 0}}}), "--mass: it must be positive, not 0 kg");
  EXPECT_EQ(said({.mass = {kilogram}, .spring_mass = Quantity{0, 0}}), "");
  EXPECT_EQ(said({.mass = {kilogram}, .spring_mass = Quantity{-0.5, 0}}),
            "--spring-mass: it must not be negative, not -0.5 kg");
  EXPECT_EQ(said({.spring_mass = Quantity{1, 0}}), "--spring-mass needs --mass as well");
  EXPECT_EQ(said({.disc_diameter = Quantity{1e-300, 0}}), "");
  EXPECT_EQ(said({.disc_diameter = Quantity{0, 0}}), "--disc-diameter: it must be positive, not 0 m");
  EXPECT_EQ(said({.disc_diameter = kilogram, .temperature = Quantity{100, 0}}), "");
  EXPECT_EQ(said({.disc_diameter = kilogram, .temperature = Quantity{1900, 0}}), "");
  EXPECT_THAT(said({.disc_diameter = kilogram, .temperature = Quantity{1901, 0}}),
              testing::HasSubstr("between 100 K and 1900 K"));
  EXPECT_EQ(said({.disc_diameter = kilogram, .temperature = Quantity{0, 0}}),
            "--temperature: it must lie between 100 K and 1900 K (for instance \"20 °C\"), not 0 K");
  EXPECT_EQ(said({.temperature = Quantity{300, 0}}),
            "--temperature needs --disc-diameter: the air's temperature matters only to the Reynolds number "
            "and the drag coefficient of a disc");
  EXPECT_EQ(said({.segment = 1e-300}), "");
  EXPECT_EQ(said({.segment = 0}), "--segment: it must be positive, not 0 s");
  EXPECT_EQ(said({.segments = 1}), "");
  EXPECT_EQ(said({.segments = 0}), "--segments: it must be positive, not 0");
  EXPECT_EQ(said({.hysteresis_exponent = 1}), "");
  EXPECT_EQ(said({.hysteresis_exponent = 0.75}), "--hysteresis-exponent: it must be at least 1, not 0.75");
}

TEST(FitOptions, TrialsAndTheirSeedNeedOneAnother) {
  EXPECT_EQ(said({.mass = {kilogram}, .monte_carlo = 1000}), "");
  EXPECT_EQ(said({.mass = {kilogram}, .monte_carlo = 10'000'000}), "");
  EXPECT_EQ(said({.mass = {kilogram}, .monte_carlo = 999}),
            "--monte-carlo: it must lie between 1000 and 10000000 trials, not 999");
  EXPECT_EQ(said({.mass = {kilogram}, .monte_carlo = 10'000'001}),
            "--monte-carlo: it must lie between 1000 and 10000000 trials, not 10000001");
  EXPECT_EQ(said({.monte_carlo = 1000}),
            "--monte-carlo needs --mass: it checks the uncertainty of the spring constant");
  EXPECT_EQ(said({.seed_given = true}), "--seed needs --monte-carlo: it is the seed of its trials");
  EXPECT_EQ(said({.mass = {kilogram}, .monte_carlo = 1000, .seed_given = true}), "");
}

TEST(FitOptions, ARateIsThatOfALogger) {
  FitOptions options;
  for (const double rate : {0.0, 1e-6, 1e12}) {
    options.read.rate = rate;
    EXPECT_EQ(said(options), "") << rate;
  }
  options.read.rate = 0.5e-6;
  EXPECT_EQ(said(options), "--rate: it must lie between 1e-6 and 1e12 Hz, not 5e-07 Hz");
  options.read.rate = 2e12;
  EXPECT_EQ(said(options), "--rate: it must lie between 1e-6 and 1e12 Hz, not 2e+12 Hz");
}

TEST(FitOptions, FromLiesBeforeTo) {
  EXPECT_EQ(said({.from = 1, .to = 1.5}), "");
  EXPECT_EQ(said({.from = 1.5, .to = 1.5}), "--from 1.5 must lie before --to 1.5");
  EXPECT_EQ(said({.from = 2, .to = 1.5}), "--from 2 must lie before --to 1.5");
  EXPECT_EQ(said({.from = 2}), "");
  EXPECT_EQ(said({.to = -2}), "");
}

TEST(FitOptions, ABodyWithoutASpringNeedsAForce) {
  EXPECT_EQ(said({.no_spring = true}),
            "--no-spring needs --force-column: a body without a spring does not swing, and only a recorded "
            "force shows its law");
  EXPECT_EQ(said({.no_spring = true, .force_column = "F"}), "");
  EXPECT_EQ(said({.law = "pendulum", .no_spring = true, .force_column = "F"}),
            "--no-spring and --law pendulum exclude each other: a pendulum's weight is its spring");
  const auto law = law_of(FitOptions{.law = "viscous+drag", .no_spring = true});
  ASSERT_TRUE(law && *law);
  EXPECT_FALSE((*law)->has<Spring>());
  EXPECT_TRUE((*law)->has<Drag>());
  EXPECT_TRUE((*law_of(FitOptions{.law = "viscous+drag"}))->has<Spring>());
  EXPECT_FALSE(*law_of(FitOptions{.law = "auto"}));
  EXPECT_FALSE(*law_of(FitOptions{.law = ""}));
  EXPECT_FALSE(law_of(FitOptions{.law = "nothing"}));
  EXPECT_NE(said({.law = "nothing"}), "");
}

TEST(FitOptions, ADriveIsRecordedOrHarmonic) {
  EXPECT_EQ(
      said({.force_column = "F", .drive_frequency = "1 Hz"}),
      "--force-column and --drive-frequency exclude each other: the drive is recorded, or it is harmonic");
  EXPECT_EQ(said({.drive_frequency = "1 Hz"}), "");
  EXPECT_EQ(said({.drive_frequency = "auto"}), "");
  EXPECT_EQ(said({.drive_frequency = "0 Hz"}), "--drive-frequency 0 Hz: it must be positive");
  EXPECT_EQ(said({.drive_frequency = "-1"}), "--drive-frequency -1: it must be positive");
  EXPECT_THAT(said({.drive_frequency = "fast"}), testing::StartsWith("--drive-frequency: "));
  EXPECT_THAT(said({.drive_frequency = "fast"}), testing::EndsWith("; or auto, to find it in the record"));
  EXPECT_DOUBLE_EQ(**drive_of({.drive_frequency = "60 rpm"}), 2 * M_PI);
  EXPECT_FALSE(*drive_of({.drive_frequency = "auto"}));
  EXPECT_FALSE(is_driven({}));
  EXPECT_TRUE(is_driven({.force_column = "F"}));
  EXPECT_TRUE(is_driven({.drive_frequency = "1"}));
}

TEST(FitOptions, SomeAreOfARecordedForceAlone) {
  EXPECT_EQ(said({.between_samples = "hold"}),
            "--between-samples needs --force-column: it says what a recorded force did between its samples");
  for (const char* good : {"linear", "hold", "band-limited", "auto"})
    EXPECT_EQ(said({.force_column = "F", .between_samples = good}), "") << good;
  EXPECT_EQ(said({.force_column = "F", .between_samples = "cubic"}),
            "--between-samples: \"cubic\" is none of linear, hold, band-limited and auto");
  EXPECT_EQ(said({.hold_out = 0.2}),
            "--hold-out needs --force-column: only a motion whose force is known can be predicted");
  for (const double good : {1e-9, 0.9}) EXPECT_EQ(said({.force_column = "F", .hold_out = good}), "");
  EXPECT_EQ(said({.force_column = "F", .hold_out = 0}),
            "--hold-out 0: it must lie above 0 and at most at 90 %");
  EXPECT_EQ(said({.force_column = "F", .hold_out = 0.91}),
            "--hold-out 0.91: it must lie above 0 and at most at 90 %");
}

TEST(FitOptions, SomeAreOfAFreeDecayAlone) {
  const std::string why =
      " is not for a driven motion, whose amplitude the drive keeps up; fit a free decay, for instance a "
      "part of the record after the drive has stopped, with --from and --to";
  EXPECT_EQ(said({.segment = 1, .force_column = "F"}), "--segment" + why);
  EXPECT_EQ(said({.segments = 1, .drive_frequency = "1"}), "--segments" + why);
  EXPECT_EQ(said({.force_column = "F", .goal = "decay_rate 1 %"}), "--goal" + why);
  EXPECT_EQ(said({.force_column = "F", .textbook = true}), "--textbook" + why);
  EXPECT_THAT(unused_if_driven({.segment = 1, .segments = 2, .goal = "g", .textbook = true}),
              ElementsAre("segment", "segments", "goal", "textbook"));
  EXPECT_THAT(unused_if_driven({}), IsEmpty());
}

TEST(FitOptions, AGoalIsAQuantityAndItsUncertainty) {
  const auto goal = [](std::string_view text) {
    const auto parsed = parse_goal(text);
    return parsed ? parsed->quantity + "|" + parsed->text + (parsed->relative ? "|relative" : "")
                  : in_words(parsed.error());
  };
  EXPECT_EQ(goal("decay_rate 0.5 %"), "decay_rate|0.5 %|relative");
  EXPECT_EQ(goal("period 0.1 ms"), "period|0.1 ms");
  for (const char* name :
       {"stiffness", "drag_coefficient", "frequency", "damping_ratio", "quality_factor",
        "logarithmic_decrement", "limit_cycle_amplitude", "equilibrium", "position", "velocity"})
    EXPECT_EQ(goal(std::string(name) + " 1 %"), std::string(name) + "|1 %|relative");
  EXPECT_EQ(goal("decay_rate"),
            "--goal: how well should decay_rate be known? For instance \"decay_rate 0.5 %\"");
  EXPECT_EQ(
      goal("dcay_rate 1 %"),
      "--goal: \"dcay_rate\" is no quantity of a fit; did you mean decay_rate? Give a name and its standard "
      "uncertainty, for instance \"decay_rate 0.5 %\"");
  EXPECT_EQ(goal("decay_rate 0 %"), "--goal: the uncertainty of decay_rate must be positive, not 0 %");
  EXPECT_EQ(goal("decay_rate -1 %"), "--goal: the uncertainty of decay_rate must be positive, not -1 %");
  EXPECT_THAT(goal("decay_rate half %"), testing::StartsWith("--goal: "));
  EXPECT_NE(said({.goal = "loudness 1 %"}), "");
}

TEST(NotFitted, KeepsWhatIsWrongWithoutTheFile) {
  const Notice nothing{"column_has_no_values", {{"column", "x"}}};
  const FittedRecording row = not_fitted("lab.csv", 3, in_file("lab.csv", nothing));
  EXPECT_EQ(row.fit.message, nothing);
  EXPECT_EQ(row.file, "lab.csv");
  EXPECT_EQ(row.series.run, 3);
  EXPECT_TRUE(row.wrong_input);
  EXPECT_FALSE(row.succeeded());
  EXPECT_EQ(row.status(), "wrong_input");
  EXPECT_EQ(row.find("stiffness"), nullptr);
  const Notice of_line = in_line(7, nothing).notice;
  EXPECT_EQ(not_fitted("lab.csv", 1, in_file("lab.csv", of_line)).fit.message, of_line);
  for (const Notice& other :
       {in_file("lab.csv, a file", nothing), Notice{"law_term_twice", {{"term", "drag"}}}})
    EXPECT_EQ(not_fitted("lab.csv", 1, other).fit.message, other);
}

TEST(PartOfWork, GoesFromItsBeginningToItsEnd) {
  std::vector<double> said_so;
  const Watch whole{nullptr, [&](double share) { said_so.push_back(share); }};
  const Watch part = part_of(whole, 0.25, 0.75);
  for (const double share : {0.0, 0.5, 1.0}) part.progress(share);
  EXPECT_THAT(said_so, ElementsAre(0.25, 0.5, 0.75));
  EXPECT_FALSE(part_of({}, 0, 1).progress);
}

std::string masses(std::string_view text) {
  FitOptions options;
  if (const auto read = assign({{"mass", std::string(text)}}, options_of(options), "fit"); !read)
    return in_words(read.error());
  std::string list;
  for (const Quantity& mass : options.mass)
    list += shortest(mass.value) + (mass.uncertainty > 0 ? "±" + shortest(mass.uncertainty) : "") + ";";
  return list;
}

TEST(Masses, AreReadWithOneUnitOrManyOrNone) {
  EXPECT_EQ(masses("48.4 g, 67.95 ± 0.01 g,0.08796 kg"), "0.0484;0.06795±1e-05;0.08796;");
  EXPECT_EQ(masses("1,2,3"), "1;2;3;");
  EXPECT_EQ(masses("0.05,0.06"), "0.05;0.06;");
  EXPECT_EQ(masses("1, 2 , 3000 g"), "0.001;0.002;3;");
  EXPECT_EQ(masses("1 g,2 kg,3 g"), "0.001;2;0.003;");
  EXPECT_EQ(masses("48.4; 67.95 g"), "0.0484;0.06795;");
}

TEST(Masses, OfWhichOneHasAUnitAndItIsNotTheLastCouldMeanAnything) {
  const std::string why =
      " has no unit, but others have: give each its unit, or give one to the last only, for all of them";
  EXPECT_EQ(masses("1 g,2,3"), "--mass: 2" + why);
  EXPECT_EQ(masses("1 g,2,3 g"), "--mass: 2" + why);
  EXPECT_EQ(masses("1,,2"), "--mass: a value is missing between two commas");
  EXPECT_EQ(masses("1,2,"), "--mass: a value is missing between two commas");
  EXPECT_THAT(masses("1,-2"), testing::HasSubstr("must be positive"));
  EXPECT_THAT(masses("one"), testing::StartsWith("--mass: "));
}

TEST(Masses, ADecimalCommaMakesNoTwoOfThem) {
  EXPECT_THAT(masses("217,6 g"), testing::HasSubstr("decimal comma: write \"217.6"));
  EXPECT_THAT(masses("217,6 ± 0,3 g"), testing::HasSubstr("decimal comma: write \"217.6"));
  EXPECT_THAT(masses("217,6+/-0,3 g"), testing::HasSubstr("decimal comma: write \"217.6"));
  EXPECT_EQ(masses("217, 6 g"), "0.217;0.006;");
  EXPECT_EQ(masses("0,2 kg, 0,3 kg"),
            "--mass: \"0,2 kg, 0,3 kg\" has a decimal comma: write \"0.2 kg, 0.3 kg\"; expected a mass, for "
            "instance 217.6 g");
  EXPECT_THAT(masses("48,4 g; 67,9 ± 0,1 g"),
              testing::HasSubstr("\"48,4 g\" has a decimal comma: write \"48.4"));
}

/// Ten samples, one each second, from 0 to 9 s; y is the square of the time, the lines are from 2.
Series ten() {
  Series series;
  series.column = "x (m)";
  series.quantity = "position";
  series.rate = 1;
  for (int i = 0; i < 10; ++i) {
    series.t.push_back(i);
    series.y.push_back(i * i);
    series.lines.push_back(i + 2);
  }
  series.outliers = {{1, 1, 3}, {5, 25, 7}};
  series.gaps = {{.t = 2, .length = 1}, {.t = 8, .length = 1}};
  return series;
}

TEST(UsedPart, HasBothItsEndsAndTheMarksBetweenThem) {
  const Series part = *used_part(ten(), {.from = 2, .to = 5});
  EXPECT_THAT(part.t, ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(part.y, ElementsAre(4, 9, 16, 25));
  EXPECT_THAT(part.lines, ElementsAre(4, 5, 6, 7));
  ASSERT_EQ(part.outliers.size(), 1u);
  EXPECT_EQ(part.outliers[0].t, 5);
  ASSERT_EQ(part.gaps.size(), 1u);
  EXPECT_EQ(part.gaps[0].t, 2);
  // A millionth of a spacing is how a logger prints it.
  EXPECT_THAT(used_part(ten(), {.from = 2 + 9e-7, .to = 5 - 9e-7})->t, ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(used_part(ten(), {.from = 2 + 2e-6, .to = 5 - 2e-6})->t, ElementsAre(3, 4));
  EXPECT_EQ(used_part(ten(), {})->t.size(), 10u);
  Series without_lines = ten();
  without_lines.lines.clear();
  EXPECT_THAT(used_part(without_lines, {.from = 8})->lines, IsEmpty());
}

TEST(UsedPart, SaysThatNothingIsLeft) {
  const auto refusal = [](const Series& series, const FitOptions& options) {
    const auto part = used_part(series, options);
    return part ? "" : in_words(part.error());
  };
  EXPECT_EQ(refusal(ten(), {.from = 10}), "--from 10: no sample is left, the recording goes from 0 to 9 s");
  EXPECT_EQ(refusal(ten(), {.to = -1}), "--to -1: no sample is left, the recording goes from 0 to 9 s");
  EXPECT_EQ(refusal(ten(), {.from = 2.25, .to = 2.75}),
            "--from 2.25 --to 2.75: no sample is left, the recording goes from 0 to 9 s");
  Series empty;
  empty.column = "x";
  EXPECT_EQ(refusal(empty, {}), "column \"x\" has no values");
  Series size = ten();
  const auto of = [&](double value) {
    size.y.assign(10, value);
    return refusal(size, {});
  };
  EXPECT_EQ(of(0), "");
  EXPECT_EQ(of(0.99e100), "");
  EXPECT_EQ(of(1.01e-100), "");
  EXPECT_EQ(of(-1e100),
            "column \"x (m)\": values like 1e+100 are too large to be squared; give them in another unit");
  EXPECT_EQ(of(1e-100),
            "column \"x (m)\": values like 1e-100 are too small to be squared; give them in another unit");
}

TEST(UsedSamples, LeaveOutTheOutliersAndNoOthers) {
  const FittedSamples kept = without_outliers(ten());
  EXPECT_THAT(kept.t, ElementsAre(0, 2, 3, 4, 6, 7, 8, 9));
  EXPECT_THAT(kept.y, ElementsAre(0, 4, 9, 16, 36, 49, 64, 81));
  Series whole = ten();
  whole.outliers.clear();
  EXPECT_EQ(without_outliers(whole).t.size(), 10u);
}

TEST(UsedSamples, AreListedInTimeWhereTheFitSetThemAside) {
  Series series = ten();
  const FittedSamples samples = without_outliers(series);
  std::vector<Notice> notices;
  list_outliers(series, samples, {}, notices);
  EXPECT_THAT(notices, IsEmpty());
  list_outliers(series, samples, {1, 3}, notices);  // at 2 and 4 s
  ASSERT_EQ(series.outliers.size(), 4u);
  const double times[] = {1, 2, 4, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(series.outliers[i].t, times[i]);
    EXPECT_EQ(series.outliers[i].value, times[i] * times[i]);
    EXPECT_EQ(series.outliers[i].line, static_cast<long>(times[i]) + 2);
  }
  EXPECT_THAT(in_words(notices), ElementsAre("2 samples, the first at 2 s, lie far from the fitted motion "
                                             "and from their neighbours and are set aside"));
  Series one = ten();
  one.lines.resize(3);
  notices.clear();
  list_outliers(one, samples, {3}, notices);
  EXPECT_THAT(
      in_words(notices),
      ElementsAre(
          "one sample, at 4 s, lies far from the fitted motion and from its neighbours and is set aside"));
  EXPECT_EQ(one.outliers[1].line, 0);
}

TEST(Quantities, HaveTheirOrderOfDerivative) {
  for (const char* name : {"position", "angle"}) EXPECT_EQ(derivative_order(name), 0);
  for (const char* name : {"velocity", "angular velocity"}) EXPECT_EQ(derivative_order(name), 1);
  for (const char* name : {"acceleration", "angular acceleration"}) EXPECT_EQ(derivative_order(name), 2);
  for (const char* name : {"force", ""}) EXPECT_EQ(derivative_order(name), -1);
  for (const char* name : {"", "position", "velocity", "acceleration"}) EXPECT_TRUE(is_linear_quantity(name));
  for (const char* name : {"angle", "angular velocity", "force"}) EXPECT_FALSE(is_linear_quantity(name));
  EXPECT_EQ(in_words(fitted_as_it_is("velocity", "v")),
            "column \"v\" holds velocity and is fitted as such: all results are those of the displacement, "
            "except the equilibrium, which is the sensor's offset");
  EXPECT_THAT(
      in_words(fitted_as_it_is("angular velocity", "w")),
      testing::EndsWith(
          "all results are those of the angle, except the equilibrium, which is the sensor's offset"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
