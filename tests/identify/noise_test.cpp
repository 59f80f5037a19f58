#include "cromer/identify/least_squares/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

// A decaying oscillation, its parameters' derivatives a linear model: frequency, decay, equilibrium, both
// phases.
constexpr int size = 5;
constexpr double w = 6, step = 0.02;

struct Model {
  std::vector<double> t, x, v, jacobian;
};

Model model(std::size_t n, const std::function<bool(std::size_t)>& missing) {
  Model result;
  const double g = 1.5 / (step * static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    if (missing(i)) continue;
    const double t = step * static_cast<double>(i), decay = std::exp(-g * t);
    const double x = decay * std::cos(w * t + 0.5), v = -w * decay * std::sin(w * t + 0.5);
    result.t.push_back(t);
    result.x.push_back(x);
    result.v.push_back(v);
    const double row[] = {t * v / w, -t * x, 1, decay * std::cos(w * t), decay * std::sin(w * t)};
    result.jacobian.insert(result.jacobian.end(), std::begin(row), std::end(row));
  }
  return result;
}

Noise noise_of(const std::vector<double>& t, const std::vector<double>& r,
               const std::vector<double>& motion) {
  const SampleGrid grid = find_grid(t);
  return find_noise(grid, r, motion, autocorrelations(r, grid, first_lags(r.size())));
}

bool none(std::size_t) { return false; }
bool half(std::size_t i) { return (i > 150 && i < 350) || (i > 450 && i < 600) || (i > 750 && i < 900); }

// The noise of a sample, given that of an AR(1) process of unit variance, displacement, velocity and a
// deviate.
using MakeNoise = std::function<double(double ar, double x, double v, double deviate)>;

struct Coverage {
  double covered[size]{}, stated[size]{}, scatter[size]{};
  double plain = 0;
};

Coverage coverage(std::size_t n, double memory, const std::function<bool(std::size_t)>& missing,
                  const MakeNoise& make, int trials) {
  Coverage result;
  const Model m = model(n, missing);
  for (int trial = 0; trial < trials; ++trial) {
    std::mt19937_64 engine(static_cast<unsigned>(trial));
    std::normal_distribution<double> normal;
    std::vector<double> noise;
    double ar = normal(engine);
    for (std::size_t i = 0; i < n; ++i) {
      ar = memory * ar + std::sqrt(1 - memory * memory) * normal(engine);
      const double deviate = normal(engine);
      if (!missing(i)) noise.push_back(make(ar, m.x[noise.size()], m.v[noise.size()], deviate));
    }
    NormalEquations sums{.size = size};
    for (std::size_t i = 0; i < noise.size(); ++i)
      sums.add_row(std::span(m.jacobian).subspan(i * size, size), noise[i]);
    const Parameters p = solve(sums).x;
    std::vector<double> r = noise, motion = m.x;
    for (std::size_t i = 0; i < r.size(); ++i)
      for (int a = 0; a < size; ++a) r[i] -= m.jacobian[i * size + static_cast<std::size_t>(a)] * p[a];
    for (std::size_t i = 0; i < r.size(); ++i) motion[i] += noise[i] - r[i];
    const Noise found = noise_of(m.t, r, motion);
    const EstimateNoise estimate = estimate_noise(m.jacobian, size, found);
    result.plain += static_cast<double>(found.is_plain()) / trials;
    for (int a = 0; a < size; ++a) {
      const double error = std::sqrt(estimate.covariance[a][a]);
      result.covered[a] +=
          (std::abs(p[a]) < student_95(estimate.degrees[a]) * error) / static_cast<double>(trials);
      result.stated[a] += estimate.covariance[a][a] / trials;
      result.scatter[a] += p[a] * p[a] / trials;
    }
  }
  return result;
}

// 1200 trials: a standard deviation of 0.6 % of the coverage.
void expect_covered(const Coverage& result) {
  for (int a = 0; a < size; ++a) {
    EXPECT_GT(result.covered[a], 0.93) << a;
    EXPECT_LT(result.covered[a], 0.97) << a;
    EXPECT_NEAR(std::sqrt(result.stated[a] / result.scatter[a]), 1, 0.09) << a;
  }
}

constexpr double sigma = 0.02;

TEST(Noise, IntervalsHoldUnderWhiteNoise) {
  const auto white = [](double, double, double, double deviate) { return sigma * deviate; };
  for (const std::size_t n : {60u, 1000u}) expect_covered(coverage(n, 0, none, white, 1200));
}

TEST(Noise, IntervalsHoldUnderCorrelatedNoise) {
  const auto correlated = [](double ar, double, double, double) { return sigma * ar; };
  for (const double memory : {0.5, 0.9, 0.97}) expect_covered(coverage(1000, memory, none, correlated, 1200));
}

