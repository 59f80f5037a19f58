// What the fits of all laws share.
#pragma once

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"

namespace cromer::core {

/// Tolerances and scale of a record's least squares; no bounds yet.
LeastSquaresOptions least_squares_options(const Record& record, const LawFitOptions& options);

/// The parameters that are held by convention (see law_fit.h), because a record under this drive does not
/// tell them.
HeldParameters held_parameters(const Record& record, const Law& law, DriveKind drive);

/// The model, with an infinite sum of squares everywhere once the watch is interrupted: the minimiser then
/// soon ends. Each call takes `steps` of the watch's steps.
template <class Model>
auto interruptible(Model model, const Watch& watch, double steps = 0) {
  return [model = std::move(model), &watch, steps](const Parameters& parameters) {
    watch.take_steps(steps);
    if (!watch.interrupted()) return model(parameters);
    NormalEquations nowhere;
    nowhere.sum_of_squares = HUGE_VAL;
    return nowhere;
  };
}

/// The watch with a bound on the steps that all motions of a record's fits may take; unchanged if it has
/// one. The bound is more than any recorded swing has needed. Without it, a fit to noise with thousands of
/// periods between few samples would take minutes.
Watch within_steps(const Watch& watch, const Record& record, DriveKind drive);

/// The watch that tells of a fit of one law. How many passes it takes is known at its end only: the share
/// done rises with each by ever less. `whole` must outlive it.
Watch counting_passes(const Watch& whole);

/// A fit without values: a half-finished minimum would look like a result.
LawFit interrupted_fit(const LawFitOptions& options, const Watch& watch);

/// Why the work ended early: a clause for another notice.
Notice why_ended(const Watch& watch);

/// The first `periods` periods of a record; at least 32 samples.
Record first_periods(const Record& record, double angular_frequency, double periods);

/// Sets status and message for a reason other than converged.
void set_status(LawFit& fit, LeastSquaresReason reason);

/// Where the sum of squares is least, within the bounds and without them.
struct Minimum {
  LeastSquaresSummary bounded;
  LeastSquaresSummary free;  ///< the same where no bound is touched; `bounded` where there is no minimum
  bool touches = false;      ///< a parameter is on its bound
};
/// Minimises within the bounds and, where a parameter is on its bound, also without them.
template <class Model>
Minimum minimise_both(const Model& model, const Parameters& start, const LeastSquaresOptions& options) {
  Minimum minimum;
  minimum.bounded = minimum.free = minimise(model, start, options);
  for (int i = 0; i < minimum.bounded.equations.size; ++i)
    minimum.touches = minimum.touches || minimum.bounded.parameters[i] <= options.lower[i];
  if (!minimum.touches || minimum.bounded.reason != LeastSquaresReason::converged) return minimum;
  LeastSquaresOptions unbounded = options;
  unbounded.lower = LeastSquaresOptions::no_bounds();
  unbounded.iteration_limit = 12;
  unbounded.error_tolerance = 1e-2;
  const LeastSquaresSummary beyond = minimise(model, minimum.bounded.parameters, unbounded);
  minimum.bounded.iterations += beyond.iterations;
  if (beyond.reason == LeastSquaresReason::converged) minimum.free = beyond;
  return minimum;
}

/// The fit or, where it ends at no damping at all, or the swing is known to grow, and a negative one clearly
/// does better, that of the swing that grows: `fit_again(options)`, which takes a negative decay rate.
template <class FitAgain>
LawFit or_growing(LawFit fit, LawFitOptions options, const FitAgain& fit_again, bool known_to_grow = false) {
  const Estimate* found = fit.find(Viscous::coefficients[0].parameter);
  if (options.may_grow || !may_grow(fit.law) || !found || (found->value > 0 && !known_to_grow)) return fit;
  options.may_grow = true;
  LawFit growing = fit_again(options);
  constexpr double surely = 3;  // standard errors
  const Estimate g = growing.decay_rate();
  return growing.status == FitStatus::converged && g.value < -surely * g.standard_error ? growing : fit;
}

}  // namespace cromer::core
