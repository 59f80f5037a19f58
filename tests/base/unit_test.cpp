// Every symbol, prefix and power against the SI brochure (9th ed., 2019) and the definitions of everyday
// units.
#include <gtest/gtest.h>

#include <string>

#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr Dimension none{}, mass{.kilogram = 1}, length{.metre = 1}, duration{.second = 1},
    temperature{.kelvin = 1}, current{.ampere = 1}, angle{.radian = 1},
    force{.kilogram = 1, .metre = 1, .second = -2}, energy{.kilogram = 1, .metre = 2, .second = -2},
    power{.kilogram = 1, .metre = 2, .second = -3}, pressure{.kilogram = 1, .metre = -1, .second = -2},
    voltage{.kilogram = 1, .metre = 2, .second = -3, .ampere = -1},
    flux_density{.kilogram = 1, .second = -2, .ampere = -1}, frequency{.second = -1, .radian = 1},
    acceleration{.metre = 1, .second = -2};

void expect(const std::string& text, double factor, const Dimension& dimension) {
  const auto unit = parse_unit(text);
  ASSERT_TRUE(unit.ok()) << text;
  EXPECT_DOUBLE_EQ(unit->factor, factor) << text;
  EXPECT_EQ(unit->dimension, dimension) << text;
  EXPECT_EQ(unit->offset, 0) << text;
}

TEST(ParseUnit, EverySymbolIsWhatTheSiSays) {
  struct Row {
    const char* text;
    double factor;
    Dimension dimension;
    bool prefixed;
  };
  for (const Row& row : {Row{"g", 1e-3, mass, true},
                         Row{"m", 1, length, true},
                         Row{"s", 1, duration, true},
                         Row{"K", 1, temperature, true},
                         Row{"A", 1, current, true},
                         Row{"N", 1, force, true},
                         Row{"J", 1, energy, true},
                         Row{"W", 1, power, true},
                         Row{"Pa", 1, pressure, true},
                         Row{"V", 1, voltage, true},
                         Row{"T", 1, flux_density, true},
                         Row{"Hz", 2 * pi, frequency, true},
                         Row{"rad", 1, angle, true},
                         Row{"rpm", 2 * pi / 60, frequency, false},
                         Row{"deg", pi / 180, angle, false},
                         Row{"°", pi / 180, angle, false},
                         Row{"degrees", pi / 180, angle, false},
                         Row{"Grad", pi / 180, angle, false},
                         Row{"radians", 1, angle, false},
                         Row{"in", 0.0254, length, false},
                         Row{"ft", 0.3048, length, false},
                         Row{"Gal", 0.01, acceleration, true},
                         Row{"gal", 0.01, acceleration, false},
                         Row{"gn", 9.80665, acceleration, false},
                         Row{"%", 0.01, none, false},
                         Row{"1", 1, none, false}}) {
    expect(row.text, row.factor, row.dimension);
    if (row.prefixed)
      expect("k" + std::string(row.text), 1000 * row.factor, row.dimension);
    else
      EXPECT_FALSE(parse_unit("k" + std::string(row.text)).ok()) << row.text;
  }
}

TEST(ParseUnit, NamesOfMassesAreSpelledOut) {
  const Dimension mass{.kilogram = 1};
  for (const char* text : {"gram", "grams", "Gramm"}) expect(text, 1e-3, mass);
  for (const char* text : {"kilogram", "kilograms", "Kilogramm"}) expect(text, 1, mass);
}

TEST(ParseUnit, TimesAreUnderstoodAsLoggersSpellThem) {
  const auto all = [](double factor, std::initializer_list<const char*> spellings) {
    for (const char* text : spellings) {
      expect(text, factor, duration);
      EXPECT_FALSE(parse_unit("k" + std::string(text)).ok()) << text;
    }
  };
  all(1e-6, {"usec", "usecs", "micros", "microsecond", "microseconds"});
  all(1e-3, {"msec", "msecs", "millis", "millisecond", "milliseconds"});
  all(1, {"sec", "secs", "second", "seconds"});
  all(60, {"min", "mins", "minute", "minutes"});
  all(3600, {"h", "hr", "hrs", "hour", "hours"});
}

TEST(ParseUnit, PrefixesArePowersOfTen) {
  expect("pm", 1e-12, length);
  expect("nm", 1e-9, length);
  for (const char* micro : {"um", "µm", "\u03bcm"}) expect(micro, 1e-6, length);
  expect("mm", 1e-3, length);
  expect("cm", 1e-2, length);
  expect("dm", 1e-1, length);
  expect("hm", 1e2, length);
  expect("km", 1e3, length);
  expect("Mm", 1e6, length);
  expect("Gm", 1e9, length);
  EXPECT_EQ(parse_unit("kg")->factor, 1);
  expect("mg", 1e-6, mass);
  EXPECT_FALSE(parse_unit("mmm").ok());
}

