#include "cromer/identify/free_decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/identify/damped_phasor.h"
#include "cromer/identify/describe_fit.h"
#include "cromer/identify/levenberg_marquardt.h"
#include "cromer/identify/refusal.h"
#include "cromer/identify/rounding_bias.h"
#include "cromer/identify/start_values.h"

namespace cromer {
namespace {

LeastSquaresOptions least_squares_options(const Record& record, const FreeDecayOptions& options) {
  LeastSquaresOptions result;
  result.iteration_limit = options.iteration_limit;
  result.tolerance = options.tolerance;
  result.scale = centred_norm(record.y);
  result.residuals = static_cast<int>(record.t.size());
  return result;
}

// A model that an interruption makes impossible everywhere, so that no further step is tried for long.
template <class Model>
auto interruptible(Model model, const Watch& watch) {
  return [model = std::move(model), &watch](const Parameters& parameters) {
    if (!watch.interrupted()) return model(parameters);
    NormalEquations nowhere;
    nowhere.sum_of_squares = HUGE_VAL;
    return nowhere;
  };
}

// Nothing of it is known: parameters halfway to the minimum would look like a result.
FreeDecay interrupted_fit(const Law& law) {
  FreeDecay fit;
  fit.law = law;
  fit.status = FitStatus::iteration_limit;
  fit.message = "interrupted before the fit was done";
  return fit;
}

Record first_part(const Record& record, std::size_t samples) {
  return {record.t.first(samples), record.y.first(samples), record.resolution};
}

void set_status(FreeDecay& fit, LeastSquaresReason reason) {
  if (reason == LeastSquaresReason::converged) return;
  fit.status = FitStatus::iteration_limit;
  fit.message = reason == LeastSquaresReason::iteration_limit
                    ? fmt::format("the fit has not settled after {} iterations", fit.iterations)
                    : "the record does not determine this law: its terms cannot be told apart";
}

void warn_of_bounds(FreeDecay& fit) {
  if (fit.law.viscous && fit.decay_rate.value <= 0)
    fit.warnings.emplace_back("the decay rate is on its bound 0: the record shows no viscous damping");
  if (fit.drag && fit.drag->value <= 0)
    fit.warnings.emplace_back("the drag is on its bound 0: the record shows none");
}

// The viscous law in the phasor's own parameters, grown from a first part to the whole record.
LeastSquaresSummary fit_phasor(const Record& record, const StartValues& start,
                               const FreeDecayOptions& options, const Watch& watch) {
  LeastSquaresSummary summary;
  summary.parameters = start.phasor;
  int iterations = 0;
  for (std::size_t samples = start.samples;; samples = std::min(record.t.size(), 8 * samples)) {
    const Record part = first_part(record, samples);
    LeastSquaresOptions settings = least_squares_options(part, options);
    const double duration = part.t.back() - part.t.front();
    settings.lower[DampedPhasor::angular_frequency] = 1e-3 / duration;
    settings.lower[DampedPhasor::decay_rate] = 0;
    const bool whole = samples == record.t.size();
    if (!whole) settings.error_tolerance = 1e-2;
    summary = minimise(interruptible(DampedPhasor(part), watch), summary.parameters, settings);
    iterations += summary.iterations;
    if (whole || watch.interrupted()) break;
  }
  summary.iterations = iterations;
  return summary;
}

FreeDecay fit_sinusoid(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  FreeDecay fit;
  fit.law = Law{};
  const std::optional<StartValues> start = find_start_values(record);
  if (!start) {
    fit.status = FitStatus::no_oscillation;
    fit.message = "no oscillation found: the spectrum has no line";
    return fit;
  }
  const LeastSquaresSummary summary = fit_phasor(record, *start, options, watch);
  if (watch.interrupted()) return interrupted_fit(options.law);
  fit.iterations = summary.iterations;
  const Parameters& p = summary.parameters;
  const double w = p[DampedPhasor::angular_frequency], g = p[DampedPhasor::decay_rate];
  const double A = p[DampedPhasor::cosine], B = p[DampedPhasor::sine];
  const double w0 = std::hypot(w, g);
  const MotionParameters motion{.angular_frequency = w0,
                                .decay_rate = g,
                                .equilibrium = p[DampedPhasor::equilibrium],
                                .position = A,
                                .velocity = w * B - g * A};

  // The same covariance, said of w0, g, E, x0 = A and v0 = w B - g A.
  constexpr int n = DampedPhasor::parameter_count;
  const double jacobian[n][n] = {
      {w / w0, g / w0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {B, -A, 0, -g, w}};
  const SquareMatrix phasor_inverse = inverse(summary.equations.matrix, n);
  SquareMatrix inverse_matrix{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (int l = 0; l < n; ++l)
          inverse_matrix[i][j] += jacobian[i][k] * phasor_inverse[k][l] * jacobian[j][l];

  std::vector<double> residuals;
  DampedPhasor(record).residuals(p, residuals);
  Parameters bias{};
  if (const std::vector<double> y = rounded_motion(record, residuals); !y.empty()) {
    const Parameters right = DampedPhasor({record.t, y, 0})(p).right;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) bias[i] += jacobian[i][k] * phasor_inverse[k][j] * right[j];
  }
  describe_fit(fit, record, motion, inverse_matrix, bias, residuals);
  fit.step = motion_step(w0, record.t.back() - record.t.front(), 1e-9);
  set_status(fit, summary.reason);
  if (const auto refusal = refuse_fit(record, fit)) {
    fit.status = refusal->status;
    fit.message = refusal->message;
  }
  return fit;
}

// The first periods of a record, as many as the frequency of a large swing stays put for.
Record first_periods(const Record& record, double angular_frequency) {
  const double end = record.t.front() + 8 * 2 * std::numbers::pi / angular_frequency;
  const auto samples =
      static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), end) - record.t.begin());
  return first_part(
      record, std::clamp<std::size_t>(samples, std::min<std::size_t>(32, record.t.size()), record.t.size()));
}

