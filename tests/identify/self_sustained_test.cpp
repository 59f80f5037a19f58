// Swings that negative damping feeds and van der Pol's term bounds: rising, kept and falling.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/diagnose/doubts.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double decay_rate = -0.1, van_der_pol = 40, limit = 0.1414;  // sqrt(0.8/40)
const Law fed = law_of("viscous+van-der-pol");

struct Swung {
  std::vector<double> t, y;
};

Swung swung_from(double position, unsigned seed) {
  Motion motion{.law = fed, .equilibrium = 0.03, .position = position};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(decay_rate);
  motion.per_mass.van_der_pol = van_der_pol;
  Swung swung{even_times(4000, 0.01), {}};
  swung.y = observed_motion(motion, {}, swung.t, 0, 0.002);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, 1e-3);
  for (double& each : swung.y) each += normal(engine);
  return swung;
}

void expect_truth(const LawFit& fit) {
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_EQ(to_text(fit.law), to_text(fed));
  EXPECT_LT(fit.residual.rms, 1.05e-3);
  EXPECT_NEAR(fit.decay_rate().value, decay_rate, 4 * fit.decay_rate().standard_error);
  EXPECT_NEAR(fit["van_der_pol"].value, van_der_pol, 4 * fit["van_der_pol"].standard_error);
  EXPECT_NEAR(fit.angular_frequency().value, 6, 4 * fit.angular_frequency().standard_error);
}

TEST(SelfSustained, IsFittedWhereverItBegins) {
  for (const double position : {0.003, 0.03, 0.1, limit, 0.2, 0.4})
    for (const unsigned seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(testing::Message() << position << ", seed " << seed);
      const Swung swung = swung_from(position, seed);
      const LawFit fit = fit_law({swung.t, swung.y}, {.law = fed});
      expect_truth(fit);
      EXPECT_LT(fit.decay_rate().standard_error, 0.02);
    }
}

// x'' - 6 mu (1 - x²/a²) x' + 36 x = 0 with a = 1 cm: the stronger, the more it moves in bursts.
TEST(SelfSustained, OfStrongBurstsEveryParameterIsRight) {
  for (const double mu : {0.5, 1.0, 1.5}) {
    Motion motion{.law = fed, .position = 0.002};
    motion.set_angular_frequency(6);
    motion.set_decay_rate(-3 * mu);
    motion.per_mass.van_der_pol = 6 * mu / 1e-4;
    const std::vector<double> t = even_times(800, 0.025), exact = observed_motion(motion, {}, t, 0, 2e-4);
    for (const unsigned seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(testing::Message() << mu << ", seed " << seed);
      std::mt19937_64 engine(seed);
      std::normal_distribution<double> normal(0, 2e-4);
      std::vector<double> y = exact;
      for (double& each : y) each += normal(engine);
      const LawFit fit = fit_law({t, y}, {.law = fed});
      ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
      EXPECT_LT(fit.residual.rms, 2.2e-4);
      EXPECT_NEAR(fit.decay_rate().value, -3 * mu, 4 * fit.decay_rate().standard_error);
      EXPECT_NEAR(fit["van_der_pol"].value, 6 * mu / 1e-4, 4 * fit["van_der_pol"].standard_error);
      EXPECT_NEAR(fit.angular_frequency().value, 6, 4 * fit.angular_frequency().standard_error);
    }
  }
}

TEST(SelfSustained, IsChosen) {
  for (const double position : {0.03, 0.1, 0.4}) {
    SCOPED_TRACE(position);
    const Swung swung = swung_from(position, 4);
    const LawChoice choice = choose_law({swung.t, swung.y}, {});
    expect_truth(choice.chosen);
  }
}

TEST(SelfSustained, MayRise) {
  const Swung swung = swung_from(0.03, 5);
  const LawFit fit = fit_law({swung.t, swung.y}, {.law = fed});
  for (const std::string& sentence : in_words(doubts({swung.t, swung.y}, fit, true, "m")))
    EXPECT_THAT(sentence, testing::Not(testing::HasSubstr("rises")));
}

