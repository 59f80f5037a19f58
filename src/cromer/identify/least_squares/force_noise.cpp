#include "cromer/identify/least_squares/force_noise.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer::core {
namespace {

using Pair = std::array<double, 2>;

double product(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }

// The covariance of position and velocity.
struct StateCovariance {
  double xx = 0, xv = 0, vv = 0;

  Pair times(const Pair& c) const { return {xx * c[0] + xv * c[1], xv * c[0] + vv * c[1]}; }

  void add(const Pair& direction, double factor) {
    xx += factor * direction[0] * direction[0];
    xv += factor * direction[0] * direction[1];
    vv += factor * direction[1] * direction[1];
  }

  StateCovariance after(const std::array<Pair, 2>& a) const {
    const Pair x = times(a[0]), v = times(a[1]);
    return {product(a[0], x), product(a[0], v), product(a[1], v)};
  }
};

// The innovations of residuals and Jacobian, and what follows from them: rows of the Jacobian and a residual,
// side by side, so wide that processors take whole registers of them.
template <std::size_t width>
class Innovations {
 public:
  Innovations(const SampleGrid& grid, std::span<const double> residuals, std::span<const double> jacobian,
              int size, const AnswerToForce& answer)
      : grid_(grid),
        residuals_(residuals),
        jacobian_(jacobian),
        size_(static_cast<std::size_t>(size)),
        answer_(answer) {}

  struct Likelihood {
    double deviance = HUGE_VAL;  // minus twice the logarithm of the restricted likelihood, but for a constant
    double variance = 0;         // a
  };

  Likelihood at(double rho) const {
    std::array<Row, 2> state{};
    Products sums;
    StateCovariance spread;
    Pair gain{};
    double variance = 1, logarithms = 0;
    std::size_t still = 0;
    bool is_steady = false;  // gain and variance change no more
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      for (std::size_t steps = i > 0 ? grid_.at(i) - grid_.at(i - 1) : 1; steps > 1; --steps) {
        carry(state, {}, {});
        spread = spread.after(answer_.transition);
        spread.add(answer_.entry, rho);
        is_steady = false;
      }
      if (!is_steady) {
        const double before = variance, direct = answer_.directly;
        const Pair seen = spread.times(answer_.sight);
        variance = product(answer_.sight, seen) + 1 + rho * direct * direct;
        for (std::size_t part = 0; part < 2; ++part)
          gain[part] =
              (product(answer_.transition[part], seen) + rho * direct * answer_.entry[part]) / variance;
        spread = spread.after(answer_.transition);
        spread.add(answer_.entry, rho);
        spread.add(gain, -variance);
        constexpr std::size_t a_while = 32;
        constexpr double negligible = 1e-12;
        still = std::abs(variance - before) < negligible * variance ? still + 1 : 0;
        is_steady = still >= a_while;
      }
      Row innovation{};
      for (std::size_t a = 0; a < size_; ++a) innovation[a] = jacobian_[i * size_ + a];
      innovation[size_] = residuals_[i];
      for (std::size_t a = 0; a < width; ++a)
        innovation[a] -= answer_.sight[0] * state[0][a] + answer_.sight[1] * state[1][a];
      carry(state, gain, innovation);
      const double weight = 1 / std::sqrt(variance);
      for (double& part : innovation) part *= weight;
      sums.add(innovation);
      logarithms += std::log(variance);
    }
    const NormalEquations equations = sums.equations(size_);
    const LinearFit fit = solve(equations);
    if (!fit.ok || !(fit.rest > 0)) return {};
    const double left = static_cast<double>(residuals_.size() - size_), a = fit.rest / left;
    return {logarithms + log_determinant(equations) + left * std::log(a), a};
  }

