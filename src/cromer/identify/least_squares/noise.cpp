#include "cromer/identify/least_squares/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cromer/identify/least_squares/residual.h"

namespace cromer {
namespace {

// The last rows of a series, row 0 the latest.
class LastRows {
 public:
  explicit LastRows(std::size_t count) {
    while (size_ < count) size_ *= 2;
    rows_.resize(size_);
  }
  Parameters& push() { return rows_[++at_ & (size_ - 1)] = Parameters{}; }
  const Parameters& back(std::size_t lag) const { return rows_[(at_ - lag) & (size_ - 1)]; }

 private:
  std::size_t size_ = 1, at_ = 0;
  std::vector<Parameters> rows_;
};

// Sums over the columns of a Jacobian, scaled and filtered as the noise is.
struct FilteredSums {
  SquareMatrix alone{};              // scaled only
  SquareMatrix all{};                // filtered
  std::vector<Parameters> gradient;  // of the logarithm of an estimate's variance with each coefficient
};

// By `to_estimates`, a row for each estimate, the Jacobian's rows become those of what a sample does to them.
class Filter {
 public:
  Filter(const Noise& noise, const SquareMatrix& to_estimates, int size)
      : noise_(noise), to_estimates_(to_estimates), size_(size) {}

  FilteredSums operator()(std::span<const double> jacobian) {
    const std::size_t order = noise_.correlation.coefficients.size();
    once_ = LastRows(order + 1);
    twice_ = LastRows(order + 1);
    sums_.gradient.assign(order, {});
    const auto n = noise_.samples;
    for (std::size_t i = 0; i < n; ++i) {
      Parameters row{};
      const double scale = noise_.scale.empty() ? 1 : noise_.scale[i];
      for (int a = 0; a < size_; ++a)
        for (int b = 0; b < size_; ++b)
          row[a] += scale * to_estimates_[a][b] *
                    jacobian[i * static_cast<std::size_t>(size_) + static_cast<std::size_t>(b)];
      add_product(sums_.alone, row);
      if (order == 0) continue;
      step(row);
      const std::size_t empty = (i + 1 < n ? noise_.grid.at(i + 1) - noise_.grid.at(i) : 100 * n + 10000) - 1;
      for (std::size_t k = 0; k < empty && !faded(); ++k) step({});
    }
    if (order == 0) sums_.all = sums_.alone;
    for (int a = 0; a < size_; ++a)
      for (int b = 0; b < size_; ++b) {
        if (order > 0) sums_.all[a][b] *= noise_.correlation.innovation;
        // Half of each product was added.
        if (b > a) continue;
        sums_.alone[b][a] = sums_.alone[a][b];
        sums_.all[b][a] = sums_.all[a][b];
      }
    return sums_;
  }

 private:
  void add_product(SquareMatrix& sum, const Parameters& row) const {
    for (int a = 0; a < size_; ++a)
      for (int b = 0; b <= a; ++b) sum[a][b] += row[a] * row[b];
  }

  void filter(LastRows& rows, const Parameters& in) const {
    const std::vector<double>& coefficients = noise_.correlation.coefficients;
    Parameters& out = rows.push();
    Parameters sum = in;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      const Parameters& before = rows.back(k + 1);
      for (int a = 0; a < size_; ++a) sum[a] += coefficients[k] * before[a];
    }
    out = sum;
  }

  void step(const Parameters& in) {
    filter(once_, in);
    const Parameters& u = once_.back(0);
    filter(twice_, u);
    add_product(sums_.all, u);
    for (std::size_t k = 0; k < sums_.gradient.size(); ++k) {
      const Parameters& before = twice_.back(k + 1);
      for (int a = 0; a < size_; ++a) sums_.gradient[k][a] += 2 * u[a] * before[a];
    }
  }

  // Nothing that would count comes any more.
  bool faded() const {
    constexpr double negligible = 1e-9;
    const std::size_t order = sums_.gradient.size();
    for (std::size_t k = 0; k < order; ++k)
      for (int a = 0; a < size_; ++a)
        if (once_.back(k)[a] * once_.back(k)[a] > negligible * sums_.all[a][a]) return false;
    return true;
  }

  const Noise& noise_;
  const SquareMatrix& to_estimates_;
  int size_;
  LastRows once_{1}, twice_{1};
  FilteredSums sums_;
};

// What squares of residuals are compared with: 1, and squares of the motion.
struct Regressors {
  int size = 0;
  std::vector<double> rows;  // `size` for each sample

