#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const ReadOptions none;

Result<Series> take(std::string_view text, std::string_view column = "", int run = 1,
                    const ReadOptions& options = {}) {
  auto recording = read_recording(text, "lab.csv", options);
  if (!recording) return recording.error();
  return take_series(*recording, column, run, options);
}

Series series(std::string_view text, std::string_view column = "", int run = 1,
              const ReadOptions& options = {}) {
  auto taken = take(text, column, run, options);
  EXPECT_TRUE(taken.ok()) << in_words(taken.error());
  return taken ? *taken : Series{};
}

std::string refusal(std::string_view text, std::string_view column = "", int run = 1,
                    const ReadOptions& options = {}) {
  const auto taken = take(text, column, run, options);
  return taken ? "taken" : in_words(taken.error());
}

/// A damped swing as text; `spoil` may change a value.
template <class Spoil>
std::string swing(int samples, double samples_per_period, int decimals, Spoil spoil) {
  std::string text = "Time (s),Position (m)\n";
  for (int i = 0; i < samples; ++i) {
    const double phase = 6.283185307179586 * i / samples_per_period;
    const double x = spoil(i, 0.3 * std::exp(-phase / 200) * std::cos(phase));
    const double scale = std::pow(10.0, decimals);
    text += concat({shortest(i * 0.01), ",", shortest(std::nearbyint(x * scale) / scale), "\n"});
  }
  return text;
}
double unspoiled(int, double x) { return x; }

TEST(TakeSeries, ConvertsToSI) {
  const Series s = series("Time (ms),Position (mm)\n0,1\n20,2\n40,4\n");
  EXPECT_THAT(s.t, ElementsAre(0, testing::DoubleEq(0.02), testing::DoubleEq(0.04)));
  EXPECT_THAT(s.y, ElementsAre(testing::DoubleEq(0.001), testing::DoubleEq(0.002), testing::DoubleEq(0.004)));
  EXPECT_EQ(s.to_si, 1e-3);
  EXPECT_EQ(s.column, "Position (mm)");
  EXPECT_DOUBLE_EQ(s.rate, 50);
  EXPECT_EQ(s.time_column, "Time (ms)");
}

TEST(TakeSeries, PrefersPositionsThenAngles) {
  EXPECT_EQ(series("t,v,x\n0,1.5,2\n1,3,4\n2,5,7\n").column, "x");
  EXPECT_EQ(series("t,omega,theta\n0,1.5,2\n1,3,4\n2,5,7\n").column, "theta");
  EXPECT_EQ(series("t,a,v\n0,1.5,2\n1,3,4\n2,5,7\n").column, "v");
  EXPECT_EQ(series("t,acc (g)\n0,1.5\n1,3\n2,5\n").to_si, 9.80665);
}

TEST(TakeSeries, UnknownUnitsAndNamesAreSaid) {
  EXPECT_THAT(in_words(series("t,x\n0,1.5\n1,2\n2,1\n").notices),
              Contains(HasSubstr("\"x\" has no unit: m is assumed; the header can name another, in brackets "
                                 "behind the column's name")));
  EXPECT_THAT(in_words(series("t,x (au)\n0,1.5\n1,2\n2,1\n").notices), Contains(HasSubstr("unit \"au\"")));
  const Series s = series("0.0 0.7 1\n0.5 0.6 2\n1.0 0.5 4\n");
  EXPECT_EQ(s.column, "column 2");
  EXPECT_THAT(in_words(s.notices), Contains(HasSubstr("no column is known to be a position")));
}

TEST(TakeSeries, AFrequencyIsNoMotion) {
  for (const char* name :
       {"Frequency (Hz)", "f (Hz)", "Frequenz", "frequenza (kHz)", "Drive frequency (rad/s)"})
    EXPECT_EQ(series(concat({"Time (s),", name, ",Signal\n0,5,1\n1,5,2\n2,5,3\n"})).column, "Signal") << name;
  EXPECT_EQ(series("Time (s),Frequency (Hz),x (m)\n0,5,1\n1,5,2\n2,5,3\n").column, "x (m)");
  EXPECT_THAT(refusal("Time (s),Frequency (Hz)\n0,5\n1,6\n2,5\n"),
              AllOf(HasSubstr("no motion"), HasSubstr("--column \"Frequency\"")));
  // Who names it has the numbers of the file.
  const Series named = series("Time (s),Frequency (kHz)\n0,5\n1,6\n2,5\n", "Frequency");
  EXPECT_THAT(named.y,
              ElementsAre(testing::DoubleEq(5000), testing::DoubleEq(6000), testing::DoubleEq(5000)));
  EXPECT_EQ(unit_of(named), "Hz");
  EXPECT_THAT(in_words(named.notices), Contains(HasSubstr("holds a frequency, which is no motion")));
  EXPECT_THAT(series("Time (s),Frequency (rad/s)\n0,6.283185307179586\n1,0\n2,0\n", "Frequency").y[0],
              testing::DoubleEq(1));
}