// A swing whose frequency changes as it decays leaves a sinusoid out of step, and is an oscillation all the
// same: its first periods show it.
FreeDecay fit_viscous(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  FreeDecay fit = fit_sinusoid(record, options, watch);
  if (fit.status == FitStatus::no_oscillation && fit.angular_frequency.value > 0) {
    const Record beginning = first_periods(record, fit.angular_frequency.value);
    constexpr double clear = 0.95;
    if (3 * beginning.t.size() < record.t.size()) {
      const FreeDecay first = fit_sinusoid(beginning, options, watch);
      if (first.status == FitStatus::converged && first.explained > clear) {
        fit.status = FitStatus::converged;
        fit.message.clear();
        fit.warnings.push_back(
            fmt::format("the frequency changes along the record: one decaying sinusoid accounts for {:.0f} % "
                        "of the variance only",
                        100 * std::max(0.0, fit.explained)));
      }
    }
  }
  warn_of_bounds(fit);
  return fit;
}

LeastSquaresSummary minimise_motion(const Record& record, const Law& law, const Parameters& start, double h,
                                    LeastSquaresOptions settings, const Watch& watch) {
  const auto model = [&](const Parameters& parameters) {
    return motion_equations(law, parameters, record, h);
  };
  return minimise(interruptible(model, watch), start, settings);
}

// Where the iteration of a motion begins. The frequency of a large swing depends on its amplitude: a start
// from the whole record's viscous fit would then lose count of the periods, and a few periods' does not.
KnownMotion known_motion(const Record& record, const FreeDecayOptions& options, const FreeDecay& viscous,
                         const Watch& watch) {
  constexpr double certain = 0.95;
  const KnownMotion whole{viscous.motion(), record.t.size()};
  if (viscous.explained > certain) return whole;
  const Record beginning = first_periods(record, viscous.angular_frequency.value);
  if (beginning.t.size() >= record.t.size()) return whole;
  const FreeDecay first = fit_sinusoid(beginning, options, watch);
  return {first.status == FitStatus::converged ? first.motion() : viscous.motion(), beginning.t.size()};
}

// From a first part to the whole record, twice as long each time.
Parameters grow(const Record& record, const Law& law, const FreeDecayOptions& options,
                const KnownMotion& known, const Watch& watch) {
  const FittedParameters fitted = fitted_parameters(law);
  const double period = 2 * std::numbers::pi / known.motion.angular_frequency;
  Parameters parameters = pack(fitted, known.motion);
  for (std::size_t samples = known.samples; samples < record.t.size(); samples *= 2) {
    const Record part = first_part(record, samples);
    LeastSquaresOptions settings = least_squares_options(part, options);
    settings.error_tolerance = 0.1;
    settings.iteration_limit = 12;
    for (int i = 0; i < fitted.count; ++i)
      if (fitted.member[i] == &MotionParameters::decay_rate || fitted.member[i] == &MotionParameters::drag)
        settings.lower[i] = 0;
    parameters = minimise_motion(part, law, parameters, period / 40, settings, watch).parameters;
  }
  return parameters;
}

