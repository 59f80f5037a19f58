#include "cromer/tasks/fit/fit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "cromer/analysis/air.h"
#include "cromer/base/number.h"
#include "cromer/documents/words/words.h"
#include "tests/support/shared_data.h"
#include "tests/tasks/disc_recording.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

const Series& disc() {
  static const Series series = disc_recording();
  return series;
}

FitOptions disc_options() {
  FitOptions options;
  options.mass = {Quantity{0.2176, 0.0003}};
  options.disc_diameter = Quantity{0.12, 0};
  options.segment = 30;
  options.segments = 3;
  return options;
}

FittedRecording fitted(const Series& series, const FitOptions& options) {
  const Result<FittedRecording> result = fit_series(series, "recording2.csv", options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? *result : FittedRecording{};
}

void expect_within(const Estimate* estimate, double truth, double relative_error) {
  ASSERT_NE(estimate, nullptr);
  EXPECT_GE(truth, estimate->value - 4 * estimate->standard_error);
  EXPECT_LE(truth, estimate->value + 4 * estimate->standard_error);
  EXPECT_LT(estimate->standard_error, relative_error * std::abs(truth));
}

TEST(FitTask, FindsTheDiscsLaw) {
  const FittedRecording result = fitted(disc(), disc_options());
  EXPECT_EQ(result.fit.status, FitStatus::converged);
  EXPECT_EQ(to_text(result.fit.law), "viscous+drag");
  EXPECT_EQ(result.candidates.size(), 22u);  // van-der-pol in the place of drag
  EXPECT_TRUE(result.fit.residual.white);
  expect_within(result.find("stiffness"), 17.04, 0.0015);
  expect_within(result.find("damping"), 0.000789, 0.1);
  expect_within(result.find("drag_constant"), 0.02043, 0.02);
  const double coefficient = 2 * 0.02043 / (air_density(293.15) * std::numbers::pi / 4 * 0.12 * 0.12);
  expect_within(result.find("drag_coefficient"), coefficient, 0.02);
  expect_within(result.find("equilibrium"), 0.2, 1e-4);
  EXPECT_EQ(result.find("cubic"), nullptr);
}

TEST(FitTask, GivesTheSegmentsRatesAndTheirMean) {
  const FittedRecording result = fitted(disc(), disc_options());
  ASSERT_EQ(result.segments.size(), 3u);
  const double rates[] = {0.0124, 0.0094, 0.0077};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(result.segments[i].rate.value, rates[i], 1.5e-4);
    EXPECT_DOUBLE_EQ(result.segments[i].from, 30.0 * static_cast<double>(i));
  }
  ASSERT_TRUE(result.decay_rate_mean.has_value());
  EXPECT_NEAR(result.decay_rate_mean->value, 0.00984, 0.00008);  // this recording's own noise
  EXPECT_GT(result.decay_rate_mean->standard_error, 0.00002);    // no less than the noise allows
  // Residuals of the later segments are white: standard errors are those of the noise, 0.3 mm, by the formula
  // of docs/theory.md. In the first one a constant rate leaves more than noise, and its error is wider.
  EXPECT_NEAR(result.segments[1].rate.standard_error, 4.2e-5, 0.3e-5);
  EXPECT_NEAR(result.segments[2].rate.standard_error, 5.5e-5, 0.3e-5);
  EXPECT_GT(result.segments[0].rate.standard_error, 6e-5);
  double squares = 0;
  for (const auto& segment : result.segments)
    squares += segment.rate.standard_error * segment.rate.standard_error;
  EXPECT_DOUBLE_EQ(result.decay_rate_mean->standard_error, std::sqrt(squares) / 3);
}

TEST(FitTask, GivesTheLargestReynoldsNumber) {
  const FittedRecording result = fitted(disc(), disc_options());
  ASSERT_TRUE(result.reynolds_max.has_value());
  EXPECT_NEAR(result.reynolds_max->value, 2525, 10);
  EXPECT_GT(result.reynolds_max->standard_error, 0.5);
  EXPECT_LT(result.reynolds_max->standard_error, 10);
  EXPECT_NEAR(result.reynolds_max_t, 0.25 * 2 * std::numbers::pi / 8.849,
              0.02);  // a quarter period after the release
  ASSERT_EQ(result.reynolds.size(), 240u);
  EXPECT_EQ(result.reynolds[1].t, 0.5);
}

