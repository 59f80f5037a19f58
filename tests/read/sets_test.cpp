// Tables that stand beside or below each other become runs.
#include "cromer/read/sets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/cells.h"
#include "cromer/read/columns.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

Set set_of(const std::string& label, const std::vector<Column>& columns, std::vector<long> lines) {
  return {label, columns, std::move(lines)};
}

Column column(const char* name, std::vector<double> values, const char* unit = "") {
  return {name, std::string(name) == "t" ? "time" : "", unit, 1, std::move(values)};
}

std::vector<std::string> laid(std::vector<Set> sets) {
  Recording recording;
  const auto good = lay_side_by_side(std::move(sets), recording);
  if (!good) return {in_words(good.error())};
  std::vector<std::string> all;
  for (const Column& each : recording.table.columns) {
    const auto known = std::count_if(each.values.begin(), each.values.end(), [](double v) { return v == v; });
    all.push_back(concat({std::to_string(each.run), column_title(each), std::to_string(known)}));
  }
  return all;
}

TEST(Sets, ARunKeepsATimeThatItHas) {
  const Column t = column("t", {0, 1}), longer = column("t", {0, 1, 2}), other = column("t", {0, 2});
  const Column x = column("x", {5, 6}), y = column("y", {7, 8}), z = column("y", {7, 8, 9});
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {t, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {other, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1t2", "1y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {longer, z}, {3, 4, 5})}),
              ElementsAre("1t2", "1x2", "1t3", "1y3"));
  EXPECT_THAT(laid({set_of("a", {longer, z}, {3, 4, 5}), set_of("a", {t, x}, {1, 2})}),
              ElementsAre("1t3", "1y3", "1t2", "1x2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {column("t", {0, 1}, "ms"), y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "1t (ms)2", "1y2"));
}

TEST(Sets, ARunBeginsWithoutALabelOrWhereAColumnIsThere) {
  const Column t = column("t", {0, 1}), x = column("x", {5, 6}), y = column("y", {7, 8});
  EXPECT_THAT(laid({set_of("", {t, x}, {1, 2}), set_of("", {t, y}, {3, 4})}),
              ElementsAre("1t2", "1x2", "2t2", "2y2"));
  EXPECT_THAT(laid({set_of("a", {t, x}, {1, 2}), set_of("a", {t, x}, {3, 4}), set_of("a", {t, y}, {5, 6})}),
              ElementsAre("1t2", "1x2", "2t2", "2x2", "2y2"));
  EXPECT_THAT(laid({set_of("a", {x}, {1, 2}), set_of("a", {column("x", {1, 2}, "mm")}, {3, 4})}),
              ElementsAre("1x2", "1x (mm)2"));
  EXPECT_THAT(laid({set_of("a", {x}, {1, 2}), set_of("b", {y}, {3, 4}), set_of("a", {y}, {5, 6})}),
              ElementsAre("1x2", "2y2", "1y2"));
}

TEST(Sets, LinesAreOfTheSet) {
  Recording recording;
  const Column x = column("x", {5, 6}), longer = column("x", {7, 8, 9});
  ASSERT_TRUE(lay_side_by_side({set_of("", {x}, {1, 2}), set_of("", {longer}, {3, 5, 7})}, recording).ok());
  EXPECT_EQ(line_of(recording, 1, 2), 7);
  EXPECT_EQ(line_of(recording, 0, 1), 2);
  EXPECT_EQ(line_of(recording, 0, 2), 0);
  EXPECT_THAT(recording.lines, IsEmpty());
  Recording alone;
  ASSERT_TRUE(lay_side_by_side({set_of("", {x}, {1, 2})}, alone).ok());
  EXPECT_THAT(alone.lines, ElementsAre(1, 2));
  EXPECT_THAT(alone.lines_of_set, IsEmpty());
}

TEST(Sets, LabelsAreSaidWhereTheyAreNotTheNumber) {
  const auto said = [](const std::vector<std::string>& labels) {
    std::vector<Notice> notices;
    say_labels(labels, notices);
    return in_words(notices);
  };
  EXPECT_THAT(said({"Run #1", "Run #2"}), IsEmpty());
  EXPECT_THAT(said({"Run #1", "Run #12"}), ElementsAre("run 2 is called \"Run #12\" in the file"));
  EXPECT_THAT(said({"Run #4"}), ElementsAre("run 1 is called \"Run #4\" in the file"));
  EXPECT_THAT(said({"Latest"}), IsEmpty());
  EXPECT_THAT(said({"Latest", ""}), ElementsAre("run 1 is called \"Latest\" in the file"));
  EXPECT_THAT(said({"1", "2"}), IsEmpty());
}

TEST(Sets, TooManyOrTooUnequalOnesAreRefused) {
  const auto many = [](std::size_t count) { return laid(std::vector<Set>(count, set_of("", {}, {}))); };
  EXPECT_THAT(many(10000), IsEmpty());
  EXPECT_THAT(many(10001), ElementsAre("the file holds 10001 tables: 10000 at most are read"));
  const auto wide = [](std::size_t count) {
    return laid({set_of("", std::vector<Column>(count, column("x", {})), {})}).size();
  };
  EXPECT_EQ(wide(100000), 100000u);
  EXPECT_THAT(laid({set_of("", std::vector<Column>(60000, column("x", {})), {}),
                    set_of("", std::vector<Column>(40001, column("x", {})), {})}),
              ElementsAre("the tables of the file have 100001 columns: 100000 at most are read"));
  // 99 columns of one row beside one that is long: 100 n cells out of n + 99.
  const auto unequal = [](std::size_t rows) {
    return laid({set_of("a", {column("x", std::vector<double>(rows))}, std::vector<long>(rows)),
                 set_of("b", std::vector<Column>(99, column("y", {1})), {1})});
  };
  EXPECT_EQ(unequal(1209).size(), 100u);
  EXPECT_THAT(unequal(1210), ElementsAre("the 2 tables of the file are too unequal in length to be laid side "
                                         "by side"));
}

std::vector<std::size_t> tables(const std::string& text) { return find_tables(split_lines(text)); }

TEST(SetsBelow, BeginAtTheFirstHeaderOnceMoreOrAtATime) {
  EXPECT_THAT(tables("a,b\n1,2\na,b\n3,4\n"), ElementsAre(0, 2));
  EXPECT_THAT(tables("a,b\n1,2\na,c\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\n\ntitle\nTime,c\n3,4\n"), ElementsAre(0, 3));
  EXPECT_THAT(tables("a,b\n1,2\nTime;c\n3,4\nt (s)\tc\n5,6\n"), ElementsAre(0, 2, 4));
  EXPECT_THAT(tables("a,b\n1,2\nTime\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\na,b\n"), ElementsAre(0));
  EXPECT_THAT(tables("1,2\nx\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a,b\n1,2\n---\na,b\n3,4\n"), ElementsAre(0, 2));
  EXPECT_THAT(tables("a,b\n-1,2\n\"+.3\",4\n# a\na,b\n \t\u22125,6\n"), ElementsAre(0, 4));
  EXPECT_THAT(tables("a,b\n1,2\na,b\nTime,d\nx,y\n3,4\n"), ElementsAre(0));
  EXPECT_THAT(tables("a\nb,c\n1,2\nb,c\n1,2\n"), ElementsAre(0, 3));
}

TEST(SetsBelow, TwoHundredAreRead) {
  std::string text;
  for (int k = 0; k < 200; ++k) text += "a,b\n1,2\n";
  EXPECT_EQ(tables(text).size(), 200u);
  EXPECT_THAT(tables(text + "a,b\n1,2\n"), ElementsAre(0));
}

TEST(SetsBelow, TitlesNameTheRun) {
  const auto read = [](const std::string& text) {
    const auto recording = read_recording(text, "lab.txt", {});
    EXPECT_TRUE(recording.ok()) << in_words(recording.error());
    return *recording;
  };
  const std::string rows = "0\t1\n1\t2\n2\t4\n";
  const auto twice = [&](const char* first, const char* second) {
    return concat({first, "\nTime (s)\tU (V)\n", rows, second, "\nTime (s)\tF (N)\n", rows});
  };
  EXPECT_THAT(runs(read(twice("U, Run #3", "F, Run #3"))), ElementsAre(1));
  EXPECT_THAT(runs(read(twice("U, Run #3 a", "F, Run #3 b"))), ElementsAre(1));
  EXPECT_THAT(runs(read(twice("U, Run #3", "F, Run #31"))), ElementsAre(1, 2));
  EXPECT_THAT(runs(read(twice("U", "F"))), ElementsAre(1, 2));
  EXPECT_THAT(
      in_words(read(twice("U, Run #3", "F, Run #31")).notices),
      ElementsAre("run 1 is called \"Run #3\" in the file", "run 2 is called \"Run #31\" in the file"));
  EXPECT_TRUE(read(twice("U", "F")).named);
  EXPECT_EQ(read(twice("U", "F")).dialect.separator, "tab");
  EXPECT_EQ(line_of(read(twice("U", "F")), 3, 2), 10);
  const auto refused = read_recording(twice("U", "F") + "x\ty\n", "lab.txt", {});
  EXPECT_EQ(in_words(refused.error()),
            "lab.txt:11: column \"Time (s)\": \"x\" is not a number; --skip-bad-rows drops such rows");
}

/// A table of runs by their numbers, times and positions.
Recording stacked(const std::vector<double>& run, const char* name = "run", const char* unit = "") {
  Recording recording;
  std::vector<double> t(run.size());
  std::iota(t.begin(), t.end(), 0);
  recording.table.columns = {
      {name, "", unit, 1, run}, {"t", "time", "s", 1, t}, {"x", "position", "m", 1, t}};
  recording.lines.resize(run.size());
  std::iota(recording.lines.begin(), recording.lines.end(), 2);
  return recording;
}

bool splits(std::vector<double> run, const char* name = "run", const char* unit = "") {
  Recording recording = stacked(run, name, unit);
  return split_stacked_runs(recording);
}

TEST(StackedRuns, HaveWholeNumbersThatRise) {
  EXPECT_TRUE(splits({1, 1, 2, 2}));
  EXPECT_TRUE(splits({1}));
  EXPECT_TRUE(splits({-3, -3, 0, 7}));
  EXPECT_FALSE(splits({1, 2, 1}));
  EXPECT_FALSE(splits({1, 1.5}));
  EXPECT_FALSE(splits({1, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_FALSE(splits({1, 2}, "Run"));
  EXPECT_FALSE(splits({1, 2}, "run", "s"));
  Recording two = stacked({1, 2});
  two.table.columns.pop_back();
  EXPECT_FALSE(split_stacked_runs(two));
}

TEST(StackedRuns, StandSideBySide) {
  Recording r = stacked({1, 1, 1, 2, 2});
  ASSERT_TRUE(split_stacked_runs(r));
  ASSERT_EQ(r.table.columns.size(), 4u);
  EXPECT_EQ(r.table.columns[0].name, "t");
  EXPECT_EQ(r.table.columns[3].run, 2);
  EXPECT_THAT(r.table.columns[3].values, ElementsAre(3, 4, testing::IsNan()));
  EXPECT_THAT(r.lines_of_set, ElementsAre(ElementsAre(2, 3, 4), ElementsAre(5, 6)));
}

TEST(StackedRuns, TenThousandAreSplit) {
  std::vector<double> run(10000);
  std::iota(run.begin(), run.end(), 1);
  EXPECT_TRUE(splits(run));
  run.push_back(10001);
  EXPECT_FALSE(splits(run));
}

TEST(StackedRuns, OneLongRunAmongManyShortOnesIsNotSplit) {
  // 99 runs of one row and one of n: 100 n cells of a column, where 16 (n + 99) + 1000 are allowed.
  const auto unequal = [](int rows) {
    std::vector<double> run(99);
    std::iota(run.begin(), run.end(), 1);
    run.resize(static_cast<std::size_t>(99 + rows), 100);
    return splits(run);
  };
  EXPECT_TRUE(unequal(30));
  EXPECT_FALSE(unequal(31));
  std::vector<double> first(34, 1);
  for (int k = 2; k <= 80; ++k) first.push_back(k);
  EXPECT_TRUE(splits(first));  // 80 * 34 are 2720, and 16 * 113 + 1000 are 2808
  first.insert(first.begin(), {1, 1});
  EXPECT_FALSE(splits(first));  // 2880 and 2840
}

/// What is said of times that start again; nothing where they are left as they are.
std::vector<std::string> said(Recording& recording) {
  split_at_restarts(recording);
  return in_words(recording.notices);
}

Recording restarted(int times) {
  std::vector<double> t;
  for (int k = 0; k <= times; ++k)
    for (int i = 0; i < 12; ++i) t.push_back(i);
  Recording recording = stacked(t, "x2");
  recording.table.columns[1].values = t;
  return recording;
}

TEST(Restarts, AreCountedFromTheFirst) {
  Recording none = restarted(0), once = restarted(1), twice = restarted(2), more = restarted(3);
  EXPECT_THAT(said(none), IsEmpty());
  EXPECT_THAT(said(once), ElementsAre("the time starts again in line 14: the file is read as 2 runs"));
  EXPECT_THAT(said(twice),
              ElementsAre("the time starts again in line 14 and 1 more time: the file is read as 3 runs"));
  EXPECT_THAT(said(more),
              ElementsAre("the time starts again in line 14 and 2 more times: the file is read as 4 runs"));
  EXPECT_EQ(once.table.columns.size(), 6u);
  EXPECT_EQ(once.table.columns[3].run, 2);
}

TEST(Restarts, OfOneTimeOfOneRunOnly) {
  Recording two_times = restarted(1), two_runs = restarted(1), no_time = restarted(1), laid = restarted(1);
  two_times.table.columns[0].quantity = "time";
  two_runs.table.columns[2].run = 2;
  no_time.table.columns[1].quantity.clear();
  laid.lines_of_set = {laid.lines};
  for (Recording* each : {&two_times, &two_runs, &no_time, &laid}) {
    EXPECT_THAT(said(*each), IsEmpty());
    EXPECT_EQ(each->table.columns.size(), 3u);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
