#include "cromer/tasks/fit/static_stiffness.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/model/sensor.h"
#include "cromer/tasks/fit/masses.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

Series held(const std::vector<double>& levels, double seconds_each, double noise, std::uint64_t seed = 5) {
  Series series;
  series.column = "Position (m)";
  series.quantity = "position";
  series.rate = 100;
  NormalDeviates normal(seed);
  double before = levels.front();
  for (const double level : levels) {
    for (int i = 0; i < static_cast<int>(100 * seconds_each); ++i) {
      // The mass is hung on in the first tenth, and swings out.
      const double s = i / 100.0, rest = std::exp(-s / (0.02 * seconds_each)) * std::cos(9 * s);
      series.t.push_back(static_cast<double>(series.t.size()) / 100);
      series.y.push_back(level + (before - level) * rest + noise * normal.next());
    }
    before = level;
  }
  return series;
}

TEST(Masses, AreReadWithOneUnitOrManyOrNone) {
  const auto masses = parse_masses("48.4 g, 67.95 ± 0.01 g,0.08796 kg");
  ASSERT_TRUE(masses.ok());
  ASSERT_EQ(masses->size(), 3u);
  EXPECT_DOUBLE_EQ((*masses)[0].value, 0.0484);
  EXPECT_DOUBLE_EQ((*masses)[1].uncertainty, 1e-5);
  EXPECT_DOUBLE_EQ((*masses)[2].value, 0.08796);
  EXPECT_EQ(*parse_masses("48.4, 67.95, 87.96 g"), *parse_masses("48.4 g,67.95 g,87.96 g"));
  EXPECT_DOUBLE_EQ((*parse_masses("0.05,0.06"))[1].value, 0.06);
}

TEST(Masses, ThatAreNoneAreRefused) {
  EXPECT_THAT(in_words(parse_masses("48.4 g,,50 g").error()), HasSubstr("between two commas"));
  EXPECT_THAT(in_words(parse_masses("48.4 m").error()), HasSubstr("--masses"));
  EXPECT_THAT(in_words(parse_masses("-48.4 g").error()), HasSubstr("negative"));
}

TEST(StaticStiffness, IsFoundFromThePlateausOfOneRun) {
  const double k = 3.2, g = 9.81;
  std::vector<double> levels;
  const auto masses = *parse_masses("40, 60, 80, 100 g");
  for (const Quantity& mass : masses) levels.push_back(0.5 - mass.value * g / k);
  const auto holds = find_holds({held(levels, 20, 1e-4)}, "hold.csv", masses);
  ASSERT_TRUE(holds.ok()) << in_words(holds.error());
  ASSERT_EQ(holds->size(), 4u);
  const auto result = static_stiffness(*holds, {g, 0});
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(result->stiffness.value, k, 4 * result->stiffness.standard_error);
  EXPECT_LT(result->stiffness.standard_error, 2e-3 * k);
}

TEST(StaticStiffness, ItsIntervalHoldsTheTruthAsOftenAsItSays) {
  const double k = 3.2, g = 9.81;
  const auto masses = *parse_masses("40, 60, 80, 100 g");
  NormalDeviates normal(11);
  int inside = 0;
  constexpr int repetitions = 2000;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<Hold> holds;
    for (const Quantity& mass : masses) {
      Hold hold;
      hold.mass = mass;
      hold.standard_error = 1e-5;  // far less than hanging the mass on again scatters
      hold.position = mass.value * g / k + 5e-4 * normal.next();
      holds.push_back(hold);
    }
    const auto result = static_stiffness(holds, {g, 0});
    inside += result->stiffness.low <= k && k <= result->stiffness.high;
  }
  EXPECT_NEAR(static_cast<double>(inside) / repetitions, 0.95, 0.015);
}

TEST(StaticStiffness, SaysWhatIsWrong) {
  const auto masses = *parse_masses("40, 60, 80 g");
  const auto two = find_holds({held({0.1, 0.2}, 20, 1e-4)}, "hold.csv", masses);
  EXPECT_THAT(in_words(two.error()), HasSubstr("3 masses are given, and 2 plateaus are found"));
  Series angle = held({0.1}, 5, 1e-4);
  angle.quantity = "angle";
  EXPECT_THAT(in_words(find_holds({angle}, "hold.csv", masses).error()), HasSubstr("needs positions"));
  const Series one = held({0.1}, 5, 1e-4);
  EXPECT_THAT(in_words(find_holds({one, one}, "hold.csv", masses).error()), HasSubstr("for 2 runs"));
  std::vector<Hold> alike(3);
  for (Hold& hold : alike) hold.mass = {0.05, 0};
  EXPECT_FALSE(static_stiffness(alike, {9.8, 0}).ok());
}

}  // namespace
}  // namespace cromer::core
