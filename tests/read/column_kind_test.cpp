// What a column measures, by its name and unit; what is taken for the time.
#include "cromer/read/column_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

TEST(ColumnKind, NamesTell) {
  for (const auto& [name, quantity] : {std::pair{"Angular velocity", "angular velocity"},
                                       {"angular position", "angle"},
                                       {"Angular acceleration", ""},
                                       {"angolare omega", "angular velocity"},
                                       {"vitesse angulaire", "angular velocity"},
                                       {"angular frequency", "frequency"},
                                       {"angular angle", "angle"},
                                       {"x12", "position"},
                                       {"x_{1}", "position"},
                                       {"V", ""},
                                       {"F2", "force"},
                                       {"Acceleratio", "acceleration"},
                                       {"Displacem", "position"},
                                       {"Displace", ""},
                                       {"Zeit", "time"},
                                       {"millis", "time"},
                                       {"seconds", "time"},
                                       {"Posizione[1]", "position"},
                                       {"expose", ""},
                                       {"12", ""},
                                       {"", ""}})
    EXPECT_EQ(quantity_of(name, ""), quantity) << name;
}

TEST(ColumnKind, UnitsDecide) {
  for (const auto& [name, unit, quantity] : {std::tuple{"x", "V", "voltage"},
                                             {"a", "deg", "angle"},
                                             {"", "mm", "position"},
                                             {"", "rad/s", "angular velocity"},
                                             {"frequency", "rad/s", "frequency"},
                                             {"a", "kHz", "frequency"},
                                             {"x", "foo", "position"},
                                             {"", "kg", ""},
                                             {"time", "MS", "time"},
                                             {"acc", "g", "acceleration"},
                                             {"", "Hz/s", ""}})
    EXPECT_EQ(quantity_of(name, unit), quantity) << name << ' ' << unit;
  EXPECT_TRUE(is_unit_of("Sec", "time"));
  EXPECT_FALSE(is_unit_of("m", "time"));
  EXPECT_FALSE(is_unit_of("foo", "time"));
  EXPECT_FALSE(is_unit_of("m", "mass"));
  EXPECT_EQ(si_unit_of("velocity"), "m/s");
  EXPECT_EQ(si_unit_of("mass"), "");
  EXPECT_EQ(unit_as_name("micros()"), "us");
  EXPECT_EQ(unit_as_name("min"), "");
  EXPECT_EQ(plain_name("X _{1}$\\[a](B)^\t"), "x1ab");
}

TEST(ColumnKind, FactorsAreKnownOrOne) {
  const auto factor = [](const char* quantity, const char* unit) {
    const ToSi si = to_si({"c", quantity, unit, 1, {}});
    return si.known ? si.factor : -si.factor;
  };
  EXPECT_EQ(factor("position", "mm"), 0.001);
  EXPECT_EQ(factor("position", ""), -1);
  EXPECT_EQ(factor("position", "px"), -1);
  EXPECT_DOUBLE_EQ(factor("frequency", "Hz"), 1);
  EXPECT_DOUBLE_EQ(factor("frequency", "rad/s"), 1 / 6.283185307179586);
}

/// The quantity of the first column of a table without names.
std::string first_of(const std::string& values, double rate = 0) {
  std::string text;
  for (std::size_t from = 0; from < values.size();) {
    const std::size_t end = std::min(values.find(' ', from), values.size());
    text += concat({values.substr(from, end - from), ";", text.size() % 3 == 0 ? "5" : "1", "\n"});
    from = end + 1;
  }
  ReadOptions options;
  options.rate = rate;
  return read(text, options).table.columns.at(0).quantity;
}

TEST(FirstColumn, ThatRunsEvenlyUpwardIsTheTime) {
  EXPECT_EQ(first_of("1 2 3"), "time");
  EXPECT_EQ(first_of("1 2"), "");
  EXPECT_EQ(first_of("3 2 1"), "");
  EXPECT_EQ(first_of("2 2 2"), "");
  EXPECT_EQ(first_of("0 1 2 3 4 5 6 7 8 9 11"), "time");  // nine of ten are even
  EXPECT_EQ(first_of("0 1 2 3 4 5 6 7 9 11"), "");        // seven of nine
  EXPECT_EQ(first_of("0 1 2 3 4 5 6 7 8 9 10.4"), "time");
  EXPECT_EQ(first_of("0 1 2.4 3 4 5.4 6"), "time");
  EXPECT_EQ(first_of("0 1 2.6 3 4 5.6 6"), "");
  EXPECT_EQ(first_of("0 1 2.5 3.5 5 6"), "");
  EXPECT_EQ(first_of("0 1 nan 3 4"), "time");
  EXPECT_EQ(first_of("0 nan 2 nan 4"), "");
}

