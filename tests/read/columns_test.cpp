// Which run a column belongs to, and what its missing values mean.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "cromer/read/time.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<int> run_of_columns(const Recording& recording) {
  std::vector<int> all;
  for (const Column& column : recording.table.columns) all.push_back(column.run);
  return all;
}

TEST(Columns, LastOnesWithoutNameAndValuesAreLeftOut) {
  EXPECT_EQ(read("x (m),\n1.5,\n2.5,\n1.5,\n").table.columns.size(), 1u);
  EXPECT_EQ(read("t (s),x (m),,\n0.1,1.5,,\n0.2,2.5,,\n").table.columns.size(), 2u);
  EXPECT_EQ(read("t (s),x (m),,y\n0.1,1.5,,\n0.2,2.5,,\n").table.columns.size(), 4u);
}

TEST(Columns, AUnitOfAnotherQuantityNamesAnother) {
  const Recording recording = read("t (s),Position (m),Force\n0.1,1.5,2\n0.2,2.5,3\n0.3,1.5,2\n");
  const auto place_of = [&](std::string_view name) {
    const auto found = find_column(recording.table, name, 0);
    return found ? static_cast<int>(*found) : -1;
  };
  EXPECT_EQ(place_of("Position (cm)"), 1);
  EXPECT_EQ(place_of("position (m)"), 1);
  EXPECT_EQ(place_of("Force (N)"), 2);
  EXPECT_EQ(place_of("Position (V)"), -1);
  EXPECT_THAT(in_words(find_column(recording.table, "Position (V)", 0).error()),
              testing::EndsWith("did you mean \"Position (m)\"?"));
}

