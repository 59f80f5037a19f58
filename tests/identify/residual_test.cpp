#include "cromer/identify/least_squares/residual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace cromer::core {
namespace CROMER_FILE {

std::vector<double> white(std::size_t n, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> r(n);
  for (double& value : r) value = normal(engine);
  return r;
}

// First-order autoregression: rho_l = a^l.
std::vector<double> autoregressive(std::size_t n, double a, unsigned seed) {
  std::vector<double> r = white(n, seed);
  for (std::size_t i = 1; i < n; ++i) r[i] += a * r[i - 1];
  return r;
}

Residual described(const std::vector<double>& r) {
  return describe_residual(r, autocorrelations(r, first_lags(r.size())));
}

TEST(Residual, WhiteNoiseIsCalledWhiteNinetyNineTimesInAHundred) {
  int called_white = 0, called_normal = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Residual residual = described(white(2000, seed));
    called_white += residual.white;
    called_normal += residual.normality > 0.05;
    EXPECT_NEAR(residual.rms, 1, 0.08);
  }
  EXPECT_NEAR(called_white, 396, 7);    // binomial: sd 2
  EXPECT_NEAR(called_normal, 380, 18);  // sd 4.4, and the test is only asymptotically exact
}

TEST(Residual, WhiteNoiseWithGapsIsCalledWhiteAsOften) {
  std::mt19937_64 engine(5);
  for (const double missing : {0.15, 0.5, 0.64}) {
    int called_white = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
      std::vector<double> t;
      for (int i = 0; i < 1000; ++i)
        if (std::uniform_real_distribution<double>(0, 1)(engine) >= missing) t.push_back(0.02 * i);
      const SampleGrid grid = find_grid(t);
      const std::vector<double> r = white(t.size(), seed);
      called_white += describe_residual(r, autocorrelations(r, grid, first_lags(r.size())), grid).white;
    }
    EXPECT_GE(called_white, 192) << missing;
  }
}

TEST(Residual, IndependentNoiseThatIsUnevenIsCalledWhite) {
  const auto loud_at_first = [](double share) { return 1 + 9 * std::exp(-10 * share); };
  const auto loud_at_last = [](double share) { return share > 0.8 ? 5.0 : 1.0; };
  for (const std::function<double(double)>& size :
       {std::function<double(double)>(loud_at_first), std::function<double(double)>(loud_at_last)}) {
    int called_white = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
      std::vector<double> r = white(1000, seed);
      for (std::size_t i = 0; i < r.size(); ++i) r[i] *= size(static_cast<double>(i) / 1000);
      called_white += described(r).white;
    }
    EXPECT_GE(called_white, 194);
  }
}

TEST(Residual, CorrelationIsSeenAcrossGaps) {
  const std::vector<double> all = autoregressive(2000, 0.5, 4);
  std::vector<double> t, r;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i % 7 < 3) t.push_back(0.01 * static_cast<double>(i)), r.push_back(all[i]);
  const SampleGrid grid = find_grid(t);
  const Residual residual = describe_residual(r, autocorrelations(r, grid, first_lags(r.size())), grid);
  EXPECT_FALSE(residual.white);
  EXPECT_NEAR(residual.autocorrelation, 0.5, 4 * residual.autocorrelation_error);
}

TEST(Residual, CorrelationAndSkewnessAreSeen) {
  EXPECT_FALSE(described(autoregressive(2000, 0.2, 1)).white);
  EXPECT_NEAR(described(autoregressive(20000, 0.6, 1)).autocorrelation, 0.6, 0.02);
  std::vector<double> skewed = white(2000, 3);
  for (double& value : skewed) value = std::exp(0.5 * value);
  EXPECT_LT(described(skewed).normality, 1e-6);
}

TEST(Residual, AutocorrelationsByTransformAreTheDirectOnes) {
  const std::vector<double> r = autoregressive(5000, 0.8, 2);
  const auto few = autocorrelations(r, 60), many = autocorrelations(r, 500);
  for (std::size_t l = 0; l <= 60; ++l) EXPECT_NEAR(few[l], many[l], 1e-12);
}

TEST(Residual, FactorIsTheSpectralDensityOfTheNoise) {
  // Of an autoregression with a: (1 - a²)/(1 - 2 a cos w + a²).
  for (double a : {0.0, 0.5, 0.9})
    for (double w : {0.0, 0.1, 0.5}) {
      double mean = 0;
      for (unsigned seed = 0; seed < 20; ++seed)
        mean += correlation_factor(autoregressive(20000, a, seed), w) / 20;
      const double density = (1 - a * a) / (1 - 2 * a * std::cos(w) + a * a);
      EXPECT_NEAR(mean, std::max(1.0, density), 0.12 * std::max(1.0, density)) << a << ' ' << w;
    }
}

TEST(Residual, NothingLeftIsNoCorrelation) {
  const std::vector<double> zeros(100, 0.0);
  EXPECT_EQ(correlation_factor(zeros, 0.1), 1);
  EXPECT_EQ(described(zeros).rms, 0);
  std::vector<double> t;
  for (int i = 0; i < 101; ++i)
    if (i != 50) t.push_back(i);
  EXPECT_EQ(autocorrelations(zeros, find_grid(t), 3), std::vector<double>(4, 0.0));
}

// Twenty pairs at a lag, or it tells nothing.
TEST(Residual, FewSamplesWithAGapAreWhite) {
  const auto rising_with_a_gap = [](int samples) {
    std::vector<double> t, r;
    for (int i = 0; i < samples; ++i) {
      t.push_back(i < 10 ? i : i + 5);
      r.push_back(i);
    }
    const SampleGrid grid = find_grid(t);
    return describe_residual(r, autocorrelations(r, grid, 5), grid);
  };
  for (const int samples : {20, 21}) {
    // 19 and 20 pairs less the one across the gap.
    const Residual residual = rising_with_a_gap(samples);
    EXPECT_TRUE(residual.white);
    EXPECT_EQ(residual.autocorrelation, 0);
    EXPECT_EQ(residual.strongest, 0);
  }
  const Residual residual = rising_with_a_gap(22);
  EXPECT_FALSE(residual.white);
  EXPECT_GT(residual.autocorrelation, 0.5);
  EXPECT_EQ(residual.strongest_lag, 1);
}

TEST(Residual, OneSampleIsNoGrid) {
  const std::vector<double> t{3};
  EXPECT_FALSE(find_grid(t).has_gaps());
  EXPECT_EQ(find_grid(t).step, 1);
  EXPECT_TRUE(find_sampling({}).stretches.empty());
  ASSERT_EQ(find_sampling(t).stretches.size(), 1u);
  EXPECT_EQ(find_sampling(t).stretches[0].count, 1u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
