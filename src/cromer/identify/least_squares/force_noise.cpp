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

  // To rounding: a filter that is steady stays so.
  bool is_as(const StateCovariance& before) const {
    constexpr double negligible = 1e-13;
    return std::abs(xx - before.xx) <= negligible * xx && std::abs(vv - before.vv) <= negligible * vv &&
           std::abs(xv - before.xv) <= negligible * std::sqrt(xx * vv);
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
    double unrestricted = HUGE_VAL;  // the deviance that laws are compared by
  };

  Likelihood at(double rho) const {
    std::array<Row, 2> state{};
    Products sums;
    StateCovariance spread;
    Pair gain{};
    double variance = 1, logarithms = 0;
    bool is_steady = false;  // gain and variance change no more
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      for (std::size_t steps = i > 0 ? grid_.at(i) - grid_.at(i - 1) : 1; steps > 1; --steps) {
        carry(state, {}, {});
        spread = spread.after(answer_.transition);
        spread.add(answer_.entry, rho);
        is_steady = false;
      }
      if (!is_steady) {
        const StateCovariance before = spread;
        const double direct = answer_.directly;
        const Pair seen = spread.times(answer_.sight);
        variance = product(answer_.sight, seen) + 1 + rho * direct * direct;
        for (std::size_t part = 0; part < 2; ++part)
          gain[part] =
              (product(answer_.transition[part], seen) + rho * direct * answer_.entry[part]) / variance;
        spread = spread.after(answer_.transition);
        spread.add(answer_.entry, rho);
        spread.add(gain, -variance);
        is_steady = spread.is_as(before);
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
    const ScaledCholesky factor(equations.matrix, equations.size, 0, all_free);
    const LinearFit fit = solve(equations);
    if (!factor.ok() || !(fit.rest > 0)) return {};
    const double left = static_cast<double>(residuals_.size() - size_), a = fit.rest / left;
    const auto n = static_cast<double>(residuals_.size());
    return {logarithms + factor.log_determinant() + left * std::log(a), a,
            logarithms + n * std::log(fit.rest / n)};
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

  const SampleGrid& grid_;
  std::span<const double> residuals_, jacobian_;
  std::size_t size_;
  const AnswerToForce& answer_;
};

// What noise of the force may be there, rho times a, and how likely that is.
struct PossibleNoise {
  double rho = 0, variance = 0, weight = 0;
};

// Every deviation of the force's noise is as likely as another before the record is seen: that of log rho is
// then the likelihood times the root of rho.
template <std::size_t width>
class NoiseSearch {
 public:
  NoiseSearch(const Innovations<width>& filter, double unit) : filter_(filter), unit_(unit) {
    // By coarse steps, and then by halves about the best.
    constexpr double lowest = -16, highest = 16, coarse = 4, fine = 0.1;
    best_ = at(lowest);
    for (double log_rho = lowest + coarse; log_rho <= highest; log_rho += coarse) take(at(log_rho));
    for (double reach = coarse / 2; reach > fine; reach /= 2)
      for (const double log_rho : {best_.log_rho - reach, best_.log_rho + reach}) take(at(log_rho));
    constexpr double rare = 5.41;  // of half a chi-squared with one degree of freedom
    without_ = filter_.at(0);
    shows_ = without_.deviance - best_.deviance > rare;
  }

  // Whether white noise of the motion alone would look like this in one record of a hundred only.
  bool shows() const { return shows_; }

  double most_likely_deviation() const { return std::sqrt(best_.variance * rho(best_)); }

  double deviance_without() const { return without_.unrestricted; }

  // With the most likely noise up to the largest, unless a larger one shows; and without any.
  double deviance(double largest) const {
    const bool possible = shows_ || most_likely_deviation() <= largest;
    return std::min(without_.unrestricted, possible ? best_.unrestricted : HUGE_VAL);
  }

  // Of deviations up to the largest, unless a larger one shows.
  std::vector<PossibleNoise> possible(double largest) const {
    constexpr double aside = 0.3, unlikely = 8, narrowest = 0.05, widest = 1;
    constexpr int most = 60;
    const double curvature =
        (density(at(best_.log_rho - aside)) + density(at(best_.log_rho + aside)) - 2 * density(best_)) /
        (aside * aside);
    const double step = std::clamp(0.5 / std::sqrt(std::max(curvature, 1e-9)), narrowest, widest);
    std::vector<PossibleNoise> found;
    const auto take_in = [&](const Point& point, double weight) {
      if (shows_ || point.variance * rho(point) <= largest * largest)
        found.push_back({rho(point), point.variance, weight});
    };
    take_in(best_, 1);
    for (const double sign : {-1.0, 1.0})
      for (int i = 1; i < most; ++i) {
        const Point point = at(best_.log_rho + sign * i * step);
        const double less = density(point) - density(best_);
        if (!(less < unlikely)) break;
        take_in(point, std::exp(-less));
      }
    if (found.empty()) return {{0, without_.variance, 1}};
    double sum = 0;
    for (const PossibleNoise& each : found) sum += each.weight;
    for (PossibleNoise& each : found) each.weight /= sum;
    return found;
  }

 private:
  struct Point {
    double log_rho = 0, deviance = HUGE_VAL, variance = 0, unrestricted = HUGE_VAL;
  };

  Point at(double log_rho) const {
    const auto likelihood = filter_.at(unit_ * std::exp(log_rho));
    return {log_rho, likelihood.deviance, likelihood.variance, likelihood.unrestricted};
  }
  void take(const Point& point) {
    if (point.deviance < best_.deviance) best_ = point;
  }
  double rho(const Point& point) const { return unit_ * std::exp(point.log_rho); }
  // Minus the logarithm of the probability density of log rho.
  static double density(const Point& point) { return 0.5 * (point.deviance - point.log_rho); }

  const Innovations<width>& filter_;
  double unit_;
  Point best_;
  typename Innovations<width>::Likelihood without_;
  bool shows_ = false;
};

template <std::size_t width>
std::optional<ForceNoise> force_noise_by(const Innovations<width>& filter, std::size_t n, int size,
                                         const SquareMatrix& inverse_matrix, double largest) {
  const double unit = 1 / filter.reach();
  if (!std::isfinite(unit)) return std::nullopt;
  const NoiseSearch<width> search(filter, unit);
  const std::vector<PossibleNoise> possible = search.possible(largest);
  ForceNoise found{.deviation = search.most_likely_deviation(),
                   .shows = search.shows(),
                   .deviance = search.deviance(largest),
                   .deviance_without = search.deviance_without()};
  double alone = 0;  // a, on average
  for (const PossibleNoise& each : possible) {
    alone += each.weight * each.variance;
    found.mean_square += each.weight * each.variance * each.rho;
  }

  // Variances whose inverses are distributed as chi-squared make Student's t, of the inverse's mean and of
  // twice the inverse square of its relative spread in degrees of freedom.
  const SquareMatrix by_force = filter.by_the_force(inverse_matrix);
  const double left = static_cast<double>(n) - size;
  SquareMatrix& covariance = found.of_estimates.covariance;
  Parameters scale{};
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j)
      covariance[i][j] = alone * inverse_matrix[i][j] + found.mean_square * by_force[i][j];
    double mean = 0, square = 0;  // of the inverse
    for (const PossibleNoise& each : possible) {
      const double inverse = 1 / (each.variance * (inverse_matrix[i][i] + each.rho * by_force[i][i]));
      mean += each.weight * inverse;
      square += each.weight * inverse * inverse;
    }
    scale[i] = 1 / std::sqrt(mean * covariance[i][i]);
    const double spread = std::max(0.0, square / (mean * mean) - 1);
    found.of_estimates.degrees[i] = std::clamp(1 / (spread / 2 + 1 / left), 1.0, left);
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) covariance[i][j] *= scale[i] * scale[j];
  return found;
}

}  // namespace

