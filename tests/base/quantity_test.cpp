#include "cromer/base/quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

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

TEST(ParseQuantity, BareNumbersAreSI) {
  expect("0.2176", "kg", 0.2176);
  expect("-1.5e-3", "m", -0.0015);
  expect("+2", "s", 2);
  expect(" 3 ", "rad/s", 3);
  expect("\u22124", "m/s", -4);
}

TEST(ParseQuantity, UncertaintyInEveryNotation) {
  for (const char* text :
       {"217.6 ± 0.3 g", "217.6 +/- 0.3 g", "217.6+-0.3 g", "(217.6 ± 0.3) g", "217.6 g ± 0.3 g",
        "217.6(3) g", "0.2176(3) kg", "0.2176 ± 0.0003", "0.2176 kg ± 0.3 g", "217.6\u00a0±\u00a00.3\u00a0g",
        "217.6±0.3g", "(217.6 ± 0.3) × 10⁻³ kg", "2.176(3)e-1 kg"})
    expect(text, "kg", 0.2176, 0.0003);
  expect("0.2176(13) kg", "kg", 0.2176, 0.0013);
  expect("217(3) g", "kg", 0.217, 0.003);
  expect("12.3(1.2) m", "m", 12.3, 1.2);
}

TEST(ParseQuantity, GramsRoundOnce) {
  // 217.6 * 1e-3 is one unit in the last place beside 0.2176; dividing is not.
  EXPECT_EQ(parse_quantity("217.6 g", "kg")->value, 0.2176);
  EXPECT_EQ(parse_quantity("0.3 mm", "m")->value, 0.0003);
}

TEST(ParseQuantity, TonnesWhereAMassIsAskedFor) {
  EXPECT_EQ(parse_quantity("2 t", "kg")->value, 2000);
  EXPECT_FALSE(parse_quantity("2 t", "s"));
  EXPECT_FALSE(parse_unit("t")) << "a column \"x (t)\" is no mass";
}

TEST(ParseQuantity, PrefixesAndComposites) {
  expect("12 cm", "m", 0.12);
  expect("20 ms", "s", 0.02);
  expect("2 µs", "s", 2e-6);
  expect("2 \u03bcs", "s", 2e-6);
  expect("1 min", "s", 60);
  expect("16.6 N/m", "N/m", 16.6);
  expect("0.166 N/cm", "N/m", 16.6);
  expect("3 kg m/s^2", "N", 3);
  expect("3 kg·m·s⁻²", "N", 3);
  expect("3 kg*m/s²", "N", 3);
  expect("3 kg/(m^2 s)", "kg/(m^2 s)", 3);
  expect("3 g/(cm² s)", "kg/(m^2 s)", 30);
  expect("3 kg/m^2/s", "kg/(m^2 s)", 3);
  expect("3 kg/(s/m) 1/s", "N", 3);
  expect("3 kg m s-2", "N", 3);
  expect("4 N/m3", "N/m^3", 4);
  expect("0.01 1/s", "1/s", 0.01);
  expect("0.6 1/min", "1/s", 0.01);
  expect("2 in", "m", 0.0508);
  expect("5 %", "", 0.05);
  expect("4 N s/m", "kg/s", 4);
}

TEST(ParseQuantity, CyclesCountTwoPi) {
  expect("0.5 Hz", "rad/s", pi);
  expect("1 kHz", "rad/s", 2000 * pi);
  expect("60 rpm", "rad/s", 2 * pi);
  expect("3 rad/s", "rad/s", 3);
  expect("180 deg", "rad", pi);
  expect("180°", "rad", pi);
  expect("90 °/s", "rad/s", pi / 2);
}

TEST(ParseQuantity, SamplesPerSecond) {
  expect("100", "Hz", 100);
  expect("100 Hz", "Hz", 100);
  expect("0.1 kHz", "Hz", 100);
  expect("100 1/s", "Hz", 100);
  expect("120 1/min", "Hz", 2);
  expect("0.1 1/ms", "Hz", 100);
}

TEST(ParseQuantity, TemperaturesAndGravity) {
  expect("20 °C", "K", 293.15);
  expect("20 ± 0.5 °C", "K", 293.15, 0.5);
  expect("20", "K", 20);
  expect("293 K", "K", 293);
  expect("2 g", "m/s^2", 2 * 9.80665);
  expect("2 g", "kg", 0.002);
}

