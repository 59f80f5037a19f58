#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;

const Column& column(const Recording& recording, std::size_t j) { return recording.table.columns.at(j); }

std::string rows_of(int count, const char* row) {
  std::string text = "Time (s);Position (m)\n";
  for (int i = 0; i < count; ++i) text += concat({"0,", std::to_string(10 + i), ";", row, "\n"});
  return text;
}

// A logger that lost power.
TEST(LastLine, CutWithinItsNumberIsLeftOut) {
  for (const char* cut : {"0,35;0", "0,35;0,", "0,35;0,3", "0,35;-0,3", "0,"}) {
    const Recording r = read(rows_of(20, "-0,34") + cut);
    EXPECT_EQ(r.table.rows(), 20u) << cut;
    EXPECT_THAT(in_words(r.notices),
                testing::Contains(HasSubstr("the last line, 22, seems cut within a number")))
        << cut;
  }
  EXPECT_EQ(read(rows_of(20, "1,25E-03") + "0,35;1,25E-0").table.rows(), 20u);
}

TEST(LastLine, WholeWithoutItsEndIsARowLikeAnyOther) {
  for (const std::string& text : {rows_of(20, "-0,34") + "0,35;0,36", rows_of(20, "-0,34") + "0,35;0,3\n",
                                  rows_of(20, "0,34") + "0,35;", rows_of(3, "0,34") + "0,35;0,3"}) {
    const Recording r = read(text);
    EXPECT_EQ(r.lines.size(), static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) -
                                  (text.back() == '\n' ? 1 : 0));
    EXPECT_THAT(in_words(r.notices), testing::Each(testing::Not(HasSubstr("last line"))));
  }
}

TEST(LastLine, ThatMayBeCutIsKeptAndSaid) {
  // Whole numbers, and decimals without their last noughts, of which a shorter one may be whole.
  for (const std::string& text :
       {rows_of(20, "1234") + "0,35;12", rows_of(10, "0,34") + rows_of(9, "0,345").substr(22) + "0,35;0"}) {
    const Recording r = read(text);
    EXPECT_EQ(r.table.columns[1].values.back(), text.back() == '2' ? 12 : 0);
    EXPECT_THAT(in_words(r.notices), testing::Contains(HasSubstr("the last line, ")));
    EXPECT_THAT(in_words(r.notices), testing::Contains(HasSubstr("it is kept")));
  }
}

TEST(ReadRecording, HeadedComma) {
  const Recording r = read("Time (s),Position (m)\n0.0,0.5\n0.1,-0.25\n0.2,1e-3\n");
  EXPECT_EQ(r.dialect.separator, "comma");
  EXPECT_EQ(r.dialect.decimal, "point");
  EXPECT_EQ(r.dialect.encoding, "UTF-8");
  EXPECT_EQ(r.dialect.name, "plain");
  ASSERT_EQ(r.table.columns.size(), 2u);
  EXPECT_EQ(column(r, 0).quantity, "time");
  EXPECT_EQ(column(r, 1).name, "Position");
  EXPECT_EQ(column(r, 1).unit, "m");
  EXPECT_EQ(column(r, 1).quantity, "position");
  EXPECT_THAT(column(r, 1).values, ElementsAre(0.5, -0.25, 1e-3));
  EXPECT_THAT(r.lines, ElementsAre(2, 3, 4));
  EXPECT_THAT(in_words(r.notices), ElementsAre());
}

struct Written {
  const char* text;
  const char* separator;
  const char* decimal;
};

void PrintTo(const Written& written, std::ostream* out) { *out << written.text; }

class SameTable : public testing::TestWithParam<Written> {};

