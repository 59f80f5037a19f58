#include "cromer/identify/diagnose/doubts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/record.h"
#include "tests/identify/synthetic.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> doubts_about(const SyntheticRecord& record) {
  const LawFit fit = choose_law(record.record(), {}).chosen;
  EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  return in_words(doubts(record.record(), fit));
}

TEST(Doubts, NoneAboutAFreeDecay) {
  for (unsigned seed = 1; seed <= cases(5u); ++seed) {
    EXPECT_THAT(doubts_about(viscous_record({}, even_times(6000, 0.01), 3e-4, 1e-4, seed)), IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({.g = 0.3}, even_times(6000, 0.01), 3e-4, 1e-4, seed)),
                IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({}, even_times(3000, 0.01), 2e-4, 1e-2, seed)), IsEmpty());
    EXPECT_THAT(doubts_about(viscous_record({.g = 0.05}, even_times(300, 0.1), 1e-3, 0, seed)), IsEmpty());
  }
}

// A linear law loses step with a bent spring and sees no decay: the record does.
TEST(Doubts, AWrongLawIsNoSwingThatDoesNotDieDown) {
  const TrueSwing truth{.angular_frequency = 6, .decay_rate = 0.05, .cubic = 40, .position = 0.3};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SyntheticRecord record{even_times(2000, 0.02), {}, 0};
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 5e-4);
    for (const double x : free_motion(truth, record.t, 0.005).x) record.y.push_back(x + normal(engine));
    const LawFit fit = fit_law(record.record(), {.law = law_of("viscous")});
    for (const std::string& sentence : in_words(doubts(record.record(), fit, true)))
      EXPECT_THAT(sentence, testing::Not(HasSubstr("does not die down"))) << seed;
  }
}

TEST(Doubts, NoAmplitudesInWindowsShorterThanRounding) {
  const SyntheticRecord record = viscous_record({}, even_times(100, 0.01), 3e-4);
  const Record later =
      record.record().part(50, 50);  // at times where the window's end rounds to its beginning
  EXPECT_TRUE(amplitude_windows(later, 1e-20, 1).empty());
  EXPECT_FALSE(amplitude_windows(later, 0.1, 1).empty());
}

TEST(Doubts, ASwingThatDoesNotDieDownMayBeDriven) {
  const SyntheticRecord record = viscous_record({.g = 0}, even_times(6000, 0.01), 3e-4, 1e-4);
  EXPECT_THAT(doubts_about(record), ElementsAre(HasSubstr("does not die down over 84 periods")));
  const SyntheticRecord few = viscous_record({.g = 0}, even_times(1000, 0.01), 3e-4, 1e-4);
  EXPECT_THAT(doubts_about(few), IsEmpty());  // fourteen periods prove nothing
}

TEST(Doubts, AnAmplitudeThatRisesIsNoFreeSwing) {
  SyntheticRecord beats = viscous_record({.g = 0.02}, even_times(6000, 0.01), 3e-4);
  for (std::size_t i = 0; i < beats.t.size(); ++i) beats.y[i] += 0.012 * std::sin(9.3 * beats.t[i]);
  EXPECT_THAT(doubts_about(beats), testing::Contains(HasSubstr("the amplitude rises")));
}

TEST(Doubts, SpikesThatAreSetAsideAreNoRise) {
  SyntheticRecord record = viscous_record({}, even_times(3000, 0.01), 3e-4);
  for (std::size_t i = 2000; i < 2200; i += 40) record.y[i] += 0.3;
  EXPECT_THAT(doubts_about(record), testing::Each(testing::Not(HasSubstr("rises"))));
}

