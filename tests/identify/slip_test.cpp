#include "cromer/identify/diagnose/slip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

// Of times 0.02 s apart, `lost` samples after number `at` of which are missing while the times go on.
SyntheticRecord with_samples_lost(const FreeSwing& truth, std::size_t at, int lost, unsigned seed) {
  SyntheticRecord record{even_times(2000, 0.02), {}, 0};
  std::vector<double> when = record.t;
  for (std::size_t i = at; i < when.size(); ++i) when[i] += 0.02 * lost;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, 2e-3);
  for (const double x : free_motion(truth, when, 0.005).x) record.y.push_back(x + normal(engine));
  return record;
}

TEST(SlippedTimes, AreFoundUnderEachLaw) {
  const FreeSwing straight{.angular_frequency = 6, .decay_rate = 0.03, .position = 0.3};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto record = with_samples_lost(straight, 800 + 40 * seed, 1 + seed % 2, seed);
    for (const char* law : {"viscous", "viscous+cubic", ""}) {
      const LawFit fit =
          *law ? fit_law(record.record(), {.law = law_of(law)}) : choose_law(record.record(), {}).chosen;
      const Notice slip = slipped_times(record.record(), fit);
      ASSERT_EQ(slip.code, "times_slip") << seed << " " << to_text(fit.law);
      EXPECT_THAT(in_words(slip), testing::HasSubstr(is_linear(fit.law) ? "part of what" : "a bent spring"));
      EXPECT_NEAR(std::get<double>(slip.values[0].value), 16 + 0.8 * seed, 1) << seed;
      EXPECT_NEAR(std::get<double>(slip.values[1].value), 0.02 * (1 + seed % 2), 0.005) << seed;
    }
  }
}

TEST(SlippedTimes, ABentSpringIsNoSlip) {
  const FreeSwing bent{.angular_frequency = 6, .decay_rate = 0.03, .cubic = 6, .position = 0.3};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto record = with_samples_lost(bent, 2000, 0, seed);
    const LawFit fit = choose_law(record.record(), {}).chosen;
    EXPECT_TRUE(slipped_times(record.record(), fit).empty()) << seed << " " << to_text(fit.law);
  }
}

}  // namespace
}  // namespace cromer::core
