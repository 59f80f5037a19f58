// Dialects with a structure of their own: each is written here from numbers that are known, and read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string labview_head =
    "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\n"
    "Multi_Headings\tYes\r\nX_Columns\tTIMES\r\nTime\t11:23:19,156616\r\n***End_of_Header***\t\r\n\t\r\n";
const std::string labview_segment =
    "Channels\t2\t\r\nSamples\t3\t3\t\r\nY_Unit_Label\tmm\tVolts\t\r\nX_Dimension\tTime\tTime\t\r\n"
    "X0\t0.5\t0.5\t\r\nDelta_X\t0.25\t0.25\t\r\n***End_of_Header***\t\t\r\n";

std::string labview(const std::string& x_columns) {
  std::string head = labview_head;
  return head.replace(head.find("TIMES"), 5, x_columns);
}

TEST(LabView, TimesAreComputedWhereRowsHaveNone) {
  const Recording r = read(labview("No") + labview_segment +
                           "X_Value\tPos\tU\tComment\r\n\t1.5\t2\t\r\n\t-2.5\t3\tsaid, 1.5\r\n\t3.5\t4\r\n");
  EXPECT_EQ(r.dialect.name, "LabVIEW");
  EXPECT_THAT(titles(r), ElementsAre("1 X_Value (s)", "1 Pos (mm)", "1 U (V)"));
  EXPECT_THAT(values(r, 0), ElementsAre(0.5, 0.75, 1));
  EXPECT_THAT(values(r, 1), ElementsAre(1.5, -2.5, 3.5));
  EXPECT_THAT(r.lines, ElementsAre(18, 19, 20));
  EXPECT_THAT(in_words(r.notices), ElementsAre());
}

