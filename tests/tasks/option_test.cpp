#include "cromer/tasks/option/option.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Option& find(const std::vector<Option>& options, std::string_view name) {
  for (const auto& option : options)
    if (option.name == name) return option;
  ADD_FAILURE() << "no option " << name;
  return options.front();
}

class SimulateTable : public ::testing::Test {
 protected:
  Result<void> set(std::string_view name, std::string_view text) { return assign(find(table, name), text); }
  std::string refusal(std::string_view name, std::string_view text) {
    const auto result = set(name, text);
    return result ? "" : in_words(result.error());
  }
  SimulateOptions options;
  std::vector<Option> table = options_of(options);
};

TEST_F(SimulateTable, NamesAreUniqueAndExplained) {
  CompareOptions compare;
  for (const auto& list : {table, options_of(compare)}) {
    std::set<std::string_view> names;
    for (const auto& option : list) {
      EXPECT_TRUE(names.insert(option.name).second) << option.name;
      EXPECT_FALSE(std::string_view(option.help).empty()) << option.name;
      EXPECT_FALSE(option.group.empty()) << option.name;
    }
  }
}

TEST_F(SimulateTable, ReadsNumbersInSiAndWithUnits) {
  ASSERT_TRUE(set("mass", "217.6 g").ok());
  EXPECT_DOUBLE_EQ(options.mass, 0.2176);
  ASSERT_TRUE(set("stiffness", "16.6").ok());
  EXPECT_EQ(options.stiffness, 16.6);
  ASSERT_TRUE(set("damping-ratio", "5 %").ok());
  EXPECT_DOUBLE_EQ(*options.damping_ratio, 0.05);
  ASSERT_TRUE(set("position", "-3.6 cm").ok());
  EXPECT_DOUBLE_EQ(*options.position, -0.036);
  ASSERT_TRUE(set("drive-phase", "90 deg").ok());
  EXPECT_DOUBLE_EQ(options.drive_phase, std::numbers::pi / 2);
}

TEST_F(SimulateTable, FrequenciesInCyclesAreMultipliedByTwoPi) {
  ASSERT_TRUE(set("drive-frequency", "3").ok());
  ASSERT_TRUE(set("drive-frequency", "0.5 Hz").ok());
  ASSERT_TRUE(set("drive-frequency", "60 rpm").ok());
  ASSERT_EQ(options.drive_frequency.size(), 3u);
  EXPECT_EQ(options.drive_frequency[0], 3);
  EXPECT_DOUBLE_EQ(options.drive_frequency[1], two_pi / 2);
  EXPECT_DOUBLE_EQ(options.drive_frequency[2], two_pi);
}

TEST_F(SimulateTable, ListsGrow) {
  ASSERT_TRUE(set("method", "exact").ok());
  ASSERT_TRUE(set("method", "rk4").ok());
  EXPECT_THAT(options.method, ElementsAre("exact", "rk4"));
}

TEST_F(SimulateTable, WholeNumbers) {
  ASSERT_TRUE(set("every", "10").ok());
  EXPECT_EQ(options.every, 10);
  ASSERT_TRUE(set("seed", "18446744073709551615").ok());
  EXPECT_EQ(options.sensor.seed, 18446744073709551615u);
  EXPECT_THAT(refusal("every", "2.5"), HasSubstr("whole number"));
  EXPECT_THAT(refusal("every", "1e30"), HasSubstr("whole number"));
  EXPECT_THAT(refusal("seed", "-1"), HasSubstr("whole number"));
}

TEST_F(SimulateTable, AnySensorOptionAsksForTheSensor) {
  EXPECT_FALSE(options.sensor.used);
  ASSERT_TRUE(set("sensor-noise", "0.3 mm").ok());
  EXPECT_TRUE(options.sensor.used);
}

TEST_F(SimulateTable, RefusalsNameOptionTextAndExpectation) {
  EXPECT_THAT(refusal("mass", "217.6 N"), ::testing::AllOf(StartsWith("--mass: "), HasSubstr("217.6 N"),
                                                           HasSubstr("force"), HasSubstr("mass")));
  EXPECT_THAT(refusal("mass", "0"), ::testing::AllOf(StartsWith("--mass: "), HasSubstr("positive")));
  EXPECT_THAT(refusal("drag", "-1"), HasSubstr("not be negative"));
  EXPECT_THAT(refusal("tolerance", "0.1"), HasSubstr("1e-15"));
  EXPECT_THAT(refusal("step", ""), HasSubstr("empty"));
  EXPECT_NE(refusal("step", "nan"), "");
  EXPECT_NE(refusal("step", "inf"), "");
}

TEST_F(SimulateTable, ARefusedValueIsNotStored) {
  EXPECT_FALSE(set("mass", "-2").ok());
  EXPECT_EQ(options.mass, 1);
}

TEST_F(SimulateTable, CheckFindsValuesThatWereSetDirectly) {
  EXPECT_TRUE(check(find(table, "mass")).ok());
  options.mass = 0;
  EXPECT_FALSE(check(find(table, "mass")).ok());
  options.drive_frequency = {1, -1};
  EXPECT_FALSE(check(find(table, "drive-frequency")).ok());
}

