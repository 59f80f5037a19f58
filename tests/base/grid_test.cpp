#include "cromer/base/grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> values(std::string_view text, std::string_view unit = "") {
  const auto grid = parse_grid(text, unit);
  if (!grid) {
    ADD_FAILURE() << text << ": " << in_words(grid.error());
    return {};
  }
  return *values_of(*grid, 8, 0);
}

std::string message(std::string_view text, std::string_view unit = "") {
  const auto grid = parse_grid(text, unit);
  return grid ? "accepted" : in_words(grid.error());
}

TEST(Grid, ListKeepsItsOrder) {
  EXPECT_THAT(values("1,0.05,0.2"), ElementsAre(1, 0.05, 0.2));
  EXPECT_THAT(values(" 3 "), ElementsAre(3));
  EXPECT_THAT(values("-1,-2"), ElementsAre(-1, -2));
}

TEST(Grid, LinearRangeHoldsBothEnds) {
  EXPECT_THAT(values("0:1:5"), ElementsAre(0, 0.25, 0.5, 0.75, 1));
  EXPECT_THAT(values("1:-1:3"), ElementsAre(1, 0, -1));
  EXPECT_THAT(values("0.1:0.7:7").back(), 0.7);
  EXPECT_THAT(values("2:2:1"), ElementsAre(2));
}

TEST(Grid, LogarithmicRangeMeetsDecades) {
  EXPECT_THAT(values("0.01:10:4:log"), ElementsAre(0.01, 0.1, 1, 10));
  const auto grid = values("0.3:7:50:log");
  EXPECT_EQ(grid.front(), 0.3);
  EXPECT_EQ(grid.back(), 7);
  for (std::size_t i = 1; i < grid.size(); ++i)
    EXPECT_NEAR(grid[i] / grid[i - 1], std::pow(7 / 0.3, 1.0 / 49), 1e-14);
}

TEST(Grid, RangesRunDownToo) {
  EXPECT_THAT(values("10:0.01:4:log"), ElementsAre(10, DoubleEq(1), DoubleEq(0.1), 0.01));
  EXPECT_THAT(values("2:1:5"), ElementsAre(2, 1.75, 1.5, 1.25, 1));
}

TEST(Grid, RemembersTheUnitItWasTypedIn) {
  const auto typed = [](std::string_view text, std::string_view si) {
    const GridUnit unit = unit_of_grid(text, si);
    return std::pair(unit.name, unit.factor);
  };
  EXPECT_EQ(typed("0.1:10:5 Hz", "rad/s"), std::pair(std::string("Hz"), 2 * std::numbers::pi));
  EXPECT_EQ(typed("0.1:10:5:log rpm", "rad/s"), std::pair(std::string("rpm"), std::numbers::pi / 30));
  EXPECT_EQ(typed("1:3:5:log", "rad/s"), std::pair(std::string("rad/s"), 1.0));
  EXPECT_EQ(typed("1,2,3 cm", "m"), std::pair(std::string("cm"), 0.01));
  EXPECT_EQ(typed("20 ms,1 s", "s"), std::pair(std::string("s"), 1.0));
  EXPECT_EQ(typed("1:2 min:2", "s"), std::pair(std::string("min"), 60.0));
  EXPECT_EQ(typed("2 %", ""), std::pair(std::string("%"), 0.01));
  EXPECT_EQ(typed("1,2", ""), std::pair(std::string(""), 1.0));
  EXPECT_EQ(typed("1:3:3 g", "m/s^2").second, 9.80665);
  EXPECT_EQ(typed("100:300:3 g", "kg").second, 1e-3);
}

TEST(Grid, UnitAtTheEndHoldsForAll) {
  const double turn = 2 * std::numbers::pi;
  EXPECT_THAT(values("1:3:3 Hz", "rad/s"),
              ElementsAre(DoubleEq(turn), DoubleEq(2 * turn), DoubleEq(3 * turn)));
  EXPECT_THAT(values("10:1000:3:log ms", "s"), ElementsAre(0.01, DoubleEq(0.1), 1));
  EXPECT_THAT(values("10,20 ms", "s"), ElementsAre(0.01, 0.02));
  EXPECT_THAT(values("10 ms,0.5 s,1 s", "s"), ElementsAre(0.01, 0.5, 1));
  EXPECT_THAT(values("1:2 min:2", "s"), ElementsAre(60, 120));
  EXPECT_THAT(values("2 %,5 %"), ElementsAre(0.02, 0.05));
}

