#include "cromer/identify/least_squares/uncertainty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cromer::core {
namespace CROMER_FILE {

// For one and two degrees of freedom the distribution has a closed form.
TEST(Student, MeetsItsClosedForms) {
  for (const double t : {-300.0, -20.0, -3.0, -1.0, -0.1, -1e-5}) {
    const double one = std::atan2(1, -t) / std::numbers::pi;
    const double root = std::sqrt(2 + t * t), two = 1 / (root * (root - t));
    EXPECT_NEAR(student_cdf(t, 1) / one, 1, 1e-13) << t;
    EXPECT_NEAR(student_cdf(t, 2) / two, 1, 1e-13) << t;
    EXPECT_NEAR(student_cdf(-t, 1), 1 - one, 1e-14) << t;
  }
  EXPECT_EQ(student_cdf(0, 7), 0.5);
}

// tan(pi (p - 1/2)) and (2 p - 1)/sqrt(2 p (1 - p)); and for many degrees z + (z^3 + z)/(4 n), z the normal
// quantile, whose next term is 3/n^2.
TEST(Student, QuantilesMeetTheirClosedForms) {
  for (const double p : {0.6, 0.975, 0.9999}) {
    EXPECT_NEAR(student_quantile(p, 1) / std::tan(std::numbers::pi * (p - 0.5)), 1, 1e-11) << p;
    EXPECT_NEAR(student_quantile(p, 2) / ((2 * p - 1) / std::sqrt(2 * p * (1 - p))), 1, 1e-11) << p;
  }
  constexpr double z = 1.959963984540054;
  for (const double n : {1e4, 1e5, 1e6})
    EXPECT_NEAR(student_quantile(0.975, n), z + (z * z * z + z) / (4 * n), 3 / (n * n) + 1e-10) << n;
}

TEST(Student, IntervalsTakeItsQuantile) {
  for (const double degrees : {1.0, 1.5, 4.0, 30.0, 1000.0, 1e6})
    EXPECT_NEAR(student_95(degrees), student_quantile(0.975, degrees), 1e-11) << degrees;
  // z + (z^3 + z)/(4 degrees), z of the normal distribution
  EXPECT_NEAR(student_95(1e9), 1.959963984540054 + 2.3722712e-9, 1e-8);
}

TEST(Student, QuantileAndProbabilityUndoEachOther) {
  for (const double degrees : {1.0, 1.3, 2.7, 8.0, 33.3, 79.9, 80.1, 1234.5, 1e5})
    for (const double p : {0.5, 0.6, 0.975, 0.9999})
      EXPECT_NEAR(1 - student_cdf(student_quantile(p, degrees), degrees), 1 - p, 1e-10 * (1 - p) + 2e-16)
          << p << " of " << degrees;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
