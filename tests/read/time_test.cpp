// Times that repeat, run backward or start again.
#include "cromer/read/time.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace cromer::core::dialects {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// first, first + 1, ...
std::vector<double> counted_from(double first, int count) {
  std::vector<double> t(static_cast<std::size_t>(count));
  std::iota(t.begin(), t.end(), first);
  return t;
}

std::vector<double> joined(std::vector<double> t, const std::vector<double>& more) {
  t.insert(t.end(), more.begin(), more.end());
  return t;
}

/// With line numbers from 11 on.
Result<RisingTimes> rising(const std::vector<double>& t) {
  std::vector<long> lines(t.size());
  std::iota(lines.begin(), lines.end(), 11);
  return keep_rising(t, lines);
}

TEST(Restart, NeedsMoreThanTenRowsBeforeIt) {
  EXPECT_THAT(restarts(joined(counted_from(0, 11), {0, 1, 2})), ElementsAre(11));
  EXPECT_THAT(restarts(joined(counted_from(0, 10), {0, 1, 2})), IsEmpty());
  // Each run is counted anew; repeated times are no rows.
  EXPECT_THAT(restarts(joined(joined(counted_from(0, 11), counted_from(0, 11)), {0, 1})),
              ElementsAre(11, 22));
  EXPECT_THAT(restarts(joined(joined(counted_from(0, 11), counted_from(0, 10)), {0, 1})), ElementsAre(11));
  EXPECT_THAT(restarts(joined(counted_from(0, 10), {9, 9, 0, 1, 2})), IsEmpty());
}

TEST(Restart, IsNearTheBeginning) {
  EXPECT_THAT(restarts(joined(counted_from(0, 21), {2, 3, 4})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(counted_from(0, 21), {2.1, 3, 4})), IsEmpty());
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {102, 103})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {102.1, 103})), IsEmpty());
  EXPECT_THAT(restarts(joined(counted_from(100, 21), {0, 1})), ElementsAre(21));
}

TEST(Restart, GoesOnForFiveRowsOrToTheEnd) {
  const std::vector<double> t = counted_from(0, 21);
  EXPECT_THAT(restarts(joined(t, {0})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 1})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(t, {0, 0, 1})), ElementsAre(22));
  EXPECT_THAT(restarts(joined(t, {0, 20})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 19})), ElementsAre(21));
  EXPECT_THAT(restarts(joined(t, {0, 1, 2, 3, 4, 3})), IsEmpty());
  EXPECT_THAT(restarts(joined(t, {0, 1, 2, 3, 4, 5, 4})), ElementsAre(21));
  const double missing = std::nan("");
  EXPECT_THAT(restarts(joined(t, {missing, 0, missing, 1, 2, 3, 4, missing, 3})), IsEmpty());
  EXPECT_THAT(restarts(joined({missing}, joined(t, {0, missing, 1}))), ElementsAre(22));
  EXPECT_THAT(restarts({}), IsEmpty());
}

TEST(Rising, TwoRowsSuffice) {
  EXPECT_THAT(rising({0, 1})->kept, ElementsAre(0, 1));
  EXPECT_THAT(rising({5})->kept, ElementsAre(0));
  EXPECT_EQ(in_words(rising({1, 0}).error()), "the time runs backward from the first row to the last");
  EXPECT_EQ(in_words(rising({1, 1}).error()), "the time stands still: all its values are equal");
  EXPECT_EQ(in_words(rising({2, 2, 1}).error()), "the time runs backward from the first row to the last");
}

TEST(Rising, AsManyBackwardAsForwardStepsAreEndured) {
  EXPECT_THAT(rising({0, 2, 1})->kept, ElementsAre(0, 1));
  EXPECT_EQ(in_words(rising({0, 3, 2, 1}).error()), "the time runs backward in most rows");
  EXPECT_THAT(rising({0, 0, 0, 2, 1})->kept, ElementsAre(0, 3));
}

TEST(Rising, WhatIsLeftOutIsCountedFromItsFirstLine) {
  const auto kept = rising({0, 1, 1, 2, 1.5, 2, 3, 1, 4, 5});
  EXPECT_THAT(kept->kept, ElementsAre(0, 1, 3, 6, 8, 9));
  EXPECT_THAT(in_words(kept->notices),
              ElementsAre("2 rows with a repeated time left out, the first in line 13",
                          "2 rows with a backward time left out, the first in line 15"));
  EXPECT_THAT(in_words(rising({0, 1, 2})->notices), IsEmpty());
}

TEST(Rising, ARestartEndsIt) {
  const auto kept = rising(joined(counted_from(5, 21), {25, 5, 6, 7}));
  EXPECT_EQ(kept->kept.size(), 21u);
  EXPECT_THAT(in_words(kept->notices),
              ElementsAre("the time starts again in line 33: the 3 rows from there on are left out",
                          "1 row with a repeated time left out, the first in line 32"));
  const auto glitch = rising(joined(counted_from(5, 10), {5, 6, 15, 16}));
  EXPECT_EQ(glitch->kept.size(), 12u);
  EXPECT_THAT(in_words(glitch->notices),
              ElementsAre("2 rows with a backward time left out, the first in line 21"));
}

TEST(TimeColumn, IsTheNearestBeforeElseOfTheRunElseOfAll) {
  const auto table = [](const std::vector<std::pair<const char*, int>>& columns) {
    Table made;
    for (const auto& [quantity, run] : columns) made.columns.push_back({"c", quantity, "", run, {}});
    return made;
  };
  const auto two = table({{"time", 1}, {"position", 1}, {"time", 1}, {"position", 1}, {"position", 2}});
  EXPECT_EQ(time_column_of(two, 1), 0u);
  EXPECT_EQ(time_column_of(two, 3), 2u);
  EXPECT_EQ(time_column_of(two, 4), 0u);
  EXPECT_EQ(time_column_of(two, 0), 2u);
  EXPECT_EQ(time_column_of(two, 2), 0u);
  const auto behind = table({{"position", 2}, {"time", 1}, {"time", 2}});
  EXPECT_EQ(time_column_of(behind, 0), 2u);
  EXPECT_EQ(time_column_of(behind, 1), 2u);
  EXPECT_EQ(time_column_of(table({{"position", 1}, {"time", 1}}), 1), std::nullopt);
}

}  // namespace
}  // namespace cromer::core::dialects
