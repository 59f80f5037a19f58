// From the options of spectrum to what is computed: each limit from both sides, each sentence whole.
#include "cromer/tasks/spectrum/spectrum_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

template <class T>
std::string said(const Result<T>& result) {
  return result ? "" : in_words(result.error());
}

TEST(SpectrumSetup, WordsAreKnownOrTheNearestIsNamed) {
  EXPECT_EQ(*peaks_of({}), Peaks::continuous);
  EXPECT_EQ(*peaks_of({.peaks = "continuous"}), Peaks::continuous);
  EXPECT_EQ(*peaks_of({.peaks = "samples"}), Peaks::samples);
  EXPECT_EQ(*peaks_of({.peaks = "peer"}), Peaks::peer);
  EXPECT_EQ(said(peaks_of({.peaks = "sample"})),
            "--peaks: \"sample\" is not known; it takes continuous, samples or peer (did you mean samples?)");
  EXPECT_EQ(said(peaks_of({.peaks = "zzzzzzzzzz"})),
            "--peaks: \"zzzzzzzzzz\" is not known; it takes continuous, samples or peer");
  EXPECT_EQ(*between_of({}), BetweenSamples::linear);
  EXPECT_EQ(*between_of({.between_samples = "hold"}), BetweenSamples::hold);
  EXPECT_EQ(*between_of({.between_samples = "band-limited"}), BetweenSamples::band_limited);
  EXPECT_THAT(said(between_of({.between_samples = "auto"})),
              StartsWith("--between-samples: \"auto\" is not known; it takes linear, hold or band-limited"));
}

TEST(SpectrumSetup, DampingLiesBetweenItsLimits) {
  EXPECT_THAT(*damping_ratios_of({}), ElementsAre(0.05));
  EXPECT_THAT(*damping_ratios_of({.damping_ratio = {"0", "0.1,20"}}), ElementsAre(0, 0.1, 20));
  EXPECT_EQ(said(damping_ratios_of({.damping_ratio = {"0.1,-0.1"}})),
            "--damping-ratio: it must lie between 0 and 20, not -0.1");
  EXPECT_EQ(said(damping_ratios_of({.damping_ratio = {"20.5"}})),
            "--damping-ratio: it must lie between 0 and 20, not 20.5");
  EXPECT_THAT(*damping_ratios_of({.loss_factor = {"0.001,2"}}), ElementsAre(0.001, 2));
  EXPECT_EQ(said(damping_ratios_of({.loss_factor = {"0.0005"}})),
            "--loss-factor: it must lie between 0.001 and 2, not 5e-04");
  EXPECT_EQ(said(damping_ratios_of({.loss_factor = {"2.5"}})),
            "--loss-factor: it must lie between 0.001 and 2, not 2.5");
  EXPECT_EQ(said(damping_ratios_of({.damping_ratio = {"1"}, .loss_factor = {"1"}})),
            "--damping-ratio and --loss-factor both say how the springs are damped; leave one of them out");
  EXPECT_THAT(said(damping_ratios_of({.damping_ratio = {"much"}})), StartsWith("--damping-ratio: "));
  EXPECT_THAT(said(damping_ratios_of({.loss_factor = {"much"}})), StartsWith("--loss-factor: "));
}

/// 101 samples, one each 0.01 s.
Component second() {
  Component component;
  component.acceleration.assign(101, 1);
  component.samples = 101;
  component.spacing = 0.01;
  return component;
}

TEST(SpectrumSetup, OscillatorsAreByPeriodOrByFrequency) {
  EXPECT_EQ(second().duration(), 1);
  SpectrumOptions options;
  EXPECT_EQ(periods_of(options, second(), 1)->size(), 200u);
  EXPECT_EQ(options.periods, "0.01:10:200:log");
  EXPECT_EQ(options.frequencies, "");
  options = {.shock = true};
  const auto shock = periods_of(options, second(), 1);
  EXPECT_EQ(options.periods, "");
  EXPECT_EQ(options.frequencies, "0.1:10:200:log Hz");
  EXPECT_NEAR(shock->front(), 10, 1e-12);
  EXPECT_NEAR(shock->back(), 0.1, 1e-12);
  options = {.frequencies = "2,4"};
  EXPECT_THAT(*periods_of(options, second(), 1),
              ElementsAre(testing::DoubleEq(std::numbers::pi), testing::DoubleEq(std::numbers::pi / 2)));
  options = {.periods = "1", .frequencies = "1"};
  EXPECT_EQ(said(periods_of(options, second(), 1)),
            "--periods and --frequencies both say which oscillators there are; leave one of them out");
}