TEST(LabView, XValueWinsOverDeltaX) {
  const Recording r = read(labview("One") + labview_segment +
                           "X_Value\tPos\tU\r\n0\t1,5\t2\r\n0,1\t2,5\t3\r\n0,2\t3,5\t4\r\n");
  EXPECT_EQ(r.dialect.decimal, "comma");  // whatever the header says
  EXPECT_THAT(values(r, 0), ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(
      in_words(r.notices),
      ElementsAre("the header says Delta_X 0.25, but X_Value goes in steps of 0.1: X_Value is taken"));
}

TEST(LabView, EachChannelMayHaveItsTimes) {
  const Recording r =
      read(labview("Multi") + labview_segment +
           "X_Value\tPos\tX_Value\tU\r\n0\t1\t0.1\t2\r\n0.25\t2\t0.35\t3\r\n0.5\t3\t0.6\t4\r\n");
  EXPECT_THAT(titles(r), ElementsAre("1 X_Value (s)", "1 Pos (mm)", "1 X_Value (s)", "1 U (V)"));
  const auto series = take_series(r, "U", 1, {});
  ASSERT_TRUE(series.ok());
  EXPECT_THAT(series->t, ElementsAre(0.1, 0.35, 0.6));
}

TEST(LabView, SegmentsGoOnOrBeginARun) {
  const std::string names = "X_Value\tPos\tU\r\n", first = "0\t1\t2\r\n0.25\t2\t3\r\n0.5\t3\t4\r\n\r\n";
  const Recording on = read(labview("One") + labview_segment + names + first + labview_segment + names +
                            "0.75\t1\t2\r\n1\t2\t3\r\n1.25\t3\t4\r\n");
  EXPECT_THAT(values(on, 0), ElementsAre(0, 0.25, 0.5, 0.75, 1, 1.25));
  const Recording again =
      read(labview("One") + labview_segment + names + first + labview_segment + names + first);
  EXPECT_THAT(runs(again), ElementsAre(1, 2));
}

TEST(LabView, BadCellsAreNamed) {
  EXPECT_THAT(
      refusal(labview("One") + labview_segment + "X_Value\tPos\tU\r\n0\t1\t2\r\n1\tabc\t2\r\n2\t1\t2\r\n"),
      HasSubstr("lab.txt:19: column \"Pos (mm)\": \"abc\" is not a number"));
  EXPECT_THAT(refusal(labview("One") + labview_segment), HasSubstr("no segment with rows"));
}

TEST(LabView, ASeparatorWithinANumberIsNoRemark) {
  EXPECT_THAT(refusal(labview("One") + labview_segment +
                      "X_Value\tPos\tU\tComment\r\n0\t1.5\t2.5\r\n1\t1\t.5\t2.5\r\n2\t1.5\t2.5\tsaid\r\n"),
              HasSubstr("lab.txt:19: there are more values than the 3 columns"));
}

TEST(Peer, ReadsBothHeadersAndStopsAtItsCount) {
  const std::string titles_of =
      "PEER DATABASE\nSomewhere, 1/2/1999\nACCELERATION TIME SERIES IN UNITS OF G\n";
  for (const char* head : {"NPTS=      5, DT=   .5000 SEC,\n", "NPTS=  5, DT=   0.5 SEC      \n",
                           "    5    0.5000    NPTS, DT\n"}) {
    const Recording r = read(titles_of + head + " 1.5E-02-2.5E-02   3.0\n-1.234-5.678 99 98\n");
    EXPECT_EQ(r.dialect.name, "PEER");
    EXPECT_THAT(titles(r), ElementsAre("1 Time (s)", "1 Acceleration (g)")) << head;
    EXPECT_THAT(values(r, 0), ElementsAre(0, 0.5, 1, 1.5, 2));
    EXPECT_THAT(values(r, 1), ElementsAre(0.015, -0.025, 3, -1.234, -5.678));
    EXPECT_THAT(r.lines, ElementsAre(5, 5, 5, 6, 6));
    EXPECT_THAT(in_words(r.notices), ElementsAre("2 values after the 5 that NPTS announces left out"));
    const auto series = take_series(r, "", 1, {});
    ASSERT_TRUE(series.ok());
    EXPECT_DOUBLE_EQ(series->y[0], 0.015 * 9.80665);
  }
}

// A line with NPTS and DT makes no such file: numbers must follow it.
TEST(Peer, AHeadFollowedByWordsIsNone) {
  const std::string table = "Time (s),Force (N)\n0,1\n1,2\n2,3\n";
  for (const char* head :
       {"NPTS=      5, DT=   .5000 SEC,\n", "NPTS of this copy: 3, DT 1 s\n", "5 0.5 NPTS, DT\n"}) {
    const Recording r = read(concat({"Made of a PEER file\n", head, table}));
    EXPECT_EQ(r.dialect.name, "plain") << head;
    EXPECT_THAT(titles(r), ElementsAre("1 Time (s)", "1 Force (N)")) << head;
    EXPECT_THAT(values(r, 1), ElementsAre(1, 2, 3)) << head;
  }
  EXPECT_EQ(read("NPTS=  3, DT=   .5000 SEC,\n\n 1 2 3\n").dialect.name, "PEER");
}

TEST(Peer, VelocitiesAndDisplacements) {
  const auto si = [](std::string_view words, std::string_view file) {
    const auto r = read(concat({"NRC\nb\nc\nd\n", words, "\nf\nNPTS= 2, DT= 0.1 SEC\n1 2\n"}), file);
    return concat({r.table.columns.at(1).quantity, " ", shortest(to_si(r.table.columns.at(1)).factor)});
  };
  EXPECT_EQ(si("VELOCITY TIME HISTORY IN UNITS OF CM/SEC. FILTER", "x.txt"), "velocity 0.01");
  EXPECT_EQ(si("DISPLACEMENT TIME SERIES IN UNITS OF CM", "x.txt"), "position 0.01");
  EXPECT_EQ(si("no words", "x.VT2"), "velocity 0.01");
  EXPECT_EQ(si("no words", "x.dt2"), "position 0.01");
}

TEST(Peer, AllIsOfOneRun) {
  const auto both = [](std::string_view words, std::string_view file) {
    return titles(read(concat({"NRC\n", words, "\nNPTS= 2, DT= 0.1 SEC\n1 2\n"}), file));
  };
  EXPECT_THAT(both("no words", "x.txt"), ElementsAre("1 Time (s)", "1 column 2"));
  EXPECT_THAT(both("no words", ""), ElementsAre("1 Time (s)", "1 column 2"));
  EXPECT_THAT(both("no words", "a.vt2"), ElementsAre("1 Time (s)", "1 Velocity (cm/s)"));
  EXPECT_THAT(both("ACCELERATION", "a.vt2"), ElementsAre("1 Time (s)", "1 Acceleration (g)"));
  EXPECT_THAT(both("ACCELERATION IN UNITS OF   CM/SEC/SEC, FILTERED", "x"),
              ElementsAre("1 Time (s)", "1 Acceleration (cm/s^2)"));
  EXPECT_THAT(both("VELOCITY IN UNITS OF M/SEC", "x"), ElementsAre("1 Time (s)", "1 Velocity (m/s)"));
}

TEST(Peer, WhatIsMissingIsSaid) {
  EXPECT_THAT(in_words(read("a\nb\nc\nNPTS= 9, DT= 0.1 SEC\n1 2\n").notices),
              Contains("NPTS says 9 values, the file holds 2"));
  EXPECT_THAT(refusal("a\nb\nc\nNPTS= 9, DT= 0 SEC\n1 2\n"),
              HasSubstr("lab.txt:4: DT is not a step above 0"));
  EXPECT_THAT(refusal("a\nb\nc\nNPTS= 9, DT= 0.1 SEC\n1 2\n3 x\n"),
              HasSubstr("lab.txt:6: \"x\" is not a number"));
}

TEST(VernierFormat, SetsFollowEachOther) {
  const std::string head = "Vernier Format 2\r\nlab.cmbl 3/4/2020 12:00:00\r\n";
  const std::string names = "Time\tPosition\r\nt\tx\r\ns\tcm\r\n\r\n";
  const Recording r = read(head + "Run 1\r\n" + names + "0\t1,5\r\n0,5\t\r\n1\t3,5\r\n\r\nBest\r\n" + names +
                           "0\t7,5\r\n0,5\t8\r\n");
  EXPECT_EQ(r.dialect.name, "Vernier Format 2");
  EXPECT_EQ(r.dialect.decimal, "comma");
  EXPECT_THAT(titles(r), ElementsAre("1 Time (s)", "1 Position (cm)", "2 Time (s)", "2 Position (cm)"));
  EXPECT_THAT(values(r, 3), ElementsAre(7.5, 8, testing::IsNan()));
  EXPECT_EQ(line_of(r, 3, 0), 17);
  EXPECT_THAT(in_words(r.notices), AllOf(Contains("run 2 is called \"Best\" in the file"),
                                         Contains(HasSubstr("1 missing value, the first in line 9"))));
  EXPECT_THAT(refusal(head + "Run 1\r\n" + names + "0\t1\r\n1\tabc\r\n"),
              HasSubstr("lab.txt:9: column \"Position (cm)\""));
}

TEST(VernierFormat, LastColumnsWithoutNameAndValuesAreLeftOut) {
  const std::string head = "Vernier Format 2\r\nlab.cmbl 3/4/2020 12:00:00\r\nRun 1\r\n";
  const std::string names = "Time\tPosition\t\r\nt\tx\t\r\ns\tcm\t\r\n\r\n";
  EXPECT_THAT(titles(read(head + names + "0\t1\t\r\n1\t2\t\r\n")),
              ElementsAre("1 Time (s)", "1 Position (cm)"));
  EXPECT_THAT(titles(read(head + names + "0\t1\t\r\n1\t2\t3\r\n")),
              ElementsAre("1 Time (s)", "1 Position (cm)", "1 column 3"));
}

TEST(VernierFormat, WhatIsMissingIsNamedWithItsLine) {
  const std::string head = "Vernier Format 2\r\nlab.cmbl 3/4/2020 12:00:00\r\n",
                    rows = "0\t1\r\n1\t2\r\n2\t1\r\n";
  const std::string names = "Time\tPosition\r\nt\tx\r\ns\tcm\r\n\r\n";
  EXPECT_THAT(refusal(head + "Run 1\r\n\r\nt\tx\r\ns\tcm\r\n" + rows),
              HasSubstr("lab.txt:4: the names of the columns of set \"Run 1\" are missing"));
  EXPECT_THAT(refusal(head + "\r\nRun 1\r\n\r\nt\tx\r\ns\tcm\r\n" + rows), HasSubstr("lab.txt:5: the names"));
  const std::size_t most = 2000;
  std::string wide = "a";
  for (std::size_t j = 1; j < most; ++j) wide += "\ta";
  EXPECT_THAT(refusal(head + "Run 1\r\n" + wide + "\ta\r\nt\r\ns\r\n\r\n" + rows),
              HasSubstr("lab.txt:4: there are more than 2000 columns"));
  EXPECT_THAT(refusal(head + "Run 1\r\n" + names), HasSubstr("lab.txt: the file holds no set of rows"));
  EXPECT_THAT(in_words(read(head + "Empty\r\n" + names + "\r\nRun 2\r\n" + names + rows).notices),
              Contains("set \"Empty\" has no rows"));
  EXPECT_THAT(in_words(read(head + "Run 1\r\n" + names + rows + "\r\nLast\r\n" + names).notices),
              Contains("set \"Last\" has no rows"));
}

TEST(LabView, AChannelMustBeNamed) {
  EXPECT_THAT(refusal(labview("One") + labview_segment + "X_Value\r\n0\r\n1\r\n2\r\n"),
              HasSubstr("lab.txt:17: no channel is named"));
}

TEST(DataStudio, RunsBelowEachOther) {
  const std::string time = "Time ( s )\t";
  const Recording r = read("Voltage, ChA, Run #1\r\n" + time + "Voltage ( V )\r\n0\t1\r\n1\t2\r\n2\t4\r\n" +
                           "Force, ChB, Run #1\r\n" + time + "Force ( N )\r\n0\t5\r\n1\t6\r\n2\t7\r\n" +
                           "Voltage, ChA, Run #2\r\n" + time + "Voltage ( V )\r\n0\t8\r\n1\t9\r\n");
  EXPECT_EQ(r.dialect.name, "DataStudio");
  EXPECT_THAT(titles(r),
              ElementsAre("1 Time (s)", "1 Voltage (V)", "1 Force (N)", "2 Time (s)", "2 Voltage (V)"));
  EXPECT_THAT(values(r, 2), ElementsAre(5, 6, 7));
  EXPECT_EQ(line_of(r, 2, 0), 8);
  EXPECT_EQ(line_of(r, 4, 1), 14);
}

TEST(HeadersAgain, BeginARun) {
  const Recording r = read("t,x\n0,1.5\n1,2\n2,1\nt,x\n0,3\n1,4\n2,5\n3,6\n");
  EXPECT_THAT(runs(r), ElementsAre(1, 2));
  EXPECT_THAT(values(r, 3), ElementsAre(3, 4, 5, 6));
  // A date above a header is no table.
  EXPECT_EQ(read("A lab\n2024-01-01\nTime (s),x (m),\n0.0,1.5,\n0.1,2.5,\n").table.rows(), 2u);
  // A word among numbers is a bad row.
  EXPECT_THAT(refusal("t,x\n0,1.5\nerror,error\n2,1\n"), HasSubstr("lab.txt:3: "));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