TEST(Noise, IntervalsHoldUnderCorrelatedNoiseWithGaps) {
  const auto correlated = [](double ar, double, double, double) { return sigma * ar; };
  expect_covered(coverage(1000, 0.9, half, correlated, 1200));
  // Half of each period: neighbours over a gap are not neighbours.
  expect_covered(coverage(
      1000, 0.9, [](std::size_t i) { return i % 50 >= 25; }, correlated, 1200));
  std::mt19937 engine(3);
  std::vector<bool> gone(1000);
  for (std::size_t i = 1; i < gone.size(); ++i) gone[i] = engine() % 4 == 0;
  expect_covered(coverage(
      1000, 0.9, [&](std::size_t i) { return gone[i]; }, correlated, 1200));
}

TEST(Noise, IntervalsHoldUnderNoiseThatGrowsWithTheMotion) {
  const auto with_x = [](double, double x, double, double deviate) {
    return (0.002 + 0.05 * std::abs(x)) * deviate;
  };
  expect_covered(coverage(1000, 0, none, with_x, 1200));
  // Samples taken up to some ms early or late.
  const auto late = [](double ar, double, double v, double deviate) {
    return 0.002 * ar + 3e-3 * v * deviate;
  };
  expect_covered(coverage(1000, 0, none, late, 1200));
  const auto both = [](double ar, double x, double, double) { return (0.01 + 0.05 * std::abs(x)) * ar; };
  expect_covered(coverage(1000, 0.9, none, both, 1200));
}

// Of 1200 samples, five times noisier in one part than elsewhere.
TEST(Noise, IntervalsHoldUnderNoiseThatIsLargerAtOneTime) {
  const auto noisy_from = [](double from, double to) {
    return [from, to, i = 0](double, double, double, double deviate) mutable {
      const double place = (i++ % 1200) / 1200.0;
      return sigma * (from < place && place < to ? 1 : 0.2) * deviate;
    };
  };
  for (const auto& [from, to] : {std::pair{0.0, 0.11}, {0.0, 0.5}, {0.5, 1.0}, {0.31, 0.42}})
    expect_covered(coverage(1200, 0, none, noisy_from(from, to), 1200));
}

// An order that Akaike's criterion finds in white noise, in three records of ten, is mostly too weak to
// count.
TEST(Noise, PlainNoiseIsCalledSo) {
  const auto white = [](double, double, double, double deviate) { return sigma * deviate; };
  EXPECT_GT(coverage(12000, 0, none, white, 400).plain, 0.75);
}

TEST(Noise, CovarianceIsThatOfTheModel) {
  // Against the sums over all pairs of samples, with gaps and growing noise.
  const Model m = model(60, [](std::size_t i) { return i > 20 && i < 33; });
  Noise noise;
  noise.samples = m.t.size();
  noise.grid = find_grid(m.t);
  noise.sum_of_squares = 1;
  noise.correlation = {{0.6, 0.2}, 1};
  const std::vector<double> rho = [&] {
    std::vector<double> r(100, 1.0);
    r[1] = 0.6 / (1 - 0.2);
    for (std::size_t l = 2; l < r.size(); ++l) r[l] = 0.6 * r[l - 1] + 0.2 * r[l - 2];
    return r;
  }();
  noise.correlation.innovation = 1 - 0.6 * rho[1] - 0.2 * rho[2];
  for (std::size_t i = 0; i < m.t.size(); ++i) noise.scale.push_back(1 + 0.5 * m.x[i]);
  SquareMatrix matrix{}, spread{};
  const auto n = m.t.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t a = 0; a < size; ++a)
        for (std::size_t b = 0; b < size; ++b) {
          const double product = m.jacobian[i * size + a] * m.jacobian[j * size + b];
          if (i == j) matrix[a][b] += product;
          const auto lag = static_cast<std::size_t>(std::abs(std::lround((m.t[i] - m.t[j]) / step)));
          spread[a][b] += product * noise.scale[i] * noise.scale[j] * rho[lag];
        }
  const SquareMatrix inverse_matrix = inverse(matrix, size);
  SquareMatrix expected{};
  double taken = 0;
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b) {
      for (int c = 0; c < size; ++c)
        for (int d = 0; d < size; ++d)
          expected[a][b] += inverse_matrix[a][c] * spread[c][d] * inverse_matrix[d][b];
      taken += inverse_matrix[a][b] * spread[b][a];
    }
  const double variance = 1 / std::max(static_cast<double>(n) / (size + 1), static_cast<double>(n) - taken);
  const EstimateNoise estimate = estimate_noise(m.jacobian, size, noise);
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b)
      EXPECT_NEAR(estimate.covariance[a][b], variance * expected[a][b],
                  1e-6 * std::sqrt(estimate.covariance[a][a] * estimate.covariance[b][b]));
}

