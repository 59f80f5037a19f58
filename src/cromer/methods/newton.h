// Newton's iteration for the one or two unknowns of an implicit step; each is a pair where an inner state
// rides along (base/coupled.h), and all are solved for together.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "cromer/base/coupled.h"
#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"
#include "cromer/base/solve_linear.h"
#include "cromer/base/state.h"

namespace cromer::core {

struct NewtonOptions {
  double tolerance = 1e-12;  ///< of the last update, relative to the motion's scale; 1e-15 to 1e-2
  int iteration_limit = 25;  ///< > 0

  friend bool operator==(const NewtonOptions&, const NewtonOptions&) = default;
};

/// An unknown of an implicit step, one of `count`, with its derivatives by all of them.
template <class Real, std::size_t count = 1>
struct UnknownOf {
  using Type = Dual<Real, count>;
};
template <class Real, std::size_t count>
struct UnknownOf<Coupled<Real>, count> {
  using Type = Coupled<Dual<Real, 2 * count>>;
};
template <class Real, std::size_t count = 1>
using Unknown = typename UnknownOf<Real, count>::Type;

/// In a pack each lane iterates by itself. A lane that has arrived stays where it is while others go on, so
/// that it does not depend on them.
template <class Real, class Root = Real>
struct NewtonResult {
  Root root;
  int iterations;  ///< of the lane that took longest
  Truth<Real> converged;
};

/// Sizes that tell when the iteration has arrived, in the unit of the unknown. Size: double, or a pack.
template <class Size>
struct NewtonScale {
  Size motion;    ///< the largest value of the motion so far; 0 before it begins
  Size rounding;  ///< changes below it are lost in the other numbers of the equation
};

/// Changes of an acceleration [m/s^2] that move neither x nor v by more than their last digits in a step h
/// [s].
template <class Real, class Time>
Magnitude<Real> acceleration_rounding(const State<Real>& y, const Time& h) {
  const auto per_step = 1.0 / magnitude(h);  // made once for all steps
  return std::numeric_limits<double>::epsilon() * per_step * (magnitude(y.x) * per_step + magnitude(y.v));
}

/// When an iteration has arrived. An update is at most the tolerance times the motion (or the root itself, if
/// larger); or updates no longer halve and are at rounding level (the given one, or a thousand roundings of
/// the motion): no equation in doubles can be solved better. NaN never arrives.
template <class Size>
class NewtonArrival {
 public:
  NewtonArrival(const NewtonScale<Size>& scale, double tolerance) : scale_(scale), tolerance_(tolerance) {}

  /// Sizes of the latest update and of the root after it. `done`: the lanes that had arrived before.
  template <class Yes>
  Yes operator()(const Size& update, const Size& root, const Yes& done) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const Size motion = larger(scale_.motion, root);
    const Yes near = done || update <= tolerance_ * motion;
    // Nearly always all have arrived, and nothing more need be computed.
    if (all(near)) return near;
    const Yes stalled = update > 0.5 * last_ && update <= larger(scale_.rounding, 1e3 * epsilon * motion);
    last_ = update;
    return near || stalled;
  }

 private:
  NewtonScale<Size> scale_;
  double tolerance_;
  Size last_ = std::numeric_limits<double>::infinity();
};

/// Newton's iteration for `count` unknowns that are pairs. The first components of all pairs have a scale of
/// their own and arrive by themselves; so do the second ones.
template <std::size_t count, class Real, class Residual>
NewtonResult<Coupled<Real>, std::array<Coupled<Real>, count>> newton_of_pairs(
    const Residual& residual, const std::array<Coupled<Real>, count>& guess,
    const NewtonScale<Coupled<double>>& scale, const NewtonOptions& options) {
  constexpr std::size_t size = 2 * count;
  using D = Dual<Real, size>;
  NewtonArrival<double> first_arrived({scale.motion.first, scale.rounding.first}, options.tolerance);
  NewtonArrival<double> second_arrived({scale.motion.second, scale.rounding.second}, options.tolerance);
  std::array<Coupled<Real>, count> u = guess;
  bool first_done = false, second_done = false;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    std::array<Coupled<D>, count> variables;
    for (std::size_t k = 0; k < count; ++k)
      variables[k] = {D::variable(u[k].first, 2 * k), D::variable(u[k].second, 2 * k + 1)};
    const std::array<Coupled<D>, count> r = residual(variables);
    std::array<std::array<Real, size>, size> jacobian;
    std::array<Real, size> update;
    for (std::size_t k = 0; k < count; ++k) {
      jacobian[2 * k] = r[k].first.derivative;
      jacobian[2 * k + 1] = r[k].second.derivative;
      update[2 * k] = r[k].first.value;
      update[2 * k + 1] = r[k].second.value;
    }
    solve_linear(jacobian, update);
    Coupled<double> moved, root;
    bool finite = true;
    for (std::size_t k = 0; k < count; ++k) {
      const Coupled<Real> change{update[2 * k], update[2 * k + 1]};
      u[k] = u[k] - change;
      moved = larger(moved, magnitude(change));
      root = larger(root, magnitude(u[k]));
      finite = finite && std::isfinite(value_of(change.first)) && std::isfinite(value_of(change.second));
    }
    // A comparison with NaN must not pass for a small update.
    if (!finite) continue;
    first_done = first_arrived(moved.first, root.first, first_done);
    second_done = second_arrived(moved.second, root.second, second_done);
    if (first_done && second_done) return {u, i, true};
  }
  return {u, options.iteration_limit, false};
}

