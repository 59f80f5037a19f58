#include "cromer/tasks/fit/law_doubt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "cromer/base/number.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/read/recording.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {
namespace CROMER_FILE {

// Five swings at 1 Hz whose amplitude falls from 1 by 0.06 each: by friction, though noise hides it.
FittedRecording of_friction(unsigned seed, const std::string& law) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> noise(0, 0.04);
  std::string bytes = "Time (s),Position (m)\n";
  for (int i = 0; i < 250; ++i) {
    const double t = 0.02 * i;
    bytes += shortest(t) + "," + shortest((1 - 0.06 * t) * std::cos(6.2831853 * t) + noise(engine)) + "\n";
  }
  FitOptions options;
  options.law = law;
  const auto recording = read_recording(bytes, "lab.csv", options.read);
  return fit(*recording, options)->front();
}

TEST(LawDoubt, IsInWhatAllLawsHaveAndNotInTheirTerms) {
  constexpr double at_end = 0.06 / (1 - 0.06 * 5);
  int open = 0, held = 0, held_if_right = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const FittedRecording chosen = of_friction(seed, "auto");
    if (!chosen.says("rival_laws")) continue;
    ++open;
    ASSERT_FALSE(chosen.law_doubts.empty());
    const FittedRecording named_one = of_friction(seed, to_text(chosen.fit.law));
    EXPECT_TRUE(named_one.law_doubts.empty());
    const Parameter *wide = named(chosen.headline, "decay_rate_end"),
                    *narrow = named(named_one.headline, "decay_rate_end");
    ASSERT_TRUE(wide && narrow);
    EXPECT_GT(wide->estimate.standard_error, narrow->estimate.standard_error);
    const std::vector<double> covariance = covariance_with_doubts(chosen);
    const std::size_t n = chosen.fit.names.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double error = chosen.find(chosen.fit.names[i])->standard_error;
      if (covariance[i * n + i] > 0) {
        EXPECT_NEAR(std::sqrt(covariance[i * n + i]) / error, 1, 1e-9);
      }
    }
    if (const Estimate* term = chosen.find("friction")) {
      EXPECT_NEAR(term->standard_error / named_one.find("friction")->standard_error, 1, 0.01);
    }
    held += wide->estimate.low <= at_end && at_end <= wide->estimate.high;
    held_if_right += narrow->estimate.low <= at_end && at_end <= narrow->estimate.high;
  }
  EXPECT_GT(open, 25);
  EXPECT_GT(held, 0.9 * open);
  EXPECT_GE(held, held_if_right + 5);
}

// Whether the little viscous damping beside a hysteretic force is there the record does not tell; the drive
// by the law without it is too weak.
TEST(LawDoubt, IsInTheDriveOfAHystereticSwing) {
  Motion motion{.law = law_of("viscous+hysteresis")};
  motion.per_mass.stiffness = 31.0;
  motion.per_mass.damping = 0.2;
  motion.per_mass.hysteresis_stiffness = 28.6;
  motion.per_mass.hysteresis_beta = 5.44;
  motion.per_mass.hysteresis_gamma = 0.84;
  motion.sine = 4.32;
  motion.drive_frequency = 8.829;
  std::vector<double> t;
  for (int i = 0; i <= 3000; ++i) t.push_back(0.02 * i);
  const std::vector<double> y = observed_motion(motion, Drive::harmonic(), t, 0, 0.001);
  int without = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> noise(0, 0.0011);
    std::string bytes = "Time (s),Position (m)\n";
    for (std::size_t i = 0; i < t.size(); ++i)
      bytes += shortest(t[i]) + "," + shortest(y[i] + noise(engine)) + "\n";
    FitOptions options;
    options.mass = {Quantity{1, 0}};
    const auto recording = read_recording(bytes, "lab.csv", options.read);
    const FittedRecording found = fit(*recording, options)->front();
    ASSERT_TRUE(found.fit.law.has<Hysteresis>()) << to_text(found.fit.law);
    without += !found.fit.law.has<Viscous>();
    EXPECT_EQ(found.says("rival_laws_of_a_fed_swing"), !found.fit.law.has<Viscous>());
    for (const auto& [name, truth] : {std::pair{"drive_force", 4.32}, std::pair{"stiffness", 31.0}}) {
      const Estimate* number = found.find(name);
      ASSERT_TRUE(number);
      EXPECT_NEAR(number->value, truth, 3 * number->standard_error) << name;
      EXPECT_LT(number->standard_error, 0.1 * truth) << name;
    }
  }
  EXPECT_GT(without, 0);
}

double of_frequency(const std::vector<LawDoubt>& doubts) {
  const auto found = std::find_if(doubts.begin(), doubts.end(),
                                  [](const LawDoubt& each) { return each.name == "angular_frequency"; });
  return found == doubts.end() ? 0 : found->by;
}