TEST(FitTask, WithoutASpeedAlongALineThereIsNoReynoldsNumber) {
  for (const char* quantity : {"acceleration", "angle"}) {
    Series series = disc();
    series.quantity = quantity;
    FitOptions options;
    options.law = "viscous";
    options.disc_diameter = disc_options().disc_diameter;
    const FittedRecording result = fitted(std::move(series), options);
    EXPECT_FALSE(result.reynolds_max.has_value()) << quantity;
    EXPECT_THAT(in_words(result.notices), testing::Contains(testing::HasSubstr("no Reynolds number")))
        << quantity;
  }
}

TEST(FitTask, CarriesTheMassesUncertainty) {
  FitOptions options = disc_options();
  const Estimate with = *fitted(disc(), options).find("stiffness");
  EXPECT_NEAR(with.standard_error, 17.04 * 0.0003 / 0.2176, 0.02 * with.standard_error);
  options.mass = {Quantity{0.2176, 0}};
  EXPECT_LT(fitted(disc(), options).find("stiffness")->standard_error, 0.01 * with.standard_error);
  options.spring_mass = Quantity{0.015, 0.003};
  const Estimate spring = *fitted(disc(), options).find("stiffness");
  EXPECT_NEAR(spring.value, with.value * (0.2176 + 0.005) / 0.2176, 1e-9);
  EXPECT_NEAR(spring.standard_error, spring.value * 0.001 / 0.2226, 0.02 * spring.standard_error);
}

TEST(FitTask, DerivedQuantitiesAgreeWithEachOther) {
  FitOptions options;
  options.law = "viscous";
  const FittedRecording result = fitted(disc(), options);
  const double w0 = result.find("angular_frequency")->value, g = result.find("decay_rate")->value;
  const double f = result.find("frequency")->value, T = result.find("period")->value;
  EXPECT_NEAR(2 * std::numbers::pi * f, std::sqrt(w0 * w0 - g * g), 1e-12 * w0);
  EXPECT_NEAR(f * T, 1, 1e-14);
  EXPECT_NEAR(result.find("damping_ratio")->value * result.find("quality_factor")->value, 0.5, 1e-14);
  EXPECT_NEAR(result.find("logarithmic_decrement")->value, g * T, 1e-14);
  // Relative uncertainties of a number and its reciprocal are the same.
  const auto relative = [&](const char* name) {
    return result.find(name)->standard_error / result.find(name)->value;
  };
  EXPECT_NEAR(relative("frequency"), relative("period"), 1e-12);
  EXPECT_NEAR(relative("damping_ratio"), relative("quality_factor"), 1e-12);
  EXPECT_NEAR(relative("damping_ratio"), relative("decay_rate"), 0.01 * relative("decay_rate"));
}

TEST(FitTask, NamesFollowTheContract) {
  std::vector<std::string> names;
  for (const Parameter& number : fitted(disc(), disc_options()).parameters)
    names.push_back(number.name + " " + number.unit);
  EXPECT_THAT(names, testing::ElementsAre("angular_frequency rad/s", "decay_rate 1/s", "drag 1/m",
                                          "equilibrium m", "position m", "velocity m/s", "stiffness N/m",
                                          "damping kg/s", "drag_constant kg/m", "drag_coefficient 1"));
}

TEST(FitTask, UsesThePartAskedFor) {
  FitOptions options;
  options.law = "viscous";
  options.from = 30;
  options.to = 60;
  const FittedRecording result = fitted(disc(), options);
  EXPECT_EQ(result.series.t.front(), 30);
  EXPECT_EQ(result.series.t.back(), 60);
  EXPECT_EQ(result.series.y.size(), 3001u);
  EXPECT_EQ(result.samples, 12001u);
  EXPECT_NEAR(result.find("decay_rate")->value, 0.0094, 1.5e-4);
  options.from = 500;
  options.to = std::nullopt;
  const Result<FittedRecording> none = fit_series(disc(), "f", options);
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(in_words(none.error()), HasSubstr("from 0 to 120 s"));
}

