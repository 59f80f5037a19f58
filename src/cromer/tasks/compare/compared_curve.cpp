#include "cromer/tasks/compare/compared_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/model/law_force.h"
#include "cromer/tasks/compare/end_comparison.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/simulate/keep_at.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Empty if there is one, in arcs where friction is all that is added to the linear law.
std::string_view why_no_closed_form(const NamedLaw& law) {
  const std::string_view option = why_not_exact(law.motion.per_mass);
  return option == Friction::coefficients[0].option ? "" : option;
}

double rms_of_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double standard_deviation(const std::vector<double>& values) {
  double mean = 0, sum = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// What noise alone puts into the amplitude of a sinusoid fitted to so many samples, at most.
double noise_amplitude(double rms, std::size_t samples) {
  constexpr double standard_errors = 5;
  return standard_errors * rms * std::sqrt(2 / static_cast<double>(std::max<std::size_t>(samples, 1)));
}

// The samples not set aside, and two motions at their times.
struct Samples {
  std::vector<double> t, measured, simulated, law;
};

Samples good_samples(const FittedRecording& recording, const Trajectory& simulated, const Trajectory& law) {
  const FittedSamples good = without_outliers(recording.series);
  Samples samples{good.t, good.y, {}, {}};
  for (double& y : samples.measured) y -= recording.fit.equilibrium().value;
  samples.simulated.reserve(good.t.size());
  samples.law.reserve(good.t.size());
  for (std::size_t i = 0; i < simulated.size() && samples.law.size() < good.t.size(); ++i) {
    if (simulated.t[i] != good.t[samples.law.size()]) continue;
    samples.simulated.push_back(simulated.x[i]);
    samples.law.push_back(law.x[i]);
  }
  return samples;
}

void compare_with_measured(ComparedCurve& curve, const FittedRecording& recording, const Samples& samples) {
  const double w = recording.fit.angular_frequency().value;
  const double scatter = standard_deviation(samples.measured);
  curve.rms = rms_of_difference(samples.measured, samples.simulated);
  curve.r_squared = 1 - std::pow(curve.rms / scatter, 2);
  curve.law_rms = rms_of_difference(samples.measured, samples.law);
  const EndComparison end = compare_ends(samples.t, samples.measured, samples.simulated, samples.law, w),
                      of_law = compare_ends(samples.t, samples.measured, samples.law, samples.law, w);
  const double noise = noise_amplitude(recording.fit.residual.rms, end.samples);
  curve.measured_at_rest = end.first_amplitude < noise;
  curve.at_rest = end.second_amplitude < noise;
  if (curve.measured_at_rest) return;
  curve.amplitude_ratio_end = end.amplitude_ratio;
  curve.phase_drift = end.phase_drift;
  curve.law_amplitude_ratio_end = of_law.amplitude_ratio;
}

// The method's own part: the same law without it.
void compare_with_law(ComparedCurve& curve, const FittedRecording& recording, const Samples& samples) {
  const EndComparison end = compare_ends(samples.t, samples.law, samples.simulated, samples.law,
                                         recording.fit.angular_frequency().value);
  // Below this a law has stopped, or has died down beyond what its own rounding leaves.
  const double nothing = 1e-9 * standard_deviation(samples.law);
  if (!(end.first_amplitude > nothing)) return;
  curve.method_amplitude_ratio = end.amplitude_ratio;
  curve.method_phase = end.phase_drift;
}

Notice said(const NamedLaw& law) {
  const std::string text = to_text(law.law);
  return law.label == text ? Notice{"law_by_name", {{"law", text}}} : Notice{"one_constant_decay_rate"};
}

}  // namespace

Result<ComparedCurve> simulate_curve(const FittedRecording& recording, const NamedLaw& law,
                                     const CompareOptions& options, double step, std::vector<Notice>& notices,
                                     const Watch& watch) {
  if (options.method == "exact")
    if (const std::string_view term = why_no_closed_form(law); !term.empty())
      return Error{"compared_has_no_closed_form", {{"term", term}}};
  const Series& series = recording.series;
  const Motion& motion = law.motion;
  const double t0 = series.t.front(), duration = series.t.back() - t0;
  const Interval interval{t0, t0 + std::ceil(duration / step - 1e-9) * step};
  KeepAt keep(series.t, 1e-6 * step);
  KeepEvery each{AnyRecorder(keep)};
  const LawRun run{.oscillator = motion.per_mass,
                   .method = options.method,
                   .interval = interval,
                   .start = {motion.position, motion.velocity},
                   .control = step};
  const Outcome outcome = run_law(run, each, watch);

  ComparedCurve curve;
  curve.label = law.label;
  curve.law = law.law;
  curve.method = options.method;
  curve.step = step;
  curve.trajectory = keep.take();
  curve.rms = curve.r_squared = curve.amplitude_ratio_end = curve.phase_drift = unknown;
  curve.law_rms = curve.law_amplitude_ratio_end = curve.method_amplitude_ratio = curve.method_phase = unknown;
  if (outcome.status != Status::reached_end || curve.trajectory.size() < series.t.size()) {
    curve.complete = false;
    curve.diverged = !outcome.interrupted;
    notices.push_back(outcome.interrupted
                          ? Notice{"curve_interrupted", {{"law", said(law)}, {"t", outcome.t}}}
                          : Notice{"curve_ended",
                                   {{"law", said(law)},
                                    {"method", options.method},
                                    {"t", outcome.t},
                                    {"status", name(outcome.status)}}});
    return curve;
  }
  const double law_step = recording.fit.step > 0 ? recording.fit.step : step;
  const Trajectory itself = motion_states(motion, {}, series.t, law_step);
  if (itself.size() < series.t.size()) return Error{"law_runs_away", {{"law", said(law)}}};
  const Samples samples = good_samples(recording, curve.trajectory, itself);
  compare_with_measured(curve, recording, samples);
  compare_with_law(curve, recording, samples);
  // A free swing never exceeds its start by much: what does has grown from step to step.
  double largest = 0;
  const double start = std::hypot(motion.position, motion.velocity / motion.angular_frequency());
  for (const double x : curve.trajectory.x) largest = std::max(largest, std::abs(x));
  if (largest > 10 * start) {
    curve.diverged = true;
    notices.push_back(
        Notice{"curve_grows",
               {{"law", said(law)}, {"method", options.method}, {"step", step}, {"times", largest / start}}});
  }
  return curve;
}

}  // namespace cromer::core