// As that of terms that are not sure, or that feed the swing.
TEST(LawDoubt, OfALawThatIsFarLikelierIsItsDifference) {
  FittedRecording result;
  result.series.quantity = "position";
  result.series.t = {0, 10};
  LawFit& fit = result.fit;
  fit.status = FitStatus::converged;
  fit.law = law_of("viscous");
  fit.names = {"angular_frequency", "decay_rate", "equilibrium", "position", "velocity"};
  fit.estimates = {make_estimate(6, 0.01, 2), make_estimate(0.1, 0.01, 2), {}, make_estimate(1, 0.1, 2), {}};
  fit.covariance.assign(25, 0);
  fit.fitted = 5;
  fit.motion.law = fit.law;
  fit.motion.set_angular_frequency(6);
  LawFit other = fit;
  other.law = law_of("friction");
  other.bic = -5000;
  other.motion.set_angular_frequency(6.2);
  other.estimates[0].value = 6.2;
  const std::vector<LawDoubt> doubts = law_doubts(result, {fit, other});
  // Of small swings no less than of the swing itself, whose damping is another here.
  const double apart = 6.2 - std::sqrt(6.0 * 6.0 - 0.1 * 0.1);
  EXPECT_NEAR(of_frequency(doubts), apart, 1e-4);
  EXPECT_TRUE(law_doubts(result, {fit}).empty());
  // It fades as the evidence against it grows.
  const auto at = [&](double against) {
    other.bic = fit.bic + against;
    return of_frequency(law_doubts(result, {fit, other}));
  };
  EXPECT_NEAR(at(0), apart / std::sqrt(2), 1e-12);
  EXPECT_NEAR(at(6.01) / at(5.99), 1, 0.02);
  EXPECT_GT(at(7.9), 0);
  EXPECT_EQ(at(8), 0);
  // The spring beside a hysteretic force does not tell how fast small swings are.
  other.law = law_of("friction+hysteresis");
  EXPECT_EQ(at(0), 0);
}

// Bends of a spring are the first terms of a series: the last one shows how far the rest may go.
TEST(LawDoubt, OfASpringOfThreeBendsIsWhatTheLastOneChanged) {
  FittedRecording result;
  result.series.quantity = "position";
  result.series.t = {0, 10};
  const auto with = [](const std::string& law, double w, double bic) {
    LawFit fit;
    fit.status = FitStatus::converged;
    fit.law = law_of(law);
    fit.names = {"angular_frequency", "decay_rate"};
    fit.estimates = {make_estimate(w, 0.01, 2), make_estimate(0.1, 0.01, 2)};
    fit.covariance.assign(4, 0);
    fit.fitted = 3 + fit.law.size();
    fit.bic = bic;
    fit.motion.law = fit.law;
    fit.motion.set_angular_frequency(w);
    return fit;
  };
  const LawFit chosen = with("viscous+cubic+quadratic+odd-quadratic", 6, 0),
               closest = with("viscous+cubic+odd-quadratic", 6.03, 40),
               farther = with("viscous+cubic+quadratic", 6.5, 90), two = with("viscous+cubic", 6.9, 400);
  result.fit = chosen;
  EXPECT_NEAR(of_frequency(law_doubts(result, {two, farther, closest, chosen})), 0.03, 1e-9);
  EXPECT_TRUE(law_doubts(result, {two, chosen}).empty());
  result.fit = closest;
  EXPECT_TRUE(law_doubts(result, {two, closest}).empty());
}

TEST(LawDoubt, OfTheQualityFactorIsThatOfTheDampingRatio) {
  std::vector<Parameter> numbers{{"damping_ratio", {0.005, 0.0003, 0.0044, 0.0056}, "1"},
                                 {"quality_factor", {100, 6, 88, 112}, "1"}};
  add_doubts(numbers, {{"damping_ratio", 0.0012}, {"quality_factor", 40}});
  const Estimate &zeta = numbers[0].estimate, &quality = numbers[1].estimate;
  EXPECT_NEAR(quality.standard_error / quality.value, zeta.standard_error / zeta.value, 1e-12);
  EXPECT_NEAR(quality.low, 1 / (2 * zeta.high), 1e-9);
  EXPECT_NEAR(quality.high, 1 / (2 * zeta.low), 1e-9);
}

TEST(LawDoubt, OfAnEndIsWhatItsStretchSaysBeyondTwoErrors) {
  const auto stretch = [](double rate, double by_the_law) {
    return AmplitudeRate{0, 0, 1, make_estimate(rate, 0.002, 2), {}, by_the_law, 0};
  };
  std::vector<LawDoubt> doubts;
  add_doubts_of_stretches(doubts, {stretch(0.083, 0.080), stretch(0.07, 0.07), stretch(0.055, 0.060)});
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_EQ(doubts[0].name, "decay_rate_end");
  EXPECT_NEAR(doubts[0].by, 0.003, 1e-12);  // 5 off, 4 seen by chance
  // With what rival laws say.
  doubts = {{"decay_rate_end", 0.004}};
  add_doubts_of_stretches(doubts, {stretch(0.08, 0.08), stretch(0.07, 0.07), stretch(0.055, 0.060)});
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_NEAR(doubts[0].by, 0.005, 1e-12);
  // One rate, or two stretches, say nothing of ends.
  doubts.clear();
  add_doubts_of_stretches(doubts, {stretch(0.08, 0.06), stretch(0.06, 0.06), stretch(0.05, 0.06)});
  add_doubts_of_stretches(doubts, {stretch(0.09, 0.08), stretch(0.05, 0.06)});
  EXPECT_TRUE(doubts.empty());
}

TEST(LawDoubt, WidensAnIntervalAsItIs) {
  const std::vector<LawDoubt> doubts{{"frequency", 0.4}};
  const Parameter wide = with_doubt({"frequency", {2, 0.3, 1.4, 2.9}, "Hz"}, doubts);
  EXPECT_DOUBLE_EQ(wide.estimate.value, 2);
  EXPECT_DOUBLE_EQ(wide.estimate.standard_error, 0.5);
  EXPECT_DOUBLE_EQ(wide.estimate.low, 1);
  EXPECT_DOUBLE_EQ(wide.estimate.high, 3.5);
  EXPECT_EQ(with_doubt({"frequency", {2, 0.3, 0, 2.9}, "Hz"}, doubts).estimate.low, 0);
  EXPECT_EQ(with_doubt({"frequency", {2, 0.3, 0.9, 2.9}, "Hz"}, {{"frequency", 1}}).estimate.low, 0);
  EXPECT_DOUBLE_EQ(with_doubt({"drag", {2, 0.3, 1.4, 2.9}, ""}, doubts).estimate.high, 2.9);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
