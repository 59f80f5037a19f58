// Start values by hand: how a part grows, and what it takes along.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/identify/start/start_values.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double w = 6, g = 0.05, h = 0.02;

/// A decaying sinusoid about 0.2, and its phasor from one of its samples on.
struct Decaying {
  std::vector<double> t = even_times(1000, h), y;

  Decaying() {
    for (const double s : t)
      y.push_back(0.2 + std::exp(-g * s) * (0.5 * std::cos(w * s) + 0.3 * std::sin(w * s)));
  }
  Record record() const { return {t, y}; }
  StartValues part(std::size_t first, std::size_t samples, double frequency_error) const {
    StartValues start;
    const double s = t[first], fall = std::exp(-g * s), c = std::cos(w * s), d = std::sin(w * s);
    start.phasor = {w, g, 0.2, fall * (0.5 * c + 0.3 * d), fall * (0.3 * c - 0.5 * d)};
    start.first = first;
    start.samples = samples;
    start.frequency_error = frequency_error;
    return start;
  }
};

void expect_grown(const StartValues& start, std::size_t first, std::size_t samples) {
  const Decaying decaying;
  const StartValues next = grown(decaying.record(), start), expected = decaying.part(first, samples, 0);
  EXPECT_EQ(next.first, first);
  EXPECT_EQ(next.samples, samples);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(next.phasor[i], expected.phasor[i], 1e-9) << i;
}

// Seven times as many more: those behind it, and before it where these are too few.
TEST(Grown, EightfoldOrToTheWholeRecord) {
  const Decaying decaying;
  expect_grown(decaying.part(0, 50, 0), 0, 400);
  expect_grown(decaying.part(600, 50, 0), 600, 400);
  expect_grown(decaying.part(601, 50, 0), 600, 400);
  expect_grown(decaying.part(700, 50, 0), 600, 400);
  expect_grown(decaying.part(50, 500, 0), 0, 1000);
  expect_grown(decaying.part(950, 50, 0), 600, 400);
}

// Between as many cycles as four errors leave open over the part, 8 s.
TEST(Grown, TheFrequencyIsSearchedFor) {
  const Decaying decaying;
  const double cycle = 1 / (400 * h - h);
  for (const double off : {-2.0, -1.0, 1.0, 2.0}) {
    StartValues start = decaying.part(0, 50, 0.6 / 4 * cycle);
    start.phasor[DampedPhasor::angular_frequency] = w + off * cycle;
    // One step to either side.
    const double there = grown(decaying.record(), start).phasor[DampedPhasor::angular_frequency];
    EXPECT_NEAR(there, w + (std::abs(off) < 1.5 ? 0 : off / 2) * cycle, 1e-9) << off;
    start.frequency_error = 1.6 / 4 * cycle;
    EXPECT_NEAR(grown(decaying.record(), start).phasor[DampedPhasor::angular_frequency], w, 1e-9) << off;
    // What is known to half a step is taken as it is, and so is what could not be searched.
    for (const double error : {0.49 / 4 * cycle, 2001.0 / 4 * cycle}) {
      start.frequency_error = error;
      EXPECT_EQ(grown(decaying.record(), start).phasor[DampedPhasor::angular_frequency], w + off * cycle);
    }
  }
}

// x'' + 2 g x' + w² x = pull: of a motion whose velocity and acceleration are given.
TEST(Integrated, RestsWhereTheLawHolds) {
  Motion derivative{.cosine = 3, .sine = 4, .drive_frequency = 5, .position = 0.7, .velocity = -1.1};
  derivative.set_angular_frequency(6);
  derivative.set_decay_rate(0.4);
  const Motion motion = integrated(derivative, 2.5);
  EXPECT_EQ(motion.velocity, 0.7);
  EXPECT_NEAR(motion.position, (2.5 - 2 * 0.4 * 0.7 + 1.1) / 36, 1e-15);
  EXPECT_EQ(motion.angular_frequency(), 6);
  EXPECT_EQ(motion.cosine, 3);
}

// The same motion by its position, its velocity and its acceleration.
TEST(DrivenStart, OfADerivativeIsThatOfTheMotion) {
  Motion motion{.equilibrium = 0.1, .position = 0.5, .velocity = 0.3};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(0.1);
  motion.cosine = 8;
  motion.sine = 3;
  motion.drive_frequency = 4.7;
  const std::vector<double> t = even_times(1500, 0.02);
  for (const int derivative : {0, 1, 2}) {
    const std::vector<double> y = observed_motion(motion, Drive::harmonic(), t, derivative, 0.002);
    const auto start = driven_start({t, y, 0, derivative}, 4.7);
    ASSERT_TRUE(start);
    EXPECT_NEAR(start->angular_frequency(), 6, 0.03) << derivative;
    EXPECT_NEAR(start->drive_frequency, 4.7, 1e-3) << derivative;
    EXPECT_NEAR(start->cosine, 8, 0.4) << derivative;
    EXPECT_NEAR(start->sine, 3, 0.4) << derivative;
    EXPECT_NEAR(start->position, 0.5, 0.06) << derivative;
    EXPECT_NEAR(start->velocity, 0.3, 0.3) << derivative;
    EXPECT_NEAR(start->equilibrium, 0.1, 0.05) << derivative;
  }
}

TEST(DrivenStart, IsNoneOfARecordThatRests) {
  const std::vector<double> t = even_times(100, 0.02), y(100, 0.3);
  EXPECT_FALSE(driven_start({t, y}, {}));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
