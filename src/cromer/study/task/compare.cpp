#include "cromer/study/task/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/terms.h"
#include "cromer/study/task/end_comparison.h"
#include "cromer/study/task/forced_options.h"
#include "cromer/study/task/keep_at.h"
#include "cromer/study/task/run_law.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double most_steps = 1e8;

// A period has at least 200 steps, and a sample is a whole number of them.
double default_step(double spacing, double period) {
  return spacing / std::max(1.0, std::ceil(200 * spacing / period - 1e-9));
}

struct NamedLaw {
  std::string label;
  Law law;
  Oscillator<double> oscillator;  // per unit mass
};

// The figures of a curve that reached the end, and whether they mean anything.
void measure_curve(ComparedCurve& curve, const FittedRecording& recording, double step,
                   std::vector<std::string>& warnings) {
  const Series& series = recording.series;
  const FreeDecay& fit = recording.fit;
  const std::size_t n = curve.trajectory.size();
  std::vector<double> measured(n);
  double mean = 0, residual = 0, total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    measured[i] = series.y[i] - fit.equilibrium.value;
    mean += measured[i] / static_cast<double>(n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    residual += (measured[i] - curve.trajectory.x[i]) * (measured[i] - curve.trajectory.x[i]);
    total += (measured[i] - mean) * (measured[i] - mean);
  }
  curve.rms = std::sqrt(residual / static_cast<double>(n));
  curve.r_squared = 1 - residual / total;
  const EndComparison end = compare_ends(series.t, measured, curve.trajectory.x, fit.angular_frequency.value);
  curve.amplitude_ratio_end = end.amplitude_ratio;
  curve.phase_drift = end.phase_drift;
  // A free swing never exceeds its start by much: what does has grown from step to step.
  double largest = 0;
  const double start = std::hypot(fit.position.value, fit.velocity.value / fit.angular_frequency.value);
  for (const double x : curve.trajectory.x) largest = std::max(largest, std::abs(x));
  if (largest > 10 * start)
    warnings.push_back(fmt::format(
        "{}: {} with a step of {:.6g} s grows to {:.3g} times the amplitude that it started from: it is "
        "unstable there, and the figures say nothing of the law; take a smaller --step or another "
        "--method",
        curve.label, curve.method, step, largest / start));
}

Result<ComparedCurve> simulate_curve(const FittedRecording& recording, const NamedLaw& law,
                                     const CompareOptions& options, double step,
                                     std::vector<std::string>& warnings, const Watch& watch) {
  if (options.method == "exact")
    if (const std::string term = why_not_exact(law.oscillator); !term.empty())
      return Error{fmt::format(
          "--method exact: there is no closed form with {}; choose rk4 or another method, or --law viscous",
          term)};
  const Series& series = recording.series;
  const FreeDecay& fit = recording.fit;
  const double t0 = series.t.front(), duration = series.t.back() - t0;
  const Interval interval{t0, t0 + std::ceil(duration / step - 1e-9) * step};
  KeepAt keep(series.t, 1e-6 * step);
  KeepEvery each{AnyRecorder(keep)};
  const Outcome outcome = run_law({.oscillator = law.oscillator,
                                   .method = options.method,
                                   .interval = interval,
                                   .start = {fit.position.value, fit.velocity.value},
                                   .control = step},
                                  each, watch);

  ComparedCurve curve;
  curve.label = law.label;
  curve.law = law.law;
  curve.method = options.method;
  curve.trajectory = keep.take();
  if (outcome.status != Status::reached_end || curve.trajectory.size() < series.t.size()) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    curve.rms = curve.r_squared = curve.amplitude_ratio_end = curve.phase_drift = unknown;
    curve.complete = false;
    warnings.push_back(outcome.interrupted
                           ? fmt::format("{}: interrupted at {:.6g} s", law.label, outcome.t)
                           : fmt::format("{}: {} ended at {:.6g} s with {}; a smaller --step may help",
                                         law.label, options.method, outcome.t, name(outcome.status)));
    return curve;
  }

  measure_curve(curve, recording, step, warnings);
  return curve;
}

// The same recording, fitted with a law of one's own choice.
Result<FittedRecording> with_law(const FittedRecording& recording, const Law& law, const Watch& watch) {
  FitOptions options = recording.options;
  options.law = to_text(law);
  options.from = options.to = std::nullopt;
  options.segment = std::nullopt;
  options.segments = std::nullopt;
  options.disc_diameter = std::nullopt;
  options.monte_carlo = std::nullopt;
  options.goal.clear();
  options.textbook = false;
  return fit_series(recording.series, recording.file, options, watch);
}

