#include "cromer/live/line_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A reader with what it made of its input so far.
struct Reading {
  explicit Reading(LineSettings settings = {}, bool within_line = false) : reader(settings, within_line) {}
  void take(std::string_view bytes, double arrival = 100) { reader.take(bytes, arrival, rows, notices); }

  LineReader reader;
  SampleRows rows;
  std::vector<Remark> notices;
};

TEST(Line, IsNumbersWordsOrGarbage) {
  EXPECT_THAT(read_line("1.5 2").numbers, ElementsAre(1.5, 2));
  EXPECT_THAT(read_line(" 1.5,\t-2e-3 \r").numbers.size(), 0u) << "two hard separators";
  EXPECT_THAT(read_line("1.5,-2e-3").numbers, ElementsAre(1.5, -2e-3));
  EXPECT_THAT(read_line("1,5;2,25").numbers, ElementsAre(1.5, 2.25));
  EXPECT_THAT(read_line("0.5\t7").numbers, ElementsAre(0.5, 7));
  EXPECT_TRUE(std::isnan(read_line("1,nan").numbers.at(1)));
  EXPECT_TRUE(std::isnan(read_line("1,").numbers.at(1)));
  EXPECT_EQ(read_line("  ").kind, LineKind::blank);
  EXPECT_EQ(read_line("# begin").kind, LineKind::comment);
  EXPECT_THAT(read_line("Time (ms),Distance (cm)").words, ElementsAre("Time (ms)", "Distance (cm)"));
  for (const char* garbage : {"12 cm", "1.2.3", "0x1f", "1e999", "\x01\x02", "12,3abc"})
    EXPECT_EQ(read_line(garbage).kind, LineKind::garbage) << garbage;
}

TEST(Line, MissingValuesAndDecimalMarks) {
  for (const char* missing : {"1,", "1,NaN", "1,null", "1, NULL "})
    EXPECT_TRUE(std::isnan(read_line(missing).numbers.at(1))) << missing;
  EXPECT_EQ(read_line(",").numbers.size(), 2u);
  EXPECT_THAT(read_line("1,5;2.5").kind, LineKind::garbage);
  EXPECT_THAT(read_line("1,5\t2").numbers, ElementsAre(1.5, 2));
  EXPECT_THAT(read_line("12,5").numbers, ElementsAre(12, 5));
  EXPECT_THAT(read_line(" 1  2 3 ").numbers, ElementsAre(1, 2, 3));
  EXPECT_EQ(read_line("% a").kind, LineKind::comment);
}

TEST(Line, WordsAreOfLettersWithoutNumbers) {
  EXPECT_THAT(read_line("Time since start").words, ElementsAre("Time since start"));
  EXPECT_THAT(read_line("a;z").words, ElementsAre("a", "z"));
  EXPECT_THAT(read_line("A,Z (m)").words, ElementsAre("A", "Z (m)"));
  for (const char* garbage : {"a,1", "a,--", "--", "1a;b", "3 words", "[1]",
                              "a\x1F"
                              "b",
                              "{};@"})
    EXPECT_EQ(read_line(garbage).kind, LineKind::garbage) << garbage;
  EXPECT_EQ(read_line("a b").kind, LineKind::words);
}

TEST(Line, IsShownInPrintableLetters) {
  EXPECT_EQ(shown(std::string(40, 'a')), std::string(40, 'a'));
  EXPECT_EQ(shown(std::string(41, 'a')), std::string(40, 'a') + "...");
  EXPECT_EQ(shown(" ~\x1F\x7F\x80\t"), " ~????");
}

TEST(LineReader, TakesLinesInWhateverPiecesTheyCome) {
  const std::string text = "0.00 1.5\r\n0.01 1.25\r\n0.02 -1e-3\r\n";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    Reading reading;
    for (std::size_t at = 0; at < text.size(); at += piece) reading.take(text.substr(at, piece));
    EXPECT_THAT(reading.rows.t, ElementsAre(0, 0.01, 0.02)) << piece;
    EXPECT_THAT(reading.rows.values, ElementsAre(1.5, 1.25, -1e-3)) << piece;
    EXPECT_TRUE(reading.notices.empty());
  }
  Reading reading;
  EXPECT_TRUE(reading.reader.headings().empty());
  reading.take(text);
  EXPECT_THAT(reading.reader.headings(), ElementsAre("Time (s)", "Value"));
}