TEST(FitTask, LeavesOutliersOutOfTheFit) {
  Series series = disc_recording(5, 20);
  FitOptions options;
  options.law = "viscous+drag";
  const FittedRecording clean = fitted(series, options);
  for (std::size_t i : {100u, 777u, 1500u}) {
    series.y[i] = 1.5;
    series.outliers.push_back({series.t[i], 1.5, 0});
  }
  const FittedRecording spiked = fitted(series, options);
  EXPECT_NEAR(spiked.fit.residual.rms, clean.fit.residual.rms, 1e-6);
  EXPECT_NEAR(spiked.find("drag")->value, clean.find("drag")->value, clean.find("drag")->standard_error);
  EXPECT_EQ(spiked.series.y.size(), clean.series.y.size());
}

TEST(FitTask, SaysFirstWhatIsLookedForFirst) {
  const FittedRecording lab = fitted(disc(), disc_options());
  std::vector<std::string> names;
  for (const Parameter& each : lab.headline) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"frequency", "stiffness", "decay_rate_start", "decay_rate_end",
                                             "reynolds_max"}));
  // All terms together, as a piece of the record has them: not the viscous term alone.
  EXPECT_NEAR(lab.headline[2].estimate.value, lab.decay_by_amplitude.front().law_rate, 1e-3);
  EXPECT_NEAR(lab.headline[3].estimate.value, lab.decay_by_amplitude.back().law_rate, 1e-3);
  EXPECT_GT(lab.headline[3].estimate.value, 2 * lab.fit.decay_rate().value);
  names.clear();
  for (const Parameter& each : fitted(disc(), FitOptions{}).headline) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"frequency", "decay_rate_start", "decay_rate_end"}));
}

TEST(FitTask, TheCommandHasTheDigitsThatAreKnown) {
  const FittedRecording lab = fitted(disc(), disc_options());
  for (const auto& [option, text] : lab.simulate)
    if (option != "step") {
      EXPECT_LE(text.size(), 13u) << option << ' ' << text;
    }
  // The spring as well as the frequency tells it, the start as well as the samples do.
  const double w = lab.fit.angular_frequency().value, error = lab.fit.angular_frequency().standard_error;
  for (const auto& [option, text] : lab.simulate) {
    if (option == "stiffness") {
      EXPECT_NEAR(std::sqrt(std::stod(text) / 0.2176), w, 0.005 * error);
    }
    if (option == "position") {
      EXPECT_NEAR(std::stod(text), lab.fit.position().value, 0.005 * lab.fit.position().standard_error);
      EXPECT_LE(text.size(), 11u);
    }
  }
}

TEST(FitTask, WritesTheCommandThatSimulatesTheLaw) {
  const std::string line = command_of("simulate", fitted(disc(), disc_options()).simulate);
  EXPECT_THAT(line, testing::StartsWith("cromer simulate --mass 0.2176 --stiffness 17.0"));
  for (const char* option : {"--damping 0.000", "--drag 0.02", "--position 0.03", "--velocity ",
                             "--method rk4", "--step 0.0033333333333333335", "--until 120"})
    EXPECT_THAT(line, HasSubstr(option));
  FitOptions per_mass;
  EXPECT_THAT(command_of("simulate", fitted(disc(), per_mass).simulate),
              testing::StartsWith("cromer simulate --mass 1 --stiffness 78.3"));
}

TEST(FitTask, EqualPartsAndSegmentsThatDoNotFit) {
  FitOptions options;
  options.law = "viscous";
  options.segments = 4;
  EXPECT_EQ(fitted(disc(), options).segments.size(), 4u);
  options.segments = std::nullopt;
  options.segment = 50;
  EXPECT_EQ(fitted(disc(), options).segments.size(), 2u);
  options.segments = 5;
  const FittedRecording few = fitted(disc(), options);
  EXPECT_EQ(few.segments.size(), 2u);
  EXPECT_THAT(in_words(few.notices), testing::Contains(HasSubstr("holds 2 of the 5 segments")));
}