  // Hᵀ times what each sample does to the estimates: what each sample of the force does to them, as the sums
  // of squares and products.
  SquareMatrix by_the_force(const SquareMatrix& inverse_matrix) const {
    SquareMatrix sums{};
    std::array<Row, 2> state{};  // of the adjoint
    std::size_t i = residuals_.size();
    for (std::size_t place = grid_.at(i - 1) + 1; place-- > 0;) {
      Row effect{};
      if (grid_.at(i - 1) == place) {
        --i;
        for (std::size_t a = 0; a < size_; ++a)
          for (std::size_t b = 0; b < size_; ++b)
            effect[a] += inverse_matrix[a][b] * jacobian_[i * size_ + b];
      }
      Row moved{};
      for (std::size_t a = 0; a < size_; ++a) {
        const Pair after = {state[0][a], state[1][a]};
        moved[a] = answer_.directly * effect[a] + product(answer_.entry, after);
        for (std::size_t part = 0; part < 2; ++part)
          state[part][a] = answer_.transition[0][part] * after[0] + answer_.transition[1][part] * after[1] +
                           answer_.sight[part] * effect[a];
      }
      for (std::size_t a = 0; a < size_; ++a)
        for (std::size_t b = 0; b < size_; ++b) sums[a][b] += moved[a] * moved[b];
      if (i == 0) break;
    }
    return sums;
  }

  // The variance of what is seen, of a force of variance 1 that has acted all the while.
  double reach() const {
    StateCovariance spread;
    double last = 0;
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      spread = spread.after(answer_.transition);
      spread.add(answer_.entry, 1);
      last = product(answer_.sight, spread.times(answer_.sight));
    }
    return last + answer_.directly * answer_.directly;
  }

 private:
  using Row = std::array<double, width>;

  // The sums of products of rows, block after block.
  class Products {
   public:
    void add(const Row& row) {
      std::copy(row.begin(), row.end(), rows_.row(filled_).data());
      if (++filled_ == rows_.rows()) end_block();
    }

    NormalEquations equations(std::size_t size) {
      end_block();
      const auto n = static_cast<Eigen::Index>(size);
      NormalEquations result;
      result.size = static_cast<int>(size);
      for (std::size_t a = 0; a < size; ++a) {
        const auto row = static_cast<Eigen::Index>(a);
        for (std::size_t b = 0; b < size; ++b) result.matrix[a][b] = sums_(row, static_cast<Eigen::Index>(b));
        result.right[a] = sums_(row, n);
      }
      result.sum_of_squares = sums_(n, n);
      return result;
    }

   private:
    void end_block() {
      const auto part = rows_.topRows(filled_);
      sums_.noalias() += part.transpose() * part;
      filled_ = 0;
    }

    static constexpr int wide = static_cast<int>(width);
    Eigen::Matrix<double, 64, wide, Eigen::RowMajor> rows_;
    Eigen::Matrix<double, wide, wide> sums_ = Eigen::Matrix<double, wide, wide>::Zero();
    Eigen::Index filled_ = 0;
  };

  void carry(std::array<Row, 2>& state, const Pair& gain, const Row& innovation) const {
    for (std::size_t a = 0; a < width; ++a) {
      const Pair before = {state[0][a], state[1][a]};
      state[0][a] = product(answer_.transition[0], before) + gain[0] * innovation[a];
      state[1][a] = product(answer_.transition[1], before) + gain[1] * innovation[a];
    }
  }

  // By the Cholesky factor of the matrix of unit diagonal.
  static double log_determinant(const NormalEquations& sums) {
    const auto n = static_cast<std::size_t>(sums.size);
    SquareMatrix factor{};
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        double rest = sums.matrix[i][j] / std::sqrt(sums.matrix[i][i] * sums.matrix[j][j]);
        for (std::size_t l = 0; l < j; ++l) rest -= factor[i][l] * factor[j][l];
        factor[i][j] = i == j ? std::sqrt(std::max(rest, 1e-300)) : rest / factor[j][j];
        if (i == j) sum += 2 * std::log(factor[i][i]) + std::log(sums.matrix[i][i]);
      }
    return sum;
  }

  const SampleGrid& grid_;
  std::span<const double> residuals_, jacobian_;
  std::size_t size_;
  const AnswerToForce& answer_;
};