TEST(LineReader, TakesHeadingAndUnitOfTime) {
  Reading reading;
  reading.take("Time (ms),Distance (cm)\n1234,56.5\n1244,57\n");
  EXPECT_THAT(reading.reader.headings(), ElementsAre("Time (s)", "Distance (cm)"));
  EXPECT_THAT(reading.rows.t, ElementsAre(1.234, 1.244));
  // After a reset the device announces them again.
  reading.take("Time (ms),Distance (cm)\n1254,58\n");
  EXPECT_EQ(reading.reader.garbage(), 0u);
  EXPECT_EQ(reading.rows.size(), 3u);

  Reading told({.time_unit = 1e-6, .headings = "Position (mm), Tilt (deg)"});
  told.take("1500000 2 3\n");
  EXPECT_THAT(told.rows.t, ElementsAre(1.5));
  EXPECT_THAT(told.rows.values, ElementsAre(2, 3));
  EXPECT_THAT(told.reader.headings(), ElementsAre("Time (s)", "Position (mm)", "Tilt (deg)"));
}

TEST(LineReader, CountsAndReportsGarbage) {
  Reading reading;
  reading.take("Sensor ready\n0.00 1\n0.01 ?!\x7f\n0.02 3\n5\n0.03 4 5\n\n0.04 6\n");
  EXPECT_THAT(reading.rows.t, ElementsAre(0, 0.02, 0.04));
  ASSERT_EQ(reading.reader.garbage(), 4u);
  EXPECT_THAT(in_words(reading.notices[0].what), HasSubstr("line 1 is no sample: \"Sensor ready\""));
  EXPECT_THAT(in_words(reading.notices[1].what), HasSubstr("line 3 is no sample: \"0.01 ?!?\""));
  EXPECT_THAT(in_words(reading.notices[3].what), HasSubstr("line 6"));
}

TEST(LineReader, AnEndlessLineTakesNoMemory) {
  Reading reading;
  const std::string noise(4096, '7');
  for (int i = 0; i < 1000; ++i) reading.take(noise);
  reading.take("\n0 1\n0.1 2\n");
  EXPECT_EQ(reading.reader.garbage(), 1u);
  EXPECT_LT(in_words(reading.notices[0].what).size(), 200u);
  EXPECT_EQ(reading.rows.size(), 2u);
}

/// Of a serial line, opened at 100 s.
struct SerialReading : Reading {
  SerialReading() : Reading({}, true) { reader.connected(100); }
};

TEST(LineReader, OpenedWithinALineLeavesItsRestOutAndSaysSo) {
  for (const char* rest : {".07 1.5", "7 1.5", "07 1.5", "1.5", "5", "nds Time", "70 1.5"}) {
    SerialReading reading;
    reading.take(std::string(rest) + "\n12.08 1\n12.09 1\n", 100.001);
    EXPECT_THAT(reading.rows.t, ElementsAre(12.08, 12.09)) << rest;
    EXPECT_EQ(reading.reader.garbage(), 0u) << rest;
    ASSERT_EQ(reading.notices.size(), 1u) << rest;
    EXPECT_THAT(in_words(reading.notices[0].what), HasSubstr(rest));
  }
  // From what is left of 19.99 to 20.00.
  SerialReading reading;
  reading.take("9.99 1\n20.00 1\n", 100.001);
  EXPECT_THAT(reading.rows.t, ElementsAre(20.00));
}

TEST(LineReader, KeepsAFirstLineThatIsWhole) {
  SerialReading next_has_its_form;
  next_has_its_form.take("12.07 1.5\n12.08 1\n", 100.001);
  EXPECT_THAT(next_has_its_form.rows.t, ElementsAre(12.07, 12.08));
  SerialReading a_digit_more;
  a_digit_more.take("990 1.5\n1000 1\n", 100.001);
  EXPECT_THAT(a_digit_more.rows.t, ElementsAre(990, 1000));
  SerialReading after_silence;  // as of a device that is reset when it is opened
  after_silence.take("Time (ms),x\n7,1.5\n8,1\n", 101.5);
  EXPECT_THAT(after_silence.rows.t, ElementsAre(0.007, 0.008));
  SerialReading values_after_silence;
  values_after_silence.take("1\n2\n", 100.2);
  values_after_silence.reader.end(101, values_after_silence.rows, values_after_silence.notices);
  EXPECT_THAT(values_after_silence.rows.values, ElementsAre(1, 2));
  for (const Reading* each :
       {&static_cast<Reading&>(next_has_its_form), &static_cast<Reading&>(a_digit_more),
        &static_cast<Reading&>(after_silence), &static_cast<Reading&>(values_after_silence)})
    EXPECT_TRUE(each->notices.empty());
}