TEST(FitTask, RefusesWhatCannotBeFitted) {
  const auto message = [&](FitOptions options) {
    const Result<FittedRecording> result = fit_series(disc(), "f", options);
    return result.ok() ? std::string("fitted") : in_words(result.error());
  };
  EXPECT_THAT(message({.law = "viscous+pendulum"}), HasSubstr("--law viscous+pendulum: a pendulum's law"));
  EXPECT_THAT(message({.law = "viscos"}), HasSubstr("did you mean viscous"));
  EXPECT_THAT(message({.from = 5, .to = 3}), HasSubstr("--from"));
  EXPECT_THAT(message({.mass = {Quantity{0, 0}}}), HasSubstr("--mass"));
  EXPECT_THAT(message({.spring_mass = Quantity{0.01, 0}}), HasSubstr("needs --mass"));
  EXPECT_THAT(message({.segment = -1}), HasSubstr("--segment"));
}

TEST(FitTask, AVelocityIsFittedByTheViscousLaw) {
  // v of x'' = -w0² x - 2 g x' obeys the same equation; the simulation starts from the displacement that
  // belongs to it.
  const double w0 = 5, g = 0.1, w = std::sqrt(w0 * w0 - g * g);
  Series series;
  series.column = "Velocity (m/s)";
  series.quantity = "velocity";
  series.rate = 100;
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.01 * i;
    series.t.push_back(t);
    series.y.push_back(-0.1 * w0 * w0 / w * std::exp(-g * t) * std::sin(w * t));  // released at 0.1 m
  }
  const FittedRecording result = fitted(series, {});
  EXPECT_EQ(to_text(result.fit.law), "viscous");
  EXPECT_NEAR(result.find("angular_frequency")->value, w0, 1e-8);
  const std::string line = command_of("simulate", result.simulate);
  EXPECT_NEAR(std::stod(line.substr(line.find("--position ") + 11)), 0.1, 1e-8);
  EXPECT_THAT(in_words(result.notices), testing::Contains(HasSubstr("holds velocity and is fitted as such")));
  EXPECT_NEAR(result.find("position")->value, 0.1, 1e-8);
}

