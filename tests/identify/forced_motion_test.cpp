#include "cromer/identify/forced_motion.h"

#include <gtest/gtest.h>

#include "cromer/identify/motion/recorded_force.h"
#include "cromer/identify/motion/sinusoidal_force.h"
#include "tests/identify/forced_truth.h"

namespace cromer {
namespace {

// Half the gradient of the sum of squares, with the sign turned, is what the normal equations hold.
template <class MakeDrive>
void expect_exact_derivatives(const MakeDrive& drive, ForcedTerms terms, const Parameters& p,
                              const ForcedSamples& samples, double h) {
  const NormalEquations at = forced_equations(terms, p, drive(p), samples, h);
  for (int i = 0; i < at.size; ++i) {
    const double d = 1e-5 * std::max(1e-2, std::abs(p[static_cast<std::size_t>(i)]));
    Parameters up = p, down = p;
    up[static_cast<std::size_t>(i)] += d;
    down[static_cast<std::size_t>(i)] -= d;
    const double slope = (forced_equations(terms, up, drive(up), samples, h).sum_of_squares -
                          forced_equations(terms, down, drive(down), samples, h).sum_of_squares) /
                         (2 * d);
    EXPECT_NEAR(at.right[static_cast<std::size_t>(i)], -0.5 * slope, 1e-6 * (1 + std::abs(slope))) << i;
    EXPECT_GT(at.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)], 0) << i;
  }
}

TEST(ForcedMotion, DerivativesByAllParametersAreExact) {
  const auto record = forced_synthetic({}, multisine(40, 1), 200, 0.03, 0.02, 1);
  for (const int derivative : {0, 1, 2}) {
    const ForcedSamples samples{record.t, record.y, derivative};
    const ForcedTerms terms{.drag = true, .curved = true};
    {
      const Parameters p{2.4, 0.1, 0.3, 0.2, 140, 5, 100, 0.1, -0.3};
      const auto drive = [&](const Parameters&) {
        return RecordedForce(record.force, 0.03, 0, ForceBetween::band_limited, 4);
      };
      expect_exact_derivatives(drive, terms, p, samples, 0.03 / 4);
    }
    {
      const Parameters p{2.4, -1, 11, 0.1, 0.3, 0.2, 140, 5, 100, 0.1, -0.3};
      const auto drive = [&](const Parameters& q) { return SinusoidalForce(q[2]); };
      expect_exact_derivatives(drive, terms, p, samples, 0.03 / 4);
    }
  }
}

TEST(ForcedMotion, IsOfFourthOrder) {
  const ForcedTruth truth{.cubic = 200};  // drag's own kink at rest would hide the order
  const auto samples = forced_synthetic({}, multisine(40, 2), 401, 0.05, 0, 2).force;
  const auto record = forced_synthetic(truth, read_between(samples, 0.05, false), 400, 0.05, 0, 2);
  const Parameters p{truth.gain, 0, truth.g, truth.w0 * truth.w0, 0, truth.cubic, 0.1, -0.4};
  const auto motion = [&](int steps) {
    return forced_motion({.curved = true}, p,
                         RecordedForce(record.force, 0.05, 0, ForceBetween::linear, steps), record.t, 0,
                         0.05 / steps);
  };
  const auto rms = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
  };
  const std::vector<double> fine = motion(256);
  EXPECT_LT(rms(fine, record.y), 1e-7);
  const auto error = [&](int steps) { return rms(motion(steps), fine); };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4, 0.1);
}

TEST(RecordedForce, ABlocksEdgeShowsNowhere) {
  std::vector<double> force;
  for (int i = 0; i < 2500; ++i) force.push_back(std::sin(0.7 * i) + 0.3 * std::cos(1.9 * i));
  constexpr int steps = 2;
  const std::vector<double> fine = refine_band_limited(force, 2 * steps);
  RecordedForce drive(force, 1, 100, ForceBetween::band_limited, steps);
  const Parameters p{1};
  for (std::size_t i = 0; i + 1 < 2400; ++i) {
    const auto t = static_cast<double>(i);
    drive.prepare(i, t, 1, steps);
    for (int j = 0; j <= 2 * steps; ++j) {
      double acceleration = 0;
      drive.add_to(p, t + 0.25 * j, acceleration, nullptr);
      ASSERT_NEAR(acceleration, fine[4 * (i + 100) + static_cast<std::size_t>(j)], 1e-14) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace cromer