TEST(SpectrumSetup, PeriodsSuitTheRecording) {
  const auto periods = [](const char* text) {
    SpectrumOptions options{.periods = text};
    return said(periods_of(options, second(), 1));
  };
  EXPECT_EQ(periods("1,0"), "--periods: it must be positive, not 0 s");
  EXPECT_EQ(periods("1.01e-5"), "");
  EXPECT_EQ(
      periods("1,9.5e-6"),
      "--periods: 9.5e-06 s is a period below a thousandth of the sampling step (0.01 s): such an oscillator "
      "moves with the ground, its PSA is the ground's own peak; ask for longer ones");
  EXPECT_EQ(periods("1e6"), "");
  EXPECT_EQ(
      periods("1,1000001"),
      "--periods: 1000001 s is a period of more than a million times the recording (1 s); ask for shorter "
      "ones");
  EXPECT_THAT(periods("long"), StartsWith("--periods: "));
  SpectrumOptions slow{.frequencies = "-1"};
  EXPECT_EQ(said(periods_of(slow, second(), 1)), "--frequencies: it must be positive, not -1 rad/s");
  // 64 bytes and 600 for each damping ratio, for each of two periods.
  SpectrumOptions two{.periods = "1,2", .memory = 2 * (64 + 600 * 3)};
  EXPECT_TRUE(periods_of(two, second(), 3));
  two.memory -= 1;
  EXPECT_FALSE(periods_of(two, second(), 3));
}

TEST(SpectrumSetup, DoubtfulPeriodsAreSaidWordForWord) {
  const auto notices = [](std::vector<double> periods, Peaks peaks, const SpectrumOptions& options) {
    return in_words(period_notices(options, periods, second(), peaks));
  };
  const SpectrumOptions options{.periods = "given", .peaks = "peer"};
  EXPECT_THAT(notices({0.02, 1}, Peaks::peer, options), IsEmpty());
  const std::string end =
      " below 0.02 s, twice the sampling step of 0.01 s: the recording holds nothing that fast, and what is "
      "shown "
      "there comes from how its samples were joined";
  EXPECT_THAT(notices({1, 0.019}, Peaks::peer, options), ElementsAre("--periods: one period is" + end));
  EXPECT_THAT(notices({0.01, 0.019, 1}, Peaks::peer, {.frequencies = "given"}),
              ElementsAre("--frequencies: 2 periods are" + end));
  EXPECT_THAT(notices({2, 1}, Peaks::continuous, options), IsEmpty());
  EXPECT_THAT(
      notices({2, 1}, Peaks::peer, options),
      ElementsAre(
          "--peaks peer: the recording (1 s) is shorter than the longest period (2 s), whose peak may "
          "come after its end; continuous counts that too"));
}

SpectrumFile file_of(const char* name, const char* heading, const char* unit, int samples, double first = 1) {
  std::string bytes =
      std::string("time (s),") + heading + (*unit ? std::string(" (") + unit + ")" : "") + "\n";
  for (int i = 0; i < samples; ++i) bytes += std::to_string(i * 0.5) + "," + shortest(first + (i % 3)) + "\n";
  return {name, bytes};
}

struct Read {
  std::vector<Component> components{};
  std::vector<Notice> notices{};
  std::string refusal{};
};

Read read(const std::vector<SpectrumFile>& files, const SpectrumOptions& options = {}) {
  Read all;
  auto components = read_components(*recordings_of(files, options), options, all.notices);
  all.refusal = said(components);
  if (components) all.components = *std::move(components);
  return all;
}

