#include "cromer/analysis/fourier.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Fourier, PowersOfTwoAreNotLess) {
  EXPECT_EQ(power_of_two(0), 8u);
  EXPECT_EQ(power_of_two(8), 8u);
  EXPECT_EQ(power_of_two(8.5), 16u);
  EXPECT_EQ(power_of_two(40000), 65536u);
}

// Also of a length that is no power of two, and of one longer than those that are kept; twice, of other
// values.
TEST(Fourier, ATransformIsTheSumsAndTurnsBack) {
  for (const std::size_t n : {8u, 30u, 1024u, 262144u})
    for (const double phase : {0.0, 0.7}) {
      std::vector<double> values(n);
      for (std::size_t j = 0; j < n; ++j)
        values[j] = 0.5 + 3 * std::cos(two_pi * 2 * static_cast<double>(j) / static_cast<double>(n) + phase);
      std::vector<std::complex<double>> sums, all;
      fourier_transform(values, sums);
      ASSERT_EQ(sums.size(), n / 2 + 1);
      const auto half = 0.5 * static_cast<double>(n);
      EXPECT_NEAR(std::abs(sums[0] - half), 0, 1e-12 * half);
      EXPECT_NEAR(std::abs(sums[2] - std::polar(3 * half, phase)), 0, 1e-12 * half);
      EXPECT_NEAR(std::abs(sums[3]), 0, 1e-12 * half);
      fourier_transform(std::vector<std::complex<double>>(values.begin(), values.end()), all);
      ASSERT_EQ(all.size(), n);
      EXPECT_NEAR(std::abs(all[n - 2] - std::conj(sums[2])), 0, 1e-12 * half);
      std::vector<double> back;
      inverse_fourier_transform(sums, n, back);
      ASSERT_EQ(back.size(), n);
      for (std::size_t j = 0; j < n; ++j) ASSERT_NEAR(back[j], values[j], 1e-12);
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
