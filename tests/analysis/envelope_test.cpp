#include "cromer/analysis/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cromer {
namespace {

TEST(Envelope, follows_the_amplitude_of_a_decaying_swing) {
  std::vector<double> t, x;
  for (int i = 0; i <= 4000; ++i) {
    t.push_back(0.01 * i);
    x.push_back(2 * std::exp(-0.05 * t.back()) * std::cos(6 * t.back()));
  }
  const Envelope found = envelope(t, x);
  // 40 s hold 38.2 periods; the release at t = 0 is a turning point.
  ASSERT_EQ(found.top.size(), 39u);
  ASSERT_EQ(found.bottom.size(), 38u);
  EXPECT_EQ(found.top_t.front(), 0);
  for (std::size_t i = 0; i < found.top.size(); ++i) {
    // A turning point lies atan(0.05/6) of phase before the touching point; its height is exact to cos of
    // that.
    EXPECT_NEAR(found.top[i], 2 * std::exp(-0.05 * found.top_t[i]), 1e-4) << found.top_t[i];
    EXPECT_NEAR(found.top_t[i], (2 * M_PI * static_cast<double>(i) - (i > 0 ? std::atan(0.05 / 6) : 0)) / 6,
                1e-5);
  }
  for (std::size_t i = 0; i < found.bottom.size(); ++i)
    EXPECT_NEAR(found.bottom[i], -2 * std::exp(-0.05 * found.bottom_t[i]), 1e-4);
}

TEST(Envelope, too_few_samples_have_none) {
  const std::vector<double> two{0, 1};
  EXPECT_TRUE(envelope(two, two).top.empty());
}

TEST(Interpolate, between_and_beyond) {
  const std::vector<double> at{1, 2, 4}, values{10, 20, 0};
  EXPECT_EQ(interpolate(at, values, 0), 10);
  EXPECT_EQ(interpolate(at, values, 1.5), 15);
  EXPECT_EQ(interpolate(at, values, 3), 10);
  EXPECT_EQ(interpolate(at, values, 9), 0);
}

}  // namespace
}  // namespace cromer