TEST(SpectrumSetup, AnAccelerationHasItsUnitOrIsGivenOne) {
  const SpectrumFile bare = file_of("a.csv", "acceleration", "", 9),
                     g = file_of("b.csv", "acceleration", "g", 9);
  EXPECT_THAT(in_words(read({g}).notices), IsEmpty());
  EXPECT_DOUBLE_EQ(read({g}).components.at(0).acceleration[1], 2 * 9.80665);
  EXPECT_THAT(in_words(read({bare}).notices),
              ElementsAre("a.csv: column \"acceleration\" has no unit of acceleration and is taken as m/s^2; "
                          "--unit names another"));
  EXPECT_EQ(read({bare}).components.at(0).acceleration[1], 2);
  const Read said_so = read({bare}, {.unit = "g"});
  EXPECT_THAT(in_words(said_so.notices), IsEmpty());
  EXPECT_DOUBLE_EQ(said_so.components.at(0).acceleration[1], 2 * 9.80665);
  EXPECT_DOUBLE_EQ(read({file_of("c.csv", "acceleration", "mg", 9)}).components.at(0).acceleration[1],
                   2e-3 * 9.80665);
  const SpectrumFile share = file_of("d.csv", "acceleration", "%", 9);
  EXPECT_THAT(
      in_words(read({share}).notices),
      ElementsAre("d.csv: column \"acceleration (%)\" has no unit of acceleration and is taken as m/s^2; "
                  "--unit names another"));
  EXPECT_EQ(read({share}).components.at(0).acceleration[1], 2);
  EXPECT_DOUBLE_EQ(read({share}, {.unit = "mg"}).components.at(0).acceleration[1], 2e-3 * 9.80665);
  EXPECT_EQ(read({g}, {.unit = "g"}).refusal,
            "--unit: b.csv: column \"acceleration (g)\" has its unit already; leave --unit out");
  EXPECT_EQ(read({bare}, {.unit = "m/s"}).refusal,
            "--unit: \"m/s\" is no unit of acceleration; for instance g, m/s^2 or cm/s^2");
  EXPECT_EQ(read({file_of("a.csv", "acceleration", "m/s^2", 9, 1e100)}).refusal, "");
  EXPECT_EQ(read({file_of("a.csv", "acceleration", "m/s^2", 9, 2e100)}).refusal,
            "a.csv: column \"acceleration (m/s^2)\" has 2e+100 m/s^2 at sample 1: nothing shakes like that; "
            "mend the "
            "recording");
}

TEST(SpectrumSetup, TwoComponentsAreCutToTheShorter) {
  const SpectrumFile long_one = file_of("a.csv", "acceleration", "g", 12, 2),
                     short_one = file_of("b.csv", "acceleration", "g", 9);
  EXPECT_THAT(in_words(read({long_one, short_one}).notices),
              ElementsAre("a.csv is longer than b.csv: its last 3 samples are left out"));
  EXPECT_THAT(in_words(read({short_one, long_one}).notices),
              ElementsAre("a.csv is longer than b.csv: its last 3 samples are left out"));
  EXPECT_EQ(read({short_one, long_one}).components.at(1).acceleration.size(), 9u);
  EXPECT_THAT(
      in_words(read({short_one, short_one}).notices),
      ElementsAre("b.csv \"acceleration (g)\" and b.csv \"acceleration (g)\" hold the same samples: one "
                  "component given twice, so RotD50 is its own spectrum and RotD100 sqrt(2) times that"));
  EXPECT_EQ(read({short_one, short_one, short_one}).refusal,
            "spectrum takes one recording, or the two components of one motion; 3 are given");
  EXPECT_EQ(read({short_one, long_one}, {.column = {"acceleration", "acceleration"}}).refusal,
            "spectrum takes one recording, or the two components of one motion; 4 are given");
}

TEST(Correction, ABandHasTwoCornersOrOne) {
  const auto band = [](const std::string& text) {
    const auto correction = correction_of({.band_pass = text});
    EXPECT_TRUE(correction) << said(correction);
    return correction ? *correction->band : PassBand{};
  };
  EXPECT_EQ(band("0.1:25 Hz").low, 0.1);
  EXPECT_EQ(band("0.1:25 Hz").high, 25);
  EXPECT_EQ(band("0.1 Hz:").low, 0.1);
  EXPECT_FALSE(band("0.1 Hz:").has_high());
  EXPECT_EQ(band(":25").low, 0);
  EXPECT_EQ(band(":25").high, 25);
  const auto refused = [](const std::string& text) { return said(correction_of({.band_pass = text})); };
  const auto two = [](const std::string& text) {
    return "--band-pass: \"" + text +
           "\": two corners with a colon between them are expected, \"0.1:25 Hz\", or one of them, \"0.1 "
           "Hz:\", \":25 Hz\"";
  };
  for (const std::string text : {"5 Hz", ":", "1:2:3", "1,2:3", "1:2,3", "1,2:"})
    EXPECT_EQ(refused(text), two(text));
  for (const std::string text : {"25:0.1 Hz", "1:1", "0:5", "-1:5", ":0", "0:"})
    EXPECT_EQ(refused(text),
              "--band-pass: \"" + text + "\": the corners must be positive, and the second one the higher");
}