TEST(LineReader, BeginsAnewWithEachConnection) {
  Reading reading;
  reading.take("0.08 1\n0.09 1");
  reading.reader.connection_lost(reading.rows, reading.notices);
  reading.reader.connected(105);
  reading.take("0.10 2\n0.11 2\n", 105);
  EXPECT_THAT(reading.rows.t, ElementsAre(0.08, 0.10, 0.11));
  EXPECT_TRUE(reading.notices.empty());

  SerialReading serial;
  serial.take("\n0.08 1\n0.09 1", 100.01);
  serial.reader.connection_lost(serial.rows, serial.notices);
  serial.reader.connected(105);
  serial.take("9 7\n0.10 2\n", 105.001);
  EXPECT_THAT(serial.rows.t, ElementsAre(0.08, 0.10));
  EXPECT_EQ(serial.notices.size(), 1u);
}

TEST(LineReader, AByteOrderMarkCostsNoSample) {
  Reading reading;
  reading.take(
      "\xEF\xBB\xBF"
      "0.00 1.5\n0.01 1\n");
  EXPECT_THAT(reading.rows.t, ElementsAre(0.00, 0.01));
  EXPECT_EQ(reading.reader.garbage(), 0u);
  Reading heading;
  heading.take(
      "\xEF\xBB\xBF"
      "Time (ms),x (cm)\n10,1\n");
  EXPECT_THAT(heading.reader.headings(), ElementsAre("Time (s)", "x (cm)"));
}