TEST(FirstColumn, ThatCountsRowsIsNoTimeWhereTheRateIsKnown) {
  EXPECT_EQ(first_of("5 6 7", 10), "index");
  EXPECT_EQ(first_of("0 2 4", 10), "time");
  EXPECT_EQ(first_of("0 1 3 4 5 6 7 8 9 10 11 12", 10), "time");
  EXPECT_EQ(read("n,x\n0,5\n1,6\n2,5\n").table.columns[0].quantity, "index");
  for (const char* name : {"Sample", "samples", "Index", "ROW", "frame", "No", "#"})
    EXPECT_EQ(read(concat({"x (m),\"", name, "\"\n0,5\n1,6\n2,5\n"})).table.columns[1].quantity, "index")
        << name;
  EXPECT_EQ(read("Periode,x (m)\n0,5\n1,6\n2,5\n").table.columns[0].quantity, "");
  EXPECT_EQ(read("Lag (s),x (m)\n0,5\n1,6\n2,5\n").table.columns[0].quantity, "");
}

TEST(FirstColumn, TakenAsTheTimeIsSaid) {
  EXPECT_THAT(in_words(read("1 5\n2 6\n3 5\n").notices),
              ElementsAre("the first column runs evenly upward: it is taken as the time in seconds"));
  EXPECT_THAT(in_words(read("q,x\n1,5\n2,6\n3,5\n").notices),
              ElementsAre("\"q\" runs evenly upward: it is taken as the time in seconds"));
  EXPECT_THAT(in_words(read("t,x\n1,5\n2,6\n3,5\n").notices), IsEmpty());
  EXPECT_THAT(in_words(read("x (m)\n1\n2\n3\n").notices), IsEmpty());
}

TEST(TimeColumn, OtherSecondsAreNoneBesideOneSoNamed) {
  const Recording r = read("Time (s),Delay (s)\n0,5\n1,6\n2,5\n");
  EXPECT_EQ(r.table.columns[0].quantity, "time");
  EXPECT_EQ(r.table.columns[1].quantity, "");
  EXPECT_EQ(read("Delay (s),x (m)\n0,5\n1,6\n2,5\n").table.columns[0].quantity, "time");
}

TEST(TimeColumn, ThatIsAskedForIsTheOnlyOne) {
  ReadOptions named;
  named.time_column = "clock";
  const Recording r = read("t (s),x (m),clock\n0,5,1\n1,6,2\n2,5,3\n", named);
  EXPECT_EQ(r.table.columns[0].quantity, "");
  EXPECT_EQ(r.table.columns[1].quantity, "position");
  EXPECT_EQ(r.table.columns[2].quantity, "time");
  EXPECT_EQ(refusal("t (s),x (m)\n0,5\n1,6\n", named),
            "lab.txt: --time-column: no column is called \"clock\"; there are \"t (s)\", \"x (m)\"");
  EXPECT_EQ(
      refusal("t (s),clock (foo)\n0,5\n1,6\n", named),
      "lab.txt: column \"clock (foo)\": the unit \"foo\" is not known: write s, ms, us, min or h after the "
      "time's name (seconds need none)");
  named.time_column = "t";
  EXPECT_EQ(refusal("t (s),time (foo)\n0,5\n1,6\n", named), "read");
  EXPECT_EQ(
      refusal("Time (m),x\n0,5\n1,6\n"),
      "lab.txt: column \"Time (m)\": the unit \"m\" is no unit of time: write s, ms, us, min or h after the "
      "time's name (seconds need none), or name another column with --time-column");
}

TEST(MissingValues, AreCountedInEachRun) {
  EXPECT_THAT(in_words(read("t,x Run #1,x Run #2\n0,1,\n1,,3\n2,3,\n").notices),
              ElementsAre("column \"x\" of run 1: 1 missing value, the first in line 3",
                          "column \"x\" of run 2: 1 missing value, the first in line 2"));
  EXPECT_THAT(in_words(read("t,x\n0,1\n1,\n").notices),
              ElementsAre("column \"x\": 1 missing value, the first in line 3"));
  EXPECT_THAT(in_words(read("t,x\n0,1\n,\n2,3\n").notices),
              ElementsAre("column \"t\": 1 missing value, the first in line 3",
                          "column \"x\": 1 missing value, the first in line 3"));
}

