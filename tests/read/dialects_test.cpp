// Limits and edges of the dialects with a structure of their own, and of those told by their headers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/cells.h"
#include "cromer/read/columns.h"
#include "cromer/read/dialect_name.h"
#include "cromer/read/recording.h"
#include "cromer/read/rows.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A file of PEER's with its head in the fourth line.
std::string peer(const std::string& head, const std::string& rows = "1 2 3\n") {
  return concat({"PEER\nKobe, 1/16/1995, Amagasaki, 90\nDATA\n", head, "\n", rows});
}

TEST(PeerHead, CountAndStepAreFoundInTwentyLines) {
  const auto with_lines = [](int lines) {
    std::string text;
    for (int i = 0; i < lines; ++i) text += "a\n";
    return read_recording(text + "NPTS= 3, DT= 0.5 SEC\n1 2 3\n", "lab.txt", {})->dialect.name;
  };
  EXPECT_EQ(with_lines(0), "PEER");
  EXPECT_EQ(with_lines(19), "PEER");
  EXPECT_NE(with_lines(20), "PEER");
  EXPECT_THAT(values(read(peer("npts: 3 dt: 0.5")), 0), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(values(read(peer("3 0.5 NPTS, DT")), 0), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(values(read(peer("# NPTS= 9, DT= 9\nNPTS= 3, DT= 0.5")), 0), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(values(read(peer("NPTS 3 values, DT is a step\nNPTS= 3, DT= 0.5")), 0), ElementsAre(0, 0.5, 1));
  EXPECT_THAT(values(read(peer("x 0.5 NPTS, DT\n3 x NPTS, DT\nDT 4 NPTS\n3 0.5 NPTS, DT")), 0),
              ElementsAre(0, 0.5, 1));
}

TEST(PeerHead, WhatIsNoCountOrStepIsRefused) {
  EXPECT_EQ(refusal(peer("NPTS= 3, DT= 0")), "lab.txt:4: DT is not a step above 0");
  EXPECT_EQ(refusal(peer("NPTS= 3, DT= 1e12")), "lab.txt:4: DT is not a step above 0");
  EXPECT_EQ(refusal(peer("NPTS= 0, DT= 1")), "lab.txt:4: NPTS is not a number of values above 0");
  EXPECT_EQ(refusal(peer("NPTS= 1.5, DT= 1")), "lab.txt:4: NPTS is not a number of values above 0");
  EXPECT_EQ(refusal(peer("NPTS= 3, DT= 1", "")), "lab.txt:4: no values follow");
  EXPECT_EQ(values(read(peer("NPTS= 1, DT= 1", "7\n")), 1).size(), 1u);
  EXPECT_THAT(in_words(read(peer("NPTS= 1e300, DT= 1")).notices),
              ElementsAre("NPTS says 1e+300 values, the file holds 3"));
}

TEST(PeerHead, ValuesBehindItsCountAreCounted) {
  EXPECT_THAT(in_words(read(peer("NPTS= 3, DT= 1")).notices), IsEmpty());
  EXPECT_TRUE(read(peer("NPTS= 3, DT= 1")).named);
  EXPECT_THAT(in_words(read(peer("NPTS= 2, DT= 1")).notices),
              ElementsAre("1 value after the 2 that NPTS announces left out"));
  EXPECT_THAT(in_words(read(peer("NPTS= 4, DT= 1", "1 2 3\n4 5 6\n7\n")).notices),
              ElementsAre("3 values after the 4 that NPTS announces left out"));
  EXPECT_THAT(in_words(read(peer("NPTS= 3, DT= 1", "1 2 3\nthe end\n")).notices), IsEmpty());
}

TEST(PeerHead, TheMotionIsNamedWithoutItsDirection) {
  EXPECT_EQ(read(peer("NPTS= 3, DT= 1")).motion, "Kobe, 1/16/1995, Amagasaki");
  EXPECT_EQ(read("PEER\nKobe, 90\nNPTS= 3, DT= 1\n1 2 3\n").motion, "");
  EXPECT_EQ(read("PEER\na, b, c\nNPTS= 3, DT= 1\n1 2 3\n").motion, "a, b");
  EXPECT_EQ(read("PEER\nKobe\nNPTS= 3, DT= 1\n1 2 3\n").motion, "");
  EXPECT_EQ(read("PEER\nNPTS= 3, DT= 1, a, b\n1 2 3\n").motion, "");
}

TEST(PeerHead, SaysWhatTheValuesAre) {
  const auto title = [](const std::string& words, std::string_view file = "lab.txt") {
    return column_title(read(concat({words, "\nNPTS= 3, DT= 1\n1 2 3\n"}), file).table.columns.at(1));
  };
  EXPECT_EQ(title("ACCELERATION"), "Acceleration (g)");
  EXPECT_EQ(title("Velocity in units of  cm/sec, filtered"), "Velocity (cm/s)");
  EXPECT_EQ(title("ACCELERATION IN UNITS OF CM/SEC/SEC"), "Acceleration (cm/s^2)");
  EXPECT_EQ(title("ACCELERATION IN UNITS OF CM/SEC2."), "Acceleration (cm/s^2)");
  EXPECT_EQ(title("DISPLACEMENT IN UNITS OF MM;"), "Displacement (mm)");
  EXPECT_EQ(title("UNITS OF G\nACCELERATION\nVELOCITY IN UNITS OF CM"), "Acceleration (g)");
  EXPECT_EQ(title("DISPLACEMENT IN UNITS OF "), "Displacement (cm)");
  EXPECT_EQ(title("a", "b.At2"), "Acceleration (g)");
  EXPECT_EQ(title("a", "AT2"), "column 2");
  EXPECT_EQ(title("a", ".dt2"), "Displacement (cm)");
  EXPECT_EQ(title("a", "x"), "column 2");
}

TEST(NumberStream, StopsWhereItIsTold) {
  using dialects::read_numbers;
  const auto lines = dialects::split_lines("1 2,3\n\n4-5+6\nend 7\n8\n");
  const auto most = read_numbers(lines, 0, 4, false, 10);
  EXPECT_THAT(most->values, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(most->lines, ElementsAre(11, 11, 11, 13));
  EXPECT_EQ(most->end, 3u);
  const auto words = read_numbers(lines, 2, 100, true);
  EXPECT_THAT(words->values, ElementsAre(4, -5, 6));
  EXPECT_EQ(words->end, 3u);
  EXPECT_EQ(read_numbers(lines, 0, 0, false)->end, 0u);
  EXPECT_EQ(read_numbers(lines, 99, 9, false)->end, lines.size());
  const auto refused = [&](const char* text, bool until_words) {
    const auto stream = read_numbers(dialects::split_lines(text), 0, 9, until_words);
    return stream ? std::string("read") : in_words(stream.error());
  };
  EXPECT_EQ(refused("1\n2 x\n", true), "line 2: \"x\" is not a number");
  EXPECT_EQ(refused("1\nx 2\n", true), "read");
  EXPECT_EQ(refused("1\nx 2\n", false), "line 2: \"x\" is not a number");
  EXPECT_EQ(refused("1;2\n", false), "line 1: \"1;2\" is not a number");
  EXPECT_EQ(refused("1 1e999,2\n", false),
            "line 1: \"1e999\" is not a number; it is too large: numbers end at 1.8e308");
  EXPECT_EQ(refused("1\r\n2\t3\n", false), "read");
}

const std::string vernier = "Vernier Format 2\nlab.cmbl\n";

TEST(VernierFormat, NamesAndUnitsMayBeShort) {
  EXPECT_THAT(titles(read(vernier + "Run 1\nTime\tx (m)\tForce\t\nt\tx\tF\ns\n\n0\t1\t2\n1\t2\t3\n")),
              ElementsAre("1 Time (s)", "1 x (m)", "1 Force"));
  EXPECT_THAT(titles(read(vernier + "Run 1\nTime\t\tx (cm)\nt\t\tx\ns\t\tm\n\n0\t1\t2\n1\t2\t3\n")),
              ElementsAre("1 Time (s)", "1 column 2", "1 x (m)"));
  EXPECT_EQ(refusal(vernier + "Run 1\nTime\tx\nt\tx\ns\tm"), "lab.txt: the file holds no set of rows");
  EXPECT_EQ(refusal(vernier + "Run 1\nTime\tx\nt\tx"), "lab.txt: the file holds no set of rows");
  EXPECT_THAT(in_words(read(vernier + "Run 1\nTime\tx\nt\tx\ns\tm\n0\t1\n1\t2").notices), IsEmpty());
}

TEST(VernierFormat, ARowWithABadCellBelongsToItsSet) {
  const std::string names = "Time\tx\nt\tx\ns\tm\n";
  EXPECT_EQ(refusal(vernier + "Run 1\n" + names + "0\t1\n1\tabc\n"),
            "lab.txt:8: column \"x (m)\": \"abc\" is not a number; --skip-bad-rows drops such rows");
  ReadOptions skip;
  skip.skip_bad_rows = true;
  const Recording two =
      read(vernier + "Run 1\n" + names + "0\t1\n1\tabc\n\nRun 2\n" + names + "5\t6\n6\t7\n", "lab.txt", skip);
  EXPECT_THAT(runs(two), ElementsAre(1, 2));
  std::string cut = vernier + "Run 1\n" + names;
  for (int i = 0; i < 9; ++i) cut += "0.5\t1.25\n";
  EXPECT_THAT(in_words(read(cut + "0.5\t1.2").notices),
              ElementsAre(HasSubstr("the last line, 16, seems cut within")));
}

std::string dialect(const std::string& text) { return read(text).dialect.name; }

TEST(DialectNames, AreToldByHeaders) {
  const std::string rows = "0,1\n1,2\n2,4\n";
  EXPECT_EQ(dialect("Run 1: t,Run 1: x\n" + rows), "Logger Pro");
  EXPECT_EQ(dialect("Remote Data: t,Remote Data: x\n" + rows), "Logger Pro");
  EXPECT_EQ(dialect("Runner: t,Runner: x\n" + rows), "plain");
  EXPECT_EQ(dialect("t Run #1,x Run #1\n" + rows), "PASCO Capstone");
  EXPECT_EQ(dialect("t Run 1,x Run 1\n" + rows), "plain");
  EXPECT_EQ(dialect("Force, ChA\nTime,Force\n" + rows), "DataStudio");
  EXPECT_EQ(dialect("Force A\nTime,Force\n" + rows), "plain");
  for (const char* value : {"Gyroscope x (rad/s)", "Acceleration z (m/s^2)", "Magnetic field y (µT)",
                            "Linear Acceleration x (m/s²)", "Rotation y"})
    EXPECT_EQ(dialect(concat({"Time (s),", value, "\n", rows})), "phyphox") << value;
  EXPECT_EQ(dialect("\"Time (s)\",\"Absolute field (µT)\"\n" + rows), "phyphox");
  for (const char* header :
       {"Time (s),Absolute field (µT)", "Time (s),Acceleration (m/s^2)", "Time (s),Gyroscope w",
        "Time (ms),Gyroscope x (rad/s)", "t (s),Gyroscope x (rad/s)", "\"Time (s)\",\"Gyroscope mean\""})
    EXPECT_EQ(dialect(concat({header, "\n", rows})), "plain") << header;
  EXPECT_EQ(dialect("Time (s),a,Gyroscope x\n0,1,2\n1,2,3\n2,4,5\n"), "phyphox");
}

TEST(Tracker, IsToldByItsSymbols) {
  EXPECT_EQ(dialect("t\tx\n0\t1\n1\t2\n"), "Tracker");
  EXPECT_EQ(dialect("t,x,y\n0,1,2\n1,2,3\n"), "Tracker");
  for (const char* header : {"t,x", "t,x,z", "t,y,x", "t,x (m),y (m)", "time,x,y", "x"})
    EXPECT_EQ(dialect(concat({header, "\n0,1,2\n1,2,3\n"})), "plain") << header;
}

TEST(Tracker, TracksAreNamedAboveTheirColumns) {
  const auto run = [](const std::string& above) {
    const Recording r = read(above + "t\tx\ty\tx\ty\n0\t1\t2\t3\t4\n1\t2\t3\t4\t5\n");
    std::vector<int> all;
    for (const Column& column : r.table.columns) all.push_back(column.run);
    return all;
  };
  EXPECT_THAT(run("\ta\t\tb\n"), ElementsAre(1, 1, 1, 2, 2));
  EXPECT_THAT(in_words(read("\ta\t\t\nt\tx\ty\n0\t1\t2\n1\t2\t3\n").notices), IsEmpty());
  EXPECT_THAT(in_words(read("c\ta\tb\nt\tx\ty\n0\t1\t2\n1\t2\t3\n").notices), IsEmpty());
  EXPECT_THAT(in_words(read("\ta\tb\nt\tx\ty\n0\t1\t2\n1\t2\t3\n").notices),
              ElementsAre("run 1 is called \"a\" in the file", "run 2 is called \"b\" in the file"));
}

TEST(Capstone, RunsAboveTheNames) {
  const auto run = [](const std::string& above, const std::string& names = "t,x,t,x") {
    const Recording r = read(above + "\n" + names + "\n0,1,0,3\n0.5,2,0.5,4\n1,2,1,5\n");
    std::string all = r.dialect.name + " ";
    for (const Column& column : r.table.columns) all += std::to_string(column.run);
    return all;
  };
  EXPECT_EQ(run("Run #1,,Run #2,"), "PASCO Capstone 1122");
  EXPECT_EQ(run("Run #1,,Run #2,,"), "PASCO Capstone 1122");
  EXPECT_EQ(run("Run #1,,,Run #2,x"), "plain 1122");
  EXPECT_EQ(run("Run #1,Run #2", "t,x,y,v"), "PASCO Capstone 1222");
  EXPECT_EQ(run("Run #1,,Run #2,,Run #3"), "plain 1122");
  EXPECT_EQ(run("Run #5,,Run #6,", "t Run #1,x Run #1,t Run #2,x Run #2"), "PASCO Capstone 1122");
  EXPECT_EQ(run(",,,"), "plain 1122");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
