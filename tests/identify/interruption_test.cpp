#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/fit_settings.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

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
  for (int after = 1; after <= 2; ++after) {
    std::atomic<bool> stop{false};
    int done = 0;
    const Watch watch{&stop, [&](double) { stop = ++done >= after; }};
    const LawChoice choice = choose_law(record.record(), {}, watch);
    EXPECT_EQ(choice.chosen.status, FitStatus::iteration_limit) << after;
    EXPECT_THAT(in_words(choice.chosen.message), testing::StartsWith("interrupted"));
    // The viscous law, those of this thread, and at most so many beside each.
    EXPECT_GE(choice.candidates.size(), static_cast<std::size_t>(1 + after));
    EXPECT_LE(choice.candidates.size(), static_cast<std::size_t>(1 + 4 * after));
    EXPECT_NEAR(choice.chosen.angular_frequency().value, 8.849, 1e-3);
    // What is missing is named, what was compared is not.
    EXPECT_THAT(in_words(choice.chosen.message),
                testing::HasSubstr(", drag+friction+odd-quadratic"));
    const std::string said = in_words(choice.chosen.message) + ',';
    for (const LawFit& fit : choice.candidates)
      EXPECT_EQ(said.find(": " + to_text(fit.law) + ','), std::string::npos) << said;
  }
}

// Wherever the steps end, only fits that were done are compared.
TEST(Interruption, AChoiceEndsWithItsSteps) {
  Motion swing{.law = law_of("viscous+cubic"), .position = 0.5, .velocity = 0.3};
  swing.set_angular_frequency(6);
  swing.set_decay_rate(0.04);
  swing.per_mass.cubic = 20;
  const std::vector<double> t = even_times(200, 0.05);
  const auto acting = multisine(15, 3);
  std::vector<double> force;
  for (const double each : t) force.push_back(acting(each));
  swing.force_gain = 5;
  const Drive recorded = Drive::recorded({force, 0, 0.05, BetweenSamples::linear});
  for (const Drive& drive : {Drive{}, recorded}) {
    const std::vector<double> y = noisy(observed_motion(swing, drive, t, 0, 0.002), 1e-3);
    const auto choice_within = [&, &drive = drive](double steps, double& left) {
      Watch watch;
      watch.steps_left = std::make_shared<std::atomic<double>>(steps);
      LawChoice choice = choose_law({t, y}, {.drive = drive}, watch);
      left = *watch.steps_left;
      return choice;
    };
    double left = 0;
    const LawChoice whole = choice_within(1e9, left);
    EXPECT_EQ(whole.chosen.status, FitStatus::converged);
    const double all = 1e9 - left;
    for (int part = 0; part < 8; ++part) {
      const LawChoice choice = choice_within((part + 0.5) / 8 * all, left);
      EXPECT_LT(left, 0) << part;
      EXPECT_EQ(choice.chosen.status, FitStatus::iteration_limit) << part;
      EXPECT_THAT(in_words(choice.chosen.message), testing::HasSubstr("need more integration steps")) << part;
      if (!choice.chosen.has_values()) continue;
      for (const LawFit& fit : choice.candidates) EXPECT_TRUE(fit.has_values()) << part;
      EXPECT_LE(choice.candidates.size(), whole.candidates.size()) << part;
    }
  }
}

TEST(Interruption, AFitThatGrowsEndsAtAnyPass) {
  const SyntheticRecord record = viscous_record({}, even_times(40'000, 0.01), 1e-4);
  std::atomic<bool> stop{false};
  int passes = 0, last = 0;
  Watch watch{&stop};
  watch.pulse = [&] { stop = ++passes == last; };
  EXPECT_EQ(fit_law(record.record(), {.every_sample = true}, watch).status, FitStatus::converged);
  const int all = passes;
  for (last = 1; last <= all; ++last) {
    passes = 0;
    watch.pulse = [&] { stop = stop || ++passes == last; };
    stop = false;
    const LawFit fit = fit_law(record.record(), {.every_sample = true}, watch);
    EXPECT_EQ(fit.status, FitStatus::iteration_limit) << last;
    EXPECT_FALSE(fit.has_values()) << last;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
