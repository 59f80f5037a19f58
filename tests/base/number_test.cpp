#include "cromer/base/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cromer/base/quantity.h"

namespace cromer::core {
namespace CROMER_FILE {

void expect(std::string_view text, double value, std::size_t length, char decimal = '.') {
  const auto number = leading_number(text, decimal);
  ASSERT_TRUE(number.has_value()) << text;
  EXPECT_EQ(number->value, value) << text;
  EXPECT_EQ(number->length, length) << text;
}

TEST(LeadingNumber, SaysHowManyBytesItTakes) {
  expect("+2 m", 2, 2);
  expect("\u22122.5 m", -2.5, 6);
  expect("-.5", -0.5, 3);
  expect("9", 9, 1);
  expect("0", 0, 1);
  expect(".0x", 0, 2);
  expect(".9", 0.9, 2);
  expect(",5", 0.5, 2, ',');
  expect("7e", 7, 1);
  expect("1e999", std::numeric_limits<double>::infinity(), 5);
  expect("-1e999", -std::numeric_limits<double>::infinity(), 6);
  EXPECT_TRUE(std::signbit(leading_number("-0")->value));
}

TEST(LeadingNumber, BeginsWithADigit) {
  for (const char* text : {".", ".x", "./", ".:", "/5", ":5", ",5", "+", "\u2212", " 1", "-nan", "x1", "+-1"})
    EXPECT_FALSE(leading_number(text).has_value()) << text;
}

TEST(WriteShortest, WritesNoMoreThanIsNeeded) {
  char text[32];
  for (const double value : {0.1, -1.5e-300, 1e22, std::numeric_limits<double>::max()}) {
    const std::string_view written(text, static_cast<std::size_t>(write_shortest(text, value) - text));
    EXPECT_EQ(leading_number(written)->value, value);
    EXPECT_EQ(leading_number(written)->length, written.size());
  }
}

TEST(To15Digits, DropsTheLastOnes) {
  EXPECT_EQ(to_15_digits(0.23610000000000003), 0.2361);
  EXPECT_EQ(to_15_digits(0.1 + 0.2), 0.3);
  EXPECT_EQ(to_15_digits(1.00000000000001), 1.00000000000001);  // its fifteenth
  EXPECT_NE(to_15_digits(1.000000000000001), 1.000000000000001);
  EXPECT_EQ(to_15_digits(-std::numeric_limits<double>::infinity()), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(to_15_digits(std::nan(""))));
}

TEST(Bytes, GoOnToTheNextUnitWhereTheyWouldHaveFourDigits) {
  EXPECT_EQ(bytes_in_words(0), "0 bytes");
  EXPECT_EQ(bytes_in_words(999), "999 bytes");
  EXPECT_EQ(bytes_in_words(999.5), "1 kB");
  EXPECT_EQ(bytes_in_words(1234), "1.23 kB");
  EXPECT_EQ(bytes_in_words(999.4e3), "999 kB");
  EXPECT_EQ(bytes_in_words(2.5e6), "2.5 MB");
  EXPECT_EQ(bytes_in_words(240e12), "240 TB");
  EXPECT_EQ(bytes_in_words(3e15), "3 PB");
  EXPECT_EQ(bytes_in_words(4e18), "4 EB");
  EXPECT_EQ(bytes_in_words(5e21), "5e+03 EB");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