template <std::size_t width>
std::optional<ForceNoise> force_noise_by(const Innovations<width>& filter, std::size_t n,
                                         std::span<const double> jacobian, int size) {
  const double unit = 1 / filter.reach();
  if (!std::isfinite(unit)) return std::nullopt;
  const auto deviance = [&](double log_rho) { return filter.at(unit * std::exp(log_rho)).deviance; };

  // The likelihood has one hump: coarse steps first, then thirds of its surroundings.
  constexpr double lowest = -16, highest = 16, coarse = 4, fine = 0.05;
  double best = lowest, least = deviance(lowest);
  for (double at = lowest + coarse; at <= highest; at += coarse)
    if (const double here = deviance(at); here < least) best = at, least = here;
  // A share of the variances as small as this one is none.
  constexpr double rare = 5.41;  // of half a chi-squared with one degree of freedom, 1 of 100
  if (!(filter.at(0).deviance - least > rare)) return std::nullopt;
  for (double reach = coarse / 2; reach > fine; reach /= 2)
    for (const double at : {best - reach, best + reach})
      if (const double here = deviance(at); here < least) best = at, least = here;

  NormalEquations sums;
  sums.size = size;
  Parameters row{};
  for (std::size_t i = 0; i < jacobian.size(); i += static_cast<std::size_t>(size)) {
    std::copy_n(jacobian.begin() + static_cast<std::ptrdiff_t>(i), size, row.begin());
    sums.add_row(row, 0);
  }
  const SquareMatrix inverse_matrix = inverse(sums.matrix, size);
  if (!std::isfinite(inverse_matrix[0][0])) return std::nullopt;
  const SquareMatrix by_force = filter.by_the_force(inverse_matrix);
  const double rho = unit * std::exp(best), a = filter.at(rho).variance;

  // How well the logarithms of rho and a are known, from the curvature of the likelihood.
  constexpr double aside = 0.3;
  const auto below = filter.at(rho * std::exp(-aside)), above = filter.at(rho * std::exp(aside));
  const double curvature = (below.deviance + above.deviance - 2 * least) / (aside * aside);
  const double of_rho = 2 / std::max(curvature, 1e-9);
  const double a_with_rho = std::log(above.variance / below.variance) / (2 * aside);
  ForceNoise found{.deviation = std::sqrt(a * rho), .of_estimates = {}};
  const double left = static_cast<double>(n) - size;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j)
      found.of_estimates.covariance[i][j] = a * (inverse_matrix[i][j] + rho * by_force[i][j]);
    const double share = rho * by_force[i][i] / (inverse_matrix[i][i] + rho * by_force[i][i]);
    const double slope = a_with_rho + share;
    found.of_estimates.degrees[i] = std::clamp(2 / (slope * slope * of_rho + 2 / left), 1.0, left);
  }
  return found;
}

}  // namespace

std::optional<ForceNoise> find_force_noise(const SampleGrid& grid, std::span<const double> residuals,
                                           std::span<const double> jacobian, int size,
                                           const AnswerToForce& answer) {
  const std::size_t n = residuals.size();
  if (n < static_cast<std::size_t>(size) + 2) return std::nullopt;
  static_assert(max_parameters < 22);
  const auto by = [&]<std::size_t width>(std::integral_constant<std::size_t, width>) {
    return force_noise_by(Innovations<width>(grid, residuals, jacobian, size, answer), n, jacobian, size);
  };
  if (size < 8) return by(std::integral_constant<std::size_t, 8>{});
  if (size < 12) return by(std::integral_constant<std::size_t, 12>{});
  return by(std::integral_constant<std::size_t, 22>{});
}

}  // namespace cromer::core