/// A root of residual(u), from the guess; the residual is called with a Dual, so that its derivative is
/// exact.
template <class Real, class Residual>
requires(!is_coupled<Real>)
    [[gnu::always_inline]] inline NewtonResult<Real> newton(const Residual& residual, const Real& guess,
                                                            const NewtonScale<Magnitude<Real>>& scale,
                                                            const NewtonOptions& options) {
  NewtonArrival<Magnitude<Real>> arrived(scale, options.tolerance);
  Real u = guess;
  Truth<Real> done = false;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    const Dual<Real, 1> r = residual(Dual<Real, 1>::variable(u, 0));
    const Real update = r.value / r.derivative[0];
    u = choose(done, u, u - update);
    done = arrived(magnitude(update), magnitude(u), done);
    if (all(done)) return {u, i, done};
  }
  return {u, options.iteration_limit, done};
}

template <class Real, class Residual>
NewtonResult<Coupled<Real>> newton(const Residual& residual, const Coupled<Real>& guess,
                                   const NewtonScale<Coupled<double>>& scale, const NewtonOptions& options) {
  const auto solved = newton_of_pairs([&](const auto& u) { return std::array{residual(u[0])}; },
                                      std::array{guess}, scale, options);
  return {solved.root[0], solved.iterations, solved.converged};
}

template <class Real, class Residual>
NewtonResult<Coupled<Real>, std::array<Coupled<Real>, 2>> newton(const Residual& residual,
                                                                 const std::array<Coupled<Real>, 2>& guess,
                                                                 const NewtonScale<Coupled<double>>& scale,
                                                                 const NewtonOptions& options) {
  return newton_of_pairs(residual, guess, scale, options);
}

/// The same for two unknowns: residual takes and gives an array of two; sizes are those of the larger.
template <class Real, class Residual>
requires(!is_coupled<Real>) [[gnu::always_inline]] inline NewtonResult<Real, std::array<Real, 2>> newton(
    const Residual& residual, const std::array<Real, 2>& guess, const NewtonScale<Magnitude<Real>>& scale,
    const NewtonOptions& options) {
  using Unknown = Dual<Real, 2>;
  NewtonArrival<Magnitude<Real>> arrived(scale, options.tolerance);
  std::array<Real, 2> u = guess;
  Truth<Real> done = false;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    const auto [r, s] =
        residual(std::array<Unknown, 2>{Unknown::variable(u[0], 0), Unknown::variable(u[1], 1)});
    const auto& [r0, r1] = r.derivative;
    const auto& [s0, s1] = s.derivative;
    const Real determinant = r0 * s1 - r1 * s0;
    const Real first = (r.value * s1 - r1 * s.value) / determinant;
    const Real second = (r0 * s.value - r.value * s0) / determinant;
    u = {choose(done, u[0], u[0] - first), choose(done, u[1], u[1] - second)};
    // A comparison with NaN must not pass for a small update.
    const auto update = larger(magnitude(first), magnitude(second));
    const auto root = larger(magnitude(u[0]), magnitude(u[1]));
    const auto finite = magnitude(first + second) < std::numeric_limits<double>::infinity();
    done = done || (finite && arrived(update, root, done));
    if (all(done)) return {u, i, done};
  }
  return {u, options.iteration_limit, done};
}

}  // namespace cromer::core