// Each range at its limits, and just outside them: the options of all commands keep to one of these.
TEST_F(SimulateTable, SettingsAreTakenInTheirOrderUntilOneIsWrong) {
  const auto told = [&](const std::vector<TypedOption>& settings) {
    const auto result = assign(settings, table, "simulate");
    return result ? "" : in_words(result.error());
  };
  EXPECT_EQ(told({{"mass", "2"}, {"every", "3"}}), "");
  EXPECT_EQ(options.mass, 2);
  EXPECT_EQ(options.every, 3);
  EXPECT_EQ(told({{"mass", "5"}, {"stifness", "2"}, {"every", "4"}}),
            "--stifness is no option of simulate; did you mean --stiffness?");
  EXPECT_EQ(options.mass, 5);
  EXPECT_EQ(options.every, 3);
  EXPECT_EQ(told({{"colour-of-it", "2"}}), "--colour-of-it is no option of simulate");
  EXPECT_EQ(told({{"method", ""}}), "--method: the value is empty");
}

TEST_F(SimulateTable, WholeNumbersThatAreTooLargeAreSaidToBe) {
  EXPECT_EQ(refusal("every", "99999999999999999999"),
            "--every: \"99999999999999999999\" is a whole number too large to be used");
  EXPECT_EQ(refusal("every", "1.5"), "--every: \"1.5\" is not a whole number");
  EXPECT_EQ(refusal("every", "1e3"), "--every: \"1e3\" is not a whole number");
}

TEST(Range, IsKeptToTheLastValue) {
  const double tiny = 5e-324;
  const auto above = [](double value) { return std::nextafter(value, HUGE_VAL); };
  const auto below = [](double value) { return std::nextafter(value, -HUGE_VAL); };
  struct Limits {
    Range range;
    std::vector<double> good, bad;
    std::string_view said;
  };
  const Limits all[] = {
      {Range::any, {-1e300, 0, 1e300}, {}, ""},
      {Range::positive, {tiny, 1e300}, {0, -tiny, -1}, "be positive"},
      {Range::not_negative, {0, tiny}, {-tiny, -1}, "not be negative"},
      {Range::at_least_one, {1, 1e300}, {below(1), 0}, "be at least 1"},
      {Range::fraction, {0, 1}, {-tiny, above(1)}, "lie between 0 and 1"},
      {Range::tolerance, {1e-15, 1e-2}, {below(1e-15), above(1e-2), 0}, "lie between 1e-15 and 1e-2"},
      {Range::accuracy, {1e-9, 0.5}, {below(1e-9), above(0.5)}, "lie between 1e-9 and 0.5"},
      {Range::air_temperature,
       {100, 1900},
       {below(100), above(1900)},
       "lie between 100 K and 1900 K (for instance \"20 °C\")"},
  };
  for (const auto& [range, good, bad, said] : all) {
    EXPECT_EQ(in_words(constraint(range)), said);
    double target = 0;
    const Option option{"limit", &target, "", range, "", "", ""};
    for (const double value : good) {
      target = value;
      EXPECT_TRUE(check(option).ok()) << said << ' ' << value;
    }
    for (const double value : bad) {
      target = value;
      ASSERT_FALSE(check(option).ok()) << said << ' ' << value;
      EXPECT_THAT(in_words(check(option).error()),
                  StartsWith("--limit: it must " + std::string(said) + ", not "));
    }
    for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      target = value;
      EXPECT_FALSE(check(option).ok()) << said << ' ' << value;
    }
  }
  double target = NAN;
  EXPECT_EQ(in_words(check({"any", &target, "m", Range::any, "", "", ""}).error()),
            "--any: it must be a finite number, not nan m");
}

TEST(FitTable, KeepsUncertaintiesWhereTheyAreUsed) {
  FitOptions options;
  const auto table = options_of(options);
  ASSERT_TRUE(assign(find(table, "mass"), "217.6 ± 0.3 g").ok());
  EXPECT_DOUBLE_EQ(options.mass.front().value, 0.2176);
  EXPECT_DOUBLE_EQ(options.mass.front().uncertainty, 0.0003);
  EXPECT_FALSE(assign(find(table, "segment"), "30 ± 1 s").ok());
  ASSERT_TRUE(assign(find(table, "segment"), "30 s").ok());
  EXPECT_EQ(options.segment, 30);
  ASSERT_TRUE(assign(find(table, "temperature"), "20 °C").ok());
  EXPECT_DOUBLE_EQ(options.temperature->value, 293.15);
  EXPECT_FALSE(assign(find(table, "temperature"), "20").ok());
}

TEST(FitTable, TheRateCountsSamples) {
  FitOptions options;
  const auto table = options_of(options);
  for (const char* text : {"100", "100 Hz", "0.1 kHz"}) {
    options.read.rate = 0;
    ASSERT_TRUE(assign(find(table, "rate"), text).ok()) << text;
    EXPECT_DOUBLE_EQ(options.read.rate, 100) << text;
  }
  EXPECT_FALSE(assign(find(table, "rate"), "0").ok());
  EXPECT_FALSE(assign(find(table, "rate"), "3 s").ok());
}

TEST(FitTable, FlagsAreTrueOrFalse) {
  ReadOptions options;
  const auto table = options_of(options);
  ASSERT_TRUE(assign(find(table, "skip-bad-rows"), "true").ok());
  EXPECT_TRUE(options.skip_bad_rows);
  EXPECT_FALSE(assign(find(table, "skip-bad-rows"), "perhaps").ok());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