TEST(Doubts, ChanceInTheTimesIsNoRise) {
  // About nine samples in a period, at times of their own.
  for (unsigned seed = 1; seed <= cases(60u); ++seed) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> wait(1 / 0.0774);
    std::vector<double> t{0};
    while (t.size() < 800) t.push_back(t.back() + wait(random));
    const SyntheticRecord record = viscous_record({.g = 0.0055, .velocity = 0}, t, 3e-4, 0, seed);
    const LawFit fit = fit_law(record.record(), {.law = law_of("viscous")});
    ASSERT_EQ(fit.status, FitStatus::converged) << seed;
    for (const Notice& notice : doubts(record.record(), fit))
      EXPECT_NE(notice.code, "amplitude_rises") << seed;
  }
}

TEST(Doubts, FrictionIsNotDescribedByTheViscousLaw) {
  // x'' = -w0² x - f sgn(x'): half waves about ±f/w0², the amplitude falling by 2 f/w0² in each.
  constexpr double w0 = 8.849, shift = 1e-4;
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal(0, 5e-5);
  SyntheticRecord record{even_times(8000, 0.01), {}, 0};
  for (const double t : record.t) {
    const double half = std::floor(w0 * t / std::numbers::pi);
    const double side = std::fmod(half, 2) == 0 ? 1 : -1;
    const double amplitude = std::max(0.0, 0.05 - (2 * half + 1) * shift);
    record.y.push_back(side * shift + amplitude * std::cos(w0 * t) + normal(engine));
  }
  const LawFit viscous = fit_law(record.record(), {.law = law_of("viscous")});
  EXPECT_THAT(in_words(doubts(record.record(), viscous)),
              testing::Contains(HasSubstr("no law tried describes")));
  EXPECT_THAT(in_words(doubts(record.record(), viscous, true)),
              testing::Contains(HasSubstr("the law viscous does not describe this recording")));
  EXPECT_THAT(doubts_about(record), testing::IsEmpty());
}

// A swing with something done to every sample.
template <class Change>
std::vector<std::string> doubts_after(const Change& change,
                                      const std::vector<double>& t = even_times(2500, 0.01)) {
  SyntheticRecord record = viscous_record({.w0 = 8, .g = 0.05, .position = 0.05, .velocity = 0}, t, 3e-4);
  for (std::size_t i = 0; i < t.size(); ++i) record.y[i] = change(t[i], record.y[i]);
  return in_words(doubts(record.record(), choose_law(record.record(), {}).chosen, false, "m"));
}

TEST(Doubts, NameWhatTheDataShow) {
  EXPECT_THAT(doubts_after([](double t, double y) { return y + 0.002 * t; }),
              ElementsAre(HasSubstr("the zero drifts, by 0.0499 m")));
  EXPECT_THAT(doubts_after([](double t, double y) { return t > 12 ? y + 0.01 : y; }),
              ElementsAre(HasSubstr("the zero jumps by 0.00998 m at 12.01 s")));
  EXPECT_THAT(doubts_after([](double t, double y) { return t > 15 ? 0.22 + 1e-3 * (y - 0.2) : y; }),
              ElementsAre(testing::ContainsRegex("the swing stops between 1[45]"),
                          HasSubstr("is fitted to the swing and to what follows the stop")));
  // Caught when nearly done, and held aside.
  EXPECT_THAT(doubts_after([](double t, double y) { return t > 40 ? 0.201 + 1e-3 * (y - 0.2) : y; },
                           even_times(5000, 0.01)),
              testing::Contains(testing::ContainsRegex("the swing stops between (39|4[01])")));
  const SyntheticRecord slow = viscous_record({.w0 = 8.168}, even_times(120, 1), 3e-4);
  EXPECT_THAT(doubts_about(slow),
              testing::Contains(HasSubstr("a swing of 0.70003 or 1.3 Hz would look the same")));
}

TEST(Departures, APendulumThatTurnsOver) {
  const TrueSwing over{
      .angular_frequency = 3, .decay_rate = 0.1, .position = 0.1, .velocity = 9, .pendulum = true};
  SyntheticRecord record{even_times(2000, 0.02), {}, 0};
  record.y = free_motion(over, record.t, 1e-3).x;
  EXPECT_THAT(in_words(turning_over(record.record())), HasSubstr("turns over"));
  for (double& y : record.y) y = std::sin(y);
  EXPECT_EQ(in_words(turning_over(record.record())), "");
}