TEST(FitTask, AgreesWithTheAuthorsOfTheCompactDisc) {
  const std::string path = data("spring-disc-capstone-mm/Oscillazioni non_pretensionata_cd_3e1masse.csv");
  SKIP_WITHOUT(path);
  const double rates[] = {0.04690, 0.07388}, frequencies[] = {5.6623, 7.2526};
  FitOptions options;
  options.read.rate = 100;
  options.law = "viscous";
  options.mass = {Quantity{0.09472, 0}, Quantity{0.05519, 0}};
  options.spring_mass = Quantity{0.01543, 0};
  const auto result = fit(bytes_of(path), path, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  ASSERT_EQ(result->size(), 2u);
  for (std::size_t run = 0; run < 2; ++run) {
    const FittedRecording& one = (*result)[run];
    EXPECT_NEAR(one.find("decay_rate")->value, rates[run], 1e-3 * rates[run]);
    EXPECT_NEAR(2 * std::numbers::pi * one.find("frequency")->value, frequencies[run],
                1e-3 * frequencies[run]);
    EXPECT_NEAR(one.find("stiffness")->value, 3.226, run == 0 ? 0.03226 : 0.06);
  }
  const auto doubted = [&] {
    const auto notices = fit(bytes_of(path), path, options)->front().notices;
    return std::any_of(notices.begin(), notices.end(),
                       [](const Notice& each) { return each.code == "one_mass_for_unlike_runs"; });
  };
  EXPECT_FALSE(doubted());
  options.mass.pop_back();
  EXPECT_TRUE(doubted());
  options.mass.resize(3, Quantity{0.1, 0});
  EXPECT_THAT(in_words(fit(bytes_of(path), path, options).error()),
              HasSubstr("3 masses are given for 2 runs; --mass needs one for each"));
}

TEST(FitTask, TheFullDiscNeedsDragAndASofteningSpring) {
  const std::string path = data("spring-disc-pasco/molla_durissima_discopieno_14.91945_0.2016_1.csv");
  SKIP_WITHOUT(path);
  FitOptions options;
  options.column = "position";
  const auto result = fit(bytes_of(path), path, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_EQ(to_text(result->front().fit.law), "viscous+drag+odd-quadratic");
  const std::map<std::string, double> rms{
      {"viscous", 2.76e-3}, {"viscous+drag", 2.38e-3}, {"viscous+drag+cubic", 0.88e-3}};
  std::size_t found = 0;
  for (const auto& candidate : result->front().candidates)
    if (const auto known = rms.find(to_text(candidate.law)); known != rms.end()) {
      ++found;
      EXPECT_NEAR(candidate.rms, known->second, 0.01e-3) << known->first;
    }
  EXPECT_EQ(found, rms.size());
}

TEST(FitTask, APendulumOnFilmDecaysAsItsAuthorsSay) {
  const std::string path = data("pendulum-tracker/8047.txt");
  SKIP_WITHOUT(path);
  FitOptions options;
  options.column = "x";
  options.law = "viscous";
  const auto result = fit(bytes_of(path), path, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_NEAR(1 / result->front().find("decay_rate")->value, 163, 4);
  EXPECT_NEAR(result->front().find("period")->value, 2.421, 0.003);
}

TEST(FitTask, ARecordingWithoutOscillationIsRefused) {
  const std::string path = data("seismometer-datastudio/train2.txt");
  SKIP_WITHOUT(path);
  const auto result = fit(bytes_of(path), path, {});
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_EQ(result->front().fit.status, FitStatus::no_oscillation);
  EXPECT_FALSE(result->front().fit.message.empty());
}

/// A swing of `amplitude` about `mean` at 0.8 Hz, in a file of this header.
std::string swing_about(double mean, double amplitude, const std::string& header) {
  std::string bytes = header + "\n";
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.02 * i;
    bytes += shortest(t) + "," + shortest(mean + amplitude * std::exp(-0.03 * t) * std::cos(5.03 * t)) + "\n";
  }
  return bytes;
}

std::vector<std::string> said_of(const std::string& bytes) {
  const auto result = fit(bytes, "lab.csv", {});
  EXPECT_TRUE(result.ok()) << in_words(result.error());
  return result.ok() ? in_words(result->front().notices) : std::vector<std::string>{};
}

/// A pendulum at 0.8 Hz, moved by hand before `until` [s], and stopped from `stop` on.
std::string moved_by_hand(double until, double stop = HUGE_VAL, double duration = 30) {
  std::string bytes = "Time (s),Gyroscope z (rad/s)\n";
  for (int i = 0; i < 50 * duration; ++i) {
    const double t = 0.02 * i, hand = t < until ? -4 * t * (until - t) : 0;
    bytes += shortest(t) + "," +
             shortest(hand + (t < stop ? 1 : 0.3) * 1.5 * std::exp(-0.03 * t) * std::cos(5.03 * t) +
                      0.02 * std::sin(1e4 * t * t)) +
             "\n";
  }
  return bytes;
}

TEST(FitTask, WhatAHandMovedAtFirstIsLeftOut) {
  const auto result = fit(moved_by_hand(3), "phone.csv", {});
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  const FittedRecording& fitted = result->front();
  EXPECT_TRUE(fitted.succeeded());
  EXPECT_GE(fitted.series.t.front(), 2.9);
  EXPECT_LE(fitted.series.t.front(), 6);
  expect_within(fitted.find("angular_frequency"), 5.03, 0.01);
  EXPECT_THAT(in_words(fitted.notices), testing::Contains(HasSubstr("while a hand still moves it")));
  // Not where a part was asked for, and not where too little is left.
  FitOptions whole;
  whole.from = 0;
  EXPECT_THAT(in_words(fit(moved_by_hand(3), "phone.csv", whole)->front().notices),
              testing::Each(testing::Not(HasSubstr("a hand"))));
  EXPECT_THAT(in_words(fit(moved_by_hand(20), "phone.csv", {})->front().notices),
              testing::Each(testing::Not(HasSubstr("a hand"))));
}

TEST(FitTask, WhatAHandStopsAtLastIsLeftOutToo) {
  for (const double stop : {29.0, 29.4, 28.2, 25.7}) {
    const auto result = fit(moved_by_hand(3, stop), "phone.csv", {});
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    const FittedRecording& fitted = result->front();
    EXPECT_LE(fitted.series.t.back(), stop);
    EXPECT_GE(fitted.series.t.back(), stop - 1.8);
    expect_within(fitted.find("decay_rate"), 0.03, 0.007);  // laws of one term more count a little
    EXPECT_THAT(in_words(fitted.notices), testing::Contains(HasSubstr("while a hand moves or stops it")));
  }
}

// Held for a second, or half of one, after 40 s: the law of the whole would have friction in place of drag.
TEST(FitTask, AShortHoldAtTheEndIsLeftOut) {
  int seed = 0;
  for (const double level : {0.005, 0.02, 0.04})
    for (const double held : {0.5, 1.0}) {
      std::mt19937 random(static_cast<unsigned>(++seed));
      std::normal_distribution<double> noise(0, 7e-4);
      double x = 0.1, v = 0;
      std::string bytes = "Time (s),Position (m)\n";
      for (int i = 0; i < 50 * (40 + held); ++i) {
        const double t = 0.02 * i;
        bytes += fmt::format("{:.2f},{:.5f}\n", t, (t < 40 ? x : level) + noise(random));
        for (int part = 0; part < 20; ++part) {  // Euler-Cromer with 1 ms
          v -= 0.001 * (40 * x + 0.06 * v + 0.3 * v * std::abs(v));
          x += 0.001 * v;
        }
      }
      const auto result = fit(bytes, "held.csv", {});
      ASSERT_TRUE(result.ok());
      const FittedRecording& fitted = result->front();
      EXPECT_LE(fitted.series.t.back(), 40) << level << ' ' << held;
      EXPECT_GE(fitted.series.t.back(), 37) << level << ' ' << held;
      EXPECT_EQ(to_text(fitted.fit.law), "viscous+drag") << level << ' ' << held;
      expect_within(fitted.find("drag"), 0.3, 0.03);
    }
}

TEST(FitTask, FourSwingsBetweenTwoHandsAreEnough) {
  for (const double stop : {8.2, 8.4}) {
    const auto result = fit(moved_by_hand(2.5, stop, 10), "phone.csv", {});
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    const FittedRecording& fitted = result->front();
    EXPECT_GE(fitted.series.t.front(), 2.5);
    EXPECT_LE(fitted.series.t.back(), stop);
    expect_within(fitted.find("decay_rate"), 0.03, 0.1);  // friction would do as well
  }
}

TEST(FitTask, SaysThatAnAxisHoldsGravity) {
  const std::string header = "Time (s),Acceleration y (m/s^2)";
  EXPECT_THAT(said_of(swing_about(9.7, 0.5, header)),
              testing::Contains(HasSubstr("this axis holds gravity")));
  EXPECT_THAT(said_of(swing_about(0.2, 0.5, header)), testing::Each(testing::Not(HasSubstr("gravity"))));
}

TEST(FitTask, SuggestsDegreesWhereAPendulumSeemsToTurnOver) {
  const auto suggests = [](const std::string& header, double amplitude) {
    const auto said = said_of(swing_about(0, amplitude, header));
    return std::any_of(said.begin(), said.end(),
                       [](const std::string& each) { return each.find("if it is in degrees") != each.npos; });
  };
  EXPECT_TRUE(suggests("t (s),angle", 40));
  EXPECT_FALSE(suggests("t (s),angle (rad)", 40));
  EXPECT_FALSE(suggests("t (s),angle (°)", 40));
  EXPECT_FALSE(suggests("t (s),angle", 0.5));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
