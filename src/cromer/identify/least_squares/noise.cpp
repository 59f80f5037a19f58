#include "cromer/identify/least_squares/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "cromer/analysis/fourier.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

// The autoregression of residuals, none where its density is within a twentieth of white noise's. Its
// autocorrelations are those of the noise: the residuals lack their mean, which the fit took away, and the
// biased estimate is too small; (1 - l/n)(rho_l - S(0)/n) over the same at lag 0.
Autoregression correlation_of(std::span<const double> r, std::vector<double> rho, const SampleGrid& grid) {
  Autoregression model = autoregression_of(r, rho, grid);
  const std::size_t order = model.coefficients.size();
  double size = 0;
  for (double coefficient : model.coefficients) size += std::abs(coefficient);
  if (size < 0.025) return {};
  const auto n = static_cast<double>(r.size());
  if (order >= rho.size()) rho = autocorrelations(r, grid, order);
  for (int round = 0; round < 4; ++round) {
    const double mean = model.density(0) / n;
    if (mean > 0.25) break;
    std::vector<double> corrected(order + 1, 1.0);
    for (std::size_t l = 1; l <= order; ++l)
      corrected[l] = (rho[l] / (1 - static_cast<double>(l) / n) + mean) / (1 + mean);
    const Autoregression next = yule_walker(corrected, r.size(), order);
    if (next.coefficients.size() < order) break;
    model = next;
  }
  return model;
}

// Sums over what each sample does to the estimates, scaled and filtered as the noise is.
struct FilteredSums {
  Parameters alone{};                // scaled only: variances
  SquareMatrix all{};                // filtered
  std::vector<Parameters> gradient;  // of the logarithm of an estimate's variance with each coefficient
};

// Block after block of rows, `width` columns: so wide that processors take whole registers of them.
template <std::size_t width>
class Filter {
 public:
  Filter(const Noise& noise, bool with_gradient)
      : coefficients_(noise.correlation.coefficients),
        order_(coefficients_.size()),
        slopes_(with_gradient ? order_ : 0),
        once_(order_ + block),
        twice_(order_ + block),
        gradient_(slopes_) {}

  // A row of the Jacobian becomes what its sample does to the estimates by the inverse of the normal matrix.
  FilteredSums operator()(const Noise& noise, std::span<const double> jacobian, int size,
                          const SquareMatrix& inverse_matrix) {
    size_ = static_cast<std::size_t>(size);
    Row column[max_parameters]{};
    for (int b = 0; b < size; ++b)
      for (int a = 0; a < size; ++a) column[b][static_cast<std::size_t>(a)] = inverse_matrix[a][b];
    const std::size_t n = noise.samples;
    const double* from = jacobian.data();
    for (std::size_t i = 0; i < n; ++i, from += size) {
      const double scale = noise.scale.empty() ? 1 : noise.scale[i];
      Row row{};
      for (int b = 0; b < size; ++b)
        for (std::size_t a = 0; a < width; ++a) row[a] += scale * from[b] * column[b][a];
      for (std::size_t a = 0; a < width; ++a) alone_[a] += row[a] * row[a];
      if (i > 0 && order_ > 0)
        for (std::size_t empty = noise.grid.at(i) - noise.grid.at(i - 1); empty > 1; --empty) put({});
      put(row);
    }
    // The noise's memory goes on after the last sample.
    for (std::size_t k = 0; order_ > 0 && k < 100 * n + 10000 && !(rows_ == 0 && has_faded()); ++k) put({});
    end_block();
    return sums(noise.correlation.innovation);
  }

 private:
  using Row = std::array<double, width>;
  static constexpr std::size_t block = 128;

  // The first rows of a buffer are the last `order` ones of the block before.
  void filter(std::vector<Row>& rows, std::size_t at, const Row& in) const {
    Row sum = in;
    for (std::size_t k = 0; k < order_; ++k) {
      const Row& before = rows[at - 1 - k];
      for (std::size_t a = 0; a < width; ++a) sum[a] += coefficients_[k] * before[a];
    }
    rows[at] = sum;
  }

  void put(const Row& in) {
    const std::size_t at = order_ + rows_++;
    filter(once_, at, in);
    if (slopes_ > 0) filter(twice_, at, once_[at]);
    if (rows_ == block) end_block();
  }

