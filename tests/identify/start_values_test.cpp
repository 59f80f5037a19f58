// Where a fit begins, and that it then ends at the truth: records with gaps, and swings whose frequency
// changes.
#include "cromer/identify/start/start_values.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double w0 = 6, period = two_pi / w0;

using Engine = std::mt19937_64;

double uniform(Engine& engine, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine);
}

// What is recorded of samples, 50 in a period: a motion of 40 periods that falls by exp(-folds).
struct Gappy {
  double folds = 0;        // of the motion's fall
  double noise = 0;        // of its first amplitude
  double correlation = 0;  // of the noise, from one sample to the next
};

SyntheticRecord gappy_record(const Gappy& gappy, const std::vector<bool>& kept, Engine& engine) {
  const double h = period / 50, A = 0.05, g = gappy.folds / (h * static_cast<double>(kept.size()));
  const double phase = uniform(engine, 0, two_pi);
  const SyntheticRecord all = viscous_record(
      {.w0 = w0, .g = g, .position = A * std::cos(phase), .velocity = A * w0 * std::sin(phase)},
      even_times(kept.size(), h));
  const double fresh = std::sqrt(1 - gappy.correlation * gappy.correlation);
  std::normal_distribution<double> normal;
  SyntheticRecord record;
  double noise = normal(engine);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    noise = gappy.correlation * noise + fresh * normal(engine);
    if (!kept[i]) continue;
    record.t.push_back(all.t[i]);
    record.y.push_back(all.y[i] + gappy.noise * A * noise);
  }
  return record;
}

std::vector<bool> every(double recorded, double of, std::size_t samples = 2000) {
  std::vector<bool> kept(samples);
  for (std::size_t i = 0; i < samples; ++i)
    kept[i] = std::fmod(static_cast<double>(i) / 50, of) < recorded - 1e-9;
  return kept;
}

std::vector<bool> without_blocks(std::size_t blocks, std::size_t length, Engine& engine) {
  std::vector<bool> kept(2000, true);
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto first = static_cast<std::size_t>(uniform(engine, 0, static_cast<double>(2000 - length)));
    std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(first), length, false);
  }
  return kept;
}

void expect_frequency(const SyntheticRecord& record) {
  const LawFit fit = fit_law(record.record(), {});
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_NEAR(fit.angular_frequency().value, w0, 5 * fit.angular_frequency().standard_error + 1e-9);
  EXPECT_LT(fit.angular_frequency().standard_error, 0.01 * w0);
}

constexpr Gappy conditions[] = {{},
                                {.noise = 0.1},
                                {.folds = 2, .noise = 0.1},
                                {.folds = 4, .noise = 0.05},
                                {.noise = 0.2, .correlation = 0.9},
                                {.folds = 1, .noise = 0.2, .correlation = 0.9}};

TEST(StartValues, PeriodsMissingOverAndOver) {
  constexpr double patterns[][2] = {{1, 2}, {1, 3}, {1, 4}, {1, 5},   {2, 3},
                                    {2, 4}, {2, 5}, {3, 5}, {0.5, 1}, {0.7, 1.9}};
  for (const auto& [recorded, of] : patterns)
    for (std::size_t c = 0; c < std::size(conditions); ++c) {
      SCOPED_TRACE(testing::Message() << recorded << " of " << of << ", condition " << c);
      Engine engine(c + 1);
      expect_frequency(gappy_record(conditions[c], every(recorded, of), engine));
    }
}

TEST(StartValues, BlocksMissing) {
  for (std::size_t c = 0; c < std::size(conditions); ++c)
    for (unsigned seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", condition " << c);
      Engine engine(seed);
      const std::vector<bool> three = without_blocks(3, 333, engine), ten = without_blocks(10, 140, engine);
      for (const auto& kept : {three, ten}) expect_frequency(gappy_record(conditions[c], kept, engine));
    }
}

TEST(StartValues, SamplesMissingAtRandom) {
  for (const double share : {0.5, 0.1})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", share " << share);
      Engine engine(seed);
      std::vector<bool> kept(2000);
      for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = uniform(engine, 0, 1) < share;
      expect_frequency(gappy_record({.folds = 1, .noise = 0.1}, kept, engine));
    }
}

// Every whole number of cycles in the gap fits nearly as well: only the least squares of both parts tell.
TEST(StartValues, TwoPartsFarApart) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Engine engine(seed);
    std::vector<bool> kept(2000, true);
    std::fill(kept.begin() + 300, kept.begin() + 1700, false);
    expect_frequency(gappy_record({.noise = 0.02}, kept, engine));
  }
}

bool names_another(const LawFit& fit) {
  return std::any_of(fit.notices.begin(), fit.notices.end(),
                     [](const Notice& each) { return each.code == "periods_in_gaps_unsure"; });
}

// Two modes of one size are two swings: no period is lost where there is no gap.
TEST(StartValues, OfTwoModesWithoutAGapNoPeriodIsLost) {
  Engine engine(3);
  std::normal_distribution<double> noise(0, 1e-3);
  std::vector<double> t, y;
  for (int i = 0; i < 1000; ++i) {
    const double at = 0.02 * i;
    t.push_back(at);
    y.push_back(0.05 * (std::cos(6 * at) + std::cos(7 * at) + std::cos(11.3 * at)) + noise(engine));
  }
  EXPECT_FALSE(names_another(fit_law({t, y}, {})));
}

