#include "cromer/record/dialects/steps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cromer::dialects {
namespace {

std::vector<double> times(int samples, double step) {
  std::vector<double> t;
  for (int i = 0; i < samples; ++i) t.push_back(i * step);
  return t;
}

/// Each time stamp off by up to `jitter`, evenly or normally spread.
std::vector<double> jittered(std::vector<double> t, double jitter, bool normal, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> bell(0, jitter);
  std::uniform_real_distribution<double> even(-jitter, jitter);
  for (double& at : t) at += normal ? bell(random) : even(random);
  return t;
}

TEST(Steps, RatesAreRoundWhereTheTimesAre) {
  for (const double rate : {100.0, 50.0, 30.0, 44100.0, 1e6, 0.1, 610.3515625, 12.5})
    EXPECT_EQ(describe_steps(times(3000, 1 / rate)).rate, rate) << rate;
  std::vector<double> summed{0};
  for (int i = 0; i < 3000; ++i) summed.push_back(summed.back() + 0.01);
  EXPECT_EQ(describe_steps(summed).rate, 100);
  EXPECT_LT(describe_steps(summed).jitter, 1e-9);
  EXPECT_EQ(describe_steps(times(3000, 0.01)).jitter, 0);
  // What is not round stays what it is.
  EXPECT_EQ(describe_steps(times(3000, 1 / 99.9876)).rate, 99.9876);
  EXPECT_EQ(describe_steps(times(3000, 0.03)).rate, 33.3333333333);
}

TEST(Steps, JitterIsNoGap) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const bool normal : {false, true}) {
      const Steps steps = describe_steps(jittered(times(3000, 0.01), 0.002, normal, seed));
      EXPECT_TRUE(steps.gaps.empty()) << steps.gaps.size() << " gaps, seed " << seed << (normal ? " n" : "");
      EXPECT_GT(steps.jitter, 0.1);
    }
}

TEST(Steps, AMissingSampleIsAGapAlsoAmongJitter) {
  for (const double jitter : {0.0, 0.001}) {
    std::vector<double> t = times(3000, 0.01);
    for (const int lost : {2500, 1200, 600}) t.erase(t.begin() + lost);
    const auto gaps = describe_steps(jittered(t, jitter, false, 3)).gaps;
    ASSERT_EQ(gaps.size(), 3u) << jitter;
    EXPECT_NEAR(gaps[0].t, 5.99, 0.002);
    EXPECT_NEAR(gaps[0].length, 0.02, 0.003);
  }
}

TEST(Steps, AGapIsNoJitter) {
  std::vector<double> t = times(3000, 0.01);
  t.erase(t.begin() + 500, t.begin() + 800);
  const Steps steps = describe_steps(t);
  EXPECT_EQ(steps.gaps.size(), 1u);
  EXPECT_LT(steps.jitter, 1e-6);
}

TEST(Steps, OneLateSampleIsNoGap) {
  std::vector<double> t = times(100, 0.01);
  t[50] += 0.007;
  EXPECT_TRUE(describe_steps(t).gaps.empty());
  EXPECT_TRUE(describe_steps(std::vector<double>{1}).gaps.empty());
}

}  // namespace
}  // namespace cromer::dialects
