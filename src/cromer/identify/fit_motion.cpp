#include "cromer/identify/fit_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cromer/identify/bounds.h"
#include "cromer/identify/describe_fit.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/fit_viscous.h"
#include "cromer/identify/refusal.h"
#include "cromer/identify/rest_minima.h"
#include "cromer/identify/rounding_bias.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double coarsest = 1.0 / 20;  // step, in periods: off by a millionth a radian

auto model_of(const Record& record, const Law& law, double h, const Watch& watch) {
  return interruptible(
      [&record, law, h](const Parameters& parameters) {
        return motion_equations(law, parameters, record, h);
      },
      watch);
}

// The frequency of a large swing depends on its amplitude: a start from the whole record's viscous fit would
// then lose count of the periods, and a few periods' does not.
KnownMotion linear_motion(const Record& record, const FreeDecayOptions& options, const FreeDecay& viscous,
                          const Watch& watch) {
  constexpr double certain = 0.95;
  const KnownMotion whole{viscous.motion(), record.t.size(), viscous.decay_rate.value};
  if (viscous.explained > certain) return whole;
  const auto first = fit_first_periods(record, viscous.angular_frequency.value, options, watch);
  if (!first) return whole;
  return {first->fit.motion(), first->samples, viscous.decay_rate.value};
}

// From a first part to the whole record, twice as long each time.
Parameters grow(const Record& record, const FreeDecayOptions& options, const KnownMotion& known,
                const Watch& watch) {
  const FittedParameters fitted = fitted_parameters(options.law);
  const double period = two_pi / known.motion.angular_frequency;
  Parameters parameters = pack(fitted, known.motion);
  for (std::size_t samples = known.samples; samples < record.t.size(); samples *= 2) {
    const Record part = first_part(record, samples);
    LeastSquaresOptions settings = least_squares_options(part, options);
    settings.error_tolerance = 0.1;
    settings.iteration_limit = 12;
    settings.lower = lower_bounds(fitted);
    parameters =
        minimise(model_of(part, options.law, coarsest * period, watch), parameters, settings).parameters;
  }
  return parameters;
}

// Every so manieth sample, at least twenty in a period.
struct Thinned {
  std::vector<double> t, y;
  Record record;

  Thinned(const Record& all, double period) : record(all) {
    const double h = (all.t.back() - all.t.front()) / static_cast<double>(all.t.size() - 1);
    const auto stride = static_cast<std::size_t>(std::clamp(period / (20 * h), 1.0, 1e6));
    if (stride < 2) return;
    for (std::size_t i = 0; i < all.t.size(); i += stride) t.push_back(all.t[i]), y.push_back(all.y[i]);
    if (t.size() < 64) return;
    record.t = t;
    record.y = y;
  }
};

}  // namespace

bool Beginning::usable() const {
  return viscous.status == FitStatus::converged || viscous.status == FitStatus::iteration_limit;
}

KnownMotion Beginning::known(const Law& law, double t0) const {
  KnownMotion result = linear;
  result.motion.pendulum = law.pendulum;
  if (!law.viscous) result.motion.decay_rate = 0;
  if (track) {
    result.motion = motion_along(*track, law, t0);
    // Where it comes to rest depends on how many half swings there are: the swing itself must tell that
    // before the rest may pull.
    result.samples = law.friction ? track->swinging : track->samples;
  }
  return result;
}

Beginning begin_fit(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  Beginning beginning;
  beginning.viscous = fit_viscous(record, options, watch);
  if (!beginning.usable() || watch.interrupted()) return beginning;
  beginning.linear = linear_motion(record, options, beginning.viscous, watch);
  beginning.track =
      track_envelope(record, beginning.linear.motion.angular_frequency, beginning.linear.decay_rate);
  return beginning;
}

