#include "cromer/identify/diagnose/slip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// Of times 0.02 s apart, `lost` samples after number `at` of which are missing while the times go on.
SyntheticRecord with_samples_lost(const TrueSwing& truth, std::size_t at, int lost, unsigned seed,
                                  int derivative = 0) {
  SyntheticRecord record{even_times(2000, 0.02), {}, 0};
  std::vector<double> when = record.t;
  for (std::size_t i = at; i < when.size(); ++i) when[i] += 0.02 * lost;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, 2e-3 * std::pow(6, derivative));
  const Trajectory motion = free_motion(truth, when, 0.005);
  for (const double each : derivative == 0 ? motion.x : motion.v) record.y.push_back(each + normal(engine));
  return record;
}

TEST(SlippedTimes, AreFoundUnderEachLaw) {
  const TrueSwing straight{.angular_frequency = 6, .decay_rate = 0.03, .position = 0.3};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto record = with_samples_lost(straight, 800 + 40 * seed, 1 + seed % 2, seed);
    for (const char* law : {"viscous", "viscous+cubic", ""}) {
      const LawFit fit =
          *law ? fit_law(record.record(), {.law = law_of(law)}) : choose_law(record.record(), {}).chosen;
      const auto slip = find_slip(record.record(), fit);
      ASSERT_TRUE(slip) << seed << " " << to_text(fit.law);
      EXPECT_NEAR(slip->at, 16 + 0.8 * seed, 1) << seed;
      EXPECT_NEAR(slip->by, -0.02 * (1 + seed % 2), 0.002) << seed;
      EXPECT_THAT(in_words(slip->notice()), testing::HasSubstr("lost samples"));
    }
  }
}

TEST(SlippedTimes, ABentSpringIsNoSlip) {
  TrueSwing bent{.angular_frequency = 6, .decay_rate = 0.03, .position = 0.3};
  for (unsigned seed = 1; seed <= 10; ++seed) {
    bent.cubic = seed % 2 ? 6 : -6;
    const auto record = with_samples_lost(bent, 2000, 0, seed);
    for (const LawFit& fit : {choose_law(record.record(), {}).chosen, fit_law(record.record(), {})})
      EXPECT_FALSE(find_slip(record.record(), fit)) << seed << " " << to_text(fit.law);
  }
}

TEST(SlippedTimes, AreFoundBesideABentSpring) {
  TrueSwing bent{.angular_frequency = 6, .decay_rate = 0.04, .position = 0.3};
  for (const int derivative : {0, 1})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      bent.cubic = (seed % 2 ? 0.3 : -0.3) * 36 / 0.09;
      const int lost = 2 + static_cast<int>(seed % 4);
      const auto record = with_samples_lost(bent, 500 + 100 * seed, lost, seed, derivative);
      Record seen = record.record();
      seen.derivative = derivative;
      const LawChoice choice = choose_law(seen, {});
      const auto slip = find_slip(seen, choice.chosen, choice.candidates);
      ASSERT_TRUE(slip) << derivative << " " << seed << " " << to_text(choice.chosen.law);
      EXPECT_NEAR(slip->at, 10 + 2 * seed, 1) << seed;
      EXPECT_NEAR(slip->by, -0.02 * lost, 0.003) << seed;
    }
}

TEST(SlippedTimes, NoiseThatWandersIsNoSlip) {
  int told = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SyntheticRecord record{even_times(90, 0.035), {}, 0};
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 0.004);
    double noise = 0;
    for (const double t : record.t) {
      noise = 0.95 * noise + normal(engine);
      record.y.push_back(0.3 * std::exp(-0.2 * t) * std::cos(6 * t) + noise);
    }
    told += find_slip(record.record(), fit_law(record.record(), {})).has_value();
  }
  EXPECT_LE(told, 1);
}

// Of velocities and accelerations, and of samples that came twice.
TEST(SlippedTimes, AreFoundInDerivatives) {
  for (const int derivative : {1, 2})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const TrueSwing straight{.angular_frequency = 6, .decay_rate = 0.03, .position = 0.3};
      SyntheticRecord record = with_samples_lost(straight, 2000, 0, seed);
      std::mt19937_64 engine(seed);
      std::normal_distribution<double> normal(0, 2e-3 * std::pow(6, derivative));
      for (std::size_t i = 0; i < record.t.size(); ++i) {
        const double at = record.t[i] - (i < 900 ? 0 : 0.04), w = std::sqrt(36 - 0.03 * 0.03);
        const double x = 0.3 * std::exp(-0.03 * at) * std::cos(w * at),
                     v = -0.3 * std::exp(-0.03 * at) * w * std::sin(w * at) - 0.03 * x;
        record.y[i] = (derivative == 1 ? v : -36 * x - 0.06 * v) + normal(engine);
      }
      Record seen = record.record();
      seen.derivative = derivative;
      const LawFit fit = fit_law(seen, {});
      const auto slip = find_slip(seen, fit);
      ASSERT_TRUE(slip) << derivative << " " << seed;
      EXPECT_THAT(in_words(slip->notice()), testing::HasSubstr("repeated samples"));
      EXPECT_NEAR(slip->at, 18, 1);
      EXPECT_NEAR(slip->by, 0.04, 0.003);
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
