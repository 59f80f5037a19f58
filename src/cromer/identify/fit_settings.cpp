#include "cromer/identify/fit_settings.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/refusal.h"

namespace cromer::core {

LeastSquaresOptions least_squares_options(const Record& record, const LawFitOptions& options) {
  LeastSquaresOptions result;
  result.iteration_limit = options.iteration_limit;
  result.tolerance = options.tolerance;
  result.scale = centred_norm(record.y);
  result.residuals = static_cast<int>(record.t.size());
  return result;
}

HeldParameters held_parameters(const Record& record, const Law& law, DriveKind drive) {
  if (!is_recorded(drive)) return {};
  // Without a spring a velocity does not show the place, and its offset looks like one of the force.
  if (record.derivative > 0 && !law.shares(springs)) return {.equilibrium = true, .position = true};
  // Of velocities and accelerations the place of rest is not seen: the equilibrium is the sensor's offset.
  if (record.derivative > 0) return {.force_offset = true};
  if (!law.shares(springs)) return {.equilibrium = true};
  // The instrument's zero lies amid the motion: within a tenth of its rms of the mean.
  const auto n = static_cast<double>(record.y.size());
  double mean = 0;
  for (const double y : record.y) mean += y / n;
  const bool amid = std::abs(mean) <= 0.1 * centred_norm(record.y) / std::sqrt(n);
  return {.equilibrium = amid, .force_offset = !amid};
}

Watch within_steps(const Watch& watch, const Record& record, DriveKind drive) {
  if (watch.steps_left) return watch;
  constexpr double any = 8e5, of_a_sample = 3000, of_a_forced_sample = 20'000;
  const double each = is_recorded(drive) ? of_a_forced_sample : of_a_sample;
  Watch bound = watch;
  bound.steps_left = std::make_shared<std::atomic<double>>(any + each * static_cast<double>(record.t.size()));
  return bound;
}

Watch counting_passes(const Watch& whole) {
  if (!whole.progress) return whole;
  Watch counting = whole;
  counting.pulse = [&whole, passes = 0]() mutable {
    constexpr double to_half = 20;
    ++passes;
    whole.progress(passes / (passes + to_half));
  };
  return counting;
}

Notice why_ended(const Watch& watch) {
  return Notice{watch.out_of_steps() ? "too_many_steps" : "interrupted"};
}

LawFit interrupted_fit(const LawFitOptions& options, const Watch& watch) {
  return refused(
      {FitStatus::iteration_limit, Notice{"ended_before_fit_was_done", {{"why", why_ended(watch)}}}},
      options);
}

Record first_periods(const Record& record, double angular_frequency, double periods) {
  const double end = record.t.front() + periods * two_pi / angular_frequency;
  const auto samples =
      static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), end) - record.t.begin());
  return record.first(
      std::clamp<std::size_t>(samples, std::min<std::size_t>(32, record.t.size()), record.t.size()));
}

void set_status(LawFit& fit, LeastSquaresReason reason) {
  if (reason == LeastSquaresReason::converged || fit.status == FitStatus::undetermined) return;
  fit.status = FitStatus::iteration_limit;
  switch (reason) {
    case LeastSquaresReason::iteration_limit:
      fit.message = Notice{"fit_not_settled", {{"iterations", fit.iterations}}};
      break;
    case LeastSquaresReason::not_finite:
      fit.message = Notice{"motion_runs_away"};
      break;
    default:
      fit.message = Notice{"law_undetermined", {{"what", Notice{"terms_not_told_apart"}}}};
  }
}

}  // namespace cromer::core