FreeDecay fit_motion(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  FreeDecay fit;
  fit.law = options.law;
  KnownMotion known;
  if (options.start) {
    known = *options.start;
  } else {
    const FreeDecay viscous = fit_viscous(record, options, watch);
    const bool usable =
        viscous.status == FitStatus::converged || viscous.status == FitStatus::iteration_limit;
    if (!usable || watch.interrupted()) {
      fit = viscous;
      fit.law = options.law;
      return fit;
    }
    known = known_motion(record, options, viscous, watch);
    known.decay_rate = viscous.decay_rate.value;
  }
  const FittedParameters fitted = fitted_parameters(options.law);
  LeastSquaresOptions settings = least_squares_options(record, options);
  for (int i = 0; i < fitted.count; ++i)
    if (fitted.member[i] == &MotionParameters::decay_rate || fitted.member[i] == &MotionParameters::drag)
      settings.lower[i] = 0;

  const MotionParameters& first = known.motion;
  const double duration = record.t.back() - record.t.front();
  const double seen = std::min(duration, 3 / std::max(known.decay_rate, 1e-300));
  const double amplitude = std::hypot(first.position, first.velocity / first.angular_frequency);
  const double root_n = std::sqrt(static_cast<double>(record.t.size()));
  // The method's error may move a parameter by a twentieth of its standard error.
  const auto step_for = [&](double rms) {
    return motion_step(first.angular_frequency, seen, 0.05 * rms / (root_n * amplitude));
  };

  const Parameters start = grow(record, options.law, options, known, watch);
  // Most of the way in coarse steps, then as fine as the residuals ask for.
  LeastSquaresOptions coarse = settings;
  coarse.error_tolerance = 1e-2;
  LeastSquaresSummary summary = minimise_motion(
      record, options.law, start, 2 * std::numbers::pi / first.angular_frequency / 40, coarse, watch);
  fit.iterations = summary.iterations;
  double h = step_for(std::sqrt(summary.equations.sum_of_squares) / root_n);
  for (int round = 0; round < 4; ++round) {
    summary = minimise_motion(record, options.law, summary.parameters, h, settings, watch);
    fit.iterations += summary.iterations;
    const double finer = step_for(std::sqrt(summary.equations.sum_of_squares) / root_n);
    if (finer > 0.8 * h) break;
    h = finer;
  }

  if (watch.interrupted()) return interrupted_fit(options.law);
  fit.step = h;
  const MotionParameters motion = unpack(fitted, summary.parameters);
  const std::vector<double> residuals = motion_residuals(motion, record, h);
  if (residuals.size() != record.t.size()) {
    fit.status = FitStatus::iteration_limit;
    fit.message = "this law's motion runs away from the recorded one";
    return fit;
  }
  const SquareMatrix inverse_matrix = inverse(summary.equations.matrix, fitted.count);
  Parameters bias{};
  if (const std::vector<double> y = rounded_motion(record, residuals); !y.empty()) {
    const NormalEquations pull = motion_equations(options.law, summary.parameters, {record.t, y, 0}, h);
    for (int i = 0; i < fitted.count; ++i)
      for (int j = 0; j < fitted.count; ++j) bias[i] += inverse_matrix[i][j] * pull.right[j];
  }
  describe_fit(fit, record, motion, inverse_matrix, bias, residuals);
  set_status(fit, summary.reason);
  warn_of_bounds(fit);
  return fit;
}

}  // namespace

std::string_view name(FitStatus status) {
  switch (status) {
    case FitStatus::converged:
      return "converged";
    case FitStatus::iteration_limit:
      return "iteration_limit";
    case FitStatus::no_oscillation:
      return "no_oscillation";
    case FitStatus::too_short:
      return "too_short";
    case FitStatus::too_noisy:
      return "too_noisy";
    case FitStatus::clipped:
      return "clipped";
    case FitStatus::overdamped:
      return "overdamped";
  }
  return "";
}

MotionParameters FreeDecay::motion() const {
  return {.angular_frequency = angular_frequency.value,
          .decay_rate = decay_rate.value,
          .drag = drag ? drag->value : 0,
          .cubic = cubic ? cubic->value : 0,
          .equilibrium = equilibrium.value,
          .position = position.value,
          .velocity = velocity.value};
}

double FreeDecay::covariance_of(std::string_view a, std::string_view b) const {
  const auto i = std::find(names.begin(), names.end(), a), j = std::find(names.begin(), names.end(), b);
  if (i == names.end() || j == names.end()) return 0;
  const auto row = static_cast<std::size_t>(i - names.begin()),
             column = static_cast<std::size_t>(j - names.begin());
  return covariance[row * names.size() + column];
}

FreeDecay fit_free_decay(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  if (const auto refusal = refuse_record(record)) {
    FreeDecay fit;
    fit.law = options.law;
    fit.status = refusal->status;
    fit.message = refusal->message;
    return fit;
  }
  if (watch.interrupted()) return interrupted_fit(options.law);
  return options.law == Law{} ? fit_viscous(record, options, watch) : fit_motion(record, options, watch);
}

Trajectory motion_of(const FreeDecay& fit, std::span<const double> t) {
  return free_motion(fit.motion(), t, fit.step);
}

}  // namespace cromer