TEST(Grid, MalformedIsSaid) {
  EXPECT_THAT(message(""), HasSubstr("the grid is empty"));
  EXPECT_THAT(message("1:2"), HasSubstr("has 2 pieces; a grid is low:high:points"));
  for (const char* prose : {"0.5-2", "0.5..2", "0.5 – 2", "0.5—2"})
    EXPECT_THAT(message(prose), HasSubstr("has no number of points; a grid is low:high:points")) << prose;
  EXPECT_THAT(message("0.5-x"), HasSubstr("unknown unit"));
  EXPECT_THAT(message("1:2:3:4:5"), HasSubstr("has 5 pieces"));
  EXPECT_THAT(message("1:2:3:lin"), HasSubstr("where only log can stand"));
  EXPECT_THAT(message("1:2:many"), HasSubstr("asks for \"many\" points, which is no whole number"));
  EXPECT_THAT(message("1:2:2.5"), HasSubstr("no whole number"));
  EXPECT_THAT(message("1:2:-3"), HasSubstr("no whole number"));
  EXPECT_THAT(message("1:2:0"), HasSubstr("asks for no points"));
  EXPECT_THAT(message("1:2:1"), HasSubstr("both ends are included"));
  EXPECT_THAT(message("1:2:1e300"), HasSubstr("more points than can be told apart"));
  EXPECT_THAT(message("0:2:5:log"), HasSubstr("both ends must be positive"));
  EXPECT_THAT(message("-1:2:5:log"), HasSubstr("both ends must be positive"));
  EXPECT_THAT(message("2:0:5:log"), HasSubstr("both ends must be positive"));
  EXPECT_THAT(message("10:-1:5:log"), HasSubstr("both ends must be positive"));
  EXPECT_THAT(message("1,,2"), HasSubstr("empty value between its commas"));
  EXPECT_THAT(message("1,x"), HasSubstr("\"x\" is not a number"));
  EXPECT_THAT(message("a:2:3"), HasSubstr("\"a\" is not a number"));
  EXPECT_THAT(message("1:2:3 kg", "s"), HasSubstr("is a mass; expected a time"));
  EXPECT_THAT(message("1 ± 0.1,2", "s"), HasSubstr("uncertainty"));
  EXPECT_THAT(message("1:nan:3"), HasSubstr("not a number"));
}

TEST(Grid, OneTooLongSaysWhatItNeeds) {
  const auto grid = parse_grid("0.1:10:1000000000000000", "");
  ASSERT_TRUE(grid.ok());
  EXPECT_EQ(grid->size(), 1000000000000000u);
  EXPECT_EQ((*grid)[grid->size() - 1], 10);
  const auto all = values_of(*grid, 56, 16e9);
  ASSERT_FALSE(all.ok());
  EXPECT_EQ(in_words(all.error()),
            "1e+15 points need 56 PB of memory, but there are only 16 GB; ask for fewer");
  EXPECT_FALSE(values_of(*parse_grid("1:2:9e15", ""), 200, 0).ok());
}

TEST(Bytes, InWords) {
  EXPECT_EQ(bytes_in_words(12), "12 bytes");
  EXPECT_EQ(bytes_in_words(1.6e9), "1.6 GB");
  EXPECT_EQ(bytes_in_words(999.9e6), "1 GB");
}

TEST(Grid, KnowsItsEndsByValue) {
  for (const Grid& grid : {Grid({2, 5, -1}), Grid(-1, 5, 7, false), Grid(5, -1, 7, false)}) {
    EXPECT_EQ(grid.lowest(), -1);
    EXPECT_EQ(grid.highest(), 5);
  }
  EXPECT_EQ(Grid({4}).size(), 1u);
}

TEST(Grid, OneOnTheLimitIsAccepted) {
  EXPECT_TRUE(parse_grid("1:2:9007199254740992", "").ok());
  EXPECT_THAT(message("1:2:9007199254740994"), HasSubstr("more points than can be told apart"));
  EXPECT_TRUE(parse_grid("1:2:2", "").ok());
  EXPECT_TRUE(fits_in_memory(10, 8, 80).ok());
  EXPECT_FALSE(fits_in_memory(10, 8, 79).ok());
  EXPECT_TRUE(fits_in_memory(1e17, 10, 0).ok());
  const auto all = fits_in_memory(2e17, 10, 0);
  ASSERT_FALSE(all.ok());
  EXPECT_EQ(in_words(all.error()), "2e+17 points need 2 EB of memory; ask for fewer");
}

TEST(Grid, WhereAUnitMayStand) {
  EXPECT_THAT(values("1 min:120 s:2", "s"), ElementsAre(60, 120));
  EXPECT_THAT(values("1:120 s:2 min", "s"), ElementsAre(60, 120));
  EXPECT_THAT(values("1:100 ms:3:log", "s"), ElementsAre(0.001, DoubleEq(0.01), 0.1));
  EXPECT_THAT(values("1, 2 ms,3", "s"), ElementsAre(1, 0.002, 3));
  EXPECT_THAT(message("1:2:3 s:log", "s"), HasSubstr("the unit stands at the end"));
  EXPECT_THAT(message("1:2:3:logs:x", "s"), HasSubstr("has 5 pieces"));
  EXPECT_THAT(message("7"), "accepted");
}

TEST(Grid, AUnitThatDoesNotBelongIsNotRemembered) {
  const auto typed = [](std::string_view text, std::string_view si) { return unit_of_grid(text, si).name; };
  EXPECT_EQ(typed("1,2 kg", "s"), "s");
  EXPECT_EQ(typed("1,2 zorg", "s"), "s");
  EXPECT_EQ(typed("1,2 °C", "K"), "K");
  EXPECT_EQ(typed("1,2 K", "K"), "K");
  EXPECT_EQ(typed("1:2 min:5:log", "s"), "min");
  EXPECT_EQ(typed("1 min,2", "s"), "s");
  EXPECT_EQ(typed("1,2 min,3", "s"), "s");
  EXPECT_EQ(unit_of_grid("1,2 Hz", "Hz").factor, 1);
  EXPECT_EQ(GridUnit{}.factor, 1);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