// In strong noise the count of cycles between two parts may be lost, but not silently.
TEST(StartValues, AnotherFrequencyThatFitsAsWellIsNamed) {
  int named = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Engine engine(seed);
    std::vector<bool> kept(6000, true);
    std::fill(kept.begin() + 200, kept.begin() + 5800, false);
    const SyntheticRecord noisy = gappy_record({.noise = 0.5}, kept, engine);
    const LawFit fit = fit_law(noisy.record(), {});
    if (fit.status != FitStatus::converged) continue;
    const bool right =
        std::abs(fit.angular_frequency().value - w0) < 5 * fit.angular_frequency().standard_error;
    named += names_another(fit);
    EXPECT_TRUE(right || names_another(fit)) << fit.angular_frequency().value;
    const SyntheticRecord clear = gappy_record({.noise = 0.02}, kept, engine);
    EXPECT_FALSE(names_another(fit_law(clear.record(), {})));
  }
  EXPECT_GT(named, 5);
}

// Long records, of which only a part is searched: the count of cycles must hold across the gaps beyond it.
TEST(StartValues, GapsBeyondTheFirstPart) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Engine engine(seed);
    std::vector<bool> kept(400'000, false);
    for (const std::size_t first : {0u, 150'000u, 390'000u}) std::fill_n(kept.begin() + first, 9000, true);
    expect_frequency(gappy_record({.noise = 0.5}, kept, engine));
  }
}

// A few samples long before the recording, as a logger's trigger leaves them.
TEST(StartValues, RecordBeginsWithAFewSamplesFarAhead) {
  Engine engine(3);
  std::vector<bool> kept(200'000, false);
  std::fill_n(kept.begin(), 12, true);
  std::fill(kept.end() - 3000, kept.end(), true);
  expect_frequency(gappy_record({.noise = 0.02}, kept, engine));
}

// A pendulum released so far that its frequency rises by half and more as it fades: no sinusoid keeps step.
SyntheticRecord large_swing(double amplitude, double periods, double folds, unsigned seed) {
  const double T = periods * period;
  const TrueSwing truth{.angular_frequency = w0,
                        .decay_rate = folds / T,
                        .equilibrium = 0.1,
                        .position = amplitude,
                        .pendulum = true};
  SyntheticRecord record{even_times(static_cast<std::size_t>(periods * 40), period / 40), {}, 0};
  Engine engine(seed);
  std::normal_distribution<double> normal(0, 0.005);
  for (const double x : free_motion(truth, record.t, period / 200).x)
    record.y.push_back(truth.equilibrium + x + normal(engine));
  return record;
}

TEST(StartValues, PendulumFromALargeAngle) {
  LawFitOptions options;
  options.law = law_of("viscous+pendulum");
  unsigned seed = 0;
  for (const double amplitude : {1.5, 1.8, 2.2, 2.5, 2.8})
    for (const double periods : {10, 40, 100})
      for (const double folds : {0.0, 0.3, 1.0, 2.0, 4.0}) {
        SCOPED_TRACE(testing::Message() << amplitude << " rad, " << periods << " periods, fall " << folds);
        const SyntheticRecord record = large_swing(amplitude, periods, folds, ++seed);
        const LawFit fit = fit_law(record.record(), options);
        ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
        EXPECT_NEAR(fit.angular_frequency().value, w0, 5 * fit.angular_frequency().standard_error);
        EXPECT_NEAR(fit.position().value, amplitude, 5 * fit.position().standard_error);
        EXPECT_NEAR(fit.residual.rms, 0.005, 0.0007);
      }
}

TEST(StartValues, PendulumFromALargeAngleIsChosen) {
  LawFitOptions options;
  options.angle = true;
  for (const double amplitude : {1.5, 2.2, 2.8})
    for (const double folds : {0.0, 1.0}) {
      SCOPED_TRACE(testing::Message() << amplitude << " rad, fall " << folds);
      const LawFit fit = choose_law(large_swing(amplitude, 40, folds, 9).record(), options).chosen;
      ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
      EXPECT_TRUE(fit.law.has<Pendulum>()) << to_text(fit.law);
      EXPECT_NEAR(fit.angular_frequency().value, w0, 5 * fit.angular_frequency().standard_error);
    }
}

// A swing that does not decay seems to grow a little in every other record: noise is no reason to begin with
// a negative decay rate.
TEST(StartValues, ASwingThatDoesNotDecayIsNotTakenToGrow) {
  Engine engine(3);
  for (int i = 0; i < 20; ++i) {
    const SyntheticRecord record = gappy_record({.noise = 0.02}, std::vector<bool>(2000, true), engine);
    const auto start = find_start_values(record.record());
    ASSERT_TRUE(start);
    EXPECT_GE(start->phasor[DampedPhasor::decay_rate], 0) << i;
    EXPECT_NEAR(start->phasor[DampedPhasor::angular_frequency], w0, 0.01);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