TEST_P(SameTable, ReadTheSame) {
  const Recording r = read(GetParam().text);
  EXPECT_EQ(r.dialect.separator, GetParam().separator);
  EXPECT_EQ(r.dialect.decimal, GetParam().decimal);
  ASSERT_EQ(r.table.columns.size(), 2u);
  EXPECT_THAT(column(r, 0).values, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(column(r, 1).values, ElementsAre(1.5, -3.75e-5, 2));
  EXPECT_EQ(column(r, 0).quantity, "time");
  EXPECT_EQ(column(r, 1).quantity, "position");
  EXPECT_EQ(column(r, 1).unit, "m");
}

INSTANTIATE_TEST_SUITE_P(
    Dialects, SameTable,
    testing::Values(
        Written{"Time (s),Position (m)\n0,1.5\n0.5,-3.75e-5\n1,2\n", "comma", "point"},
        Written{"Time (s), Position (m)\n0, 1.5\n0.5, -3.75E-5\n1, 2\n", "comma", "point"},
        Written{"Time (s);Position (m)\n0;1,5\n0,5;-3,75E-5\n1;2\n", "semicolon", "comma"},
        Written{"Time (s);Position (m)\r\n0;1.5\r\n0.5;-3.75E-5\r\n1;2\r\n", "semicolon", "point"},
        Written{"Time ( s )\tPosition [m]\n0\t1,5\n0,5\t-3,75E-5\n1\t2\n", "tab", "comma"},
        Written{"Time (s) Position (m)\n 0   1.5\n 0.5 -3.75E-5\n 1   2\n", "blanks", "point"},
        Written{"time_s,position_m\n0,1.5\n0.5,-3.75e-5\n1,2\n", "comma", "point"},
        Written{"--- pendulum ---\nTime (s),Position (m)\n0\t1,5\n0,5\t-3,75E-5\n1\t2\n", "tab", "comma"},
        Written{"\xEF\xBB\xBF\"Time (s)\";\"Position (m)\"\n0;1,5\n0,5;-3,75E-5\n1;2", "semicolon", "comma"},
        Written{"\"Time (s)\",\"Position (m)\"\n\"0\",\"1,5\"\n\"0,5\",\"-3,75E-5\"\n\"1\",\"2\"\n", "comma",
                "comma"},
        Written{"Time (s),Position (m),\n0,1.5,\n0.5,-3.75e-5,\n1,2,\n", "comma", "point"},
        Written{"# a comment\n%another\nTime (s),Position (m)\n\n0,1.5\n# between\n0.5,-3.75e-5\n1,2\n\n",
                "comma", "point"},
        Written{"#Time\tPosition\t\n#[s]\t[m]\n0\t1.5\n0.5\t-3.75e-5\n1\t2\n", "tab", "point"},
        Written{"Time,Position\n(s),(m)\n0,1.5\n0.5,-3.75e-5\n1,2\n", "comma", "point"},
        Written{"Time (s),Position (m)\r0,1.5\r0.5,\u22123.75e-5\r1,+2\r", "comma", "point"}));

TEST(ReadRecording, Cp1252BecomesUtf8) {
  const Recording r = read("Zeit (s);Weg \xE4 (\xB5m)\n0;1\n1;2\n2;4\n");
  EXPECT_EQ(r.dialect.encoding, "cp1252");
  EXPECT_EQ(column(r, 1).name, "Weg ä");
  EXPECT_EQ(column(r, 1).unit, "µm");
  EXPECT_EQ(column(r, 1).quantity, "position");
}

TEST(ReadRecording, RunsSideBySide) {
  const Recording r =
      read("\xEF\xBB\xBF\"Position (mm) Run #1\";\"Position (mm) Run #2\"\r\n60,5;33,0\r\n58,25;\r\n");
  EXPECT_EQ(r.dialect.name, "PASCO Capstone");
  EXPECT_EQ(r.dialect.encoding, "UTF-8 with BOM");
  EXPECT_THAT(runs(r), ElementsAre(1, 2));
  EXPECT_EQ(column(r, 1).run, 2);
  EXPECT_EQ(column(r, 1).name, "Position");
  EXPECT_TRUE(std::isnan(column(r, 1).values[1]));
  EXPECT_THAT(in_words(r.notices), ElementsAre());  // a shorter run misses nothing
}

TEST(ReadRecording, RepeatedNamesBeginARun) {
  const Recording r = read("Time (s),x (m),Time (s),x (m)\n0,1,0,5\n1,2,1,6\n2,3,2,7\n",
                           {.delimiter = ",", .decimal = {}, .time_column = {}});
  EXPECT_THAT(runs(r), ElementsAre(1, 2));
  EXPECT_EQ(column(r, 2).run, 2);
}

TEST(ReadRecording, ANameMayHoldTheSeparator) {
  const Recording r = read("\"Time (s) Run #1\",\"Temperature, Ch P3 (°C) Run #1\"\n0.5,20.5\n1.5,21.5\n");
  EXPECT_EQ(column(r, 1).name, "Temperature, Ch P3");
  EXPECT_EQ(column(r, 1).unit, "°C");
}

TEST(ReadRecording, DialectsByTheirHeaders) {
  EXPECT_EQ(
      read("Voltage, ChA, Run #1\r\nTime ( s )\tVoltage ( V )\r\n0.0\t0.5\r\n0.1\t0.6\r\n").dialect.name,
      "DataStudio");
  EXPECT_EQ(read("mass_D\nt\tx\ty\t\n0.0\t0.5\t1.5\t\n0.1\t0.6\t1.6\t\n").dialect.name, "Tracker");
  EXPECT_EQ(read("Latest: Time (s),Latest: Position (m)\n0.0,0.5\n0.1,0.6\n").dialect.name, "Logger Pro");
  EXPECT_EQ(read("Data Set 1:Time(s),Data Set 1:Position(m)\n0.0,0.5\n0.1,0.6\n").dialect.name,
            "Graphical Analysis");
  EXPECT_EQ(read("\"Time (s)\",\"Gyroscope x (rad/s)\"\n0.0E0,0.5E-1\n1.0E-1,0.6E0\n").dialect.name,
            "phyphox");
}

TEST(ReadRecording, MissingValuesAreCounted) {
  const Recording r = read("t,x,v\n0,1,\n1,NaN,2\n2,null,3\n3,4,5\n");
  EXPECT_TRUE(std::isnan(column(r, 1).values[1]));
  EXPECT_THAT(in_words(r.notices), ElementsAre("column \"x\": 2 missing values, the first in line 3",
                                               "column \"v\": 1 missing value, the first in line 2"));
}

TEST(ReadRecording, AWordNamesLineColumnAndCure) {
  const std::string text = "Time (s),Position (m)\n0.5,1\n1.5,abc\n2.5,3\n";
  EXPECT_EQ(refusal(text),
            "lab.txt:3: column \"Position (m)\": \"abc\" is not a number; --skip-bad-rows drops such rows");
  const Recording r =
      read(text, {.delimiter = {}, .decimal = {}, .time_column = {}, .rate = 0, .skip_bad_rows = true});
  EXPECT_THAT(column(r, 1).values, ElementsAre(1, 3));
  EXPECT_THAT(r.lines, ElementsAre(2, 4));
  EXPECT_THAT(in_words(r.notices), ElementsAre("1 bad row left out, the first in line 3"));
  EXPECT_THAT(refusal("t,x\n0.1,abc\n0.2,2\n0.3,3\n"),
              HasSubstr("lab.txt:2: column \"x\""));  // the first row too
  EXPECT_THAT(refusal("t,x\n0.1,1\n0.2,1e999\n0.3,3\n"),
              HasSubstr("lab.txt:3: column \"x\": \"1e999\" is not a number"));
  EXPECT_THAT(refusal("t;x\n0.1;1\n0.2;1,5\n0.3;3\n"), HasSubstr("the decimal mark of this file is a point"));
  EXPECT_THAT(refusal("t,x\n0.1,1\n0.2,2,7\n0.3,3\n"),
              HasSubstr("lab.txt:3: there are more values than the 2 columns"));
}

TEST(ReadRecording, TwoWaysOfReadingAreNotGuessedAt) {
  const std::string text = "1,234,5,678\n2,345,6,789\n";
  EXPECT_THAT(refusal(text), HasSubstr("two ways"));
  EXPECT_THAT(refusal(text), HasSubstr("--delimiter"));
  EXPECT_THAT(refusal(text), HasSubstr("--decimal"));
  EXPECT_EQ(read(text, {.delimiter = ",", .decimal = {}, .time_column = {}}).table.columns.size(), 4u);
  const Recording pairs = read(text, {.delimiter = {}, .decimal = ",", .time_column = {}});
  ASSERT_EQ(pairs.table.columns.size(), 2u);
  EXPECT_THAT(column(pairs, 0).values, ElementsAre(1.234, 2.345));
  EXPECT_THAT(column(pairs, 1).values, ElementsAre(5.678, 6.789));
  // A header settles it.
  EXPECT_EQ(read("t,x\n1,234\n2,345\n").table.columns.size(), 2u);
  const Recording one = read("Position (m)\n1,234\n2,345\n");
  EXPECT_THAT(column(one, 0).values, ElementsAre(1.234, 2.345));
  // So does a sign where a fraction cannot have one.
  EXPECT_EQ(read("1,234\n2,-345\n").table.columns.size(), 2u);
}

TEST(ReadRecording, WhatIsNoRecordingIsRefusedClearly) {
  EXPECT_EQ(refusal(""), "lab.txt: the file is empty");
  EXPECT_THAT(refusal("\n\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal("Time (s),Position (m)\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal(std::string("\x7F"
                                  "ELF\0\1",
                                  6)),
              HasSubstr("binary file (a zero byte at offset 4)"));
  EXPECT_THAT(refusal("PK\x03\x04rest"), HasSubstr("ZIP"));
  EXPECT_THAT(refusal("LabVIEW Measurement\t\n1\t2\n"), HasSubstr("no segment with rows"));
  EXPECT_THAT(refusal("1 2\n3 4\n", {.delimiter = "|", .decimal = {}, .time_column = {}}),
              HasSubstr("--delimiter"));
  EXPECT_THAT(refusal("1 2\n3 4\n", {.delimiter = {}, .decimal = "'", .time_column = {}}),
              HasSubstr("--decimal"));
  EXPECT_THAT(refusal("1 2\n3 4\n", {.delimiter = {}, .decimal = {}, .time_column = "t"}),
              HasSubstr("--time-column"));
}

TEST(ReadRecording, TimeIsFoundWithoutAName) {
  const Recording r = read("0.0 0.7 0.2\n0.05 0.6 0.1\n0.1 0.5 0.0\n0.15 0.4 -0.1\n");
  EXPECT_EQ(column(r, 0).quantity, "time");
  EXPECT_EQ(column(r, 1).name, "column 2");
  EXPECT_THAT(in_words(r.notices), ElementsAre(HasSubstr("taken as the time")));
  // Falling values are no time.
  EXPECT_EQ(column(read("3.5 0.7\n2.5 0.6\n1.5 0.5\n"), 0).quantity, "");
}

TEST(ReadRecording, RunsBelowEachOtherAreSplit) {
  const Recording r = read("# made by simulate\nrun,t (s),x (m)\n1,0,1\n1,0.5,2\n1,1,3\n2,0,4\n2,0.5,5\n");
  EXPECT_EQ(r.dialect.name, "Cromer");
  EXPECT_THAT(runs(r), ElementsAre(1, 2));
  ASSERT_EQ(r.table.columns.size(), 4u);
  EXPECT_EQ(r.table.rows(), 3u);
  EXPECT_EQ(column(r, 3).run, 2);
  EXPECT_THAT(column(r, 1).values, ElementsAre(1, 2, 3));
  EXPECT_THAT(column(r, 3).values, ElementsAre(4, 5, testing::IsNan()));
  EXPECT_EQ(line_of(r, 1, 2), 5);
  EXPECT_EQ(line_of(r, 3, 1), 7);
  EXPECT_THAT(in_words(r.notices), ElementsAre());
}

TEST(ReadRecording, ALineOfNumbersNamesNothing) {
  const Recording r = read("A title\n7 0.01\n0.5\n0.25\n-0.5\n");
  EXPECT_EQ(column(r, 0).name, "A title");
  EXPECT_THAT(column(r, 0).values, ElementsAre(0.5, 0.25, -0.5));
  // But their number and a step make a time.
  const Recording counted = read("A title\n3 0.5\n0.5\n0.25\n-0.5\n");
  EXPECT_EQ(column(counted, 0).quantity, "time");
  EXPECT_THAT(column(counted, 0).values, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(in_words(counted.notices), ElementsAre(HasSubstr("0.5 s is taken as their step")));
}

TEST(ReadRecording, ManyShortRowsCostNoMemory) {
  std::string text;
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 1500; ++j) text += "1;";
    text += "1\n";
  }
  for (int i = 0; i < 2'000'000; ++i) text += "1\n";
  const auto recording =
      read_recording(text, "lab.txt", {.delimiter = ";", .decimal = {}, .time_column = {}});
  EXPECT_TRUE(!recording || recording->table.rows() * recording->table.columns.size() < text.size());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
