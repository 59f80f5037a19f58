#include "cromer/identify/least_squares/rounding_bias.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

TEST(RoundingBias, TheExpectedErrorIsTheMeanOverTheNoise) {
  std::mt19937_64 engine(1);
  for (const double noise : {0.02, 0.1, 0.2, 0.4}) {
    for (const double value : {0.0, 0.2, 0.45, 3.7}) {
      std::normal_distribution<double> normal(0, noise);
      double sum = 0;
      constexpr int count = 100'000;
      for (int i = 0; i < count; ++i) sum += std::round(value + normal(engine)) - value;
      EXPECT_NEAR(expected_rounding_error(value, noise), sum / count, noise < 0.05 ? 0.02 : 0.008)
          << noise << " " << value;
    }
  }
}

TEST(RoundingBias, FineRoundingIsBlurred) {
  const std::vector<double> residuals{1, -1, 1, -1}, t{0, 1, 2, 3}, y{5, 5, 5, 5};
  EXPECT_TRUE(rounded_motion({t, y, 0}, residuals).empty());
  EXPECT_TRUE(rounded_motion({t, y, 1}, residuals).empty());
  EXPECT_FALSE(rounded_motion({t, y, 4}, residuals).empty());
}

// The root of the mean square of (estimate - truth) / standard error is 1 where the errors are honest.
TEST(RoundingBias, CoarseRoundingWidensTheUncertainties) {
  const double g = 0.03;
  for (const double resolution : {0.01, 0.005}) {
    for (const double amplitude : {0.05, 0.047}) {
      double sum = 0;
      constexpr unsigned seeds = 20;
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        const SyntheticRecord record =
            viscous_record({.w0 = 6, .g = g, .equilibrium = 0.2, .position = amplitude, .velocity = 0},
                           even_times(3000, 0.01), 2e-4, resolution, seed);
        const LawFit fit = fit_law(record.record(), {});
        const double z = (fit.decay_rate().value - g) / fit.decay_rate().standard_error;
        sum += z * z / seeds;
      }
      EXPECT_LT(std::sqrt(sum), 1.2) << resolution << " " << amplitude;
    }
  }
}

}  // namespace
}  // namespace cromer::core
