// Which column is taken as the series, what is said of it, and what the table's edges do to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Series series(std::string_view text, std::string_view column = "", const ReadOptions& options = {},
              int run = 1) {
  auto taken = take_series(read(text, options), column, run, options);
  EXPECT_TRUE(taken.ok()) << in_words(taken.error());
  return taken ? *taken : Series{};
}

std::string refusal(std::string_view text, std::string_view column = "", const ReadOptions& options = {},
                    int run = 1) {
  const auto taken = take_series(read(text, options), column, run, options);
  return taken ? "taken" : in_words(taken.error());
}

const ReadOptions ten{.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 10};

TEST(Series, TheQuantitiesComeInTheirOrder) {
  const std::string rows = "\n0,1,2\n1,2,4\n2,4,5\n";
  const auto taken = [&](const char* names) { return series(concat({"t (s),", names, rows})).column; };
  EXPECT_EQ(taken("v (m/s),omega (rad/s)"), "omega (rad/s)");
  EXPECT_EQ(taken("a (m/s^2),v (m/s)"), "v (m/s)");
  EXPECT_EQ(taken("F (N),a (m/s^2)"), "a (m/s^2)");
  EXPECT_EQ(taken("omega (rad/s),phi (rad)"), "phi (rad)");
  EXPECT_EQ(taken("n,q"), "q");
}

TEST(Series, WithoutAMotionItSaysSo) {
  EXPECT_EQ(refusal("t (s),f (Hz),g (Hz)\n0,1,2\n1,2,3\n2,4,5\n"),
            "lab.txt: there is no motion beside the time: \"f (Hz)\", \"g (Hz)\" hold frequencies; to fit "
            "one all the same, name it with --column, for instance --column \"f\"");
  EXPECT_THAT(refusal("t (s),f (Hz)\n0,1\n1,2\n2,4\n"), HasSubstr("\"f (Hz)\" holds a frequency; to fit"));
  EXPECT_EQ(refusal("t (s)\n0\n1\n2\n"), "lab.txt: there is no column beside the time");
  EXPECT_EQ(refusal("t (s),n\n0,5\n1,5\n2,6\n"), "lab.txt: there is no column beside the time");
  EXPECT_THAT(in_words(series("t (s),q\n0,5\n1,6\n2,5\n").notices),
              Contains("no column is known to be a position, angle or velocity: \"q\" is taken"));
  EXPECT_THAT(in_words(series("0.0 0.7 1\n0.5 0.6 2\n1.0 0.5 4\n").notices),
              Contains("no column is known to be a position, angle or velocity: of \"column 2\", "
                       "\"column 3\", \"column 2\" is taken; --column names another"));
}

TEST(Series, MissingAndUnknownUnitsAreSaid) {
  EXPECT_THAT(in_words(series("t (s),q\n0,5\n1,6\n2,5\n", "q").notices),
              ElementsAre("column \"q\" has no unit: its values are taken as they are"));
  EXPECT_THAT(in_words(series("t,x (px)\n0,5\n1,6\n2,5\n").notices),
              ElementsAre("unit \"px\" of column \"x\" is not known: its values are taken as they are",
                          "column \"t\" has no unit: s is assumed; the header can name another, in brackets "
                          "behind the column's name"));
  EXPECT_THAT(in_words(series("t (s),x (m)\n0,5\n1,6\n2,5\n").notices), IsEmpty());
  EXPECT_EQ(unit_of(series("t (s),x (px)\n0,5\n1,6\n2,5\n")), "px");
  EXPECT_EQ(unit_of(series("t (s),q (kg)\n0,5\n1,6\n2,5\n")), "kg");
  EXPECT_EQ(unit_of(series("t (s),q (mA)\n0,5\n1,6\n2,5\n")), "");
  EXPECT_EQ(series("t (s),phi (foo)\n0,5\n1,6\n2,5\n").quantity, "");
  EXPECT_EQ(series("t (s),v (foo)\n0,5\n1,6\n2,5\n").quantity, "velocity");
  EXPECT_EQ(series("t (s),phi\n0,5\n1,6\n2,5\n").quantity, "angle");
}

