// What stands between the steps of a motion, and between the samples of a force.
#include "cromer/identify/motion/path.h"

#include <gtest/gtest.h>

#include "cromer/identify/least_squares/sampling.h"
#include "cromer/identify/motion/motion_system.h"

namespace cromer::core {
namespace CROMER_FILE {

// Any polynomial of fifth degree.
double place(double t) { return 1 + t * (-2 + t * (0.5 + t * (3 + t * (-1.5 + t * 0.7)))); }
double speed(double t) { return -2 + t * (1 + t * (9 + t * (-6 + t * 3.5))); }
double acceleration(double t) { return 1 + t * (18 + t * (-18 + t * 14)); }

TEST(WithinAStep, APolynomialOfFifthDegreeIsItself) {
  constexpr double from = 0.3, h = 0.8;
  DormandPrince::Memory<double> step{};
  step.from = {place(from), speed(from)};
  step.to = {place(from + h), speed(from + h)};
  step.acceleration_from = acceleration(from);
  step.acceleration_to = acceleration(from + h);
  for (const double share : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(displacement_within(step, h, share), place(from + share * h), 1e-13) << share;
    EXPECT_NEAR(velocity_within(step, h, share), speed(from + share * h), 1e-12) << share;
  }
}

std::vector<Stretch> stretches_of(const std::vector<double>& t) { return find_sampling(t).stretches; }

TEST(Sampling, OfEqualStepsIsUniformInPiecesOfABlock) {
  std::vector<double> t;
  for (int i = 0; i < 600; ++i) t.push_back(3 + 0.25 * i);
  const Sampling found = find_sampling(t);
  EXPECT_EQ(found.step, 0.25);
  std::size_t next = 0;
  for (const Stretch& stretch : found.stretches) {
    EXPECT_EQ(stretch.first, next);
    EXPECT_TRUE(stretch.uniform);
    EXPECT_LE(stretch.count, longest_stretch);
    next += stretch.count;
  }
  EXPECT_EQ(next, 600u);
  EXPECT_EQ(found.stretches.size(), 3u);
}

TEST(Sampling, UnevenTimesAreOneStretchAndAGapBeginsAnother) {
  std::vector<double> uneven, gap;
  for (int i = 0; i < 100; ++i) {
    uneven.push_back(i + 0.3 * (i % 3));
    gap.push_back(0.25 * (i < 40 ? i : i + 7));
  }
  ASSERT_EQ(stretches_of(uneven).size(), 1u);
  EXPECT_FALSE(stretches_of(uneven)[0].uniform);
  EXPECT_EQ(stretches_of(uneven)[0].count, 100u);
  const auto both = stretches_of(gap);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].count, 40u);
  EXPECT_EQ(both[1].first, 40u);
  EXPECT_TRUE(both[0].uniform && both[1].uniform);
}

TEST(Sampling, TheMedianStepOfTimesWithAGapIsThatOfMost) {
  EXPECT_EQ(median_step(std::vector<double>{0, 1, 2, 10, 11}), 1);
  EXPECT_EQ(median_step(std::vector<double>{5, 7}), 2);
}

// The difference of two such times is good to 1e-13 only.
TEST(Sampling, TheStepOfEvenTimesIsTheirMeanWhereverTheyBegin) {
  std::vector<double> t;
  for (int i = 0; i <= 1000; ++i) t.push_back(2000 + 0.1 * i);
  EXPECT_NEAR(median_step(t), 0.1, 1e-15);
}

double force_at(double s, BetweenSamples between) {
  static const std::vector<double> samples{1, 3, 2, -1, 0};
  const ForceRecord force{samples, 10, 0.5, between};
  Motion motion;
  motion.force_gain = 2;
  motion.force_offset = 0.25;
  RecordedColumns columns(motion, force, 10, 2);
  columns.prepare(static_cast<std::size_t>(s / 0.5));
  double sum = 0, derivatives[2] = {};
  columns.add(s, sum, derivatives);
  EXPECT_DOUBLE_EQ(sum, 2 * derivatives[0]);
  EXPECT_EQ(derivatives[1], 2);
  return derivatives[0] - 0.25;
}

TEST(RecordedColumns, AreTheForceBetweenItsSamples) {
  for (const double share : {0.0, 0.25, 0.4, 0.75}) {
    EXPECT_NEAR(force_at(0.5 * share, BetweenSamples::linear), 1 + 2 * share, 1e-12) << share;
    EXPECT_NEAR(force_at(1 + 0.5 * share, BetweenSamples::linear), 2 - 3 * share, 1e-12) << share;
    EXPECT_NEAR(force_at(0.5 + 0.5 * share, BetweenSamples::hold), 3, 1e-12) << share;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
