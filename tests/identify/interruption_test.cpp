#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/fit_settings.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

TEST(Interruption, NoLawConvergesWhenItIsInterrupted) {
  const SyntheticRecord record = viscous_record({}, even_times(3000, 0.01), 1e-4);
  const std::atomic<bool> stop{true};
  const Watch watch{&stop, {}};
  for (const Law& law :
       {law_of("viscous"), law_of("viscous+drag"), law_of("viscous+cubic"), law_of("viscous+drag+cubic")}) {
    const LawFit fit = fit_law(record.record(), {.law = law}, watch);
    EXPECT_EQ(fit.status, FitStatus::iteration_limit) << to_text(law);
    EXPECT_THAT(in_words(fit.message), testing::StartsWith("interrupted"));
    EXPECT_EQ(fit.angular_frequency().value, 0);  // nothing that could be taken for a result
  }
  const LawChoice choice = choose_law(record.record(), {}, watch);
  EXPECT_EQ(choice.chosen.status, FitStatus::iteration_limit);
  EXPECT_THAT(in_words(choice.chosen.message), testing::StartsWith("interrupted"));
}

TEST(Interruption, AFitOfOneLawTellsOfItsPassesAndEndsWithinThem) {
  const SyntheticRecord record = viscous_record({}, even_times(3000, 0.01), 1e-4);
  for (const Law& law : {law_of("viscous"), law_of("viscous+drag+cubic")}) {
    std::atomic<bool> stop{false};
    std::vector<double> shares;
    std::size_t last = 0;
    const Watch watch{&stop, [&](double share) {
                        shares.push_back(share);
                        stop = last > 0 && shares.size() >= last;
                      }};
    EXPECT_EQ(fit_law(record.record(), {.law = law}, counting_passes(watch)).status, FitStatus::converged);
    EXPECT_GE(shares.size(), 5u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LT(shares.back(), 1);
    last = 3;
    shares.clear();
    const LawFit fit = fit_law(record.record(), {.law = law}, counting_passes(watch));
    EXPECT_THAT(in_words(fit.message), testing::StartsWith("interrupted"));
    EXPECT_EQ(fit.angular_frequency().value, 0);
  }
}

TEST(Interruption, AChoiceThatIsNotDoneSaysSo) {
  const SyntheticRecord record = viscous_record({}, even_times(3000, 0.01), 1e-4);
  for (int after = 1; after <= 4; ++after) {
    std::atomic<bool> stop{false};
    int done = 0;
    const Watch watch{&stop, [&](double) { stop = ++done == after; }};
    const LawChoice choice = choose_law(record.record(), {}, watch);
    EXPECT_EQ(choice.chosen.status, FitStatus::iteration_limit) << after;
    EXPECT_THAT(in_words(choice.chosen.message), testing::StartsWith("interrupted"));
    EXPECT_EQ(choice.candidates.size(),
              static_cast<std::size_t>(1 + 2 * after));  // the viscous law, and pairs
    EXPECT_NEAR(choice.chosen.angular_frequency().value, 8.849, 1e-3);
    // What is missing is named, what was compared is not.
    EXPECT_THAT(in_words(choice.chosen.message),
                testing::EndsWith("drag+friction+odd-quadratic, viscous+drag+friction+odd-quadratic"));
    EXPECT_EQ(
        in_words(choice.chosen.message).find("not compared yet: viscous+drag+cubic,") != std::string::npos,
        after == 1);
  }
}

}  // namespace
}  // namespace cromer::core
