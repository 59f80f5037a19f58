#include "cromer/identify/free_decay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/identify/damped_phasor.h"
#include "cromer/identify/levenberg_marquardt.h"
#include "cromer/identify/refusal.h"
#include "cromer/identify/start_values.h"

namespace cromer {
namespace {

double centred_norm(std::span<const double> y) {
  double mean = 0, sum = 0;
  for (double value : y) mean += value;
  mean /= static_cast<double>(y.size());
  for (double value : y) sum += (value - mean) * (value - mean);
  return std::sqrt(sum);
}

LeastSquaresOptions least_squares_options(const Record& record, const FreeDecayOptions& options) {
  LeastSquaresOptions result;
  result.iteration_limit = options.iteration_limit;
  result.tolerance = options.tolerance;
  result.scale = centred_norm(record.y);
  result.residuals = static_cast<int>(record.t.size());
  return result;
}

Record first_part(const Record& record, std::size_t samples) {
  return {record.t.first(samples), record.y.first(samples), record.resolution};
}

// An equilibrium lives at zero frequency, all else at the oscillation's own: their variances widen
// differently.
struct Widening {
  double oscillation = 1, equilibrium = 1;

  double of(std::string_view parameter) const {
    return parameter == "equilibrium" ? equilibrium : oscillation;
  }
};

// Covariance, intervals and statistics from the inverse of the normal matrix, in the order of
// fitted_parameters.
void describe(FreeDecay& fit, const Record& record, const MotionParameters& motion,
              const SquareMatrix& inverse_matrix, std::span<const double> residuals) {
  const FittedParameters fitted = fitted_parameters(fit.law);
  const auto n = static_cast<double>(record.t.size());
  const double h = (record.t.back() - record.t.front()) / (n - 1);
  const std::vector<double> rho = autocorrelations(residuals, first_lags(residuals.size()));
  fit.residual = describe_residual(residuals, rho);
  const double norm = centred_norm(record.y);
  const double sum_of_squares = fit.residual.rms * fit.residual.rms * n;
  fit.explained = 1 - sum_of_squares / (norm * norm);

  const Widening widening{correlation_factor(residuals, rho, motion.angular_frequency * h),
                          correlation_factor(residuals, rho, 0)};
  fit.independent_samples = n / widening.oscillation;
  const double k = fitted.count;
  const double degrees = std::max(1.0, fit.independent_samples - k);
  fit.student = student_95(degrees);
  fit.bic = fit.independent_samples * 2 * std::log(fit.residual.rms) + k * std::log(fit.independent_samples);
  // Rounding alone leaves q^2/12; residuals below that only repeat the rounding's pattern.
  const double variance =
      std::max(sum_of_squares / std::max(1.0, n - k), record.resolution * record.resolution / 12);

  fit.names.clear();
  fit.covariance.assign(static_cast<std::size_t>(fitted.count * fitted.count), 0);
  for (int i = 0; i < fitted.count; ++i) {
    fit.names.emplace_back(fitted.name[i]);
    for (int j = 0; j < fitted.count; ++j)
      fit.covariance[static_cast<std::size_t>(i * fitted.count + j)] =
          variance * inverse_matrix[i][j] *
          std::sqrt(widening.of(fitted.name[i]) * widening.of(fitted.name[j]));
  }
  const auto estimate = [&](std::string_view parameter, double value) {
    return make_estimate(value, std::sqrt(std::max(0.0, fit.covariance_of(parameter, parameter))),
                         fit.student);
  };
  fit.angular_frequency = estimate("angular_frequency", motion.angular_frequency);
  fit.decay_rate = estimate("decay_rate", motion.decay_rate);
  if (fit.law.drag) fit.drag = estimate("drag", motion.drag);
  if (fit.law.cubic) fit.cubic = estimate("cubic", motion.cubic);
  fit.equilibrium = estimate("equilibrium", motion.equilibrium);
  fit.position = estimate("position", motion.position);
  fit.velocity = estimate("velocity", motion.velocity);
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
                               const FreeDecayOptions& options) {
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
    summary = minimise(DampedPhasor(part), summary.parameters, settings);
    iterations += summary.iterations;
    if (whole) break;
  }
  summary.iterations = iterations;
  return summary;
}

FreeDecay fit_sinusoid(const Record& record, const FreeDecayOptions& options) {
  FreeDecay fit;
  fit.law = Law{};
  const std::optional<StartValues> start = find_start_values(record);
  if (!start) {
    fit.status = FitStatus::no_oscillation;
    fit.message = "no oscillation found: the spectrum has no line";
    return fit;
  }
  const LeastSquaresSummary summary = fit_phasor(record, *start, options);
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
  describe(fit, record, motion, inverse_matrix, residuals);
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
FreeDecay fit_viscous(const Record& record, const FreeDecayOptions& options) {
  FreeDecay fit = fit_sinusoid(record, options);
  if (fit.status == FitStatus::no_oscillation && fit.angular_frequency.value > 0) {
    const Record beginning = first_periods(record, fit.angular_frequency.value);
    constexpr double clear = 0.95;
    if (3 * beginning.t.size() < record.t.size()) {
      const FreeDecay first = fit_sinusoid(beginning, options);
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
    NormalEquations equations = motion_equations(law, parameters, record, h);
    if (watch.interrupted()) equations.sum_of_squares = HUGE_VAL;  // no step is accepted any more
    return equations;
  };
  return minimise(model, start, settings);
}

// From the viscous fit of a few periods to the whole record, twice as long each time: where the frequency
// depends on the amplitude, a start from the whole record's viscous fit would lose count of the periods.
Parameters grow(const Record& record, const Law& law, const FreeDecayOptions& options,
                const FreeDecay& viscous, const Watch& watch) {
  const FittedParameters fitted = fitted_parameters(law);
  const double period = 2 * std::numbers::pi / viscous.angular_frequency.value;
  const Record beginning = first_periods(record, viscous.angular_frequency.value);
  std::size_t samples = beginning.t.size();
  Parameters parameters = pack(fitted, viscous.motion());
  if (samples >= record.t.size()) return parameters;
  const FreeDecay start = fit_sinusoid(beginning, options);
  if (start.status == FitStatus::converged) parameters = pack(fitted, start.motion());
  for (; samples < record.t.size(); samples *= 2) {
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
  const FreeDecay viscous = fit_viscous(record, options);
  FreeDecay fit;
  fit.law = options.law;
  if (viscous.status != FitStatus::converged && viscous.status != FitStatus::iteration_limit) {
    fit = viscous;
    fit.law = options.law;
    return fit;
  }
  const FittedParameters fitted = fitted_parameters(options.law);
  LeastSquaresOptions settings = least_squares_options(record, options);
  for (int i = 0; i < fitted.count; ++i)
    if (fitted.member[i] == &MotionParameters::decay_rate || fitted.member[i] == &MotionParameters::drag)
      settings.lower[i] = 0;

  const double duration = record.t.back() - record.t.front();
  const double seen = std::min(duration, 3 / std::max(viscous.decay_rate.value, 1e-300));
  const double amplitude =
      std::hypot(viscous.position.value, viscous.velocity.value / viscous.angular_frequency.value);
  const double root_n = std::sqrt(static_cast<double>(record.t.size()));
  // The method's error may move a parameter by a twentieth of its standard error.
  const auto step_for = [&](double rms) {
    return motion_step(viscous.angular_frequency.value, seen, 0.05 * rms / (root_n * amplitude));
  };

  constexpr double certain = 0.95;
  const Parameters start = viscous.explained > certain ? pack(fitted, viscous.motion())
                                                       : grow(record, options.law, options, viscous, watch);
  // Most of the way in coarse steps, then as fine as the residuals ask for.
  LeastSquaresOptions coarse = settings;
  coarse.error_tolerance = 1e-2;
  LeastSquaresSummary summary = minimise_motion(
      record, options.law, start, 2 * std::numbers::pi / viscous.angular_frequency.value / 40, coarse, watch);
  fit.iterations = summary.iterations;
  double h = step_for(std::sqrt(summary.equations.sum_of_squares) / root_n);
  for (int round = 0; round < 4; ++round) {
    summary = minimise_motion(record, options.law, summary.parameters, h, settings, watch);
    fit.iterations += summary.iterations;
    const double finer = step_for(std::sqrt(summary.equations.sum_of_squares) / root_n);
    if (finer > 0.8 * h) break;
    h = finer;
  }

  fit.step = h;
  const MotionParameters motion = unpack(fitted, summary.parameters);
  const std::vector<double> residuals = motion_residuals(motion, record, h);
  if (residuals.size() != record.t.size()) {
    fit.status = FitStatus::iteration_limit;
    fit.message = "this law's motion runs away from the recorded one";
    return fit;
  }
  describe(fit, record, motion, inverse(summary.equations.matrix, fitted.count), residuals);
  set_status(fit, summary.reason);
  if (watch.interrupted()) {
    fit.status = FitStatus::iteration_limit;
    fit.message = "interrupted";
  }
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
  return options.law == Law{} ? fit_viscous(record, options) : fit_motion(record, options, watch);
}

Trajectory motion_of(const FreeDecay& fit, std::span<const double> t) {
  return free_motion(fit.motion(), t, fit.step);
}

}  // namespace cromer