TEST(TakeSeries, ADisplacementInDegreesIsAnAngle) {
  for (const char* heading : {"Auslenkung in Grad", "Auslenkung in °", "Auslenkung (°)", "x / °"}) {
    const Series taken = series(std::string("Zeit in s;") + heading + "\n0;90\n1;0\n2;90\n");
    EXPECT_EQ(taken.quantity, "angle") << heading;
    EXPECT_NEAR(taken.y[0], 1.5707963, 1e-6) << heading;
  }
}

TEST(TakeSeries, TheTimeIsNoMotion) {
  EXPECT_EQ(refusal("Time (s),x (m),Force (N)\n0,1,2\n1,2,3\n2,3,4\n", "Time (s)"),
            "lab.csv: column \"Time (s)\" is the time; name the column that moves with it with --column: "
            "\"x (m)\" or \"Force (N)\"");
  EXPECT_EQ(refusal("Time (s)\n0\n1\n2\n", "Time (s)"), "lab.csv: there is no column beside the time");
}

TEST(TakeSeries, SeveralAlikeAreListed) {
  const std::string text = "t,x,y\n0,1.5,2\n1,2,3\n2,1,4\n";
  EXPECT_EQ(refusal(text),
            "lab.csv: several columns are alike: \"x\", \"y\"; say which with --column, for instance "
            "--column \"x\"; \"modes\" finds the natural frequencies of coupled motions from all of them");
  EXPECT_EQ(series(text, "y").y[0], 2);
}

TEST(TakeSeries, NamesAreMatchedLoosely) {
  const std::string text = "Time (s),Position (m) Run #1,x_{1}\n0,1.5,5\n1,2,6\n2,1,8\n";
  for (const char* name : {"Position", "Position (m)", "position", "Position (m) Run #1", "POSITION (mm)"})
    EXPECT_EQ(series(text, name).column, "Position (m)") << name;
  EXPECT_EQ(series(text, "x").column, "x_{1}");
  EXPECT_EQ(series(text, "x1").column, "x_{1}");
  EXPECT_THAT(refusal(text, "positon"), HasSubstr("did you mean \"Position\"?"));
  EXPECT_THAT(refusal(text, "tim"), testing::Not(HasSubstr("did you mean")));  // nobody means the time
  EXPECT_THAT(refusal("t,x_1,x_2\n0,1,2\n1,2,3\n2,3,4\n", "x"), HasSubstr("fits several columns"));
}

TEST(TakeSeries, NamesAloneAreNoChoice) {
  const std::string text = "Tempo,Forzante,Pendolo\n0,1.5,5\n1,2,6\n2,1,8\n";
  EXPECT_EQ(refusal(text),
            "lab.csv: no column is known to be a position, angle or velocity: \"Forzante\", \"Pendolo\"; say "
            "which with --column, for instance --column \"Forzante\"");
  EXPECT_EQ(series(text, "Pendolo").y[0], 5);
  EXPECT_EQ(series("Tempo,Pendolo\n0,1.5\n1,2\n2,1\n").column, "Pendolo");  // there is but one
  const Series s = series("0.0 0.7 1\n0.5 0.6 2\n1.0 0.5 4\n");
  EXPECT_EQ(s.column, "column 2");
  EXPECT_THAT(in_words(s.notices),
              Contains(HasSubstr("of \"column 2\", \"column 3\", \"column 2\" is taken")));
}