FreeDecay fit_motion(const Record& record, const FreeDecayOptions& options, const KnownMotion& known,
                     const Watch& watch, bool roughly) {
  FreeDecay fit;
  fit.law = options.law;
  const FittedParameters fitted = fitted_parameters(options.law);
  LeastSquaresOptions settings = least_squares_options(record, options);
  settings.lower = lower_bounds(fitted);

  const MotionParameters& first = known.motion;
  const double duration = record.t.back() - record.t.front();
  const double seen = std::min(duration, 3 / std::max(known.decay_rate, 1e-300));
  const double amplitude = std::hypot(first.position, first.velocity / first.angular_frequency) *
                           std::pow(first.angular_frequency, record.derivative);
  const double root_n = std::sqrt(static_cast<double>(record.t.size()));
  // The method's error may move a parameter by a twentieth of its standard error.
  const auto step_for = [&](double rms) {
    return motion_step(first.angular_frequency, seen, 0.05 * rms / (root_n * amplitude));
  };

  // Most of the way in coarse steps and on few samples, then as fine as the residuals ask for.
  const double period = two_pi / first.angular_frequency;
  const Thinned thinned(record, period);
  LeastSquaresOptions coarse = settings;
  coarse.error_tolerance = roughly ? 1e-2 : 1e-1;
  if (roughly) coarse.iteration_limit = settings.iteration_limit = std::min(20, options.iteration_limit);
  coarse.residuals = static_cast<int>(thinned.record.t.size());
  Parameters start = grow(record, options, known, watch);
  double h = coarsest * period;
  LeastSquaresSummary summary = minimise(model_of(thinned.record, options.law, h, watch), start, coarse);
  fit.iterations = summary.iterations;
  Minimum minimum;
  if (roughly) {
    settings.error_tolerance = 1e-2;
    minimum = minimise_both(model_of(record, options.law, h, watch), summary.parameters, settings);
    fit.iterations += minimum.bounded.iterations;
  } else {
    h = step_for(std::sqrt(summary.equations.sum_of_squares / static_cast<double>(coarse.residuals)));
    Parameters from = summary.parameters;
    for (int round = 0; round < 4; ++round) {
      minimum = minimise_both(model_of(record, options.law, h, watch), from, settings);
      fit.iterations += minimum.bounded.iterations;
      from = minimum.bounded.parameters;
      const double finer = step_for(std::sqrt(minimum.bounded.equations.sum_of_squares) / root_n);
      if (finer > 0.8 * h) break;
      h = finer;
    }
  }

  // Of the minima for several numbers of half swings before a rest the lowest counts.
  std::vector<LeastSquaresSummary> minima =
      rest_minima(record, options.law, minimum.bounded, settings, h, watch);
  if (minima.front().equations.sum_of_squares < minimum.bounded.equations.sum_of_squares) {
    minimum = minimise_both(model_of(record, options.law, h, watch), minima.front().parameters, settings);
    fit.iterations += minimum.bounded.iterations;
  }
  if (minimum.bounded.reason == LeastSquaresReason::iteration_limit)
    minimum.bounded = minimum.free =
        end_of_band_minimum(record, options.law, minimum.bounded, settings, h, watch);
  minima.front() = minimum.bounded;

  if (watch.interrupted()) return interrupted_fit(options.law);
  fit.step = h;
  const MotionParameters motion = unpack(fitted, minimum.bounded.parameters);
  const std::vector<double> residuals = motion_residuals(motion, record, h);
  if (residuals.size() != record.t.size() || !std::isfinite(residuals.back())) {
    fit.status = FitStatus::iteration_limit;
    fit.message = "this law's motion runs away from the recorded one";
    return fit;
  }
  const SquareMatrix inverse_matrix = inverse(minimum.free.equations.matrix, fitted.count);
  Parameters bias{};
  if (const std::vector<double> y = rounded_motion(record, residuals); !y.empty()) {
    Record pulled = record;
    pulled.y = y;
    const NormalEquations pull = motion_equations(options.law, minimum.bounded.parameters, pulled, h);
    for (int i = 0; i < fitted.count; ++i)
      for (int j = 0; j < fitted.count; ++j) bias[i] += inverse_matrix[i][j] * pull.right[j];
  }
  describe_fit(fit, record, motion, inverse_matrix, bias, residuals);
  set_intervals(fit, unpack(fitted, minimum.free.parameters), record);
  spread_over(fit, minima);
  set_status(fit, minimum.bounded.reason);
  if (const auto refusal = refuse_frequency(fit); refusal && fit.status == FitStatus::converged) {
    fit.status = refusal->status;
    fit.message = refusal->message;
  }
  return fit;
}

}  // namespace cromer
