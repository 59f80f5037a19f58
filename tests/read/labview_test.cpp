// LabVIEW's measurement files: separators, units and segments of their headers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string head(const std::string& x_columns, const std::string& more = "") {
  return concat({"LabVIEW Measurement\t\nX_Columns\t", x_columns, "\n", more, "***End_of_Header***\t\n\n"});
}

const std::string end = "***End_of_Header***\n";
const std::string rows = "0\t1\t2\n1\t2\t4\n2\t3\t6\n";

TEST(LabViewFile, SeparatorAndTimesStandInItsHead) {
  for (const char* comma : {"Separator,Comma\n", "Separator\tComma\n", "Separator,,\n"})
    EXPECT_EQ(
        read(concat({"LabVIEW Measurement\n", comma, "X_Columns,One\n", end, end, "X_Value,a\n0,1.5\n1,2\n"}))
            .dialect.separator,
        "comma")
        << comma;
  EXPECT_EQ(read(head("One", "Separator\tTab\n") + end + "X_Value\ta\tb\n" + rows).dialect.separator, "tab");
  EXPECT_THAT(values(read(head("One", "line\n") + end + "X_Value\ta\tb\n" + rows), 0), ElementsAre(0, 1, 2));
  // Tags behind the head are none of it.
  EXPECT_THAT(values(read(head("One") + "X_Columns\tNo\n" + end + "X_Value\ta\tb\n" + rows), 0),
              ElementsAre(0, 1, 2));
}

TEST(LabViewFile, UnitsAndNamesOfChannels) {
  const auto named = [](const std::string& tags, const std::string& names) {
    return titles(read(head("One") + tags + end + names + "\n" + rows));
  };
  EXPECT_THAT(named("Y_Unit_Label\tNewtons\tAmps\n", "X_Value\ta\tb"),
              ElementsAre("1 X_Value (s)", "1 a (N)", "1 b (A)"));
  EXPECT_THAT(named("Y_Unit_Label\tMeters\n", "X_Value\ta\tb"),
              ElementsAre("1 X_Value (s)", "1 a (m)", "1 b"));
  EXPECT_THAT(named("Y_Unit_Label\tRadians\tDegrees\n", "X_Value\ta\tb"),
              ElementsAre("1 X_Value (s)", "1 a (rad)", "1 b (deg)"));
  EXPECT_THAT(named("Y_Unit_Label\tmm\tSeconds\n", "X_Value\ta (cm)\tb"),
              ElementsAre("1 X_Value (s)", "1 a (cm)", "1 b (s)"));
  EXPECT_THAT(named("", "\t\tb\tComment\t"), ElementsAre("1 X_Value (s)", "1 channel 1", "1 b"));
  EXPECT_THAT(named("", "T\ta\t(x)"), ElementsAre("1 T (s)", "1 a", "1 (x)"));
  EXPECT_THAT(named("X_Dimension\tTime\nX_Unit_Label\tms\n", "X_Value\ta\tb"),
              ElementsAre("1 X_Value (s)", "1 a", "1 b"));
  EXPECT_THAT(titles(read(head("One") + "X_Dimension\tLength\nX_Unit_Label\tMeters\n" + end +
                              "X_Value\ta\tb\n" + rows,
                          "lab.txt", {.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 1})),
              ElementsAre("1 X_Value (m)", "1 a", "1 b"));
}

TEST(LabViewFile, SpecialBlocksAreNoTags) {
  const std::string special = "***Start_Special***\nX0\t7\nDelta_X\t9\n***End_Special***\n";
  const Recording r = read(head("No") + special + "X0\t1\nDelta_X\t0.5\n" + end + "X_Value\ta\n\t5\n\t6\n");
  EXPECT_THAT(values(r, 0), ElementsAre(1, 1.5));
}

TEST(LabViewFile, TimesAreComputed) {
  const auto times = [](const std::string& tags) {
    return values(read(head("No") + tags + end + "X_Value\ta\n\t5\n\t6\n"), 0);
  };
  EXPECT_THAT(times("X0\t0,5\nDelta_X\t0,25\n"), ElementsAre(0.5, 0.75));
  EXPECT_THAT(times("Delta_X\t0.25\t7\n"), ElementsAre(0, 0.25));
  EXPECT_THAT(times("X0\t1\t9\nDelta_X\t0.25\n"), ElementsAre(1, 1.25));
  for (const char* none : {"", "Delta_X\t0\n", "Delta_X\t-1\n", "Delta_X\tx\n"})
    EXPECT_EQ(
        refusal(concat({head("No"), none, end, "X_Value\ta\n\t5\n\t6\n"})),
        "lab.txt: the rows carry no X_Value and the header no Delta_X above 0: the times are not known");
}