// The constant rate, and the frequency that goes with it.
Result<NamedLaw> constant_rate(const FittedRecording& recording, const Watch& watch) {
  double w0 = recording.fit.angular_frequency.value, g = recording.fit.decay_rate.value;
  if (!(recording.fit.law == Law{})) {
    const Result<FittedRecording> fitted = with_law(recording, Law{}, watch);
    if (!fitted) return fitted.error();
    if (watch.interrupted()) return NamedLaw{};
    w0 = fitted->fit.angular_frequency.value;
    g = fitted->fit.decay_rate.value;
  }
  if (recording.decay_rate_mean) g = recording.decay_rate_mean->value;
  return NamedLaw{"one constant decay rate", Law{}, {.mass = 1, .stiffness = w0 * w0, .damping = 2 * g}};
}

}  // namespace

Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch) {
  if (const Result<void> known = check_method_name(options.method); !known)
    return Error{"--method: " + known.error().message};
  CompareResult result;
  result.recording = recording;
  const FreeDecay& fit = recording.fit;
  const bool fitted = fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit;
  if (!fitted || !(fit.angular_frequency.value > 0)) return result;
  if (recording.series.quantity.find("velocity") != std::string::npos ||
      recording.series.quantity == "acceleration")
    return Error{fmt::format(
        "compare needs a position or an angle, and column \"{}\" holds {}; choose one by --column",
        recording.series.column, recording.series.quantity)};

  const Series& series = recording.series;
  const double period = two_pi / fit.angular_frequency.value, duration = series.t.back() - series.t.front();
  const double spacing = series.rate > 0 ? 1 / series.rate : period / 200;
  const double step = options.step.value_or(default_step(spacing, period));
  if (!(step > 0) || duration / step > most_steps)
    return Error{fmt::format("--step {}: it must be positive and give at most {:.0e} steps over {:.6g} s",
                             step, most_steps, duration)};

  MotionParameters p = fit.motion();
  Law law_simulated = fit.law;
  if (fit.law.pendulum) {
    law_simulated.pendulum = false;
    law_simulated.cubic = true;
    const Result<FittedRecording> refitted = with_law(recording, law_simulated, watch);
    if (!refitted) return refitted.error();
    p = refitted->fit.motion();
    result.warnings.push_back(
        fmt::format("the pendulum is simulated as {}, fitted to the recording: the methods' law has no sine",
                    to_text(law_simulated)));
  }
  const Result<NamedLaw> constant = constant_rate(recording, watch);
  if (!constant) return constant.error();
  if (watch.interrupted()) {
    result.warnings.emplace_back("interrupted before anything was simulated");
    result.complete = false;
    return result;
  }
  const NamedLaw chosen{to_text(law_simulated),
                        law_simulated,
                        {.mass = 1,
                         .stiffness = p.angular_frequency * p.angular_frequency,
                         .damping = 2 * p.decay_rate,
                         .drag = p.drag,
                         .friction = p.friction,
                         .cubic = p.cubic}};
  for (const NamedLaw& law : {*constant, chosen}) {
    Result<ComparedCurve> curve = simulate_curve(recording, law, options, step, result.warnings, watch);
    if (!curve) return curve.error();
    result.complete = result.complete && curve->complete;
    result.curves.push_back(std::move(*curve));
  }
  return result;
}

Result<std::vector<CompareResult>> compare(std::string_view bytes, std::string_view file,
                                           const CompareOptions& options, const Watch& watch) {
  if (const Result<void> known = check_method_name(options.method); !known)
    return Error{"--method: " + known.error().message};
  if (is_driven(options.fit))
    return Error{
        "--force-column and --drive-frequency are options of fit: compare lays free motions side by side"};
  FitOptions free = options.fit;
  free.recognise_drive = false;
  const Result<std::vector<FittedRecording>> fits = fit(bytes, file, free, watch);
  if (!fits) return fits.error();
  std::vector<CompareResult> results;
  for (const FittedRecording& recording : *fits) {
    if (recording.wrong_input) return Error{std::string(file) + ": " + recording.fit.message};
    Result<CompareResult> one = compare_fitted(recording, options, watch);
    if (!one) return one.error();
    results.push_back(std::move(*one));
  }
  return results;
}

}  // namespace cromer