TEST(LineReader, ValuesAloneAreStampedByArrival) {
  Reading reading;
  for (int i = 0; i < 5; ++i) reading.take(std::to_string(i) + "\n", 100 + 0.01 * i);
  EXPECT_THAT(reading.reader.headings(), ElementsAre("Time (s)", "Value"));
  EXPECT_EQ(reading.reader.times().by, TimesBy::nothing);
  // They are held back for a while, to be stamped better.
  reading.reader.release(100.79, reading.rows, reading.notices);
  EXPECT_EQ(reading.rows.size(), 0u);
  reading.reader.release(100.81, reading.rows, reading.notices);
  ASSERT_EQ(reading.rows.size(), 5u);
  // What arrives at once still has rising times.
  reading.take("5\n6\n7\n", 100.05);
  reading.reader.end(100.05, reading.rows, reading.notices);
  ASSERT_EQ(reading.rows.size(), 8u);
  EXPECT_THAT(reading.rows.values, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(reading.rows.t[i], 0.01 * i, 1e-6);
  EXPECT_EQ(reading.reader.times().by, TimesBy::arrival);
  for (std::size_t i = 1; i < reading.rows.size(); ++i) EXPECT_GT(reading.rows.t[i], reading.rows.t[i - 1]);
}

TEST(LineReader, LinesOfAThousandBytesAreRead) {
  const std::string longest = "0 1." + std::string(996, '0'), longer = longest + "0";
  Reading whole, cut;
  whole.take(longest + "\n");
  EXPECT_EQ(whole.rows.size(), 1u);
  cut.take(longer + "\n1 2\n");
  EXPECT_THAT(cut.rows.t, ElementsAre(1));
  EXPECT_THAT(in_words(cut.notices.at(0).what), HasSubstr("line 1 is no sample: \"0 1.000"));
}

TEST(LineReader, ThirtyTwoNumbersAreALine) {
  std::string line = "0";
  for (int i = 1; i < 32; ++i) line += " 1";
  Reading reading, wide;
  reading.take(line + "\n");
  EXPECT_EQ(reading.rows.width, 31u);
  EXPECT_THAT(reading.reader.headings().back(), "Value 31");
  wide.take(line + " 1\n");
  EXPECT_EQ(wide.reader.garbage(), 1u);
}

TEST(LineReader, HeadingsSayMoreThanReady) {
  Reading named, ready, twice, few;
  named.take("Height (mm)\n1\n");
  EXPECT_THAT(named.reader.headings(), ElementsAre("Time (s)", "Height (mm)"));
  ready.take("ready\n1\n");
  EXPECT_THAT(ready.reader.headings(), ElementsAre("Time (s)", "Value"));
  EXPECT_THAT(in_words(ready.notices.at(0).what), HasSubstr("line 1 is no sample: \"ready\""));
  twice.take("boot,ok\nTime,x\n1 2\n3 4\nTime,y\n");
  EXPECT_THAT(twice.reader.headings(), ElementsAre("Time (s)", "x"));
  EXPECT_EQ(twice.notices.size(), 2u);
  EXPECT_THAT(in_words(twice.notices.at(1).what), HasSubstr("line 5"));
  few.take("a,b\n1 2 3\n");
  EXPECT_THAT(few.reader.headings(), ElementsAre("Time (s)", "Value 1", "Value 2"));
  EXPECT_EQ(few.reader.garbage(), 1u);
  Reading some({.headings = "a"});
  some.take("0 1 2\n");
  EXPECT_THAT(some.reader.headings(), ElementsAre("Time (s)", "a", "Value 2"));
}

TEST(LineReader, OnlyUnitsOfTimeScaleTheTimes) {
  const auto second = [](const std::string& heading) {
    Reading reading;
    reading.take(heading + ",x\n1000,1\n2000,1\n");
    return reading.rows.t.at(1);
  };
  EXPECT_EQ(second("Time [ms]"), 2);
  EXPECT_EQ(second("Time (of it) (ms)"), 2000);
  EXPECT_EQ(second("Time (m)"), 2000);
  EXPECT_EQ(second("Time )ms("), 2000);
  EXPECT_EQ(second("Time (ms"), 2000);
  EXPECT_EQ(second("Time ms)"), 2000);
  EXPECT_EQ(second("Time ()"), 2000);
}

TEST(LineReader, ALineWithoutItsTimeIsNone) {
  Reading reading;
  reading.take("0 1\nnan 2\n0.1 nan\n0.2 3\n");
  EXPECT_THAT(reading.rows.t, ElementsAre(0, 0.1, 0.2));
  EXPECT_EQ(reading.reader.garbage(), 1u);
  Reading value({.rate = 10});
  value.take("1\nnan\n3\n");
  EXPECT_THAT(value.rows.t, ElementsAre(0, 0.1, 0.2));
  EXPECT_EQ(value.rows.width, 1u);
  EXPECT_EQ(value.reader.times().by, TimesBy::count);
}

TEST(LineReader, SilenceBeforeTheFirstByteShowsAWholeLine) {
  const auto rows = [](double arrival) {
    SerialReading reading;
    reading.take("7 1\n12.08 1\n", arrival);
    return reading.rows.size();
  };
  EXPECT_EQ(rows(100.029), 1u);
  EXPECT_EQ(rows(100.031), 2u);
  SerialReading slow;  // the silence is between two pieces of a line
  slow.take("7", 100.001);
  slow.take(" 1\n12.08 1\n", 100.2);
  EXPECT_THAT(slow.rows.t, ElementsAre(12.08));
  SerialReading lost;
  lost.take("\n0.08 1\n0.09 1", 100.01);
  lost.reader.connection_lost(lost.rows, lost.notices);
  lost.reader.connected(105);
  lost.take("9 7\n0.10 2\n", 105.2);
  EXPECT_THAT(lost.rows.t, ElementsAre(0.08, 0.10));
}

TEST(LineReader, TheFormOfTheNextLineShowsAWholeOne) {
  const auto whole = [](const std::string& first, const std::string& next) {
    SerialReading reading;
    reading.take(first + "\n" + next + "\n", 100.001);
    return reading.rows.size() == 2;
  };
  EXPECT_TRUE(whole("9.5 1", "10.4 1"));
  EXPECT_FALSE(whole("9.3 1", "10.4 1"));
  EXPECT_FALSE(whole("9.5 1", "100.4 1"));
  EXPECT_FALSE(whole("12 1", "12.5 1"));
  EXPECT_FALSE(whole("12.5 1", "12.5 1"));
  EXPECT_FALSE(whole("12.4 1 1", "12.5 1"));
  EXPECT_FALSE(whole("4", "5"));
  EXPECT_FALSE(whole("-2 1", "3 1"));
  SerialReading last;
  last.take("12.4 1\n", 100.001);
  last.reader.end(101, last.rows, last.notices);
  EXPECT_EQ(last.rows.size(), 0u);
  ASSERT_EQ(last.notices.size(), 1u);
  EXPECT_EQ(last.notices[0].kind, RemarkKind::connection);
  SerialReading stopped;  // while its first line waits
  stopped.take("12.4 1\n12.", 100.001);
  stopped.reader.release_all(stopped.rows, stopped.notices);
  EXPECT_EQ(stopped.rows.size(), 0u);
  ASSERT_EQ(stopped.notices.size(), 1u);
  EXPECT_EQ(in_words(stopped.notices[0].what),
            "what came first may be the end of a line, and is left out: \"12.4 1\"");
}

TEST(LineReader, RowsThatAreLetGoHaveOneValue) {
  Reading reading;
  reading.take("1\n2\n");
  SampleRows none, two;
  reading.reader.release(100.1, none, reading.notices);
  EXPECT_EQ(none.width, 0u);
  reading.reader.release_all(two, reading.notices);
  EXPECT_EQ(two.width, 1u);
  EXPECT_EQ(two.size(), 2u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