TEST(ParseQuantity, RefusalsNameWhatWasExpected) {
  EXPECT_EQ(message("5 N", "kg"), "\"5 N\" is a force; expected a mass, for instance 217.6 g");
  EXPECT_EQ(message("5 N/m^7", "kg"), "\"5 N/m^7\" is in N/m^7; expected a mass, for instance 217.6 g");
  EXPECT_EQ(message("abc", "s"), "\"abc\" is not a number; expected a time, for instance 20 ms");
  EXPECT_EQ(message("5 zorg", "m"),
            "\"5 zorg\": unknown unit \"zorg\"; expected a length, for instance 12 cm");
  EXPECT_EQ(message("217,6 g", "kg"),
            "\"217,6 g\" has a decimal comma: write \"217.6 g\"; expected a mass, for instance 217.6 g");
  EXPECT_EQ(message("1e999", "m"), "\"1e999\" is too large; expected a length, for instance 12 cm");
  EXPECT_EQ(message("5 ± -1 g", "kg"),
            "\"5 ± -1 g\" has a negative uncertainty; expected a mass, for instance 217.6 g");
}

TEST(ParseQuantity, RatesAndFrequenciesAreNotMixed) {
  EXPECT_FALSE(parse_quantity("3 1/s", "rad/s").ok());
  EXPECT_FALSE(parse_quantity("3 Hz", "1/s").ok());
  EXPECT_FALSE(parse_quantity("3 rad/s", "1/s").ok());
  EXPECT_FALSE(parse_quantity("5 %", "rad").ok());
}

TEST(ParseQuantity, MalformedTextIsRefused) {
  for (const char* text : {"",        " ",           "kg",     "nan",    "inf",       "-inf",    "0x10",
                           "1e400 g", "--3",         "3 g g/", "3 (g)",  "5(3",       "5(x) g",  "(5 ± 1 g",
                           "5 ± g",   "5 ± 1 ± 2 g", "5 kg^",  "5 kg^0", "1 × 10 kg", "1e308 Gg"})
    EXPECT_FALSE(parse_quantity(text, "kg").ok()) << text;
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
  EXPECT_THAT(message("3,14159 m", "m"), HasSubstr("write \"3.14159 m\";"));
  EXPECT_THAT(message("3,09 m", "m"), HasSubstr("write \"3.09 m\";"));
  EXPECT_THAT(message("5 ± 0,9", "m"), HasSubstr("write \"5 ± 0.9\";"));
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

TEST(ParseUnit, ProductsOfKnownSymbolsAreCoherent) {
  for (const char* text : {"kg m/s^2", "N", "m·kg·s⁻²", "J/m"}) {
    const auto unit = parse_unit(text);
    ASSERT_TRUE(unit.ok()) << text;
    EXPECT_DOUBLE_EQ(unit->factor, 1) << text;
    EXPECT_EQ(unit->dimension, parse_unit("N")->dimension) << text;
  }
  EXPECT_EQ(parse_unit("")->dimension, Dimension{});
  EXPECT_EQ(parse_unit("°C")->offset, 273.15);
}

TEST(ParseUnit, UnknownOrOverlongIsRefused) {
  for (const char* text : {"au", "m/", "/m", "m//s", "m^^2", "m^99", "foo bar", "²"})
    EXPECT_FALSE(parse_unit(text).ok()) << text;
  std::string endless = "m^9";
  for (int i = 0; i < 50; ++i) endless += " m^9";
  EXPECT_FALSE(parse_unit(endless).ok());
}

TEST(FormatQuantity, UncertaintyDecidesTheDigits) {
  EXPECT_EQ(format_quantity({17.0412, 0.0238}, "N/m"), "17.041\u00a0±\u00a00.024\u00a0N/m");
  EXPECT_EQ(format_quantity({17.0412, 0.0318}, "N/m"), "17.04\u00a0±\u00a00.03\u00a0N/m");
  EXPECT_EQ(format_quantity({0.2176, 0.0003}, "kg"), "0.2176\u00a0±\u00a00.0003\u00a0kg");
  EXPECT_EQ(format_quantity({-5, 0.5}, "m"), "\u22125.0\u00a0±\u00a00.5\u00a0m");
  EXPECT_EQ(format_quantity({12345, 300}, ""), "12300\u00a0±\u00a0300");
  EXPECT_EQ(format_quantity({0.004, 0.3}, "m"), "0.0\u00a0±\u00a00.3\u00a0m");
  EXPECT_EQ(format_quantity({-0.004, 0.3}, "m"), "0.0\u00a0±\u00a00.3\u00a0m");
}

TEST(FormatQuantity, RoundingMayCarry) {
  EXPECT_EQ(format_quantity({1, 0.096}, ""), "1.00\u00a0±\u00a00.10");
  EXPECT_EQ(format_quantity({1, 0.0996}, ""), "1.00\u00a0±\u00a00.10");
  EXPECT_EQ(format_quantity({1, 0.0296}, ""), "1.00\u00a0±\u00a00.03");
  EXPECT_EQ(format_quantity({9.996, 0.05}, ""), "10.00\u00a0±\u00a00.05");
  EXPECT_EQ(format_quantity({0.96, 0.5}, ""), "1.0\u00a0±\u00a00.5");
  EXPECT_EQ(format_quantity({0.96, 5}, ""), "1\u00a0±\u00a05");
}

TEST(FormatQuantity, VeryLargeAndSmallTakeAPowerOfTen) {
  EXPECT_EQ(format_quantity({1.2e-5, 2e-7}, "kg"), "(1.200\u00a0±\u00a00.020)\u00a0×\u00a010⁻⁵\u00a0kg");
  EXPECT_EQ(format_quantity({3.21e7, 5e5}, ""), "(3.21\u00a0±\u00a00.05)\u00a0×\u00a010⁷");
  EXPECT_EQ(format_quantity({1.5e-9, 0}, "m"), "1.5\u00a0×\u00a010⁻⁹\u00a0m");
}

TEST(FormatQuantity, WithoutUncertaintySixDigits) {
  EXPECT_EQ(format_quantity({2.5, 0}, "s"), "2.5\u00a0s");
  EXPECT_EQ(format_quantity({pi, 0}, ""), "3.14159");
  EXPECT_EQ(format_quantity({100, 0}, "Hz"), "100\u00a0Hz");
  EXPECT_EQ(format_quantity({0, 0}, "m"), "0\u00a0m");
  EXPECT_EQ(format_quantity({30, 0}, "°"), "30°");
}

TEST(Rounded, SignificantDigits) {
  EXPECT_EQ(rounded(2.5, 3), "2.50");
  EXPECT_EQ(rounded(123456.7, 3), "123000");
  EXPECT_EQ(rounded(999999.7, 3), "1.00\u00a0×\u00a010⁶");
  EXPECT_EQ(rounded(-0.000123456, 2), "\u22120.00012");
  EXPECT_EQ(rounded(0.00009, 1), "9\u00a0×\u00a010⁻⁵");
  EXPECT_EQ(rounded(0, 3), "0");
  EXPECT_EQ(rounded(std::numeric_limits<double>::quiet_NaN(), 3), "nan");
}

TEST(Shortest, ReadsBackAsTheSameDouble) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_TRUE(rc::check("shortest reads back", [](double value) {
    if (!std::isfinite(value)) return;
    RC_ASSERT(parse_quantity(shortest(value), "m")->value == value);
  }));
}