TEST(ParseUnit, PowersHaveOneDigitHoweverTheyAreWritten) {
  const char* raised[] = {"¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  for (int n = 1; n <= 9; ++n) {
    const std::string digit = std::to_string(n), small = raised[n - 1];
    const Dimension up{.metre = static_cast<signed char>(n)}, down{.metre = static_cast<signed char>(-n)};
    for (const std::string& text : {"m^" + digit, "m" + digit, "m" + small}) expect(text, 1, up);
    for (const std::string& text :
         {"m^-" + digit, "m-" + digit, "m\u2212" + digit, "m^\u2212" + digit, "m⁻" + small, "m^⁻" + digit})
      expect(text, 1, down);
  }
  for (const char* text : {"m^0", "m0", "m⁰", "m^11", "m11", "m¹²", "m²¹", "m¹¹", "m^", "m⁻", "m^-", "m-"})
    EXPECT_FALSE(parse_unit(text).ok()) << text;
  expect("cm^3", 1e-6, {.metre = 3});
  expect("min^-2", 1.0 / 3600, {.second = -2});
}

TEST(ParseUnit, ProductsAndQuotientsAreJoinedInEveryWay) {
  for (const char* text : {"N m", "N*m", "N·m", "N\u22c5m", "N\u00a0m", "N\u202fm", "N\u2009m", "N\tm",
                           " N m ", "N * m", "N/(1/m)", "N  m"})
    expect(text, 1, energy);
  expect("m/s/s", 1, acceleration);
  expect("m / s^2", 1, acceleration);
}

TEST(ParseUnit, BracketsAreDividedByAsAWhole) {
  const Dimension damping{.kilogram = 1, .metre = -2, .second = -1};
  for (const char* text : {"kg/(m^2 s)", "kg/(m^2*s)", "kg/ ( m^2 s )", "kg/(m m s)"})
    expect(text, 1, damping);
  expect("kg/(m s) m", 1, {.kilogram = 1, .second = -1});
  expect("kg/(s/m)/m", 1, {.kilogram = 1, .second = -1});
  for (const char* text : {"kg/(m", "(kg)", "kg (m)", "kg/((m))", "kg/m)"})
    EXPECT_FALSE(parse_unit(text).ok()) << text;
}

TEST(ParseUnit, PowersOfABaseUnitReachToAHundred) {
  const auto times = [](int nines, const std::string& rest) {
    std::string text = rest;
    for (int i = 0; i < nines; ++i) text += " m^9";
    return text;
  };
  expect(times(11, "m"), 1, {.metre = 100});
  EXPECT_FALSE(parse_unit(times(11, "m^2")).ok());
  expect("m^-1/m^9/m^9/m^9/m^9/m^9/m^9/m^9/m^9/m^9/m^9/m^9", 1, {.metre = -100});
}

TEST(ParseUnit, GramOrGravityIsWhatWasExpected) {
  EXPECT_EQ(parse_unit("g", &acceleration)->factor, 9.80665);
  EXPECT_EQ(parse_unit("g", &acceleration)->dimension, acceleration);
  EXPECT_EQ(parse_unit("g", &mass)->factor, 1e-3);
  EXPECT_EQ(parse_unit("mg", &acceleration)->factor, 1e-3 * 9.80665);
  EXPECT_EQ(parse_unit("µg", &acceleration)->factor, 1e-6 * 9.80665);
  EXPECT_EQ(parse_unit("%g", &acceleration)->factor, 0.01 * 9.80665);
  EXPECT_FALSE(parse_unit("%g", &mass).ok());
  EXPECT_EQ(parse_unit("mg", &mass)->factor, 1e-6);
  EXPECT_EQ(parse_unit("kg", &acceleration)->dimension, mass);
  EXPECT_EQ(parse_unit("mg")->dimension, mass);
  EXPECT_EQ(parse_unit("deg", &acceleration)->dimension.radian, 1);
  EXPECT_EQ(parse_unit("g m", &acceleration)->dimension.kilogram, 1);
}

TEST(ParseUnit, OnlyADegreeCelsiusAloneHasAnOffset) {
  for (const char* text : {"°C", "degC", " °C "}) {
    EXPECT_EQ(parse_unit(text)->offset, 273.15) << text;
    EXPECT_EQ(parse_unit(text)->factor, 1) << text;
    EXPECT_EQ(parse_unit(text)->dimension, temperature) << text;
  }
  expect("J/°C", 1, {.kilogram = 1, .metre = 2, .second = -2, .kelvin = -1});
  expect("m/degC", 1, {.metre = 1, .kelvin = -1});
}

TEST(ParseUnit, TheWordThatIsUnknownIsNamed) {
  EXPECT_EQ(in_words(parse_unit("kg foo/s").error()), "unknown unit \"foo\"");
  EXPECT_EQ(in_words(parse_unit("kg^0").error()), "unknown unit \"kg^0\"");
  EXPECT_EQ(in_words(parse_unit("kg/").error()), "unknown unit \"kg/\"");
  EXPECT_FALSE(parse_unit("Gm^9 Gm^9 Gm^9 Gm^9").ok());  // more metres than a double holds
  EXPECT_FALSE(parse_unit("pm^9 pm^9 pm^9").ok());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
