#include "cromer/identify/choose/choose_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/law_force.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(ChooseLaw, ALongRecordIsJudgedByAPartAndFittedWhole) {
  const TrueSwing truth{.angular_frequency = 8.849,
                        .decay_rate = 0.002,
                        .drag = 0.1,
                        .equilibrium = 0.2,
                        .position = 0.036,
                        .velocity = 0};
  SyntheticRecord record{even_times(400'000, 0.001), {}, 0};
  std::mt19937_64 engine(4);
  std::normal_distribution<double> normal(0, 3e-4);
  for (const double x : free_motion(truth, record.t, 0.01).x)
    record.y.push_back(truth.equilibrium + x + normal(engine));
  const LawChoice choice = choose_law(record.record(), {});
  const LawFit& fit = choice.chosen;
  EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_EQ(to_text(fit.law), "viscous+drag");
  EXPECT_LE(choice.candidates.size(), 23u);  // with van-der-pol in the place of drag, and with quadratic
  EXPECT_NEAR(fit["drag"].value, 0.1, 4 * fit["drag"].standard_error);
  EXPECT_NEAR(fit.decay_rate().value, 0.002, 4 * fit.decay_rate().standard_error);
  EXPECT_THAT(in_words(fit.notices), testing::Contains(testing::HasSubstr("one in 10 up to 399.99 s")));
  // The uncertainties are those of all samples, half of the candidate's.
  EXPECT_LT(fit["drag"].standard_error, 0.6 * choice.candidates[1]["drag"].standard_error);
}

// Its second harmonic and the middle that moves as the swing dies down stand apart from the swing's
// frequency.
TEST(ChooseLaw, ASpringThatIsNotSymmetricIsFound) {
  Motion truth{.law = law_of("viscous+quadratic"), .position = 0.05};
  truth.set_angular_frequency(6);
  truth.set_decay_rate(0.06);
  truth.per_mass.quadratic = 36;
  const std::vector<double> t = even_times(600, 0.0419);
  const std::vector<double> x = free_motion(truth, t, 0.005).x;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 5e-4);
    std::vector<double> y = x;
    for (double& each : y) each += normal(engine);
    EXPECT_EQ(to_text(choose_law({t, y}, {}).chosen.law), "viscous+quadratic") << seed;
  }
}

// A zero that creeps bends springs and takes dampings away; no free swing is without any.
TEST(ChooseLaw, ALawWithoutAnyDampingIsNotChosen) {
  struct Creeping {
    double w, size, cycles, damping_ratio, creep, fall;
  };
  for (const Creeping& swing : {Creeping{4.1785, 0.024224, 9.44, 0.00155, 0.397, 5.617},
                                Creeping{10.4508, 0.022324, 12.995, 0.001164, 0.2947, 8.024}})
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const std::vector<double> t = even_times(1500, two_pi / swing.w * swing.cycles / 1500);
      SyntheticRecord record = viscous_record({.w0 = swing.w,
                                               .g = swing.w * swing.damping_ratio,
                                               .equilibrium = 0,
                                               .position = swing.size,
                                               .velocity = 0},
                                              t, 0.01 * swing.size, 0, seed);
      for (std::size_t i = 0; i < t.size(); ++i)
        record.y[i] += swing.size * swing.creep * (1 - std::exp(-swing.fall * t[i] / t.back()));
      EXPECT_TRUE(choose_law(record.record(), {}).chosen.law.shares(dissipative_terms))
          << swing.w << ' ' << seed;
    }
}

bool was_tried(const LawChoice& choice, const Law& law) {
  return std::any_of(choice.candidates.begin(), choice.candidates.end(),
                     [&](const LawFit& fit) { return fit.law == law; });
}

TEST(ChooseLaw, WhoGivesAnExponentLooksForHysteresis) {
  const Law hysteretic = law_of("viscous+hysteresis");
  const SyntheticRecord record = viscous_record({}, even_times(400, 0.05), 1e-3);
  EXPECT_FALSE(was_tried(choose_law(record.record(), {}), hysteretic));
  const LawChoice choice = choose_law(record.record(), {.hysteresis_exponent = 2});
  EXPECT_TRUE(was_tried(choice, hysteretic));
  EXPECT_EQ(to_text(choice.chosen.law), "viscous");
}

TEST(ChooseLaw, EverySampleMayCount) {
  SyntheticRecord record = viscous_record({}, even_times(400, 0.05), 1e-3);
  record.y[200] += 0.1;
  const LawChoice choice = choose_law(record.record(), {});
  EXPECT_EQ(choice.chosen.outliers, std::vector<std::size_t>{200});
  EXPECT_NEAR(choice.chosen.residual.rms, 1e-3, 2e-4);
  const LawChoice every = choose_law(record.record(), {.every_sample = true});
  EXPECT_TRUE(every.chosen.outliers.empty());
  EXPECT_NEAR(every.chosen.residual.rms, std::hypot(1e-3, 0.1 / std::sqrt(400)), 5e-4);
}

