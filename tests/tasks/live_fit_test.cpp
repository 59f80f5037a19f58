#include "cromer/tasks/record/live_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/record/options.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double decay_rate = 0.05, frequency = 1.5;

/// `cycles` of a noisy decay at 100 samples a second beside a column that only drifts.
SampleRows swing(double cycles) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 5e-4);
  SampleRows rows;
  rows.width = 2;
  for (int n = 0; n < cycles / frequency * 100; ++n) {
    const double t = n / 100.0;
    rows.add(t, std::vector{1e-3 * t, 0.05 * std::exp(-decay_rate * t) * std::cos(2 * M_PI * frequency * t) +
                                          noise(random)});
  }
  return rows;
}

const Headings headings{"Time (s)", "Temperature (K)", "Position (m)"};

TEST(LiveFit, TakesTheColumnThatSwingsUnlessOneIsNamed) {
  // The other one drifts by more than the swing.
  EXPECT_EQ(live_fit(swing(90), headings, "")->series.column, "Position (m)");
  EXPECT_EQ(live_fit(swing(90), headings, "Temperature")->series.column, "Temperature (K)");
  EXPECT_EQ(live_fit(swing(10), headings, "Position (m)")->series.column, "Position (m)");
  EXPECT_FALSE(live_fit(swing(10), headings, "Force"));
}

TEST(LiveFit, AfterTenCyclesItIsWhatTheWholeRecordingSays) {
  const auto early = live_fit(swing(10), headings, ""), whole = live_fit(swing(90), headings, "");
  ASSERT_TRUE(early && whole);
  ASSERT_TRUE(early->succeeded()) << in_words(early->fit.message);
  ASSERT_TRUE(whole->succeeded()) << in_words(whole->fit.message);
  EXPECT_EQ(early->series.column, "Position (m)");
  const double live = early->find("frequency")->value, final = whole->find("frequency")->value;
  EXPECT_NEAR(live, final, 1e-3 * final);
  EXPECT_NEAR(final, frequency, 1e-4);
  for (const char* name : {"angular_frequency", "decay_rate", "equilibrium", "position", "velocity"}) {
    const Estimate &of_live = *early->find(name), &of_whole = *whole->find(name);
    EXPECT_NEAR(of_live.value, of_whole.value, 3 * of_live.standard_error) << name;
  }
}

TEST(LiveFit, SaysNothingBeforeThereIsAnythingToSay) {
  EXPECT_FALSE(live_fit({}, {}, ""));
  EXPECT_FALSE(live_fit(swing(0.1), headings, ""));
  const auto short_one = live_fit(swing(0.6), headings, "");
  EXPECT_TRUE(!short_one || !short_one->succeeded());
}

TEST(RecordOptions, AreCheckedBeforeAnythingIsOpened) {
  const auto told = [](const RecordOptions& options) {
    const auto setup = check(options);
    return setup ? "" : in_words(setup.error());
  };
  RecordOptions options;
  options.from = "-";
  options.output = "new.csv";
  EXPECT_EQ(told(options), "");
  EXPECT_EQ(check(options)->lines.time_unit, 0);
  for (const auto& [unit, factor] : {std::pair{"s", 1.0}, std::pair{"ms", 1e-3}, std::pair{"us", 1e-6}}) {
    options.time_unit = unit;
    EXPECT_EQ(check(options)->lines.time_unit, factor);
  }
  for (const std::string unit : {"m", "Hz", "fortnights"}) {
    options.time_unit = unit;
    EXPECT_EQ(told(options), "--time-unit \"" + unit + "\" is no unit of time; it is s, ms or us");
  }
  options.time_unit = "";
  options.output = "no/such/folder/new.csv";
  EXPECT_EQ(told(options), "cannot write no/such/folder/new.csv: there is no folder no/such/folder");
  options.output = "";
  EXPECT_EQ(told(options), "-o FILE.csv is needed: where the recording is to go");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
