// Numbers for people: where powers of ten begin, which digits stay, what carries.
#include <gtest/gtest.h>

#include <limits>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double infinite = std::numeric_limits<double>::infinity();
const std::string nbsp = "\u00a0";

TEST(Rounded, TakesAPowerOfTenOutsideOf1em4To1e6) {
  EXPECT_EQ(rounded(1e-4, 1), "0.0001");
  EXPECT_EQ(rounded(0.99e-4, 2), "9.9" + nbsp + "×" + nbsp + "10⁻⁵");
  EXPECT_EQ(rounded(999999, 6), "999999");
  EXPECT_EQ(rounded(1e6, 1), "1" + nbsp + "×" + nbsp + "10⁶");
  EXPECT_EQ(rounded(1.25e-306, 3), "1.25" + nbsp + "×" + nbsp + "10⁻³⁰⁶");
  EXPECT_EQ(rounded(4.5e178, 2), "4.5" + nbsp + "×" + nbsp + "10¹⁷⁸");
  EXPECT_EQ(rounded(7e249, 1), "7" + nbsp + "×" + nbsp + "10²⁴⁹");
}

TEST(Rounded, AtLeastOneDigitAtMostSeventeen) {
  EXPECT_EQ(rounded(2.6, 0), "3");
  EXPECT_EQ(rounded(2.6, -5), "3");
  EXPECT_EQ(rounded(0.1, 17), "0.10000000000000001");
  EXPECT_EQ(rounded(0.1, 18), "0.10000000000000001");
  EXPECT_EQ(rounded(infinite, 3), "inf");
  EXPECT_EQ(rounded(-infinite, 3), "\u2212inf");
  EXPECT_EQ(rounded(-0.0, 3), "0");
}

TEST(Shortest, SaysWhatIsNoNumber) {
  EXPECT_EQ(shortest(-infinite), "-inf");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(shortest(-2.5), "-2.5");
}

TEST(FormatQuantity, OneDigitOfAnUncertaintyFromThreeOn) {
  EXPECT_EQ(format_quantity({1, 0.10}, ""), "1.00" + nbsp + "±" + nbsp + "0.10");
  EXPECT_EQ(format_quantity({1, 0.12}, ""), "1.00" + nbsp + "±" + nbsp + "0.12");
  EXPECT_EQ(format_quantity({1, 0.294}, ""), "1.00" + nbsp + "±" + nbsp + "0.29");
  EXPECT_EQ(format_quantity({1, 0.296}, ""), "1.0" + nbsp + "±" + nbsp + "0.3");
  EXPECT_EQ(format_quantity({1, 0.9}, ""), "1.0" + nbsp + "±" + nbsp + "0.9");
  EXPECT_EQ(format_quantity({1, 0.94}, ""), "1.0" + nbsp + "±" + nbsp + "0.9");
  EXPECT_EQ(format_quantity({10, 2.5}, "N"), "10.0" + nbsp + "±" + nbsp + "2.5" + nbsp + "N");
}

TEST(FormatQuantity, OfAnUncertaintyLargerThanTheValueLittleIsLeft) {
  EXPECT_EQ(format_quantity({4.9, 30}, ""), "0" + nbsp + "±" + nbsp + "30");
  EXPECT_EQ(format_quantity({5.1, 30}, ""), "10" + nbsp + "±" + nbsp + "30");
  EXPECT_EQ(format_quantity({0.1, 30}, ""), "0" + nbsp + "±" + nbsp + "30");
  EXPECT_EQ(format_quantity({-5.1, 30}, ""), "\u221210" + nbsp + "±" + nbsp + "30");
  EXPECT_EQ(format_quantity({0, 0.3}, ""), "0.0" + nbsp + "±" + nbsp + "0.3");
}

TEST(FormatQuantity, ThePowerOfTenIsThatOfTheLarger) {
  EXPECT_EQ(format_quantity({1, 3e7}, ""), "(0" + nbsp + "±" + nbsp + "3)" + nbsp + "×" + nbsp + "10⁷");
  EXPECT_EQ(format_quantity({999960, 50}, ""), "999960" + nbsp + "±" + nbsp + "50");
  EXPECT_EQ(format_quantity({-2.5e-6, 3e-8}, "m"),
            "(\u22122.50" + nbsp + "±" + nbsp + "0.03)" + nbsp + "×" + nbsp + "10⁻⁶" + nbsp + "m");
}

TEST(FormatQuantity, AnUncertaintyThatIsNoneIsLeftOut) {
  for (const double none : {0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(format_quantity({1200, none}, "m"), "1200" + nbsp + "m");
  EXPECT_EQ(format_quantity({123456.4, 0}, ""), "123456");
  EXPECT_EQ(format_quantity({-0.1234564, 0}, ""), "\u22120.123456");
  EXPECT_EQ(format_quantity({1.2e7, 0}, ""), "1.2" + nbsp + "×" + nbsp + "10⁷");
  EXPECT_EQ(format_quantity({-infinite, 1}, "m"), "\u2212inf" + nbsp + "m");
}

TEST(FormatConcise, CountsInTheLastPlace) {
  EXPECT_EQ(format_concise({0.009841, 0.00003}, "1/s"), "0.00984(3)" + nbsp + "1/s");
  EXPECT_EQ(format_concise({-17.0412, 0.0238}, ""), "\u221217.041(24)");
  EXPECT_EQ(format_concise({0.004, 0.3}, "°"), "0.0(3)°");
  EXPECT_EQ(format_concise({9.996, 0.05}, ""), "10.00(5)");
  EXPECT_EQ(format_concise({5, 1.5}, ""), "5.0(15)");
}

TEST(FormatConcise, IsTheLongFormWhereItHasNoSense) {
  EXPECT_EQ(format_concise({5, 3}, ""), "5" + nbsp + "±" + nbsp + "3");
  EXPECT_EQ(format_concise({500, 30}, "m"), "500" + nbsp + "±" + nbsp + "30" + nbsp + "m");
  EXPECT_EQ(format_concise({1.2e-5, 2e-7}, ""), format_quantity({1.2e-5, 2e-7}, ""));
  EXPECT_EQ(format_concise({5, 0}, "m"), "5" + nbsp + "m");
  EXPECT_EQ(format_concise({5, infinite}, "m"), "5" + nbsp + "m");
  EXPECT_EQ(format_concise({infinite, 1}, "m"), "inf" + nbsp + "m");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