TEST(FormatQuantity, ReadsBackWithinItsLastPlace) {
  EXPECT_TRUE(rc::check("format reads back", [] {
    const double value = *rc::gen::inRange(-100000, 100000) * std::pow(10.0, *rc::gen::inRange(-12, 12));
    const double uncertainty = *rc::gen::inRange(1, 100000) * std::pow(10.0, *rc::gen::inRange(-10, 8));
    const auto back = parse_quantity(format_quantity({value, uncertainty}, "N/m"), "N/m");
    RC_ASSERT(back.ok());
    // One digit of 3 to 9 is off by a sixth at most, and the value by half of that digit.
    RC_ASSERT(std::fabs(back->uncertainty - uncertainty) <= uncertainty / 6);
    RC_ASSERT(std::fabs(back->value - value) <= uncertainty / 4 + 1e-12 * std::fabs(value));
  }));
}

TEST(ParseQuantity, AnyTextEndsInAnAnswer) {
  EXPECT_TRUE(rc::check("no text crashes", [](const std::string& text) {
    const auto quantity = parse_quantity(text, "kg");
    RC_ASSERT((quantity.ok() ? std::isfinite(quantity->value) : !in_words(quantity.error()).empty()));
  }));
}

TEST(LeadingNumber, TakesTheLongestNumber) {
  EXPECT_EQ(leading_number("-3.75e-5 m")->length, 8u);
  EXPECT_EQ(leading_number("-3,75E-5", ',')->value, -3.75e-5);
  EXPECT_EQ(leading_number("1.5.2")->length, 3u);
  EXPECT_EQ(leading_number(".5")->value, 0.5);
  EXPECT_FALSE(leading_number("nan").has_value());
  EXPECT_FALSE(leading_number("e5").has_value());
  EXPECT_FALSE(leading_number("").has_value());
  EXPECT_FALSE(leading_number("-").has_value());
  EXPECT_FALSE(leading_number("--1").has_value());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