  void end_block() {
    for (std::size_t b = 0; b < size_; ++b) {
      Row sum{};
      for (std::size_t i = order_; i < order_ + rows_; ++i)
        for (std::size_t a = 0; a < width; ++a) sum[a] += once_[i][b] * once_[i][a];
      for (std::size_t a = 0; a < width; ++a) all_[b][a] += sum[a];
    }
    for (std::size_t k = 0; k < slopes_; ++k) {
      Row sum{};
      for (std::size_t i = order_; i < order_ + rows_; ++i)
        for (std::size_t a = 0; a < width; ++a) sum[a] += once_[i][a] * twice_[i - 1 - k][a];
      for (std::size_t a = 0; a < width; ++a) gradient_[k][a] += 2 * sum[a];
    }
    const auto shift = static_cast<std::ptrdiff_t>(rows_);
    for (std::vector<Row>* rows : {&once_, &twice_})
      std::copy(rows->begin() + shift, rows->begin() + shift + static_cast<std::ptrdiff_t>(order_),
                rows->begin());
    rows_ = 0;
  }

  // True if no later row would count.
  bool has_faded() const {
    constexpr double negligible = 1e-9;
    for (std::size_t k = 0; k < order_; ++k)
      for (std::size_t a = 0; a < size_; ++a)
        if (once_[k][a] * once_[k][a] > negligible * all_[a][a]) return false;
    return true;
  }

  FilteredSums sums(double innovation) const {
    FilteredSums result;
    result.gradient.assign(slopes_, {});
    for (std::size_t a = 0; a < size_; ++a) {
      result.alone[a] = alone_[a];
      for (std::size_t b = 0; b < size_; ++b) result.all[a][b] = innovation * all_[a][b];
      for (std::size_t k = 0; k < slopes_; ++k) result.gradient[k][a] = gradient_[k][a] / all_[a][a];
    }
    return result;
  }

  const std::vector<double>& coefficients_;
  std::size_t order_, slopes_, rows_ = 0, size_ = 0;
  std::vector<Row> once_, twice_;
  Row alone_{};
  std::array<Row, width> all_{};
  std::vector<Row> gradient_;
};

// The same without gradients, by the spectra of what each sample does to the estimates, times that of the
// noise: of many coefficients it takes a small part of the time.
FilteredSums sums_by_transform(const Noise& noise, std::span<const double> jacobian, int size,
                               const SquareMatrix& inverse_matrix) {
  const std::size_t n = noise.samples;
  const std::size_t length = power_of_two(2 * static_cast<double>(noise.grid.at(n - 1) + 1));
  std::vector<double> values(length);
  const auto transformed = [&] {
    std::vector<std::complex<double>> spectrum;
    fourier_transform(values, spectrum);
    return spectrum;
  };
  values[0] = 1;
  const std::vector<double>& coefficients = noise.correlation.coefficients;
  for (std::size_t k = 0; k < std::min(coefficients.size(), length - 1); ++k)
    values[k + 1] = -coefficients[k];
  const std::vector<std::complex<double>> whitening = transformed();
  std::vector<std::vector<std::complex<double>>> effects;
  FilteredSums result;
  for (int a = 0; a < size; ++a) {
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      double effect = 0;
      for (int b = 0; b < size; ++b)
        effect +=
            inverse_matrix[a][b] * jacobian[i * static_cast<std::size_t>(size) + static_cast<std::size_t>(b)];
      if (!noise.scale.empty()) effect *= noise.scale[i];
      result.alone[a] += effect * effect;
      values[noise.grid.at(i)] = effect;
    }
    effects.push_back(transformed());
  }
  const std::size_t half = length / 2;
  for (std::size_t k = 0; k <= half; ++k) {
    const double density = (k == 0 || k == half ? 1 : 2) * noise.correlation.innovation /
                           (std::norm(whitening[k]) * static_cast<double>(length));
    for (std::size_t a = 0; a < effects.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b)
        result.all[a][b] += density * (effects[a][k].real() * effects[b][k].real() +
                                       effects[a][k].imag() * effects[b][k].imag());
  }
  for (std::size_t a = 0; a < effects.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) result.all[b][a] = result.all[a][b];
  return result;
}