TEST(TakeSeries, EachSensorKeepsTheTimeBeforeIt) {
  const std::string text =
      "Time A\tPos A\tTime B\tPos B\n[s]\t[mm]\t[s]\t[mm]\n0\t1\t0.5\t7\n1\t2\t1.5\t8\n2\t4\t2.5\t9\n";
  EXPECT_EQ(series(text, "Pos A").time_column, "Time A (s)");
  EXPECT_EQ(series(text, "Pos B").time_column, "Time B (s)");
  EXPECT_THAT(series(text, "Pos B").t, ElementsAre(0.5, 1.5, 2.5));
  EXPECT_THAT(refusal(text), HasSubstr("\"Pos A (mm)\", \"Pos B (mm)\""));
}

TEST(TakeSeries, ARateGivenIsTheRate) {
  std::string text = "x (m)\n";
  for (int i = 0; i < 500; ++i) text += concat({std::to_string(i % 7), "\n"});
  for (const double rate : {100.0, 30.0, 44100.0, 33.333}) {
    ReadOptions options;
    options.rate = rate;
    EXPECT_EQ(series(text, "", 1, options).rate, rate);
    EXPECT_EQ(series(text, "", 1, options).jitter, 0);
  }
}

TEST(TakeSeries, RunsAreCountedFromOne) {
  const std::string text = "x (mm) Run #4;x (mm) Run #7\n1,5;9,5\n2,5;8,5\n3,5;\n";
  const ReadOptions options{.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 100};
  EXPECT_EQ(series(text, "", 1, options).y.size(), 3u);
  EXPECT_EQ(series(text, "", 2, options).y.size(), 2u);
  EXPECT_THAT(refusal(text, "", 3, options), HasSubstr("there is no run 3: the file has 2 runs"));
  EXPECT_DOUBLE_EQ(series(text, "", 1, options).t[2], 0.02);
  EXPECT_THAT(refusal(text), HasSubstr("--rate"));
}

TEST(TakeSeries, MissingValuesKeepTheirTime) {
  const ReadOptions options{.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 10};
  const Series s = series("x (m)\n1\n2\nNaN\n4\n5\n", "", 1, options);
  EXPECT_THAT(s.y, ElementsAre(1, 2, 4, 5));
  EXPECT_DOUBLE_EQ(s.t[2], 0.3);
  ASSERT_EQ(s.gaps.size(), 1u);
  EXPECT_DOUBLE_EQ(s.gaps[0].t, 0.1);
  EXPECT_DOUBLE_EQ(s.gaps[0].length, 0.2);
}