// Of many coefficients by a transform where no degrees of freedom are asked for; with them sample by sample.
TEST(Noise, VariancesOfALongMemoryAreThoseOfTheFilter) {
  const Model m = model(3000, half);
  Noise noise;
  noise.grid = find_grid(m.t);
  noise.samples = m.t.size();
  noise.sum_of_squares = 2;
  noise.correlation.coefficients.assign(90, 0.0);
  noise.correlation.coefficients[0] = 0.6;
  noise.correlation.coefficients[89] = 0.2;
  noise.correlation.innovation = 0.5;
  for (const bool even : {true, false}) {
    for (std::size_t i = 0; i < noise.samples && !even; ++i)
      noise.scale.push_back(0.5 + static_cast<double>(i) / static_cast<double>(noise.samples));
    const SumNoise once = noise_of_sums(m.jacobian, size, noise, false),
                   filtered = noise_of_sums(m.jacobian, size, noise, true);
    for (int a = 0; a < size; ++a)
      EXPECT_NEAR(once.variance[a] / filtered.variance[a], 1, 1e-7) << a << ' ' << even;
  }
}

TEST(Noise, DegreesSayHowWellAVarianceIsKnown) {
  // Of an equilibrium and of a line's phases: the variance of a variance's logarithm is two over its degrees.
  for (const double angle : {0.0, 0.125}) {
    double mean = 0, squares = 0, said = 0;
    constexpr int trials = 400, n = 2000;
    for (int trial = 0; trial < trials; ++trial) {
      std::mt19937_64 engine(static_cast<unsigned>(trial));
      std::normal_distribution<double> normal;
      std::vector<double> t, r, jacobian;
      double ar = normal(engine);
      for (int i = 0; i < n; ++i) {
        ar = 0.9 * ar + normal(engine);
        t.push_back(step * i);
        r.push_back(ar);
        jacobian.push_back(std::cos(angle * i));
        if (angle > 0) jacobian.push_back(std::sin(angle * i));
      }
      const Noise noise = noise_of(t, r, std::vector<double>(r.size()));
      const EstimateNoise estimate = estimate_noise(jacobian, angle > 0 ? 2 : 1, noise);
      const double variance = std::log(estimate.covariance[0][0]);
      mean += variance / trials;
      squares += variance * variance / trials;
      said += 2 / estimate.degrees[0] / trials;
    }
    EXPECT_NEAR(squares - mean * mean, said, 0.35 * said) << angle;
  }
}

TEST(Noise, WhatTheJacobianDoesNotTellIsInfinite) {
  const std::vector<double> t{0, 1, 2, 3, 4, 5}, r{1, -1, 1, -1, 1, -1}, motion(6, 0.0);
  const std::vector<double> jacobian(12, 1.0);
  const EstimateNoise estimate = estimate_noise(jacobian, 2, noise_of(t, r, motion));
  EXPECT_TRUE(std::isinf(estimate.covariance[0][0]));
  EXPECT_TRUE(std::isinf(estimate.covariance[1][1]));
}

TEST(Noise, CorrelationOverGapsIsThatOverTheirSteps) {
  // Half of the samples missing, in blocks much longer than the noise's memory: its density at a line.
  double mean = 0, mean_slow = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::mt19937_64 engine(static_cast<unsigned>(trial));
    std::normal_distribution<double> normal;
    std::vector<double> t, r;
    double ar = normal(engine);
    for (int i = 0; i < 8000; ++i) {
      ar = 0.9 * ar + std::sqrt(1 - 0.81) * normal(engine);
      if (i % 400 < 200) t.push_back(step * i), r.push_back(ar);
    }
    const Autoregression found = noise_of(t, r, std::vector<double>(r.size())).correlation;
    mean += found.density(5 * step) / 40;
    mean_slow += found.density(0) / 40;
  }
  const double density = 0.19 / (1 - 1.8 * std::cos(5 * step) + 0.81);
  EXPECT_NEAR(mean, density, 0.06 * density);
  EXPECT_NEAR(mean_slow, 19, 0.08 * 19);
}

TEST(Noise, TimesThatJitterAreNoGaps) {
  std::vector<double> t;
  for (int i = 0; i < 500; ++i) t.push_back(0.01 * std::round(2.094 * i));
  EXPECT_FALSE(find_grid(t).has_gaps());
  EXPECT_NEAR(find_grid(t).step, 0.02094, 2e-5);
  for (double& each : t) each += each > 3 ? 1 : 0;
  const SampleGrid grid = find_grid(t);
  ASSERT_TRUE(grid.has_gaps());
  EXPECT_NEAR(static_cast<double>(grid.place.back()), 499 + 1 / 0.02094, 1.5);
}

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

}  // namespace CROMER_FILE
}  // namespace cromer::core