FilteredSums filtered_sums(const Noise& noise, std::span<const double> jacobian, int size,
                           const SquareMatrix& inverse_matrix, bool with_gradient) {
  static_assert(max_parameters <= 20);
  if (!with_gradient && !noise.correlation.may_be_noise())
    return sums_by_transform(noise, jacobian, size, inverse_matrix);
  const auto sums = [&]<std::size_t width>(Filter<width> filter) {
    return filter(noise, jacobian, size, inverse_matrix);
  };
  if (size <= 4) return sums(Filter<4>(noise, with_gradient));
  if (size <= 8) return sums(Filter<8>(noise, with_gradient));
  if (size <= 12) return sums(Filter<12>(noise, with_gradient));
  return sums(Filter<20>(noise, with_gradient));
}

// JᵀJ.
SquareMatrix normal_matrix(std::span<const double> jacobian, int size) {
  SquareMatrix matrix{};
  for (std::size_t i = 0; i < jacobian.size(); i += static_cast<std::size_t>(size)) {
    const double* row = jacobian.data() + i;
    for (int a = 0; a < size; ++a)
      for (int b = 0; b <= a; ++b) matrix[a][b] += row[a] * row[b];
  }
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < a; ++b) matrix[b][a] = matrix[a][b];
  return matrix;
}

// Degrees of freedom of variances that are sums over stretches, each of as many as it has samples
// (F. E. Satterthwaite, Biometrics Bull. 2, 110 (1946)); none where they are not wanted, or noise is even.
std::vector<double> degrees_along(std::span<const double> jacobian, int size, const Noise& noise,
                                  const SquareMatrix& inverse_matrix, bool wanted) {
  std::vector<double> degrees;
  if (!wanted || noise.stretch == 0) return degrees;
  const auto each = static_cast<double>(noise.stretch);
  for (int a = 0; a < size; ++a) {
    double all = 0, squares = 0;
    for (std::size_t i = 0; i < noise.samples;) {
      double part = 0;
      for (const std::size_t end = std::min(noise.samples, i + noise.stretch); i < end; ++i) {
        double effect = 0;
        for (int b = 0; b < size; ++b)
          effect += inverse_matrix[a][b] *
                    jacobian[i * static_cast<std::size_t>(size) + static_cast<std::size_t>(b)];
        part += effect * effect * noise.scale[i] * noise.scale[i];
      }
      all += part;
      squares += part * part;
    }
    degrees.push_back(each * all * all / squares);
  }
  return degrees;
}

// Of the noise, where a fit of `size` parameters has taken so much away from the sum of squares.
double variance_of(const Noise& noise, int size, double taken) {
  const auto n = static_cast<double>(noise.samples);
  return noise.sum_of_squares / std::max({1.0, n / (size + 1), n - taken});
}

// How much wider than its sums an estimate's variance is, in a fit of `size` parameters.
struct SumSpread {
  double widening = 1, degrees = 0;
};

SumSpread spread_of_sum(const FilteredSums& sums, int a, int size, const Noise& noise,
                        const std::vector<double>& along, bool with_degrees) {
  const auto n = static_cast<double>(noise.samples);
  const double factor = sums.all[a][a] / sums.alone[a], wide = std::clamp(factor, 1.0, n);
  SumSpread result{.widening = wide / factor};
  if (!with_degrees) return result;
  std::vector<double> slope;
  for (const Parameters& gradient : sums.gradient) slope.push_back(gradient[a]);
  const double known = 2 / noise.correlation.log_variance(slope, n);
  result.degrees = std::min({n / wide, known, along.empty() ? n : along[static_cast<std::size_t>(a)]}) *
                   std::max(0.0, 1 - size / n);
  return result;
}