TEST(LabViewFile, ContradictionsAreSaid) {
  const auto said = [](const std::string& tags, const std::string& x_columns = "One") {
    return in_words(read(head(x_columns) + tags + end + "X_Value\ta\tb\n" + rows).notices);
  };
  EXPECT_THAT(said("Samples\t3\nDelta_X\t1\n"), IsEmpty());
  EXPECT_THAT(said("Samples\t4\t3\n"),
              ElementsAre("the header says 4 samples per channel, but there are 3 rows: the rows are taken"));
  EXPECT_THAT(said("Delta_X\t1.0099\n"), IsEmpty());
  EXPECT_THAT(said("Delta_X\t1.011\n"),
              ElementsAre("the header says Delta_X 1.011, but X_Value goes in steps of 1: X_Value is taken"));
  EXPECT_THAT(said("Delta_X\t0.989\n").size(), 1u);
  EXPECT_THAT(
      in_words(read(head("One") + "Delta_X\t1\n" + end + "X_Value\ta\n0\t1\n0.33333333\t1\n0.66666667\t2\n")
                   .notices),
      ElementsAre("the header says Delta_X 1, but X_Value goes in steps of 0.333333: X_Value is taken"));
  EXPECT_THAT(said("Delta_X\t0.5\n", "No"), IsEmpty());
  // Ten of them suffice, each once.
  std::string segments = head("One");
  for (int k = 0; k < 14; ++k)
    segments += concat({"Channels\t1\nSamples\t", std::to_string(k < 2 ? 7 : k + 20), "\n", end,
                        "X_Value\ta\n", std::to_string(k), "\t5\n"});
  EXPECT_EQ(in_words(read(segments).notices).size(), 10u);
}

TEST(LabViewFile, SegmentsBeginARunUnlessTheyGoOn) {
  const auto run = [](const std::string& first, const std::string& names, const std::string& next) {
    const Recording r =
        read(head("One") + end + "X_Value\ta\n" + first + "\nChannels\t1\n" + end + names + "\n" + next);
    return concat({std::to_string(runs(r).size()), " ", std::to_string(r.table.rows())});
  };
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\ta", "2\t3\n"), "1 3");
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\ta", "1\t3\n"), "2 2");
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\tb", "2\t3\n"), "2 2");
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\ta (m)", "2\t3\n"), "2 2");
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\ta\tb", "2\t3\t4\n"), "2 2");
  EXPECT_EQ(run("0\t1\n1\t2\n", "X_Value\ta", ""), "1 2");
  EXPECT_EQ(run("", "X_Value\ta", "2\t3\n"), "1 1");
  const Recording appended =
      read(head("One") + end + "X_Value\ta\n0\t1\n1\t2\n\nChannels\t1\n" + end + "X_Value\ta\n2\t3\n\n");
  EXPECT_THAT(values(appended, 1), ElementsAre(1, 2, 3));
  EXPECT_THAT(appended.lines, ElementsAre(7, 8, 13));
}

TEST(LabViewFile, WhatIsMissingIsNamedWithItsLine) {
  EXPECT_EQ(refusal(head("One")), "lab.txt: the file holds no segment with rows");
  EXPECT_EQ(refusal(head("One") + end), "lab.txt: the file holds no segment with rows");
  EXPECT_EQ(refusal(head("One") + end + "X_Value\n0\n"), "lab.txt:6: no channel is named");
  EXPECT_EQ(refusal(head("One") + end + "X_Value\ta\n0\tx\n"),
            "lab.txt:7: column \"a\": \"x\" is not a number; --skip-bad-rows drops such rows");
  std::string wide = "X_Value";
  for (int j = 1; j < 2000; ++j) wide += "\ta";
  EXPECT_EQ(refusal(head("One") + end + wide + "\n0\t1\n"), "read");
  EXPECT_EQ(refusal(head("One") + end + wide + "\ta\n0\t1\n"), "lab.txt:6: there are more than 2000 columns");
}

TEST(LabViewFile, ALastLineThatIsCutIsSaid) {
  std::string text = head("One") + end + "X_Value\ta\n";
  for (int i = 0; i < 9; ++i) text += concat({std::to_string(i), "\t1.25\n"});
  EXPECT_THAT(in_words(read(text + "9\t1.2").notices),
              ElementsAre(HasSubstr("the last line, 16, seems cut within a number")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