TEST(Correction, ItsOptionsGoWithABand) {
  EXPECT_FALSE(correction_of({})->any());
  EXPECT_EQ(*correction_of({.baseline = "cubic"})->baseline, 3);
  EXPECT_TRUE(correction_of({.baseline = "constant"})->any());
  EXPECT_EQ(said(correction_of({.band_pass_order = 2})),
            "--band-pass-order says how --band-pass filters; give that too");
  EXPECT_EQ(said(correction_of({.causal = true})), "--causal says how --band-pass filters; give that too");
  const auto of_order = [](int order) {
    return correction_of({.band_pass = "1:5", .band_pass_order = order, .causal = true});
  };
  for (const int order : {1, 12}) EXPECT_EQ(of_order(order)->order, order);
  EXPECT_TRUE(of_order(1)->causal);
  EXPECT_EQ(correction_of({.band_pass = "1:5"})->order, 4);
  for (const int order : {0, 13})
    EXPECT_EQ(said(of_order(order)),
              "--band-pass-order: it must lie between 1 and 12, not " + std::to_string(order));
}

TEST(Correction, ABaselineIsTakenOff) {
  Component component;
  component.file = "shake.csv";
  component.spacing = 0.1;
  component.acceleration = {1, 3, 5, 7};
  Component straight = component;
  ASSERT_TRUE(correct(straight, {.baseline = 1}));
  for (const double a : straight.acceleration) EXPECT_NEAR(a, 0, 1e-14);
  EXPECT_NEAR(straight.baseline, 7, 1e-14);
  ASSERT_TRUE(correct(component, {.baseline = 0}));
  EXPECT_THAT(component.acceleration, ElementsAre(-3, -1, 1, 3));
  EXPECT_EQ(component.baseline, 4);
  EXPECT_TRUE(correct(component, {.baseline = 2}));
  EXPECT_EQ(said(correct(component, {.baseline = 3})),
            "--baseline: shake.csv: 4 samples are too few for this polynomial; take a lower degree");
}

TEST(Correction, AFilterNeedsTheRecordingToHoldItsCorners) {
  Component component;
  component.file = "shake.csv";
  component.spacing = 0.01;
  component.acceleration.assign(200, 0);
  component.acceleration[100] = 1;
  const auto refused = [&](PassBand band) {
    Component copy = component;
    return said(correct(copy, {.band = band}));
  };
  EXPECT_EQ(refused({.low = 1, .high = 49.9}), "");
  EXPECT_EQ(
      refused({.low = 1, .high = 50}),
      "--band-pass: shake.csv: a corner of 50 Hz is not below half the sampling rate, 50 Hz: the recording "
      "holds nothing that fast; leave the high corner out");
  EXPECT_EQ(
      refused({.low = 50}),
      "--band-pass: shake.csv: a corner of 50 Hz is not below half the sampling rate, 50 Hz: the recording "
      "holds nothing that fast; leave the high corner out");
  EXPECT_EQ(
      refused({.low = 1e-6}),
      "--band-pass: shake.csv: a corner of 1e-06 Hz is far slower than the recording of 2 s shows; take a "
      "higher one");
  // What it rings with dies down in zeros before and behind, or behind alone.
  Component both = component, causal = component;
  ASSERT_TRUE(correct(both, {.band = PassBand{.low = 1}}));
  ASSERT_TRUE(correct(causal, {.band = PassBand{.low = 1}, .causal = true}));
  const std::size_t zeros = causal.acceleration.size() - 200;
  EXPECT_GT(zeros, 50u);
  EXPECT_EQ(both.acceleration.size(), 200 + 2 * zeros);
  EXPECT_EQ(causal.begins, 0);
  EXPECT_NEAR(both.begins, -0.01 * static_cast<double>(zeros), 1e-12);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(causal.acceleration[i], 0);
  const std::size_t middle = zeros + 100;
  for (std::size_t i = 1; i < 100; ++i)
    EXPECT_NEAR(both.acceleration[middle - i], both.acceleration[middle + i], 1e-9);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