// The degrees of freedom cost twice what the covariance does.
EstimateNoise estimate(std::span<const double> jacobian, int size, const Noise& noise, double resolution,
                       bool with_degrees) {
  const SquareMatrix matrix = normal_matrix(jacobian, size), inverse_matrix = inverse(matrix, size);
  EstimateNoise result;
  if (!std::isfinite(inverse_matrix[0][0])) {
    for (int a = 0; a < size; ++a) result.covariance[a][a] = HUGE_VAL;
    result.degrees.fill(1);
    return result;
  }
  const FilteredSums sums = filtered_sums(noise, jacobian, size, inverse_matrix, with_degrees);
  // The part of the sum of squares that the fit took away: the trace of H times the covariance.
  double taken = 0;
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b) taken += matrix[a][b] * sums.all[b][a];
  const double variance = std::max(variance_of(noise, size, taken), resolution * resolution / 12);
  const std::vector<double> along = degrees_along(jacobian, size, noise, inverse_matrix, with_degrees);
  Parameters widening{};  // beyond that of the sums
  for (int a = 0; a < size; ++a) {
    const SumSpread spread = spread_of_sum(sums, a, size, noise, along, with_degrees);
    widening[a] = spread.widening;
    result.degrees[a] = spread.degrees;
  }
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b)
      result.covariance[a][b] = variance * sums.all[a][b] * std::sqrt(widening[a] * widening[b]);
  return result;
}

// 1, and the squares of a motion's displacement from its mean and of its velocity.
class MotionSquares {
 public:
  MotionSquares(std::span<const double> motion, const SampleGrid& grid) : motion_(motion), grid_(grid) {
    double sum[4]{};
    for (std::size_t i = 0; i < motion.size(); ++i) sum[i % 4] += motion[i];
    mean_ = (sum[0] + sum[1] + sum[2] + sum[3]) / static_cast<double>(motion.size());
  }

  std::array<double, 3> row(std::size_t i) const {
    return {1, square_of_displacement(i), square_of_velocity(i)};
  }

 private:
  double square_of_displacement(std::size_t i) const { return (motion_[i] - mean_) * (motion_[i] - mean_); }

  // From the neighbours, unless a gap is between.
  double square_of_velocity(std::size_t i) const {
    const std::size_t last = motion_.size() - 1;
    std::size_t before = i > 0 ? i - 1 : i, after = i < last ? i + 1 : i;
    if (grid_.has_gaps()) {
      if (grid_.at(i) - grid_.at(before) > 1) before = i;
      if (grid_.at(after) - grid_.at(i) > 1) after = i;
    }
    const double slope =
        (motion_[after] - motion_[before]) / static_cast<double>(std::max<std::size_t>(1, after - before));
    return slope * slope;
  }

  std::span<const double> motion_;
  const SampleGrid& grid_;
  double mean_ = 0;
};

// The normal equations of the squares of residuals over the first `size` of them.
NormalEquations regression(const MotionSquares& x, int size, std::span<const double> r,
                           std::span<const double> weight) {
  // Half of a symmetric matrix; in locals, which stay in registers.
  double m00 = 0, m10 = 0, m11 = 0, m20 = 0, m21 = 0, m22 = 0, b0 = 0, b1 = 0, b2 = 0, squares = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto [one, p, q] = x.row(i);
    const double w = weight.empty() ? 1 : weight[i], y = r[i] * r[i];
    const double wp = w * p, wq = w * q, wy = w * y;
    m00 += w * one, m10 += wp, m11 += wp * p, m20 += wq, m21 += wq * p, m22 += wq * q;
    b0 += wy, b1 += wy * p, b2 += wy * q, squares += wy * y;
  }
  NormalEquations sums;
  sums.size = size;
  sums.matrix[0] = {m00, m10, m20};
  sums.matrix[1] = {m10, m11, m21};
  sums.matrix[2] = {m20, m21, m22};
  sums.right = {b0, b1, b2};
  sums.sum_of_squares = squares;
  return sums;
}

double value(const MotionSquares& x, std::size_t i, const Parameters& coefficients) {
  const auto [one, p, q] = x.row(i);
  return coefficients[0] * one + coefficients[1] * p + coefficients[2] * q;
}

// Wald's statistic of all coefficients but the first: chi-squared with size - 1 degrees of freedom if all
// of them are 0.
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

