// Runs below each other in one table.
#include "cromer/read/stacked_runs.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "cromer/read/columns.h"

namespace cromer::core::dialects {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

}  // namespace
}  // namespace cromer::core::dialects