TEST(Series, ARateIsNotUsedBesideTimes) {
  const Series s = series("t (s),x (m)\n0,5\n1,6\n2,5\n", "", ten);
  EXPECT_THAT(in_words(s.notices), ElementsAre("--rate is not used: the times stand in \"t (s)\""));
  EXPECT_EQ(s.rate, 1);
  const Series rated = series("x (m)\n5\n6\n5\n", "", ten);
  EXPECT_EQ(rated.rate, 10);
  EXPECT_EQ(rated.time_column, "");
  EXPECT_THAT(rated.t, ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(in_words(rated.notices), IsEmpty());
  EXPECT_EQ(series("x (m)\n5\n", "", ten).rate, 0);
  EXPECT_EQ(
      refusal("x (m)\n5\n6\n"),
      "lab.txt: there is no time column: give the samples per second with --rate, or name the column with "
      "--time-column");
  for (const double wrong : {-1.0, HUGE_VAL, std::nan("")}) {
    ReadOptions options;
    options.rate = wrong;
    EXPECT_EQ(in_words(read_recording("1 2\n", "lab.txt", options).error()),
              "--rate must be a number of samples per second above 0");
  }
}

TEST(Series, OneRunOrSeveralAreCounted) {
  EXPECT_EQ(refusal("t (s),x (m)\n0,5\n1,6\n", "", {}, 2), "lab.txt: there is no run 2: the file has 1 run");
  EXPECT_EQ(refusal("t,x Run #1,x Run #2\n0,1,2\n1,2,3\n", "", {}, 0),
            "lab.txt: there is no run 0: the file has 2 runs");
  EXPECT_EQ(refusal("t (s),x (m)\n0,\n1,\n"), "lab.txt: column \"x (m)\" of run 1 has no values");
}

TEST(Series, OneSampleIsTaken) {
  const Series one = series("t (s),x (m)\n7,5\n");
  EXPECT_THAT(one.t, ElementsAre(7));
  EXPECT_EQ(one.rate, 0);
  EXPECT_THAT(in_words(one.notices), ElementsAre("column \"x (m)\" never changes"));
  const Series two = series("t (s),x (m)\n7,5\n7.5,6\n");
  EXPECT_EQ(two.rate, 2);
  EXPECT_THAT(in_words(two.notices), IsEmpty());
  EXPECT_THAT(in_words(series("t (s),x (m)\n0,5\n1,5\n").notices),
              ElementsAre("column \"x (m)\" never changes"));
}

TEST(Series, GapsAreCountedAndTheLongestIsNamed) {
  std::string text = "t (s),x (m)\n";
  for (int i = 0; i < 60; ++i)
    if (i != 20 && (i < 40 || i > 42)) text += concat({std::to_string(i), ",", std::to_string(i % 7), "\n"});
  const Series s = series(text);
  EXPECT_THAT(in_words(s.notices), ElementsAre("2 gaps between samples, the longest 4.00 s at 39.0000 s"));
  EXPECT_EQ(s.gaps.size(), 2u);
}

TEST(Series, OneSampleSticksOutAlone) {
  std::string text = "t (s),x (m)\n", force = "t (s),F (N)\n";
  for (int i = 0; i < 60; ++i) {
    const std::string row = concat({std::to_string(i), ",", shortest(i == 30 ? 9 : 0.01 * i), "\n"});
    text += row, force += row;
  }
  EXPECT_THAT(in_words(series(text).notices), ElementsAre("1 sample sticks out alone, the first in line 32"));
  EXPECT_THAT(in_words(series(force).notices), Contains("1 sample sticks out alone, the first in line 32"));
  ASSERT_EQ(series(text).outliers.size(), 1u);
  EXPECT_EQ(series(text).outliers[0].value, 9);
  EXPECT_EQ(series(text).outliers[0].t, 30);
}

TEST(Series, TheResolutionIsInSI) {
  std::string text = "t (s),x (mm)\n";
  for (int i = 0; i < 60; ++i) text += concat({std::to_string(i), ",", shortest(17 * i % 61 * 0.5), "\n"});
  EXPECT_DOUBLE_EQ(series(text).resolution, 0.0001);
}

TEST(CountedStep, ANumberOfRowsAndAStepMakeATime) {
  EXPECT_THAT(in_words(read("3 0.5\n5\n6\n5\n").notices),
              ElementsAre("the line \"3 0.5\" counts the rows: 0.5 s is taken as their step"));
  EXPECT_EQ(read("3 0.5\n5\n6\n5\n").table.columns.size(), 2u);
  EXPECT_EQ(read("a\n4 9\n 3 0.5\n5\n6\n5\n").table.columns.size(), 2u);
  for (const char* none :
       {"4 0.5\n5\n6\n5\n", "3 0.5 1\n5\n6\n5\n", "x\n3 0\n5\n6\n5\n", "x\n3 x\n5\n6\n5\n"})
    EXPECT_NE(read(none).table.columns.at(0).quantity, "time") << none;
  EXPECT_EQ(read("3 0.5\n5\n6\n5\n", ten).table.columns.size(), 1u);
}

TEST(NumberRuns, ColumnsWithoutALabelBelongToTheirNeighbours) {
  const auto run = [](const char* names) {
    std::string all, rows = "0", next = "1";
    for (int j = 1; j < 1 + std::count(names, names + std::string_view(names).size(), ','); ++j)
      rows += ",5", next += ",6";
    for (const Column& column : read(concat({names, "\n", rows, "\n", next, "\n"})).table.columns)
      all += std::to_string(column.run);
    return all;
  };
  EXPECT_EQ(run("t (s),x Run #1,q,x Run #2,q2"), "11122");
  EXPECT_EQ(run("t (s),x Run #1,t (s),x Run #2"), "1122");
  EXPECT_EQ(run("x Run #1,t (s),x Run #2,t (s)"), "1222");
  EXPECT_EQ(run("q,x Run #1,x Run #2"), "112");
  EXPECT_EQ(run("x Run #1,x Run #2,x Run #1"), "123");
  EXPECT_EQ(run("x Run #1,x Run #2,y Run #1"), "121");
  EXPECT_EQ(run("t (s),x (m),y (m)"), "111");
  EXPECT_EQ(run("x (m),x (mm),x (m)"), "112");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