  std::span<const double> row(std::size_t i) const {
    return {rows.data() + static_cast<std::size_t>(size) * i, static_cast<std::size_t>(size)};
  }
  double value(std::size_t i, const Parameters& coefficients) const {
    double sum = 0;
    for (int a = 0; a < size; ++a) sum += coefficients[a] * row(i)[static_cast<std::size_t>(a)];
    return sum;
  }
};

NormalEquations regression(const Regressors& x, std::span<const double> y, std::span<const double> weight) {
  NormalEquations sums;
  sums.size = x.size;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const std::span<const double> row = x.row(i);
    const double w = weight.empty() ? 1 : weight[i];
    for (std::size_t a = 0; a < row.size(); ++a) {
      sums.right[a] += w * row[a] * y[i];
      for (std::size_t b = 0; b < row.size(); ++b) sums.matrix[a][b] += w * row[a] * row[b];
    }
  }
  return sums;
}

// 1, and the squares of the displacement from the mean and of the velocity, each over its own mean.
Regressors squares_of(std::span<const double> motion, const SampleGrid& grid) {
  const std::size_t n = motion.size();
  double mean = 0;
  for (double x : motion) mean += x / static_cast<double>(n);
  std::vector<double> x(n), v(n);
  double all_x = 0, all_v = 0, known = 0;
  for (std::size_t i = 0; i < n; ++i) {
    all_x += x[i] = (motion[i] - mean) * (motion[i] - mean);
    // From the neighbours, unless a gap is between.
    const std::size_t before = i > 0 && grid.at(i) - grid.at(i - 1) == 1 ? i - 1 : i;
    const std::size_t after = i + 1 < n && grid.at(i + 1) - grid.at(i) == 1 ? i + 1 : i;
    const double slope = (motion[after] - motion[before]) / static_cast<double>(after - before);
    v[i] = slope * slope;
    if (after > before) all_v += v[i], ++known;
  }
  Regressors result{3, {}};
  result.rows.reserve(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    result.rows.push_back(1);
    result.rows.push_back(all_x > 0 ? x[i] * static_cast<double>(n) / all_x : 0);
    result.rows.push_back(std::isnan(v[i]) ? 1 : all_v > 0 ? v[i] * known / all_v : 0);
  }
  return result;
}

// Those without the last, which says nothing new where a motion is steady.
Regressors without_last(const Regressors& all) {
  Regressors result{all.size - 1, {}};
  for (std::size_t i = 0; i < all.rows.size() / static_cast<std::size_t>(all.size); ++i)
    for (int a = 0; a < result.size; ++a) result.rows.push_back(all.row(i)[static_cast<std::size_t>(a)]);
  return result;
}

// Wald's statistic of all coefficients but the first: chi-squared with size - 1 degrees of freedom where
// there is nothing to them.
double statistic(const Parameters& coefficients, const SquareMatrix& covariance, int size) {
  SquareMatrix block{};
  Parameters part{};
  for (int a = 1; a < size; ++a) {
    part[a - 1] = coefficients[a];
    for (int b = 1; b < size; ++b) block[a - 1][b - 1] = covariance[a][b];
  }
  const ScaledCholesky factor(block, size - 1, 0, all_free);
  if (!factor.ok()) return 0;
  const Parameters solved = factor.solve(part);
  double sum = 0;
  for (int a = 0; a + 1 < size; ++a) sum += part[a] * solved[a];
  return sum;
}

// Whether squares of residuals follow the regressors, at a level of 1 %. The test is R. Koenker's (J.
// Econometrics 17, 107 (1981)), with the squares' own correlation.
bool follow(std::span<const double> square, const Regressors& x, const SampleGrid& grid) {
  const double critical = x.size == 3 ? 9.210 : 6.635;
  const NormalEquations sums = regression(x, square, {});
  const ScaledCholesky factor(sums.matrix, x.size, 0, all_free);
  if (!factor.ok()) return false;
  const Parameters coefficients = factor.solve(sums.right);
  std::vector<double> left(square.size());
  Noise noise;
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = square[i] - x.value(i, coefficients);
    noise.sum_of_squares += left[i] * left[i];
  }
  SquareMatrix covariance = inverse(sums.matrix, x.size);
  for (Parameters& row : covariance)
    for (double& value : row) value *= noise.sum_of_squares / static_cast<double>(left.size());
  if (statistic(coefficients, covariance, x.size) < critical) return false;
  noise.samples = left.size();
  noise.grid = grid;
  noise.correlation = autoregression_of(left, autocorrelations(left, grid, first_lags(left.size())), grid);
  return statistic(coefficients, estimate_noise(x.rows, x.size, noise).covariance, x.size) > critical;
}