// Three samples for each parameter: ten of 32 samples, which a body with drag and a cubic spring has.
TEST(ChooseLaw, FewSamplesOfADrivenMotionTellFewTerms) {
  Motion truth{.law = law_of("viscous+drag+cubic"),
               .cosine = 8,
               .drive_frequency = 4.7,
               .position = 0.5,
               .velocity = 0.3};
  truth.set_angular_frequency(6);
  truth.set_decay_rate(0.1);
  truth.per_mass.drag = 0.3;
  truth.per_mass.cubic = 30;
  truth.per_mass.quadratic = 4;
  const auto most_terms = [&](std::size_t samples) {
    const std::vector<double> t = even_times(samples, 0.15);
    const std::vector<double> y = noisy(observed_motion(truth, Drive::harmonic(), t, 0, 0.002), 1e-5);
    const LawChoice choice = choose_law({t, y}, {.drive = Drive::harmonic(), .drive_frequency = 4.7});
    int most = 0;
    for (const LawFit& fit : choice.candidates) most = std::max(most, fit.fitted);
    return most;
  };
  EXPECT_EQ(most_terms(32), 10);
  EXPECT_EQ(most_terms(33), 11);
}

// A body without a spring has no place to come back to: nothing that pulls it there is tried.
TEST(ChooseLaw, OfABodyWithoutASpringOnlyDampingIsChosen) {
  ForcedTruth truth{.w0 = 0, .g = 0.3, .drag = 0.8, .position = 0, .velocity = 0.2};
  const auto choice_of = [&] {
    const ForcedSynthetic record = forced_synthetic(truth, multisine(10, 3), 600, 0.03, 2e-3, 3, 1);
    LawChoice choice =
        choose_law(record.record(), {.law = law_with<Viscous>,
                                     .drive = Drive::recorded(record.recorded(BetweenSamples::linear)),
                                     .hysteresis_exponent = 2});
    for (const LawFit& fit : choice.candidates)
      EXPECT_FALSE(fit.law.shares(springs.with(terms_of_position))) << to_text(fit.law);
    return choice;
  };
  const LawChoice choice = choice_of();
  EXPECT_EQ(choice.chosen.status, FitStatus::converged);
  EXPECT_EQ(choice.chosen.law, (law_with<Viscous, Drag>));
  EXPECT_NEAR(choice.chosen["drag"].value, 0.8, 4 * choice.chosen["drag"].standard_error);
  EXPECT_NEAR(choice.chosen.decay_rate().value, 0.3, 4 * choice.chosen.decay_rate().standard_error);
  EXPECT_TRUE(choice.rivals.empty());
  EXPECT_TRUE(was_tried(choice, law_with<Viscous>));
  EXPECT_TRUE(was_tried(choice, law_with<Viscous, Friction>));
  // Nor where something does pull.
  truth.w0 = 0.1;
  EXPECT_TRUE(was_tried(choice_of(), law_with<Viscous, Drag, Friction>));
}

// More samples than a choice looks at.
TEST(ChooseLaw, NoiseIsNotJudgedByAPart) {
  const std::vector<double> t = even_times(200'001, 0.001), y = noisy(std::vector<double>(t.size()), 1);
  const LawChoice choice = choose_law({t, y}, {});
  EXPECT_EQ(choice.chosen.status, FitStatus::no_oscillation);
  EXPECT_EQ(choice.candidates.size(), 1u);
  EXPECT_TRUE(choice.chosen.notices.empty());
}

TEST(ChooseLaw, APartThatIsInterruptedSaysWhatIsMissing) {
  const SyntheticRecord record = viscous_record({}, even_times(200'001, 0.001), 1e-3);
  std::atomic<bool> stop{false};
  const Watch watch{&stop, [&](double share) {
                      stop = true;
                      EXPECT_LE(share, 0.5 * 4 / 20);  // of twenty laws one, and those under way
                    }};
  const LawChoice choice = choose_law(record.record(), {}, watch);
  EXPECT_EQ(choice.chosen.status, FitStatus::iteration_limit);
  EXPECT_EQ(choice.chosen.message.code, "ended_before_these_laws");
  EXPECT_GE(choice.candidates.size(), 2u);
  EXPECT_LE(choice.candidates.size(), 5u);
  EXPECT_GT(choice.chosen.independent_samples, 150'000);  // the viscous law on the whole record
  ASSERT_EQ(choice.chosen.notices.size(), 1u);
  EXPECT_EQ(choice.chosen.notices[0].code, "laws_compared_on_a_part");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