TEST(MissingValues, FourEvenlySpacedOnesAreASlowerSensor) {
  const auto said = [](const std::string& values) {
    std::string text = "t;x\n";
    for (std::size_t i = 0; i < values.size(); ++i)
      text += concat({std::to_string(i), ";", values[i] == '.' ? "" : std::string(1, values[i]), "\n"});
    return in_words(read(text).notices).at(0);
  };
  EXPECT_EQ(said("1.2.3.4"), "column \"x\" is measured only in every 2nd row");
  EXPECT_EQ(said("1.2.3."), "column \"x\": 3 missing values, the first in line 3");
  EXPECT_EQ(said(".1..2..3..4"), "column \"x\" is measured only in every 3rd row");
  EXPECT_EQ(said("1...2...3...4"), "column \"x\" is measured only in every 4th row");
  EXPECT_EQ(said("1.2.3.4..5"), "column \"x\": 5 missing values, the first in line 3");
  EXPECT_EQ(said("1234.567"), "column \"x\": 1 missing value, the first in line 6");
  for (const auto& [stride, nth] : {std::pair{11u, "11th"}, {21u, "21st"}, {111u, "111th"}}) {
    std::string values;
    for (int k = 0; k < 4; ++k) values += std::string(k > 0 ? stride - 1 : 0, '.') + "1";
    EXPECT_THAT(said(values), HasSubstr(concat({"every ", nth, " row"})));
  }
}

TEST(FindColumn, ByNameThenByPlainNameThenWithoutSubscript) {
  Table table;
  for (const auto& [name, unit, run] :
       {std::tuple{"x", "m", 1}, {"x", "mm", 1}, {"Y_1", "", 1}, {"x", "m", 2}})
    table.columns.push_back({name, "", unit, run, {}});
  EXPECT_EQ(find_column(table, "x (mm)", 1).value(), 1u);
  EXPECT_EQ(find_column(table, "x (m)", 2).value(), 3u);
  EXPECT_EQ(find_column(table, "x", 2).value(), 3u);
  EXPECT_EQ(find_column(table, "x", 0).value(), 0u);
  EXPECT_EQ(find_column(table, "y1", 1).value(), 2u);
  EXPECT_EQ(find_column(table, "y", 1).value(), 2u);
  EXPECT_EQ(in_words(find_column(table, "x", 1).error()),
            "\"x\" fits several columns; there are \"x (m)\", \"x (mm)\", \"Y_1\"");
  EXPECT_EQ(in_words(find_column(table, "zebra crossing", 2).error()),
            "no column is called \"zebra crossing\"; there are \"x (m)\"");
}

TEST(Columns, EmptyOnesWithoutANameAreDropped) {
  const auto count = [](const char* text) { return read(text).table.columns.size(); };
  EXPECT_EQ(count("t,x,,\n0,1,,\n1,2,,\n"), 2u);
  EXPECT_EQ(count("t,x,y\n0,1,\n1,2,\n"), 3u);
  EXPECT_EQ(count("t,x,\n0,1,\n1,2,3\n"), 3u);
}

TEST(Rows, OfARunEndAtItsLastValue) {
  const double nan = std::nan("");
  Table table;
  table.columns = {
      {"a", "", "", 1, {1, nan, nan}}, {"b", "", "", 1, {nan, 2, nan}}, {"c", "", "", 2, {1, 2, 3}}};
  EXPECT_EQ(rows_of_run(table, 1), 2u);
  EXPECT_EQ(rows_of_run(table, 2), 3u);
  EXPECT_EQ(rows_of_run(table, 3), 0u);
}

TEST(CleanTable, SensorsKeepTheirOwnTimes) {
  const auto heads = [](const Table& table) {
    std::vector<std::string> all;
    for (std::size_t j = 0; j < table.columns.size(); ++j)
      all.push_back(concat({column_heading(table, j), " ", std::to_string(table.columns[j].values.size())}));
    return all;
  };
  const Recording r = read("t,x,t,y,z\n0,1,0.5,2,5\n1,2,0.5,3,6\n2,4,2.5,5,7\n");
  const auto clean = clean_table(r, {});
  EXPECT_THAT(heads(*clean), ElementsAre("t (s) 3", "x 3", "t (s) 3", "y 3", "z 3"));
  EXPECT_TRUE(std::isnan(clean->columns[3].values[2]));
  EXPECT_THAT(heads(*clean_table(read("x (m),y (m)\n1,5\n2,6\n3,5\n"), {})),
              ElementsAre("x (m) 3", "y (m) 3"));
  ReadOptions rate;
  rate.rate = 4;
  const auto timed = clean_table(read("x (m),y (m)\n1,5\n2,6\n3,5\n", rate), rate);
  EXPECT_THAT(heads(*timed), ElementsAre("Time (s) 3", "x (m) 3", "y (m) 3"));
  EXPECT_THAT(timed->columns[0].values, ElementsAre(0, 0.25, 0.5));
  EXPECT_THAT(in_words(clean_table(read("t,x\n3,1\n2,2\n1,4\n"), {}).error()),
              HasSubstr("lab.txt: the time runs"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
