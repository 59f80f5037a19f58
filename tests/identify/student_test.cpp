#include "cromer/identify/student.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cromer {
namespace {

// For one and two degrees of freedom the distribution has a closed form.
TEST(Student, MeetsItsClosedForms) {
  for (const double t : {-300.0, -20.0, -3.0, -1.0, -0.1, -1e-5}) {
    const double one = std::atan2(1, -t) / std::numbers::pi;
    const double root = std::sqrt(2 + t * t), two = 1 / (root * (root - t));
    EXPECT_NEAR(student_cdf(t, 1) / one, 1, 1e-13) << t;
    EXPECT_NEAR(student_cdf(t, 2) / two, 1, 1e-13) << t;
    EXPECT_NEAR(student_cdf(-t, 1), 1 - one, 1e-15) << t;
  }
  EXPECT_EQ(student_cdf(0, 7), 0.5);
}

// Quantiles to ten digits, by R 4.2: qt(0.975, n) and qt(0.9999, n).
TEST(Student, MeetsPublishedQuantiles) {
  EXPECT_NEAR(student_quantile(0.975, 1), 12.7062047362, 1e-9);
  EXPECT_NEAR(student_quantile(0.975, 2), 4.30265272991, 1e-10);
  EXPECT_NEAR(student_quantile(0.975, 5), 2.57058183564, 1e-10);
  EXPECT_NEAR(student_quantile(0.975, 10), 2.22813885196, 1e-10);
  EXPECT_NEAR(student_quantile(0.975, 30), 2.04227245630, 1e-10);
  EXPECT_NEAR(student_quantile(0.975, 120), 1.97993040508, 1e-10);
  EXPECT_NEAR(student_quantile(0.975, 1e12), 1.95996398454, 1e-6);
}

TEST(Student, QuantileAndProbabilityUndoEachOther) {
  for (const double degrees : {1.0, 1.3, 2.7, 8.0, 33.3, 79.9, 80.1, 1234.5, 1e5})
    for (const double p : {0.5, 0.6, 0.975, 0.9999})
      EXPECT_NEAR(1 - student_cdf(student_quantile(p, degrees), degrees), 1 - p, 1e-10 * (1 - p) + 2e-16)
          << p << " of " << degrees;
}

}  // namespace
}  // namespace cromer
