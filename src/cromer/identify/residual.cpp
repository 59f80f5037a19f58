#include "cromer/identify/residual.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace cromer {
namespace {

// Sum of a[i] b[i] in eight strands.
double dot(const double* a, const double* b, std::size_t n) {
  constexpr std::size_t lanes = 8;
  double sum[lanes]{};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes)
    for (std::size_t l = 0; l < lanes; ++l) sum[l] += a[i + l] * b[i + l];
  double total = 0;
  for (; i < n; ++i) total += a[i] * b[i];
  for (double strand : sum) total += strand;
  return total;
}

std::vector<double> centred(std::span<const double> r) {
  double mean = 0;
  for (double value : r) mean += value;
  mean /= static_cast<double>(r.size());
  std::vector<double> result(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) result[i] = r[i] - mean;
  return result;
}

std::vector<double> products_by_transform(const std::vector<double>& r, std::size_t lags) {
  std::size_t padded = 8;
  while (padded < r.size() + lags + 1) padded *= 2;
  std::vector<double> extended(r);
  extended.resize(padded, 0.0);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, extended);
  for (auto& value : transform) value = std::norm(value);
  fft.inv(extended, transform, static_cast<Eigen::Index>(padded));
  extended.resize(lags + 1);
  return extended;
}

}  // namespace

std::vector<double> autocorrelations(std::span<const double> r, std::size_t lags) {
  const std::vector<double> c = centred(r);
  std::vector<double> rho(lags + 1);
  constexpr std::size_t most_direct = 64;
  if (lags > most_direct) {
    rho = products_by_transform(c, lags);
  } else {
    for (std::size_t l = 0; l <= lags; ++l) rho[l] = dot(c.data(), c.data() + l, c.size() - l);
  }
  const double variance = rho[0];
  for (double& value : rho) value = variance > 0 ? value / variance : 0;
  rho[0] = 1;
  return rho;
}

std::size_t first_lags(std::size_t samples) { return std::min<std::size_t>(32, samples / 2); }

Residual describe_residual(std::span<const double> r) {
  return describe_residual(r, autocorrelations(r, first_lags(r.size())));
}

Residual describe_residual(std::span<const double> r, const std::vector<double>& rho) {
  Residual result;
  const auto n = static_cast<double>(r.size());
  result.rms = std::sqrt(dot(r.data(), r.data(), r.size()) / n);

  const std::vector<double> c = centred(r);
  double m2 = 0, m3 = 0, m4 = 0;
  for (double value : c) {
    const double square = value * value;
    m2 += square;
    m3 += square * value;
    m4 += square * square;
  }
  m2 /= n;
  m3 /= n;
  m4 /= n;
  if (m2 > 0) {
    const double skewness = m3 / (m2 * std::sqrt(m2)), excess = m4 / (m2 * m2) - 3;
    // The statistic is chi-squared with two degrees of freedom, whose tail is exponential.
    result.normality = std::exp(-0.5 * n / 6 * (skewness * skewness + 0.25 * excess * excess));
  }

  const std::size_t lags = std::min<std::size_t>(20, rho.size() - 1);
  if (lags == 0) return result;
  result.autocorrelation = rho[1];
  double q = 0;
  for (std::size_t l = 1; l <= lags; ++l) q += rho[l] * rho[l] / (n - static_cast<double>(l));
  q *= n * (n + 2);
  // 99 % quantile of chi-squared, Wilson & Hilferty, PNAS 17, 684 (1931); at 20 degrees of freedom 37.57
  // (tables: 37.566).
  const auto k = static_cast<double>(lags);
  const double root = 1 - 2 / (9 * k) + 2.326348 * std::sqrt(2 / (9 * k));
  result.white = q <= k * root * root * root;
  return result;
}

double correlation_factor(std::span<const double> r, double phase_step) {
  return correlation_factor(r, autocorrelations(r, first_lags(r.size())), phase_step);
}

double correlation_factor(std::span<const double> r, const std::vector<double>& rho, double phase_step) {
  const std::size_t most = r.size() / 2;
  std::vector<double> longer;
  const std::vector<double>* lagged = &rho;
  for (;;) {
    const std::size_t lags = lagged->size() - 1;
    double sum = 1;
    for (std::size_t l = 1; l <= lags; ++l) {
      sum += 2 * (*lagged)[l] * std::cos(static_cast<double>(l) * phase_step);
      if (static_cast<double>(l) >= 5 * std::max(1.0, sum)) return std::max(1.0, sum);
    }
    if (lags >= most) return std::max(1.0, sum);
    longer = autocorrelations(r, lags < 64 ? std::min<std::size_t>(2048, most) : most);
    lagged = &longer;
  }
}

}  // namespace cromer
