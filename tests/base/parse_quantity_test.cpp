// What is refused and with which words; blanks, brackets and powers of ten as people type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

void expect(std::string_view text, std::string_view unit, double value, double uncertainty = 0) {
  const auto quantity = parse_quantity(text, unit);
  ASSERT_TRUE(quantity.ok()) << text << ": " << in_words(quantity.error());
  EXPECT_DOUBLE_EQ(quantity->value, value) << text;
  EXPECT_DOUBLE_EQ(quantity->uncertainty, uncertainty) << text;
}

std::string message(std::string_view text, std::string_view unit) {
  const auto quantity = parse_quantity(text, unit);
  return quantity ? "accepted" : in_words(quantity.error());
}

TEST(ParseQuantity, EveryRefusalShowsAnExampleThatIsAccepted) {
  for (const char* unit :
       {"",    "kg",    "N/m", "kg/s", "kg/m",  "N",   "N/m^3", "N/m^2", "N/m^5", "kg/(m^2 s)", "m",
        "m/s", "m/s^2", "s",   "rad",  "rad/s", "1/s", "K",     "J",     "V",     "Pa",         "Hz"}) {
    const std::string said = message("x", unit);
    const std::size_t at = said.find(", for instance ");
    ASSERT_NE(at, std::string::npos) << said;
    std::string example = said.substr(at + 15);
    const std::size_t either = example.find(" or ");
    if (either != std::string::npos) {
      EXPECT_TRUE(parse_quantity(example.substr(either + 4), unit).ok()) << said;
      example.resize(either);
    }
    EXPECT_TRUE(parse_quantity(example, unit).ok()) << said;
  }
  EXPECT_THAT(message("x", ""), HasSubstr("expected a plain number, for instance 0.05 or 5 %"));
  EXPECT_THAT(message("x", "rad/s"), HasSubstr("expected a frequency, for instance 3 rad/s or 0.5 Hz"));
  EXPECT_THAT(message("x", "N m"), HasSubstr("expected a number in N m"));
  EXPECT_THAT(message("3 N/m", "kg"), HasSubstr("is a stiffness"));
  EXPECT_THAT(message("3 kg/s", "kg"), HasSubstr("is a damping"));
  EXPECT_THAT(message("3 kg/m^2/s", "kg"), HasSubstr("is a damping that grows with the displacement"));
  EXPECT_THAT(message("3 1/s", "kg"), HasSubstr("is a rate"));
  EXPECT_THAT(message("3 kg", "Hz"), HasSubstr("is a mass; expected a number of samples per second"));
  EXPECT_THAT(message("3 g ± 1 s", "kg"), HasSubstr("is a time"));
}

TEST(ParseQuantity, AllBlanksAreOne) {
  for (const char* blank : {" ", "\t", "\r", "\u00a0", "\u202f", "\u2009", " \u2009\t"}) {
    const std::string b = blank;
    expect(b + "3" + b + "±" + b + "1" + b + "g", "kg", 0.003, 0.001);
    expect(b + "3" + b + "g" + b + "±" + b + "1" + b + "g", "kg", 0.003, 0.001);
  }
}

TEST(ParseQuantity, PowersOfTenInEveryNotation) {
  for (const char* text : {"3 × 10⁻⁵ m", "3 x 10^-5 m", "3*10^\u22125 m", "3 × 10^-05 m", "3e-5 m", "3E-5 m"})
    expect(text, "m", 3e-5);
  for (const char* text : {"(3 ± 1)e2 m", "(3 ± 1)E+2 m", "(3 ± 1) × 10^+2 m", "3(1)e2 m", "(3 ± 1) × 10² m"})
    expect(text, "m", 300, 100);
  expect("2 × 10¹² m", "m", 2e12);
  expect("2 × 10^12 m", "m", 2e12);
  expect("3 × 10^-400 m", "m", 0);
  for (const char* text : {"3 × 10^ m", "3 × 10^-401 m", "3 × 10 m", "3 × 10⁻ m"})
    EXPECT_THAT(message(text, "m"), HasSubstr("has no power of ten after the 10")) << text;
  EXPECT_FALSE(parse_quantity("3 × 9 m", "m").ok());
  EXPECT_FALSE(parse_quantity("3 × 10^400 m", "m").ok());
}

TEST(ParseQuantity, AnUncertaintyOfZeroIsOne) {
  expect("5 ± 0 g", "kg", 0.005);
  expect("5(0) g", "kg", 0.005);
}

TEST(ParseQuantity, BracketsHoldDigitsOnly) {
  expect("1.25(123456789012345) m", "m", 1.25, 1234567890123.45);
  for (const char* text : {"1.25(1234567890123456) m", "1.25e3(2) m", "1.25(2.3.4) m", "1.25() m", "1.25(2",
                           "1.25(/) m", "1.25(:) m", "1.25(.) m"})
    EXPECT_THAT(message(text, "m"), HasSubstr("is not a number with its uncertainty; write it as 0.2176(3)"))
        << text;
  EXPECT_THAT(message("(5 ± 1 g", "kg"), HasSubstr("lacks a closing bracket"));
  expect("(5) g", "kg", 0.005);
  expect("5(9) m", "m", 5, 9);
}

TEST(ParseQuantity, ADecimalCommaIsCured) {
  EXPECT_THAT(message("3,14159 m", "m"), HasSubstr("write 3.14159;"));
  EXPECT_THAT(message("3,09 m", "m"), HasSubstr("write 3.09;"));
  EXPECT_THAT(message("5 ± 0,9", "m"), HasSubstr("write 0.9;"));
  EXPECT_THAT(message("3,", "m"), HasSubstr("unknown unit \",\""));
  EXPECT_THAT(message("3,x", "m"), HasSubstr("unknown unit"));
}

TEST(ParseQuantity, TheUncertaintyMayHaveItsOwnUnit) {
  expect("2 m ± 3 mm", "m", 2, 0.003);
  expect("2 m +/- 3 mm", "m", 2, 0.003);
  expect("2 m+-3 mm", "m", 2, 0.003);
  expect("20 °C ± 0.5 K", "K", 293.15, 0.5);
  expect("2 m ± 3", "m", 2, 3);
  expect("2 cm ± 3", "m", 0.02, 0.03);
  expect("2 +/\u2212 3 cm", "m", 0.02, 0.03);
}

TEST(ParseQuantity, WhatOverflowsIsTooLarge) {
  EXPECT_THAT(message("1e308 km", "m"), HasSubstr("is too large"));
  EXPECT_THAT(message("1 ± 1e308 km", "m"), HasSubstr("is too large"));
  expect("1e305 km", "m", 1e308);
}

}  // namespace
}  // namespace cromer::core