// Standard deviation of each sample over the mean one (rms): a regression of the squares, each with the
// weight that its own variance gives it. Empty where they do not follow the motion.
std::vector<double> scale_of(std::span<const double> square, std::span<const double> motion,
                             const SampleGrid& grid) {
  constexpr std::size_t fewest = 30;
  if (square.size() < fewest) return {};
  Regressors x = squares_of(motion, grid);
  if (!ScaledCholesky(regression(x, square, {}).matrix, x.size, 0, all_free).ok()) x = without_last(x);
  if (!follow(square, x, grid)) return {};

  const auto n = static_cast<double>(square.size());
  double mean = 0;
  for (double each : square) mean += each / n;
  std::vector<double> variance(square.size(), mean), weight(square.size());
  for (int round = 0; round < 6; ++round) {
    for (std::size_t i = 0; i < weight.size(); ++i) weight[i] = 1 / (variance[i] * variance[i]);
    const NormalEquations sums = regression(x, square, weight);
    // No part may be negative: the most negative one goes, until none is.
    std::array<bool, max_parameters> free = all_free;
    Parameters coefficients{};
    for (int dropped = 0; dropped < x.size; ++dropped) {
      const ScaledCholesky factor(sums.matrix, x.size, 0, free);
      if (!factor.ok()) return {};
      coefficients = factor.solve(sums.right);
      const auto least = std::min_element(coefficients.begin(), coefficients.begin() + x.size);
      if (*least >= 0) break;
      free[static_cast<std::size_t>(least - coefficients.begin())] = false;
    }
    for (std::size_t i = 0; i < variance.size(); ++i)
      variance[i] = std::max(0.01 * mean, x.value(i, coefficients));
  }
  double sum = 0;
  for (double each : variance) sum += each / n;
  for (double& each : variance) each = std::sqrt(each / sum);
  return variance;
}

}  // namespace

EstimateNoise estimate_noise(std::span<const double> jacobian, int size, const Noise& noise,
                             double resolution) {
  EstimateNoise result;
  result.size = size;
  SquareMatrix matrix{};
  for (std::size_t i = 0; i < noise.samples; ++i) {
    const double* row = jacobian.data() + i * static_cast<std::size_t>(size);
    for (int a = 0; a < size; ++a)
      for (int b = 0; b <= a; ++b) matrix[a][b] += row[a] * row[b];
  }
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < a; ++b) matrix[b][a] = matrix[a][b];
  const SquareMatrix inverse_matrix = inverse(matrix, size);
  const auto n = static_cast<double>(noise.samples);
  const double k = size;
  if (!std::isfinite(inverse_matrix[0][0])) {
    result.covariance = inverse_matrix;
    result.degrees.fill(1);
    result.independent_samples = n;
    return result;
  }

  const FilteredSums sums = Filter(noise, inverse_matrix, size)(jacobian);
  // The part of the sum of squares that the fit took away: the trace of H times the covariance.
  double taken = 0;
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b) taken += matrix[a][b] * sums.all[b][a];
  const double variance =
      std::max(noise.sum_of_squares / std::max({1.0, n / (k + 1), n - taken}), resolution * resolution / 12);
  Parameters widening{};
  double mean_widening = 0;
  for (int a = 0; a < size; ++a) {
    const double factor = sums.all[a][a] / sums.alone[a][a];
    widening[a] = std::clamp(factor, 1.0, n) / factor;
    mean_widening += std::clamp(factor, 1.0, n) / k;
    std::vector<double> slope(sums.gradient.size());
    for (std::size_t l = 0; l < slope.size(); ++l)
      slope[l] = sums.gradient[l][a] * noise.correlation.innovation / sums.all[a][a];
    const double known = 2 / noise.correlation.log_variance(slope, n);
    result.degrees[a] = std::min(n / std::clamp(factor, 1.0, n), known) * std::max(0.0, 1 - k / n);
  }
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b)
      result.covariance[a][b] = variance * sums.all[a][b] * std::sqrt(widening[a] * widening[b]);
  result.independent_samples = n / mean_widening;
  return result;
}

Noise find_noise(std::span<const double> t, std::span<const double> r, std::span<const double> motion) {
  Noise noise;
  noise.grid = find_grid(t);
  noise.samples = r.size();
  std::vector<double> square(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) noise.sum_of_squares += square[i] = r[i] * r[i];

  noise.scale = scale_of(square, motion, noise.grid);
  std::vector<double> standardised(r.begin(), r.end());
  for (std::size_t i = 0; i < noise.scale.size(); ++i) standardised[i] /= noise.scale[i];
  noise.correlation = autoregression_of(
      standardised, autocorrelations(standardised, noise.grid, first_lags(r.size())), noise.grid);
  return noise;
}

}  // namespace cromer
