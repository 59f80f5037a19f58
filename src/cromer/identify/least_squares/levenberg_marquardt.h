// Least squares by Gauss-Newton steps, damped (Levenberg-Marquardt) where a full step would not help, with
// lower bounds.
//
// A model gives its normal equations in one pass over the data, so that an accepted trial costs nothing
// twice. The first step is undamped: from good start values the iteration is pure Gauss-Newton.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cromer/base/function_ref.h"
#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer::core {

struct LeastSquaresOptions {
  int iteration_limit = 50;       // > 0
  double tolerance = 1e-10;       // of a step, relative to the data's scale; 0 < tolerance < 1
  double error_tolerance = 1e-5;  // of a step, in standard errors; 0 <= error_tolerance < 1
  double roughness = 0;           // a step of so many standard errors that does not help is the last; >= 0
  bool along_bounds = false;  // where a step that a bound cuts off leads uphill, take the best one along it
  double scale = 1;           // Euclidean norm of the data; > 0
  int residuals = 1;          // their number; > 0
  Parameters lower = no_bounds();  // -inf where free

  static constexpr Parameters no_bounds() {
    Parameters p{};
    p.fill(-std::numeric_limits<double>::infinity());
    return p;
  }
};

enum class LeastSquaresReason { converged, iteration_limit, singular, not_finite };

struct LeastSquaresSummary {
  LeastSquaresReason reason = LeastSquaresReason::iteration_limit;
  int iterations = 0;
  Parameters parameters{};
  NormalEquations equations;  ///< at the parameters
};

/// A step from parameters within their lower bounds. Where it would lead beyond one: cut off there, and with
/// what then is best for the others.
struct BoundedStep {
  Parameters cut_off, along_the_bound;
  bool meets_a_bound = false;
};

/// Nothing where the matrix is singular to rounding.
inline std::optional<BoundedStep> bounded_step(const NormalEquations& equations, const Parameters& at,
                                               const Parameters& lower, double lambda) {
  const int n = equations.size;
  // A parameter on its bound stays there while the data push it outwards.
  std::array<bool, max_parameters> free{};
  for (int i = 0; i < n; ++i) free[i] = at[i] > lower[i] || equations.right[i] > 0;
  BoundedStep step{at, at};
  for (bool first = true;; first = false) {
    const ScaledCholesky factor(equations.matrix, n, lambda, free);
    if (!factor.ok()) return std::nullopt;
    Parameters right = equations.right;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (!free[j]) right[i] -= equations.matrix[i][j] * (step.along_the_bound[j] - at[j]);
    const Parameters solved = factor.solve(right);
    bool all_within = true;
    for (int i = 0; i < n; ++i) {
      if (!free[i]) continue;
      step.along_the_bound[i] = std::max(at[i] + solved[i], lower[i]);
      if (at[i] + solved[i] < lower[i]) free[i] = all_within = false;
    }
    if (first) step.cut_off = step.along_the_bound;
    if (all_within) return step;
    step.meets_a_bound = true;
  }
}

/// How far a step moves the model, along another: as a sum of squares.
inline double moved(const NormalEquations& equations, const Parameters& step, const Parameters& other) {
  double sum = 0;
  for (int i = 0; i < equations.size; ++i)
    for (int j = 0; j < equations.size; ++j) sum += step[i] * equations.matrix[i][j] * other[j];
  return sum;
}

inline Parameters difference(const Parameters& to, const Parameters& from) {
  Parameters step{};
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = to[i] - from[i];
  return step;
}

/// Minimises the sum of squared residuals. `model(parameters)` returns its NormalEquations there (a
/// sum_of_squares that is not finite marks parameters that cannot be); the start must lie within the bounds.
inline LeastSquaresSummary minimise(FunctionRef<NormalEquations(const Parameters&)> model,
                                    const Parameters& start, const LeastSquaresOptions& options) {
  LeastSquaresSummary at;
  at.parameters = start;
  at.equations = model(start);
  if (!std::isfinite(at.equations.sum_of_squares)) {
    at.reason = LeastSquaresReason::not_finite;
    return at;
  }
  const int n = at.equations.size;
  double lambda = 0;
  Parameters last{};  // the step before, if it was a full one
  double last_motion = 0;
  while (at.iterations < options.iteration_limit) {
    ++at.iterations;
    const std::optional<BoundedStep> bounded =
        bounded_step(at.equations, at.parameters, options.lower, lambda);
    if (!bounded) {
      if (lambda > 1e12) {
        at.reason = LeastSquaresReason::singular;
        return at;
      }
      lambda = std::max(10 * lambda, 1e-9);
      continue;
    }
    Parameters trial = bounded->cut_off, step = difference(trial, at.parameters);

    double motion = moved(at.equations, step, step);
    const double along = moved(at.equations, last, step);
    // Along a bent valley full steps lie on one line, each the last one times the same ratio (below 0 where
    // they go to and fro): all that are to come are taken at once. A. C. Aitken, Proc. R. Soc. Edinb. 46, 289
    // (1926).
    const double ratio = along / last_motion;
    const bool all_at_once = lambda == 0 && std::abs(along) > 0.99 * std::sqrt(motion * last_motion) &&
                             std::abs(ratio) > 0.5 && std::abs(ratio) < 0.99;
    if (all_at_once)
      for (int i = 0; i < n; ++i)
        trial[i] = std::max(at.parameters[i] + step[i] / (1 - ratio), options.lower[i]);
    const double variance = at.equations.sum_of_squares / std::max(1, options.residuals - n);
    const double enough = std::max(options.tolerance * options.tolerance * options.scale * options.scale,
                                   options.error_tolerance * options.error_tolerance * variance);

    const double before = at.equations.sum_of_squares;
    NormalEquations equations;
    for (bool again = options.along_bounds && bounded->meets_a_bound;; again = false) {
      equations = model(trial);
      if (!again || equations.sum_of_squares <= before) break;
      // Cut off at a bound, a step may lead uphill: the other parameters were to go along with that one.
      trial = bounded->along_the_bound;
      step = difference(trial, at.parameters);
      motion = moved(at.equations, step, step);
    }
    // Where the step moves the model by less than the sum of squares can resolve, the gradient still can:
    // such a step is taken on trust.
    const bool unresolved =
        motion <= std::max(1e-13 * before, options.roughness * options.roughness * variance);
    const double limit = unresolved ? before * (1 + 1e-13) : before;
    const bool better = std::isfinite(equations.sum_of_squares) && equations.sum_of_squares <= limit;
    last = lambda == 0 && better && !all_at_once ? step : Parameters{};
    last_motion = last == Parameters{} ? 0 : motion;
    if (better) {
      at.parameters = trial;
      at.equations = equations;
      lambda = lambda > 1e-8 ? lambda / 10 : 0;
    } else {
      lambda = lambda > 0 ? 10 * lambda : 1e-4;
    }
    const bool is_rough = motion > 1e-13 * before;  // a step that the sum of squares could resolve
    if ((motion <= enough && lambda <= 1e-3) || (unresolved && !better && (!is_rough || lambda <= 1e-3))) {
      at.reason = LeastSquaresReason::converged;
      return at;
    }
    if (lambda > 1e14) {
      at.reason = LeastSquaresReason::singular;
      return at;
    }
  }
  at.reason = LeastSquaresReason::iteration_limit;
  return at;
}

}  // namespace cromer::core