TEST(Doubts, WanderingNoiseIsNoWrongLaw) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SyntheticRecord record = viscous_record({.w0 = 8, .g = 0.05, .position = 0.05}, even_times(2500, 0.01));
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 3e-4);
    double noise = 0;
    for (double& y : record.y) y += noise = 0.95 * noise + normal(engine);
    EXPECT_THAT(doubts_about(record), IsEmpty()) << seed;
  }
}

// Over few swings noise that wanders has more power at the swing's frequency than at the higher ones beside
// it.
TEST(Doubts, WanderingNoiseOverAFewSwingsIsNoWrongLaw) {
  int told = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SyntheticRecord record = viscous_record({.w0 = 8, .g = 0.2, .position = 0.05}, even_times(130, 0.03));
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, 5e-4);
    double noise = 0;
    for (double& y : record.y) y += noise = 0.9 * noise + normal(engine);
    const LawFit fit = fit_law(record.record(), {});
    for (const std::string& sentence : in_words(doubts(record.record(), fit, true)))
      told += sentence.find("does not describe") != sentence.npos;
  }
  EXPECT_LE(told, 2);
}

// Of a body at 6 rad/s, driven at 5, and of what else pushes it.
std::vector<std::string> driven_doubts_about(double second, double third_harmonic, double correlation,
                                             unsigned seed = 1) {
  SyntheticRecord record{even_times(3000, 0.02), {}, 0};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, 1e-4);
  double noise = 0;
  for (const double t : record.t) {
    noise = correlation * noise + normal(engine);
    record.y.push_back(0.05 * std::cos(5 * t) + 0.03 * std::exp(-0.05 * t) * std::cos(6 * t) +
                       second * std::cos(6.8 * t) + third_harmonic * std::cos(15 * t) + noise);
  }
  const LawFit fit = fit_law(record.record(), {.drive = Drive::harmonic(), .drive_frequency = 5.0});
  EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  return in_words(driven_doubts(record.record(), fit, residuals_of(fit, record.record()), 5, true, "m"));
}

TEST(Doubts, WhatADrivenLawLeavesIsNamed) {
  EXPECT_THAT(driven_doubts_about(0.01, 0, 0),
              ElementsAre(testing::AllOf(HasSubstr("oscillates at 1.08"), HasSubstr("another drive")),
                          HasSubstr("the law viscous does not describe this recording")));
  EXPECT_THAT(driven_doubts_about(0, 0.002, 0), testing::Contains(HasSubstr("3 times the drive's")));
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (const double correlation : {0.0, 0.95})
      EXPECT_THAT(driven_doubts_about(0, 0, correlation, seed), IsEmpty()) << seed << ' ' << correlation;
}

TEST(Doubts, AWideningThatIsNoneIsNotSaid) {
  LawFit fit;
  fit.residual = {.rms = 1, .normality = 0, .autocorrelation = 0.99, .white = false};
  fit.independent_samples = 3000;
  EXPECT_THAT(in_words(widening(fit, 3000)), HasSubstr("of frequency and decay are hardly widened"));
  fit.independent_samples = 100;
  EXPECT_THAT(in_words(widening(fit, 3000)), HasSubstr("those of 100 independent samples"));
  // Where neighbours show nothing, the distance that does is named.
  fit.residual = {.autocorrelation = -0.036,
                  .autocorrelation_error = 0.0183,
                  .strongest_lag = 7,
                  .strongest = 0.11,
                  .white = false};
  EXPECT_THAT(in_words(widening(fit, 3000)), HasSubstr("are correlated (0.110 at a lag of 7 samples): the"));
  fit.residual.autocorrelation = -0.037;  // beyond two standard errors
  EXPECT_THAT(in_words(widening(fit, 3000)), HasSubstr("are correlated (-0.037 from sample to sample): the"));
  fit.residual.white = true;
  EXPECT_EQ(in_words(widening(fit, 3000)), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