TEST(Runs, GroupsOfColumns) {
  // Graphical Analysis: a restarted run has the same label.
  EXPECT_THAT(
      run_of_columns(read(
          "Data Set 1:Time(s),Data Set 1:x(m),Data Set 1:Time(s),Data Set 1:x(m)\n0.1,1,0.1,2\n0.2,1,,\n")),
      ElementsAre(1, 1, 2, 2));
  // A second time with another quantity is a second sensor, not a second run.
  EXPECT_THAT(run_of_columns(read("t (s),x (m),t (s),phi (rad)\n0.1,1,0.15,2\n0.2,1,0.25,2\n")),
              ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(run_of_columns(read("x (m),t (s),x (m),t (s)\n1,0.1,2,0.1\n1,0.2,2,0.2\n")),
              ElementsAre(1, 1, 2, 2));
  // Two sensors with their own times, twice.
  EXPECT_THAT(run_of_columns(read("t,x,t,y,t,x,t,y\n0.1,1,0.2,2,0.1,1,0.2,2\n0.3,1,0.4,2,0.3,1,0.4,2\n")),
              ElementsAre(1, 1, 1, 1, 2, 2, 2, 2));
  // A time without a label belongs to the columns behind it.
  EXPECT_THAT(run_of_columns(read("Time (s);x (m) Run #1;Time (s);x (m) Run #2\n0,1;1;0,1;2\n0,2;1;0,2;2\n")),
              ElementsAre(1, 1, 2, 2));
}

TEST(Runs, AreCalledSoInOtherLanguages) {
  for (const std::string word : {"Durchgang", "Lauf", "Corsa", "Essai", "Ensayo", "Série"}) {
    const std::string one = word + " #1;", two = word + " #2\n";
    const Recording read_as = read("Zeit (s) " + one + "Ort (m) " + one + "Zeit (s) " + word +
                                   " #2;Ort (m) " + two + "0;1;0;2\n1;2;1;3\n");
    EXPECT_THAT(run_of_columns(read_as), ElementsAre(1, 1, 2, 2)) << word;
    EXPECT_EQ(read_as.table.columns[3].name, "Ort");
  }
  // Sensors and carts have numbers, too.
  for (const std::string word : {"Sensor", "Cart", "Kanal"})
    EXPECT_THAT(run_of_columns(read("t (s);x (m) " + word + " #1;x (m) " + word + " #2\n0;1;2\n1;2;3\n")),
                ElementsAre(1, 1, 1))
        << word;
}

TEST(Runs, TracksAreCalledByTheirNames) {
  const Recording r = read("#multi:\n\tball\t\trod\t\nt\tx\ty\tx\ty\t\n0\t1\t2\t3\t4\t\n0.1\t1\t2\t\t\t\n");
  EXPECT_EQ(r.dialect.name, "Tracker");
  EXPECT_THAT(run_of_columns(r), ElementsAre(1, 1, 1, 2, 2));
  EXPECT_THAT(in_words(r.notices), Contains("run 2 is called \"rod\" in the file"));
  const auto series = take_series(r, "x", 2, {});
  ASSERT_TRUE(series.ok());
  EXPECT_EQ(series->y.front(), 3);
}

TEST(MissingValues, SlowerSensors) {
  for (const auto& [stride, said] :
       {std::pair{3, "every 3rd row"}, std::pair{12, "every 12th row"}, std::pair{22, "every 22nd row"}}) {
    std::string text = "Time (s),Pos A (mm),Pos B (mm)\n";
    for (int i = 0; i < 5 * stride; ++i) text += concat({std::to_string(i), i % stride ? ",1,\n" : ",1,2\n"});
    EXPECT_THAT(in_words(read(text).notices), Contains(HasSubstr(said)));
  }
}

TEST(MissingValues, SensorsSampledInTurn) {
  std::string text = "Time (s),Pos A (mm),Pos B (mm)\n";
  for (int i = 0; i < 10; ++i) text += concat({"0.", std::to_string(i), i % 2 ? ",1,\n" : ",,2\n"});
  const Recording r = read(text);
  EXPECT_THAT(in_words(r.notices), ElementsAre("column \"Pos A (mm)\" is measured only in every 2nd row",
                                               "column \"Pos B (mm)\" is measured only in every 2nd row"));
  const auto series = take_series(r, "Pos A", 1, {});
  ASSERT_TRUE(series.ok());
  EXPECT_EQ(series->rate, 5);
  EXPECT_EQ(series->t.front(), 0.1);
}

TEST(Columns, APeriodIsNoTime) {
  const Recording r = read("Period [s],Spectral acceleration [g]\n0.01,0.5\n0.02,0.75\n0.05,1\n");
  EXPECT_EQ(r.table.columns.at(0).quantity, "");
}

TEST(Columns, RunsAreNamedInALineOfTheirOwn) {
  const std::string rows = "0,1,0,3\n0.5,2,0.5,4\n1,2,1,5\n";
  const std::string names = "Time (s),Position (m),Time (s),Position (m)\n";
  for (const std::string above : {"Run #1,,Run #2,\n", "\"Run #1\",\"\",\"Run #2\",\"\"\r\n",
                                  "Run #1,Run #1,Run #2,Run #2\n", "My lab\nRun #1,,Run #2\n"}) {
    const Recording r = read(above + names + rows);
    EXPECT_EQ(r.dialect.name, "PASCO Capstone") << above;
    EXPECT_THAT(runs(r), ElementsAre(1, 2)) << above;
    EXPECT_EQ(r.table.columns.at(3).name, "Position");
    EXPECT_EQ(r.table.columns.at(3).run, 2);
    EXPECT_THAT(in_words(r.notices), ElementsAre()) << above;
  }
  // A label counts, not the order.
  const Recording later = read("Run #3,,Run #7,\n" + names + rows);
  EXPECT_THAT(in_words(later.notices), ElementsAre("run 1 is called \"Run #3\" in the file",
                                                   "run 2 is called \"Run #7\" in the file"));
  // One time for all.
  const Recording shared =
      read(",Run #1,Run #2\nTime (s),Position (m),Position (m)\n0,1,2\n0.5,2,3\n1,4,5\n");
  EXPECT_THAT(runs(shared), ElementsAre(1, 2));
  const auto series = take_series(shared, "", 2, {});
  ASSERT_TRUE(series.ok()) << in_words(series.error());
  EXPECT_THAT(series->t, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(series->y, ElementsAre(2, 3, 5));
  // Other words above the names are a title.
  EXPECT_EQ(read("Run #1,by me,,\n" + names + rows).dialect.name, "plain");
  EXPECT_EQ(read("Run #1\n" + names + rows).dialect.name, "plain");
}

TEST(Columns, TheTimesOfAllAreThoseOfEach) {
  // Times before and behind what they belong to, in runs that interleave, and in none.
  std::uint32_t state = 1;
  const auto random = [&](std::uint32_t most) { return (state = state * 1664525 + 1013904223) >> 16 & most; };
  for (int trial = 0; trial < 200; ++trial) {
    Table table;
    for (std::uint32_t j = random(15); j > 0; --j)
      table.columns.push_back(
          {"c", random(3) == 0 ? "time" : "position", "", static_cast<int>(random(3)), {}});
    const auto all = dialects::time_columns_of(table);
    for (std::size_t j = 0; j < table.columns.size(); ++j)
      EXPECT_EQ(all[j], dialects::time_column_of(table, j));
  }
}

TEST(Commas, WholeNumbersAmongDecimalCommasAreRefused) {
  ReadOptions comma;
  comma.decimal = ",";
  const std::string text = "0,1,1,6\n0,1,5\n0,2,1,7\n0,3,1,7\n";
  const auto refused = read_recording(text, "lab.txt", comma);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()),
              HasSubstr("lab.txt:2: \"0,1,5\": it is open which commas are decimal marks"));
  comma.skip_bad_rows = true;
  EXPECT_THAT(read(text, comma).table.columns.at(1).values, ElementsAre(1.6, 1.7, 1.7));
}

TEST(Commas, QuotesTellDecimalsFromSeparators) {
  const Recording r = read("Time,Position\n0,\"1,5\"\n\"0,5\",2\n1,\"-3,75E-5\"\n");
  EXPECT_EQ(r.dialect.decimal, "comma");
  EXPECT_THAT(r.table.columns.at(0).values, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(r.table.columns.at(1).values, ElementsAre(1.5, 2, -3.75e-5));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