TEST(TakeSeries, RepeatedAndBackwardTimesAreLeftOut) {
  const Series s = series("t,x\n0,1\n1,2\n1,3\n2,4\n1.5,5\n3,6\n4,7\n");
  EXPECT_THAT(s.t, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(s.y, ElementsAre(1, 2, 4, 6, 7));
  EXPECT_THAT(s.lines, ElementsAre(2, 3, 5, 7, 8));
  EXPECT_THAT(in_words(s.notices), Contains("1 row with a repeated time left out, the first in line 4"));
  EXPECT_THAT(in_words(s.notices), Contains("1 row with a backward time left out, the first in line 6"));
}

TEST(TakeSeries, ATimeThatNeverRisesIsRefused) {
  EXPECT_THAT(refusal("t,x\n3,1\n2,2\n1,3\n0,4\n"), HasSubstr("column \"t\": the time runs backward"));
  EXPECT_THAT(refusal("t,x\n3,1\n3,2\n3,3\n"), HasSubstr("the time stands still"));
  // Steps whose rate, or whose length, no double holds.
  EXPECT_THAT(refusal("t,x\n0,1\n5e-324,2\n1e-323,3\n"),
              HasSubstr("\"t\": from 0 to 5e-324 is no step of time"));
  EXPECT_THAT(refusal("t,x\n-1.7e308,1\n1.7e308,2\n"), HasSubstr("is no step of time"));
}

TEST(TakeSeries, ARestartBeginsTheNextRun) {
  std::string text = "t,x\n";
  for (int run = 0; run < 2; ++run)
    for (int i = 0; i < 20 - 5 * run; ++i)
      text += concat({shortest(0.1 * i), ",", std::to_string(i % 5 + run), "\n"});
  const auto recording = read_recording(text, "lab.csv", none);
  ASSERT_TRUE(recording.ok());
  EXPECT_THAT(runs(*recording), ElementsAre(1, 2));
  EXPECT_THAT(in_words(recording->notices),
              ElementsAre("the time starts again in line 22: the file is read as 2 runs"));
  EXPECT_EQ(series(text).t.size(), 20u);
  const Series second = series(text, "", 2);
  EXPECT_EQ(second.t.size(), 15u);
  EXPECT_EQ(second.y[3], 4);
  EXPECT_EQ(second.lines[3], 25);
  // One backward time is a glitch.
  std::string glitch = "t,x\n";
  for (int i = 0; i < 40; ++i)
    glitch += concat({i == 30 ? "0" : shortest(0.1 * i), ",", std::to_string(i), "\n"});
  EXPECT_THAT(in_words(series(glitch).notices),
              Contains("1 row with a backward time left out, the first in line 32"));
  EXPECT_EQ(series(glitch).t.size(), 39u);
}

TEST(TakeSeries, TheStepIsTheMedianOfAll) {
  EXPECT_DOUBLE_EQ(series("t,x\n0,1\n5,2\n6,3\n7,2\n8,1\n").rate, 1);
  const Series jittery = series("t,x\n0,1\n1,2\n2.5,3\n3,2\n4,1\n");
  // steps 1, 1.5, 0.5, 1: median 1, standard deviation sqrt(1/8)
  EXPECT_NEAR(jittery.jitter, std::sqrt(0.125), 1e-15);
  EXPECT_TRUE(jittery.gaps.empty());
}

TEST(TakeSeries, CleanSwingsHaveNoOutliers) {
  for (const double samples_per_period : {7.0, 20.0, 100.0, 1000.0})
    for (const int decimals : {1, 2, 3, 4, 9})
      EXPECT_TRUE(series(swing(4000, samples_per_period, decimals, unspoiled)).outliers.empty())
          << samples_per_period << ' ' << decimals;
}

TEST(TakeSeries, NoisySwingsHaveNoOutliers) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.003);
  for (const double samples_per_period : {10.0, 100.0})
    EXPECT_TRUE(series(swing(12000, samples_per_period, 4, [&](int, double x) {
                  return x + noise(random);
                })).outliers.empty());
}

TEST(TakeSeries, StepsAndReleasesAreNoOutliers) {
  EXPECT_TRUE(
      series(swing(2000, 100, 4, [](int i, double x) { return i < 300 ? 0.2 : x; })).outliers.empty());
  EXPECT_TRUE(
      series(swing(2000, 100, 3, [](int i, double) { return i % 37 == 0 ? 0.101 : 0.1; })).outliers.empty());
}

TEST(TakeSeries, TopsThatAreCutOffAreSaid) {
  const auto says = [](const Series& s) {
    return std::any_of(s.notices.begin(), s.notices.end(),
                       [](const Notice& notice) { return notice.code == "column_tops_cut_off"; });
  };
  for (const int decimals : {2, 3, 4, 6})
    EXPECT_FALSE(says(series(swing(4000, 100, decimals, unspoiled)))) << decimals;
  EXPECT_TRUE(says(series(swing(4000, 100, 4, [](int, double x) { return std::min(x, 0.2); }))));
}

TEST(TakeSeries, WhatNeverChangesHasNoOutliers) {
  EXPECT_TRUE(series(swing(3000, 100, 4, [](int, double) { return 0.3; })).outliers.empty());
}

TEST(TakeSeries, AnUnknownUnitIsNotTakenForMetres) {
  EXPECT_EQ(series("t (s),x (px)\n0,1.5\n1,2\n2,1\n").quantity, "");
  EXPECT_EQ(series("t (s),x (mm)\n0,1.5\n1,2\n2,1\n").quantity, "position");
}

TEST(TakeSeries, SpikesAreListedAndStay) {
  const Series s =
      series(swing(2000, 100, 4, [](int i, double x) { return i == 700 || i == 1500 ? x + 0.4 : x; }));
  ASSERT_EQ(s.outliers.size(), 2u);
  EXPECT_EQ(s.outliers[0].line, 702);
  EXPECT_NEAR(s.outliers[0].t, 7.0, 1e-12);
  EXPECT_EQ(s.y[700], s.outliers[0].value);
  EXPECT_THAT(in_words(s.notices), Contains("2 samples stick out alone, the first in line 702"));
}

