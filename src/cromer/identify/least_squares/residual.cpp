#include "cromer/identify/least_squares/residual.h"

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

// Sums of r_i r_(i+l), l up to `lags`, block after block: transforms of a long record would not fit into the
// processor's cache.
std::vector<double> products_by_transform(const std::vector<double>& r, std::size_t lags) {
  std::size_t size = 8;
  while (size < r.size() + lags && size < 8 * lags) size *= 2;
  const std::size_t step = size - lags;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> block(size);
  std::vector<std::complex<double>> own, all, sum(size / 2 + 1);
  const auto transform = [&](std::size_t begin, std::size_t count, auto& to) {
    const auto first = r.begin() + static_cast<std::ptrdiff_t>(begin);
    count = std::min(count, r.size() - begin);
    std::fill(std::copy(first, first + static_cast<std::ptrdiff_t>(count), block.begin()), block.end(), 0.0);
    fft.fwd(to, block);
  };
  for (std::size_t begin = 0; begin < r.size(); begin += step) {
    transform(begin, step, own);
    transform(begin, size, all);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      // Without the check for infinities that * makes.
      const double re = own[k].real() * all[k].real() + own[k].imag() * all[k].imag();
      const double im = own[k].real() * all[k].imag() - own[k].imag() * all[k].real();
      sum[k] += std::complex<double>(re, im);
    }
  }
  fft.inv(block, sum, static_cast<Eigen::Index>(size));
  block.resize(lags + 1);
  return block;
}

// r_i = sum over k of a_k r_(i-k) + white noise.
struct Autoregression {
  std::vector<double> coefficients;  // a_1, a_2, ...
  double innovation = 1;             // variance of that noise over the variance of r

  // Spectral density at an angle [rad per sample], over that of white noise of r's variance.
  double density(double angle) const {
    std::complex<double> response = 1;
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      response -= coefficients[k] * std::polar(1.0, -static_cast<double>(k + 1) * angle);
    return innovation / std::norm(response);
  }

  // Variance of the logarithm of that density, estimated from so many samples: those of the innovation and of
  // the coefficients, whose covariance is the inverse of the Toeplitz matrix of autocovariances times
  // innovation over samples. I. Gohberg & A. Semencul give that inverse as A Aᵀ - B Bᵀ, triangular both.
  double log_variance(double angle, double samples) const {
    const std::size_t p = coefficients.size();
    std::complex<double> response = 1;
    for (std::size_t k = 0; k < p; ++k)
      response -= coefficients[k] * std::polar(1.0, -static_cast<double>(k + 1) * angle);
    std::vector<double> slope(p);
    for (std::size_t k = 0; k < p; ++k)
      slope[k] = 2 * (std::polar(1.0, -static_cast<double>(k + 1) * angle) / response).real();
    double form = 0;
    for (std::size_t j = 0; j < p; ++j) {
      double a = slope[j], b = 0;
      for (std::size_t i = j; i < p; ++i) {
        if (i > j) a -= slope[i] * coefficients[i - j - 1];
        b += slope[i] * coefficients[p - 1 - (i - j)];
      }
      form += a * a - b * b;
    }
    return (2 + form) / samples;
  }
};

// The Yule-Walker solution (Levinson-Durbin recursion) of the best order up to `most` < rho.size().
Autoregression autoregression(const std::vector<double>& rho, std::size_t samples, std::size_t most) {
  const auto n = static_cast<double>(samples);
  Autoregression model, best;
  double least = 0;
  for (std::size_t p = 1; p <= most; ++p) {
    double reflection = rho[p];
    for (std::size_t k = 1; k < p; ++k) reflection -= model.coefficients[k - 1] * rho[p - k];
    reflection /= model.innovation;
    if (!(std::abs(reflection) < 1)) break;  // what is left is predicted to rounding
    const std::vector<double> before = model.coefficients;
    for (std::size_t k = 1; k < p; ++k) model.coefficients[k - 1] -= reflection * before[p - 1 - k];
    model.coefficients.push_back(reflection);
    model.innovation *= 1 - reflection * reflection;
    const double parameters = static_cast<double>(p);
    if (n <= parameters + 2) break;
    const double criterion = n * std::log(model.innovation) + 2 * parameters * n / (n - parameters - 1);
    if (criterion >= least) continue;
    least = criterion;
    best = model;
  }
  return best;
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
  return correlation(r, rho, phase_step).factor;
}

Correlation correlation(std::span<const double> r, const std::vector<double>& rho, double phase_step) {
  const std::size_t most = std::min<std::size_t>(512, r.size() / 4);
  Autoregression model = autoregression(rho, r.size(), std::min(rho.size() - 1, most));
  // An order near the most that was tried may not be enough.
  for (std::size_t tried = rho.size() - 1; tried < most && 4 * model.coefficients.size() > 3 * tried;) {
    tried = std::min(4 * tried, most);
    model = autoregression(autocorrelations(r, tried), r.size(), tried);
  }
  const double n = static_cast<double>(r.size()), factor = std::max(1.0, model.density(phase_step));
  return {factor, std::min(n / factor, 2 / model.log_variance(phase_step, n))};
}

}  // namespace cromer
