#include "cromer/identify/least_squares/residual.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "cromer/analysis/fourier.h"
#include "cromer/base/extent.h"

namespace cromer::core {
namespace {

// 1 - sum over k of a_k exp(-i k angle).
std::complex<double> response(const std::vector<double>& coefficients, double angle) {
  std::complex<double> sum = 1;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    sum -= coefficients[k] * std::polar(1.0, -static_cast<double>(k + 1) * angle);
  return sum;
}

}  // namespace

double Autoregression::density(double angle) const {
  return innovation / std::norm(response(coefficients, angle));
}

double Autoregression::log_variance(std::span<const double> slope, double samples) const {
  const std::size_t p = coefficients.size();
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

// The recursion of Levinson and Durbin.
Autoregression yule_walker(std::span<const double> rho, std::size_t samples, std::size_t most) {
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
  const std::size_t size = power_of_two(static_cast<double>(std::min(r.size() + lags, 8 * lags)));
  const std::size_t step = size - lags;
  std::vector<double> block(size);
  std::vector<std::complex<double>> own, all, sum(size / 2 + 1);
  const auto transform = [&](std::size_t begin, std::size_t count, auto& to) {
    const auto first = r.begin() + static_cast<std::ptrdiff_t>(begin);
    count = std::min(count, r.size() - begin);
    std::fill(std::copy(first, first + static_cast<std::ptrdiff_t>(count), block.begin()), block.end(), 0.0);
    fourier_transform(block, to);
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
  inverse_fourier_transform(sum, size, block);
  block.resize(lags + 1);
  return block;
}

// Sums of r_i r_(i+l), l up to `lags`.
std::vector<double> products(const std::vector<double>& r, std::size_t lags) {
  constexpr std::size_t most_direct = 64;
  if (lags > most_direct) return products_by_transform(r, lags);
  std::vector<double> sums(lags + 1);
  for (std::size_t l = 0; l <= std::min(lags, r.size() - 1); ++l)
    sums[l] = dot(r.data(), r.data() + l, r.size() - l);
  return sums;
}

// The values in their places, zeros where there is none.
std::vector<double> placed(const std::vector<double>& values, const SampleGrid& grid) {
  std::vector<double> result(grid.place.back() + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) result[grid.place[i]] = values[i];
  return result;
}

// How many pairs of samples there are at each lag.
std::vector<double> pairs(const SampleGrid& grid, std::size_t lags) {
  return products(placed(std::vector<double>(grid.place.size(), 1.0), grid), lags);
}

// The highest order that samples with gaps can tell: where every second sample still has so many neighbours
// before it. Autocorrelations at several lags, each from other samples, do not go together well enough.
std::size_t longest_memory(const SampleGrid& grid) {
  if (!grid.has_gaps()) return std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> before;  // before[k]: samples with exactly k neighbours before them
  std::size_t run = 0;
  for (std::size_t i = 0; i < grid.place.size(); ++i) {
    run = i > 0 && grid.place[i] - grid.place[i - 1] == 1 ? run + 1 : 0;
    if (run >= before.size()) before.resize(run + 1);
    ++before[run];
  }
  std::size_t order = before.size(), with = 0;
  while (2 * (with += before[order - 1]) < grid.place.size()) --order;
  return std::max<std::size_t>(1, order - 1);
}

}  // namespace

std::vector<double> autocorrelations(std::span<const double> r, std::size_t lags) {
  return autocorrelations(r, {}, lags);
}

std::vector<double> autocorrelations(std::span<const double> r, const SampleGrid& grid, std::size_t lags) {
  std::vector<double> values = centred(r);
  if (!grid.has_gaps()) {
    std::vector<double> rho = products(values, lags);
    const double variance = rho[0];
    for (double& value : rho) value = variance > 0 ? value / variance : 0;
    rho[0] = 1;
    return rho;
  }
  values = placed(values, grid);
  std::vector<double> rho = products(values, lags);
  if (!(rho[0] > 0)) return std::vector<double>(lags + 1, 0.0);
  // Over the mean square of the very samples that are in the pairs: (a + b)(a + b) - a a - b b.
  for (double& value : values) value *= value / rho[0];
  const std::vector<double> squares = products(values, lags), count = pairs(grid, lags);
  for (const std::size_t place : grid.place) values[place] += 1;
  const std::vector<double> both = products(values, lags);
  const auto n = static_cast<double>(r.size());
  for (std::size_t l = 1; l <= lags; ++l) {
    const double taken = (both[l] - squares[l] - count[l]) / 2 * rho[0];
    // As much too small as those of a record without gaps, which are positive definite for it.
    rho[l] = count[l] > 0.5 && taken > 0 ? rho[l] / taken * std::max(0.0, 1 - static_cast<double>(l) / n) : 0;
  }
  rho[0] = 1;
  return rho;
}

namespace {

/// By how much the variance of a correlation of white noise grows where the noise is uneven, and large
/// samples meet large ones: the mean fourth power of the size along the record over the square of its mean
/// square, by the mean squares of stretches (whose squares are too large by 2 in their length).
double unevenness(const std::vector<double>& r) {
  const std::size_t length = stretch_of(r.size()), stretches = r.size() / length;
  if (stretches < 4) return 1;
  double squares = 0, fourths = 0;
  for (std::size_t k = 0; k < stretches; ++k) {
    const double* from = r.data() + k * length;
    const double square = dot(from, from, length);
    squares += square;
    fourths += square * square;
  }
  const auto n = static_cast<double>(stretches), each = static_cast<double>(length);
  return squares > 0 ? std::max(1.0, n * fourths / (squares * squares) * each / (each + 2)) : 1;
}

}  // namespace

std::size_t stretch_of(std::size_t samples) { return std::max<std::size_t>(16, samples / 50); }

double chi_squared(double degrees, double deviations) {
  const double root = 1 - 2 / (9 * degrees) + deviations * std::sqrt(2 / (9 * degrees));
  return degrees * root * root * root;
}

std::size_t first_lags(std::size_t samples) { return std::min<std::size_t>(32, samples / 2); }

bool is_arithmetic(double rms, std::span<const double> y) {
  const auto [low, high] = extent_of(y);
  return rms < 1e-9 * (high - low);
}

bool is_rounding(double rms, double resolution) { return rms <= 0.36 * resolution; }

bool dies_down(std::span<const double> r, double times) {
  const std::size_t quarter = r.size() / 4;
  const auto squares = [](std::span<const double> part) {
    return dot(part.data(), part.data(), part.size());
  };
  return squares(r.first(quarter)) > times * squares(r.last(quarter));
}

Residual describe_residual(std::span<const double> r, const std::vector<double>& rho,
                           const SampleGrid& grid) {
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
  std::vector<double> count;
  if (grid.has_gaps()) count = pairs(grid, lags);
  const double uneven = unevenness(c);
  constexpr double fewest_pairs = 20;
  double q = 0, k = 0, strongest = 0;
  for (std::size_t l = 1; l <= lags; ++l) {
    const double lag = static_cast<double>(l), all = n - lag;
    const double taken = grid.has_gaps() ? count[l] : all;
    if (grid.has_gaps() && taken < fewest_pairs) continue;
    // Of white noise: (1 - l / n) of a correlation of so many pairs.
    const double error = all * std::sqrt(uneven / (n * (n + 2) * taken)), standardised = rho[l] / error;
    if (l == 1) {
      result.autocorrelation = rho[1];
      result.autocorrelation_error = error;
    }
    q += standardised * standardised;
    ++k;
    const double size = std::abs(rho[l]) * std::sqrt(taken / all);
    if (size <= strongest) continue;
    strongest = size;
    result.strongest = rho[l];
    result.strongest_lag = static_cast<int>(l);
  }
  result.white = true;
  if (k == 0) return result;
  constexpr double one_in_a_hundred = 2.326348;  // at 20 degrees of freedom 37.57 (tables: 37.566)
  result.white = q <= chi_squared(k, one_in_a_hundred);
  return result;
}

double correlation_factor(std::span<const double> r, double phase_step) {
  return correlation_factor(r, autocorrelations(r, first_lags(r.size())), phase_step);
}

double correlation_factor(std::span<const double> r, const std::vector<double>& rho, double phase_step) {
  return std::max(1.0, autoregression_of(r, rho, {}).density(phase_step));
}

Autoregression autoregression_of(std::span<const double> r, const std::vector<double>& rho,
                                 const SampleGrid& grid) {
  const std::size_t most = std::min(std::min<std::size_t>(512, r.size() / 4), longest_memory(grid));
  Autoregression model = yule_walker(rho, r.size(), std::min(rho.size() - 1, most));
  // An order near the most that was tried may not be enough.
  for (std::size_t tried = rho.size() - 1; tried < most && 4 * model.coefficients.size() > 3 * tried;) {
    tried = std::min(4 * tried, most);
    model = yule_walker(autocorrelations(r, grid, tried), r.size(), tried);
  }
  return model;
}

}  // namespace cromer::core