TEST(TakeSeries, RoundedTimesAreMadeEvenWhereTheyWere) {
  std::string text = "Time (s),Position (m)\n";
  for (int i = 0; i < 600; ++i)
    text += concat({shortest(std::nearbyint(i / 0.6) / 100), ",", shortest(std::sin(0.1 * i)), "\n"});
  const Series s = series(text);
  EXPECT_EQ(s.rate, 60);
  EXPECT_TRUE(s.gaps.empty());
  for (std::size_t i = 0; i < 600; ++i) ASSERT_NEAR(s.t[i], static_cast<double>(i) / 60, 1e-3) << i;
  EXPECT_THAT(in_words(s.notices), ElementsAre(HasSubstr("the times are rounded to 0.01 s")));
}

TEST(TakeSeries, RoundingToTwoLevelsIsNotClipping) {
  for (const double size : {0.4, 0.5, 0.7, 1.3}) {
    const auto steps = [&](int i, double) { return 0.01 * std::nearbyint(size * std::cos(0.1 * i) + 0.3); };
    const Series s = series(swing(3000, 60, 2, steps));
    EXPECT_DOUBLE_EQ(s.resolution, 0.01) << size;
    EXPECT_THAT(in_words(s.notices), Not(Contains(HasSubstr("out of its range")))) << size;
  }
}

TEST(TakeSeries, RoundingIsSeen) {
  EXPECT_DOUBLE_EQ(series(swing(4000, 100, 4, unspoiled)).resolution, 1e-4);
  EXPECT_DOUBLE_EQ(series(swing(4000, 100, 2, unspoiled)).resolution, 1e-2);
  EXPECT_EQ(series(swing(4000, 100, 14, unspoiled)).resolution, 0);
  // An encoder's step that is no decimal place.
  const Series s =
      series(swing(4000, 100, 14, [](int, double x) { return std::nearbyint(x / 0.0052) * 0.0052; }));
  EXPECT_NEAR(s.resolution, 0.0052, 1e-8);
}

TEST(CleanTable, PutsTimeFirstAndKeepsUnits) {
  const auto recording = read_recording("Position (mm),Time (ms)\n1,0\n2,20\n5,20\n,40\n", "lab.csv", none);
  ASSERT_TRUE(recording.ok());
  const auto clean = clean_table(*recording, none);
  ASSERT_TRUE(clean.ok());
  ASSERT_EQ(clean->columns.size(), 2u);
  EXPECT_EQ(column_heading(*clean, 0), "Time (s)");
  EXPECT_EQ(column_heading(*clean, 1), "Position (mm)");
  EXPECT_THAT(clean->columns[0].values, ElementsAre(0, testing::DoubleEq(0.02), testing::DoubleEq(0.04)));
  EXPECT_THAT(clean->columns[1].values, ElementsAre(1, 2, testing::IsNan()));
}

TEST(CleanTable, ReadsBackAsItself) {
  const ReadOptions options{.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 100};
  const auto recording =
      read_recording("x (mm) Run #1;x (mm) Run #2\n1,5;9,5\n2,5;8,5\n3,5;\n", "lab.csv", options);
  ASSERT_TRUE(recording.ok());
  const auto clean = clean_table(*recording, options);
  ASSERT_TRUE(clean.ok());
  std::string text;
  for (std::size_t j = 0; j < clean->columns.size(); ++j)
    text += concat({j ? "," : "", column_heading(*clean, j)});
  for (std::size_t i = 0; i < clean->rows(); ++i) {
    text += '\n';
    for (std::size_t j = 0; j < clean->columns.size(); ++j) {
      const double value = clean->columns[j].values[i];
      text += concat({j ? "," : "", std::isnan(value) ? "" : shortest(value)});
    }
  }
  const auto again = read_recording(text, "clean.csv", none);
  ASSERT_TRUE(again.ok()) << in_words(again.error());
  ASSERT_EQ(again->table.columns.size(), clean->columns.size());
  for (std::size_t j = 0; j < clean->columns.size(); ++j) {
    EXPECT_EQ(again->table.columns[j].run, clean->columns[j].run);
    EXPECT_EQ(again->table.columns[j].unit, clean->columns[j].unit);
    for (std::size_t i = 0; i < clean->rows(); ++i) {
      const double a = again->table.columns[j].values[i], b = clean->columns[j].values[i];
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)));
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