// True if the squares of the residuals follow the motion's, at a level of 1 %. The test is R. Koenker's (J.
// Econometrics 17, 107 (1981)), with the squares' own correlation.
bool squares_grow_with_motion(std::span<const double> r, const MotionSquares& x, const NormalEquations& sums,
                              const SampleGrid& grid) {
  const int size = sums.size;
  const double critical = size == 3 ? 9.210 : 6.635;
  const auto [ok, coefficients, rest] = solve(sums);
  Noise noise;
  noise.samples = r.size();
  noise.sum_of_squares = rest;
  SquareMatrix covariance = inverse(sums.matrix, size);
  for (Parameters& row : covariance)
    for (double& each : row) each *= noise.sum_of_squares / static_cast<double>(r.size());
  if (statistic(coefficients, covariance, size) < critical) return false;

  std::vector<double> left(r.size()), rows;
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = r[i] * r[i] - value(x, i, coefficients);
    const std::array<double, 3> row = x.row(i);
    rows.insert(rows.end(), row.begin(), row.begin() + size);
  }
  noise.grid = grid;
  noise.correlation = autoregression_of(left, autocorrelations(left, grid, first_lags(left.size())), grid);
  return statistic(coefficients, estimate(rows, size, noise, 0, false).covariance, size) > critical;
}

}  // namespace

// A regression of the squares of residuals, each with the weight that its own variance gives it.
std::vector<double> noise_scale(const SampleGrid& grid, std::span<const double> r,
                                std::span<const double> motion) {
  constexpr std::size_t fewest = 30;
  if (r.size() < fewest) return {};
  const MotionSquares x(motion, grid);
  NormalEquations sums = regression(x, 3, r, {});
  // The velocity says nothing new where a motion is steady.
  while (sums.size > 1 && !ScaledCholesky(sums.matrix, sums.size, 0, all_free).ok()) --sums.size;
  if (sums.size == 1 || !squares_grow_with_motion(r, x, sums, grid)) return {};

  const int size = sums.size;
  const auto n = static_cast<double>(r.size());
  const double mean = sums.right[0] / n;
  std::vector<double> variance(r.size(), mean), weight(r.size());
  for (int round = 0; round < 6; ++round) {
    for (std::size_t i = 0; i < weight.size(); ++i) weight[i] = 1 / (variance[i] * variance[i]);
    sums = regression(x, size, r, weight);
    // No part may be negative: the most negative one goes, until none is.
    std::array<bool, max_parameters> free = all_free;
    Parameters coefficients{};
    for (int dropped = 0; dropped < size; ++dropped) {
      const ScaledCholesky factor(sums.matrix, size, 0, free);
      if (!factor.ok()) return {};
      coefficients = factor.solve(sums.right);
      int least = 0;  // by what each part adds on average
      for (int a = 1; a < size; ++a)
        if (coefficients[a] * sums.matrix[0][a] < coefficients[least] * sums.matrix[0][least]) least = a;
      if (coefficients[least] >= 0) break;
      free[static_cast<std::size_t>(least)] = false;
    }
    for (std::size_t i = 0; i < variance.size(); ++i)
      variance[i] = std::max(0.01 * mean, value(x, i, coefficients));
  }
  double sum = 0;
  for (double each : variance) sum += each / n;
  for (double& each : variance) each = std::sqrt(each / sum);
  return variance;
}

std::vector<double> scale_along(const SampleGrid& grid, std::span<const double> r,
                                const std::vector<double>& rho) {
  const std::size_t length = stretch_of(r.size()), stretches = r.size() / length;
  if (stretches < 4) return {};
  const auto n = static_cast<double>(r.size());
  // The last stretch takes what is left over.
  const auto stretch_at = [&](std::size_t i) { return std::min(i / length, stretches - 1); };
  std::vector<double> square(stretches), count(stretches);
  double fourths = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double each = r[i] * r[i];
    square[stretch_at(i)] += each;
    ++count[stretch_at(i)];
    fourths += each * each / n;
  }
  double mean = 0, squared = 0;
  const auto shortest = static_cast<double>(length);
  for (std::size_t k = 0; k < stretches; ++k) {
    mean += square[k] / n;
    square[k] /= count[k];
    squared += count[k] / n * square[k] * square[k];
  }
  // The variance of a square over the mean square's square, 2 of normal noise: `squared` is too large by that
  // over the stretch's length.
  const double ratio = fourths / squared, spread = (ratio - 1) / (1 - ratio / shortest);
  if (!(mean > 0) || !(spread > 0) || !(ratio < shortest)) return {};
  double memory = 1;
  for (std::size_t l = 1; l < rho.size(); ++l) memory += 2 * rho[l] * rho[l];
  double q = 0;
  for (std::size_t k = 0; k < stretches; ++k)
    q += (square[k] / mean - 1) * (square[k] / mean - 1) * count[k] / (spread * memory);
  constexpr double one_in_a_thousand = 3.090232;  // standard deviations
  const double degrees = static_cast<double>(stretches - 1);
  if (q <= chi_squared(degrees, one_in_a_thousand)) return {};

  std::vector<double> scale(r.size()), standardised(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    scale[i] = std::sqrt(square[stretch_at(i)] / mean);
    if (!(scale[i] > 0)) return {};
    standardised[i] = r[i] / scale[i];
  }
  const auto lags = autocorrelations(standardised, grid, first_lags(r.size()));
  return describe_residual(standardised, lags, grid).white ? scale : std::vector<double>{};
}