// A motion of negative damping without a bound, from 2 cm; grown by e^(growth) in all.
Swung growing(Motion motion, double growth, double noise, unsigned seed) {
  motion.position = 0.02;
  motion.set_angular_frequency(6);
  motion.set_decay_rate(-growth / 40);
  Swung swung{even_times(2000, 0.02), {}};
  swung.y = observed_motion(motion, {}, swung.t, 0, 0.002);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, noise);
  for (double& each : swung.y) each += normal(engine);
  return swung;
}

TEST(Growing, IsFoundAsNegativeViscousDamping) {
  for (const double growth : {0.1, 0.8, 4.0})
    for (const unsigned seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(testing::Message() << growth << ", seed " << seed);
      const Swung swung = growing({.law = law_of("viscous")}, growth, 2e-4, seed);
      const LawChoice choice = choose_law({swung.t, swung.y}, {});
      for (const LawFit& fit : {choice.chosen, fit_law({swung.t, swung.y}, {})}) {
        ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
        EXPECT_EQ(to_text(fit.law), "viscous");
        EXPECT_LT(fit.residual.rms, 2.1e-4);
        const Estimate g = fit.decay_rate();
        EXPECT_NEAR(g.value, -growth / 40, 4 * g.standard_error);
        EXPECT_LT(g.high, 0);
        EXPECT_LT(g.standard_error, 2e-4);
        EXPECT_NEAR(fit.angular_frequency().value, 6, 4 * fit.angular_frequency().standard_error);
      }
    }
}

TEST(Growing, OnABentSpring) {
  for (const char* spring : {"viscous+cubic", "viscous+pendulum"}) {
    SCOPED_TRACE(spring);
    Motion motion{.law = law_of(spring)};
    const double rad = 20;  // of a pendulum: from 0.4 to 0.9 rad
    if (motion.law.has<Cubic>()) motion.per_mass.cubic = 1e3;
    Swung swung = growing(motion, 0.8, 2e-5, 4);
    if (motion.law.has<Pendulum>()) {
      motion.position = 0.02 * rad;
      motion.set_angular_frequency(6);
      motion.set_decay_rate(-0.02);
      swung.y = noisy(observed_motion(motion, {}, swung.t, 0, 0.002), 4e-4);
    }
    const LawChoice choice = choose_law({swung.t, swung.y}, {.angle = motion.law.has<Pendulum>()});
    EXPECT_EQ(to_text(choice.chosen.law), spring);
    const Estimate g = choice.chosen.decay_rate();
    EXPECT_NEAR(g.value, -0.02, 4 * g.standard_error);
    EXPECT_LT(g.high, 0);
  }
}

TEST(Growing, IsSaidWithItsRate) {
  const Swung swung = growing({.law = law_of("viscous")}, 0.8, 2e-4, 5);
  const std::vector<std::string> said =
      in_words(doubts({swung.t, swung.y}, fit_law({swung.t, swung.y}, {}), false, "m"));
  ASSERT_EQ(said.size(), 1u);
  EXPECT_THAT(said[0], testing::HasSubstr("grows by itself, at 0.0200"));
}

// What does not grow exponentially is no negative damping: the first half of a beat.
TEST(Growing, OfAnotherShapeIsStillDoubted) {
  Swung swung{even_times(2000, 0.02), {}};
  for (const double t : swung.t)
    swung.y.push_back(0.02 * std::sin(0.5 * 3.1 * (t + 2) / 42) * std::cos(6 * t));
  swung.y = noisy(swung.y, 1e-4);
  const LawFit fit = fit_law({swung.t, swung.y}, {});
  const std::vector<std::string> said = in_words(doubts({swung.t, swung.y}, fit, false, "m"));
  EXPECT_THAT(said, testing::Contains(testing::HasSubstr("something drives or pushes it")));
  EXPECT_THAT(said, testing::Not(testing::Contains(testing::HasSubstr("by itself"))));
}

// Noise alone makes an undamped swing seem to grow in every second record.
TEST(Growing, NeedsToBeSeen) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const SyntheticRecord record = viscous_record({.g = 0}, even_times(2000, 0.02), 1e-3, 0, seed);
    EXPECT_GE(fit_law(record.record(), {}).decay_rate().value, 0) << seed;
  }
}

TEST(SelfSustained, NeedsItsBound) {
  const Swung swung = swung_from(0.03, 6);
  const LawFit fit = fit_law({swung.t, swung.y}, {.law = law_of("viscous+drag")});
  EXPECT_GE(fit.decay_rate().value, 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
