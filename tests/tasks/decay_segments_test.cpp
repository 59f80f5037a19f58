// The decay rate part by part, and masses at rest: of handmade records.
#include "cromer/tasks/fit/decay_segments.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "cromer/model/sensor.h"
#include "cromer/tasks/fit/static_stiffness.h"

namespace cromer::core {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// A swing of 1 Hz that loses `rate` a second in its first 6 s and twice that in the next, 40 samples a
/// second from 10 s on.
struct Swing {
  std::vector<double> t, y;

  explicit Swing(double duration = 12, double rate = 0.1) {
    NormalDeviates noise(3);
    for (int i = 0; i <= static_cast<int>(40 * duration + 0.5); ++i) {
      const double s = i / 40.0, decay = s < 6 ? rate * s : rate * 6 + 2 * rate * (s - 6);
      t.push_back(10 + s);
      y.push_back(std::exp(-decay) * std::cos(2 * M_PI * s) + 1e-3 * noise.next());
    }
  }
  Record record() const { return {t, y, 0}; }
};

TEST(DecaySegments, AreOfALengthOrSoMany) {
  const Swing swing;
  const auto segments = [&](std::optional<double> length, std::optional<int> count) {
    return fit_segments(swing.record(), 1, length, count);
  };
  EXPECT_THAT(segments({}, {}).segments, IsEmpty());
  EXPECT_FALSE(segments({}, {}).mean);
  for (const DecaySegments& two : {segments(6, {}), segments({}, 2), segments(6, 2)}) {
    ASSERT_EQ(two.segments.size(), 2u);
    EXPECT_THAT(in_words(two.notices), IsEmpty());
    EXPECT_EQ(two.segments[0].from, 10);
    EXPECT_EQ(two.segments[0].to, 16);
    EXPECT_EQ(two.segments[1].from, 16);
    EXPECT_EQ(two.segments[1].to, 22);
    EXPECT_NEAR(two.segments[0].rate.value, 0.1, 2e-3);
    EXPECT_NEAR(two.segments[1].rate.value, 0.2, 4e-3);
    EXPECT_NEAR(two.mean->value, (two.segments[0].rate.value + two.segments[1].rate.value) / 2, 1e-12);
    EXPECT_NEAR(two.mean->standard_error,
                std::hypot(two.segments[0].rate.standard_error, two.segments[1].rate.standard_error) / 2,
                1e-12);
    EXPECT_GT(two.mean->high, two.mean->value + 1.9 * two.mean->standard_error);
  }
  const DecaySegments one = segments(6, 1);
  ASSERT_EQ(one.segments.size(), 1u);
  EXPECT_EQ(one.segments[0].to, 16);
  EXPECT_THAT(in_words(one.notices), IsEmpty());
  EXPECT_THAT(in_words(segments(6, 3).notices),
              ElementsAre("the record of 12 s holds 2 of the 3 segments of 6 s"));
  EXPECT_EQ(segments(6, 3).segments.size(), 2u);
  EXPECT_THAT(in_words(segments(13, {}).notices),
              ElementsAre("the record of 12 s is shorter than one segment of 13 s"));
  EXPECT_THAT(segments(13, {}).segments, IsEmpty());
  // The last sample stands for one step more.
  EXPECT_EQ(segments(12.025, {}).segments.size(), 1u);
}

TEST(DecaySegments, HoldAPeriodAndAHalfAndEightSamples) {
  const Swing swing;
  EXPECT_EQ(fit_segments(swing.record(), 1, 1.55, {}).segments.size(), 7u);
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, 1.5, {}).notices),
              testing::Each(testing::Not(testing::StartsWith("no decay rates"))));
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, 1.49, {}).notices),
              ElementsAre("no decay rates by segment: those of --segment 1.49 would be 1.49 s long, but a "
                          "segment must hold 1.5 periods and 8 samples, here 1.5 s"));
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, {}, 9).notices),
              ElementsAre("no decay rates by segment: those of --segments 9 would be 1.33 s long, but a "
                          "segment must hold 1.5 periods and 8 samples, here 1.5 s"));
  EXPECT_THAT(in_words(fit_segments(swing.record(), 0.1, 0.19, {}).notices),
              ElementsAre("no decay rates by segment: those of --segment 0.19 would be 0.19 s long, but a "
                          "segment must hold 1.5 periods and 8 samples, here 0.2 s"));
}

TEST(DecaySegments, WhatFailsIsLeftOutAndSaidOnce) {
  Swing swing;
  for (std::size_t i = 0; i < swing.t.size(); ++i)
    if (swing.t[i] > 13 && swing.t[i] < 16) swing.y[i] = 0.25;
  const DecaySegments one = fit_segments(swing.record(), 1, 3, {});
  EXPECT_EQ(one.segments.size(), 3u);
  ASSERT_EQ(in_words(one.notices).size(), 1u);
  EXPECT_THAT(in_words(one.notices)[0], testing::StartsWith("the segment from 13 to 16 s is left out: "));
  for (std::size_t i = 0; i < swing.t.size(); ++i)
    if (swing.t[i] > 13) swing.y[i] = 0.25;
  const DecaySegments three = fit_segments(swing.record(), 1, 3, {});
  EXPECT_EQ(three.segments.size(), 1u);
  ASSERT_EQ(in_words(three.notices).size(), 1u);
  EXPECT_THAT(in_words(three.notices)[0],
              testing::StartsWith("3 of the 4 segments are left out; the first, from 13 to 16 s: "));
  const std::atomic<bool> stop{true};
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, 3, {}, {&stop, {}}).notices),
              ElementsAre("interrupted after 0 of the 4 segments"));
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
            "f.csv: 1 masses are given for 2 runs; --masses needs one for each");
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
      "the position does not move in one direction as the mass grows: are --masses in the order of the "
      "holds?";
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

}  // namespace
}  // namespace cromer::core