EstimateNoise estimate_noise(std::span<const double> jacobian, int size, const Noise& noise,
                             double resolution) {
  return estimate(jacobian, size, noise, resolution, true);
}

SumNoise noise_of_sums(std::span<const double> effects, int size, const Noise& noise, bool with_degrees) {
  SquareMatrix identity{};
  for (int a = 0; a < size; ++a) identity[a][a] = 1;
  const FilteredSums sums = filtered_sums(noise, effects, size, identity, with_degrees);
  const std::vector<double> along = degrees_along(effects, size, noise, identity, with_degrees);
  Parameters squares{};
  for (std::size_t i = 0; i < effects.size(); i += static_cast<std::size_t>(size))
    for (int a = 0; a < size; ++a)
      squares[a] += effects[i + static_cast<std::size_t>(a)] * effects[i + static_cast<std::size_t>(a)];
  SumNoise result;
  for (int a = 0; a < size; ++a) {
    const auto [widening, degrees] = spread_of_sum(sums, a, 1, noise, along, with_degrees);
    result.variance[a] = variance_of(noise, 1, sums.all[a][a] / squares[a]) * sums.all[a][a] * widening;
    result.degrees[a] = degrees;
  }
  return result;
}

Noise find_noise(const SampleGrid& grid, std::span<const double> r, std::span<const double> motion,
                 const std::vector<double>& rho) {
  Noise noise;
  noise.grid = grid;
  noise.samples = r.size();
  for (double each : r) noise.sum_of_squares += each * each;
  std::vector<double> left(r.begin(), r.end()), lags = rho;
  const auto take = [&](const std::vector<double>& scale) {
    if (scale.empty()) return false;
    if (noise.scale.empty()) noise.scale.assign(r.size(), 1);
    for (std::size_t i = 0; i < left.size(); ++i) {
      noise.scale[i] *= scale[i];
      left[i] /= scale[i];
    }
    lags = autocorrelations(left, grid, first_lags(r.size()));
    return true;
  };
  take(noise_scale(grid, r, motion));
  if (take(scale_along(grid, left, lags))) {
    noise.stretch = stretch_of(r.size());
    double square = 0;
    for (const double each : noise.scale) square += each * each / static_cast<double>(r.size());
    for (double& each : noise.scale) each /= std::sqrt(square);
  }
  noise.correlation = correlation_of(left, lags, grid);
  return noise;
}

double expected_rounding_error(double value, double noise) {
  if (noise < 0.05) return std::round(value) - value;
  double sum = 0;
  for (int k = 1; k < 20; ++k) {
    const double blur = std::exp(-two_pi * pi * k * k * noise * noise);
    if (blur < 1e-4) break;
    sum += (k % 2 ? -1 : 1) * std::sin(two_pi * k * value) * blur / (pi * k);
  }
  return sum;
}

std::vector<double> rounded_motion(const Record& record, std::span<const double> residuals) {
  const double q = record.resolution;
  if (!(q > 0)) return {};
  double mean_square = 0;
  for (double r : residuals) mean_square += r * r / static_cast<double>(residuals.size());
  if (mean_square > 0.36 * q * q) return {};
  const double noise = std::sqrt(std::max(0.0, mean_square / (q * q) - 1.0 / 12));
  const double offset = record.y[0] - q * std::round(record.y[0] / q);  // of the steps from zero
  std::vector<double> rounded(residuals.size());
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    const double motion = record.y[i] - residuals[i];
    rounded[i] = motion + q * expected_rounding_error((motion - offset) / q, noise);
  }
  return rounded;
}

}  // namespace cromer::core
