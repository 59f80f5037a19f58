// Sweeps of springs with hysteretic damping.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/sweep/sweep.h"
#include "tests/tasks/sweep_options.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;

SweepOptions spring_with(const Values& values) {
  return options_with(with(
      {{"mass", "2"}, {"stiffness", "50"}, {"drive-amplitude", "3"}, {"drive-frequency", "1:9:17"}}, values));
}

TEST(SweepLossFactor, MeetsTheComplexStiffness) {
  const auto result = sweep(spring_with({{"loss-factor", "0.02,0.1,0.5"}}));
  ASSERT_TRUE(result) << in_words(result.error());
  ASSERT_EQ(result->plan.rows.rows, 51u);
  EXPECT_EQ(in_words(result->plan.way), "closed form");
  EXPECT_EQ(result->plan.method, "exact");
  EXPECT_TRUE(in_words(result->plan.notices).empty());
  for (std::size_t row = 0; row < 51; ++row) {
    const double* r = result->rows.data() + 4 * row;  // loss factor, frequency, amplitude, phase lag
    const std::complex<double> stiffness = 50.0 * std::complex<double>(1, r[0]) - 2.0 * r[1] * r[1];
    EXPECT_NEAR(r[2] / (3 / std::abs(stiffness)), 1, 1e-14) << r[0] << " " << r[1];
    EXPECT_NEAR(r[3], std::arg(stiffness), 1e-14);
  }
}

// At resonance as much as the damping ratio eta/2, and at every frequency the same loss in a cycle: pi eta k
// X^2.
TEST(SweepLossFactor, DampsAtResonanceAsHalfItsDampingRatio) {
  const auto hysteretic = sweep(spring_with({{"loss-factor", "0.1"}}));
  const auto viscous = sweep(spring_with({{"damping-ratio", "0.05"}}));
  ASSERT_TRUE(hysteretic && viscous);
  for (std::size_t row = 0; row < 17; ++row) {
    const double *h = hysteretic->rows.data() + 3 * row, *v = viscous->rows.data() + 3 * row;
    if (h[0] == 5) {
      EXPECT_NEAR(h[1], 3 / (0.1 * 50), 1e-14);
      EXPECT_NEAR(h[1] / v[1], 1, 2e-3);  // of euler-cromer's default step
    }
    const double work_of_the_force = std::numbers::pi * 3 * h[1] * std::sin(h[2]);
    EXPECT_NEAR(work_of_the_force / (std::numbers::pi * 0.1 * 50 * h[1] * h[1]), 1, 1e-12);
  }
}

TEST(SweepLossFactor, IsSaidOfSettledMotionsOfTheLinearLawAlone) {
  for (const char* other : {"damping", "damping-ratio", "cubic", "drag", "friction", "until"})
    EXPECT_THAT(refusal(spring_with({{"loss-factor", "0.1"}, {other, "0.2"}})),
                HasSubstr(std::string("--") + other));
  SweepOptions options = spring_with({{"loss-factor", "0.1"}});
  options.simulate.method = {"rk4"};
  EXPECT_THAT(refusal(options), HasSubstr("--method"));
  options = spring_with({{"loss-factor", "0.1"}});
  options.direction = "up";
  EXPECT_THAT(refusal(options), HasSubstr("--direction"));
  options = spring_with({{"loss-factor", "0.1"}});
  options.measure = {"final"};
  EXPECT_THAT(refusal(options), HasSubstr("final"));
  EXPECT_THAT(refusal(spring_with({{"loss-factor", "-0.1"}})), HasSubstr("--loss-factor"));
  EXPECT_THAT(refusal(spring_with({{"loss-factor", "0.1"}, {"drive-amplitude", ""}})),
              HasSubstr("--loss-factor"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