std::optional<ForceNoise> find_force_noise(const SampleGrid& grid, std::span<const double> residuals,
                                           std::span<const double> jacobian, int size,
                                           const SquareMatrix& inverse_matrix, const AnswerToForce& answer,
                                           double largest) {
  const std::size_t n = residuals.size();
  if (n < static_cast<std::size_t>(size) + 2) return std::nullopt;
  // Whole registers, and one column for the residuals.
  static_assert(max_parameters < 24);
  const auto by = [&]<std::size_t width>(std::integral_constant<std::size_t, width>) {
    return force_noise_by(Innovations<width>(grid, residuals, jacobian, size, answer), n, size,
                          inverse_matrix, largest);
  };
  if (size < 8) return by(std::integral_constant<std::size_t, 8>{});
  if (size < 12) return by(std::integral_constant<std::size_t, 12>{});
  return by(std::integral_constant<std::size_t, 24>{});
}

double answer_norm(const AnswerToForce& answer, std::size_t places) {
  StateCovariance spread;
  double sum = 0;
  for (std::size_t i = 0; i < places; ++i) {
    sum += product(answer.sight, spread.times(answer.sight)) + answer.directly * answer.directly;
    spread = spread.after(answer.transition);
    spread.add(answer.entry, 1);
  }
  return sum;
}

}  // namespace cromer::core
