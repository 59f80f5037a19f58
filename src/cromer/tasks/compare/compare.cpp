#include "cromer/tasks/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cromer/base/add_once.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/base/state.h"
#include "cromer/identify/diagnose/slip.h"
#include "cromer/identify/law_fit.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/in_file.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/simulate/run_law.h"
#include "cromer/tasks/simulate/simulate_setup.h"
#include "cromer/trajectory.h"

namespace cromer::core {
namespace {

constexpr double of_fits = 0.7;  // of the work, roughly

/// Keeps the states of a run at the times `t` [s], strictly increasing, which must outlive it. Between two
/// states of the run it takes the cubic that has their positions and velocities; within `slack` [s] of a
/// state, that state.
class KeepAt {
 public:
  KeepAt(const std::vector<double>& t, double slack) : t_(t), slack_(slack) {
    kept_.t.reserve(t.size());
    kept_.x.reserve(t.size());
    kept_.v.reserve(t.size());
  }

  void operator()(double t, const State<double>& y) {
    while (kept_.size() < t_.size() && t_[kept_.size()] <= t + slack_) {
      const double at = t_[kept_.size()];
      const State<double> here = t - at <= slack_ ? y : between(at, t, y);
      kept_.t.push_back(at);
      kept_.x.push_back(here.x);
      kept_.v.push_back(here.v);
    }
    before_t_ = t;
    before_ = y;
  }

  Trajectory take() { return std::move(kept_); }

 private:
  State<double> between(double at, double t, const State<double>& y) const {
    const double h = t - before_t_, s = (at - before_t_) / h;
    const double dx = y.x - before_.x;
    const double a = h * before_.v, b = h * y.v;
    const double c2 = 3 * dx - 2 * a - b, c3 = a + b - 2 * dx;
    return {before_.x + s * (a + s * (c2 + s * c3)), (a + s * (2 * c2 + 3 * s * c3)) / h};
  }

  const std::vector<double>& t_;
  double slack_;
  double before_t_ = 0;
  State<double> before_{};
  Trajectory kept_;
};

/// How two motions, sampled at the same times, compare at the end.
struct EndComparison {
  double amplitude_ratio = 1;  ///< of the second over the first
  double phase_drift = 0;      // [rad] of the second minus the first, followed through the record
  double first_amplitude = 0, second_amplitude = 0;  ///< at the end
  std::size_t samples = 0;                           ///< that the amplitudes at the end rest on
  double early_amplitude = 0;                        ///< of the first, before
};

/// Samples [first, last).
struct Window {
  std::size_t first, last;
};

// Amplitude and phase of the sinusoid of frequency w that fits the samples best.
std::complex<double> local_sinusoid(std::span<const double> t, std::span<const double> x, Window window,
                                    double w) {
  const std::size_t n = window.last - window.first;
  const Record part{t.subspan(window.first, n), x.subspan(window.first, n), 0};
  const DampedPhasor::Linear fit = DampedPhasor(part).best_linear(w, 0);
  return {fit.cosine, -fit.sine};  // cosine cos(wt) + sine sin(wt) = |z| cos(wt + arg z)
}

Window late_half(Window window) { return {window.first + (window.last - window.first) / 2, window.last}; }

// The second motion over the first at the window's end. The change of their ratio from the first half to the
// second is extrapolated by a quarter of the window, which lies between the middle of the second half and the
// end.
std::complex<double> ratio_at_end(std::span<const double> t, std::span<const double> first,
                                  std::span<const double> second, Window window, double w) {
  const Window late = late_half(window), early{window.first, late.first};
  const std::complex<double> before =
                                 local_sinusoid(t, second, early, w) / local_sinusoid(t, first, early, w),
                             after = local_sinusoid(t, second, late, w) / local_sinusoid(t, first, late, w);
  const std::complex<double> change = after / before;
  return std::isfinite(std::abs(change)) ? after * std::sqrt(change) : after;
}

// From the first to the last upward crossing of zero; `otherwise` if there are fewer than three.
double frequency_in(std::span<const double> t, std::span<const double> x, Window window, double otherwise) {
  int crossings = 0;
  double from = 0, to = 0;
  for (std::size_t i = window.first + 1; i < window.last; ++i) {
    if (!(x[i - 1] < 0 && x[i] >= 0)) continue;
    to = t[i - 1] + (t[i] - t[i - 1]) * x[i - 1] / (x[i - 1] - x[i]);
    if (++crossings == 1) from = to;
  }
  return crossings < 3 ? otherwise : two_pi * (crossings - 1) / (to - from);
}

/// Windows of ten periods 2 pi/w follow the phase through the record, so that a drift beyond half a turn is
/// not folded back. The last window, extrapolated from its middle to its end, gives the result. The frequency
/// of each window is that of `guide`, a motion without noise near both; if it does not oscillate there, w
/// [rad/s].
EndComparison compare_ends(std::span<const double> t, std::span<const double> first,
                           std::span<const double> second, std::span<const double> guide, double w) {
  EndComparison end;
  const double length = 10 * two_pi / w;
  const int windows = std::max(1, static_cast<int>((t.back() - t.front()) / length));
  double drift = 0;
  for (int i = windows; i > 0; --i) {
    const double from = std::max(t.front(), t.back() - i * length), to = t.back() - (i - 1) * length;
    const Window window{static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), from) - t.begin()),
                        static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), to) - t.begin())};
    if (window.last < window.first + 8) continue;
    const double here = frequency_in(t, guide, window, w);
    const std::complex<double> a = local_sinusoid(t, first, window, here),
                               b = local_sinusoid(t, second, window, here);
    if (std::abs(a) > 0) {
      const double now = std::arg(b * std::conj(a));
      drift = now + two_pi * std::round((drift - now) / two_pi);
    }
    if (i > 1) continue;
    const std::complex<double> ratio = ratio_at_end(t, first, second, window, here);
    end = {
        .amplitude_ratio = std::abs(ratio),
        .phase_drift = drift + std::arg(ratio * std::polar(1.0, -drift)),
        .first_amplitude = std::abs(local_sinusoid(t, first, late_half(window), here)),
        .second_amplitude = std::abs(local_sinusoid(t, second, late_half(window), here)),
        .samples = window.last - late_half(window).first,
        .early_amplitude = std::abs(local_sinusoid(t, first, {window.first, late_half(window).first}, here))};
  }
  return end;
}

struct NamedLaw {
  Notice label;
  Law law;
  Motion motion;  ///< from the recording's first sample on
};

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// The option of a term that has no closed form; empty if there is none. With friction alone beside the
/// linear law there is one, in arcs.
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

/// The standard error of the amplitude of a sinusoid fitted to so many samples.
double amplitude_error(double rms, std::size_t samples) {
  return rms * std::sqrt(2 / static_cast<double>(std::max<std::size_t>(samples, 1)));
}

/// The most that noise alone adds to the amplitude of a sinusoid fitted to so many samples.
double noise_amplitude(double rms, std::size_t samples) {
  constexpr double standard_errors = 5;
  return standard_errors * amplitude_error(rms, samples);
}

// The samples not set aside, and the motions of a law at their times.
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

/// The standard error of the amplitude of a sinusoid of w [rad/s] fitted to so many samples: from the
/// residuals' amplitude at w in windows of that length, and never less than that of white noise.
double amplitude_error_of(const FittedRecording& recording, double w, std::size_t samples) {
  const FittedSamples good = without_outliers(recording.series);
  const double white = amplitude_error(recording.fit.residual.rms, samples);
  const std::vector<double> left = residuals_of(recording.fit, {good.t, good.y, recording.series.resolution});
  std::vector<double> amplitudes;
  for (std::size_t last = left.size(); samples > 8 && last >= samples; last -= samples)
    amplitudes.push_back(std::abs(local_sinusoid(good.t, left, {last - samples, last}, w)));
  if (amplitudes.size() < 4) return white;
  constexpr double of_rayleigh = 1.1774;  // median over one component's standard deviation
  return std::max(white, upper_median(amplitudes) / of_rayleigh);
}

void compare_with_measured(ComparedCurve& curve, const FittedRecording& recording, const Samples& samples) {
  const double w = recording.fit.angular_frequency().value;
  const double scatter = standard_deviation(samples.measured);
  curve.rms = rms_of_difference(samples.measured, samples.simulated);
  curve.r_squared = 1 - std::pow(curve.rms / scatter, 2);
  curve.law_rms = rms_of_difference(samples.measured, samples.law);
  const EndComparison end = compare_ends(samples.t, samples.measured, samples.simulated, samples.law, w);
  const double noise = noise_amplitude(recording.fit.residual.rms, end.samples);
  curve.measured_at_rest = end.first_amplitude < noise;
  // What is measured may itself be as large as the noise.
  curve.at_rest = end.second_amplitude < 2 * noise;
  if (curve.measured_at_rest) return;
  curve.amplitude_ratio_end = end.amplitude_ratio;
  // Of late^(3/2) over early^(1/2).
  const double one = amplitude_error_of(recording, w, end.samples);
  curve.amplitude_ratio_error =
      end.amplitude_ratio * std::hypot(1.5 * one / end.first_amplitude, 0.5 * one / end.early_amplitude);
  curve.phase_drift = end.phase_drift;
}

// The method's own part: against the same law solved without its error.
void compare_with_law(ComparedCurve& curve, const FittedRecording& recording, const Samples& samples) {
  const EndComparison end = compare_ends(samples.t, samples.law, samples.simulated, samples.law,
                                         recording.fit.angular_frequency().value);
  // Below this the law's motion has stopped, or has died down to its own rounding.
  const double nothing = 1e-9 * standard_deviation(samples.law);
  if (!(end.first_amplitude > nothing)) return;
  curve.method_amplitude_ratio = end.amplitude_ratio;
  curve.method_phase = end.phase_drift;
}

double largest_of(const std::vector<double>& x) {
  double largest = 0;
  for (const double each : x) largest = std::max(largest, std::abs(each));
  return largest;
}

ComparedCurve begun_curve(Notice label, const Law& law, std::string_view method) {
  ComparedCurve curve;
  curve.label = std::move(label);
  curve.law = law;
  curve.method = method;
  curve.rms = curve.r_squared = curve.amplitude_ratio_end = curve.phase_drift = not_known;
  curve.law_rms = curve.method_amplitude_ratio = curve.method_phase = not_known;
  return curve;
}

/// The law itself at the recording's times, without a method's error. A law whose motion leaves all bounds is
/// an Error.
Result<ComparedCurve> law_curve(const FittedRecording& recording, const NamedLaw& law, double step) {
  const Series& series = recording.series;
  ComparedCurve curve = begun_curve(law.label, law.law, without_method);
  const double law_step = recording.fit.step > 0 ? recording.fit.step : step;
  curve.trajectory = motion_states(law.motion, {}, series.t, law_step);
  if (curve.trajectory.size() < series.t.size()) return Error{"law_runs_away", {{"law", law.label}}};
  compare_with_measured(curve, recording, good_samples(recording, curve.trajectory, curve.trajectory));
  curve.method_amplitude_ratio = 1;
  curve.method_phase = 0;
  return curve;
}

/// Runs the law over the recording's times, by a method in steps. The figures leave out samples set aside. A
/// run that ended early, or that grows to ten times the law's own motion, is a notice. A law that the method
/// cannot integrate is an Error.
Result<ComparedCurve> simulate_curve(const FittedRecording& recording, const NamedLaw& law,
                                     const ComparedCurve& itself, const std::string& method, double step,
                                     std::vector<Notice>& notices, const Watch& watch) {
  if (method == "exact")
    if (const std::string_view term = why_no_closed_form(law); !term.empty())
      return Error{"compared_has_no_closed_form", {{"term", term}}};
  const Series& series = recording.series;
  const Motion& motion = law.motion;
  const double t0 = series.t.front(), duration = series.t.back() - t0;
  const Interval interval{t0, t0 + std::ceil(duration / step - 1e-9) * step};
  KeepAt keep(series.t, 1e-6 * step);
  KeepEvery each{AnyRecorder(keep)};
  const LawRun run{.oscillator = motion.per_mass,
                   .method = method,
                   .interval = interval,
                   .start = {motion.position, motion.velocity},
                   .control = step};
  const Outcome outcome = run_law(run, each, watch);

  ComparedCurve curve =
      begun_curve(Notice{"law_by_method", {{"law", law.label}, {"method", method}}}, law.law, method);
  curve.step = step;
  curve.trajectory = keep.take();
  if (outcome.status != Status::reached_end || curve.trajectory.size() < series.t.size()) {
    curve.complete = false;
    curve.diverged = !outcome.interrupted;
    notices.push_back(outcome.interrupted
                          ? Notice{"curve_interrupted", {{"law", law.label}, {"t", outcome.t}}}
                          : Notice{"curve_ended",
                                   {{"law", law.label},
                                    {"method", method},
                                    {"t", outcome.t},
                                    {"status", name(outcome.status)}}});
    return curve;
  }
  const Samples samples = good_samples(recording, curve.trajectory, itself.trajectory);
  compare_with_measured(curve, recording, samples);
  compare_with_law(curve, recording, samples);
  const double start = std::hypot(motion.position, motion.velocity / motion.angular_frequency()),
               largest = largest_of(curve.trajectory.x);
  if (largest > 10 * std::max(start, largest_of(itself.trajectory.x))) {
    curve.diverged = true;
    notices.push_back(Notice{
        "curve_grows", {{"law", law.label}, {"method", method}, {"step", step}, {"times", largest / start}}});
  }
  return curve;
}

// A period has at least the default steps, and a sample is a whole number of them.
double dividing_step(double spacing, double period) {
  return spacing / std::max(1.0, std::ceil(default_steps_per_period * spacing / period - 1e-9));
}

// Fits the samples of a fit, from the first on, with a given law.
LawFit with_law(const FittedRecording& recording, const Law& law, const Watch& watch) {
  const Series& series = recording.series;
  FittedSamples samples = without_outliers(series);
  if (samples.t.front() > series.t.front()) {  // the motion begins there
    samples.t.insert(samples.t.begin(), series.t.front());
    samples.y.insert(samples.y.begin(), series.y.front());
  }
  LawFitOptions options;
  options.law = law;
  return fit_law({samples.t, samples.y, series.resolution}, options, watch);
}

// What the law's springs with viscous damping alone miss is the damping's part, not the frequency's.
Law one_rate_law(Law law) { return law.without(dissipative_terms).with(law_with<Viscous>); }

// As fitted, or with the mean of the segments' rates.
NamedLaw constant_rate(const FittedRecording& recording, const Watch& watch) {
  const Motion& begun = recording.fit.motion;
  const Law law = one_rate_law(recording.fit.law);
  const bool mean_of_segments = has_mean_rate(recording);
  Motion constant = begun;
  if (!(recording.fit.law == law)) {
    const LawFit fitted = with_law(recording, law, watch);
    if (watch.interrupted()) return NamedLaw{};
    constant = fitted.motion;
    if (mean_of_segments || fitted.status != FitStatus::converged) {
      // The segments' mean rate starts where the chosen law does.
      constant.equilibrium = begun.equilibrium;
      constant.position = begun.position;
      constant.velocity = begun.velocity;
    }
  }
  if (mean_of_segments) constant.set_decay_rate(recording.decay_rate_mean->value);
  return NamedLaw{Notice{"one_constant_decay_rate"}, law, constant};
}

}  // namespace

namespace {

Result<void> check_methods(const CompareOptions& options) {
  for (const std::string& method : options.method)
    if (const Result<void> known = check_method_name(method); !known)
      return Error{"method_is_wrong", {{"what", known.error().notice}}};
  return {};
}

}  // namespace

Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch) {
  if (const Result<void> known = check_methods(options); !known) return known.error();
  const auto refuse = [&](const Notice& why) {
    return Error{recording.file.empty() ? why : in_file(recording.file, why)};
  };
  if (recording.driven) return refuse(Notice{"compared_is_driven"});
  CompareResult result;
  result.recording = recording;
  result.notices = recording.notices;
  const LawFit& fit = recording.fit;
  const bool fitted = fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit;
  if (!fitted || !(fit.angular_frequency().value > 0)) return result;
  if (derivative_order(recording.series.quantity) > 0)
    return refuse(
        Notice{"compared_is_no_position",
               {{"column", recording.series.column}, {"kind", kind_of(recording.series.quantity)}}});

  const Series& series = recording.series;
  result.doubts = recording.doubts;
  if constexpr (looks_for_slips)
    for (const Notice& notice : recording.notices)
      if (is_of_slips(notice)) result.doubts.push_back(notice);
  result.others_tried = !law_is_chosen(options.fit);
  const double period = two_pi / fit.angular_frequency().value, duration = series.t.back() - series.t.front();
  const double spacing = series.rate > 0 ? 1 / series.rate : period / default_steps_per_period;
  const double step = options.step.value_or(dividing_step(spacing, period));
  if (!(step > 0) || step > duration || duration / step > most_steps_of_a_run)
    return Error{"compared_step", {{"step", step}, {"most", most_steps_of_a_run}, {"duration", duration}}};

  const NamedLaw constant = constant_rate(recording, part_of(watch, 0, 0.2));
  if (watch.interrupted()) {
    result.notices.push_back(Notice{"interrupted_before_simulating"});
    result.complete = false;
    return result;
  }
  const NamedLaw chosen{Notice{"law_by_name", {{"law", to_text(fit.law)}}}, fit.law, fit.motion};
  for (const NamedLaw& law : {constant, chosen}) {
    Result<ComparedCurve> curve = law_curve(recording, law, step);
    if (!curve) return curve.error();
    result.curves.push_back(std::move(*curve));
  }
  const std::vector<std::string> by_default{"euler-cromer"},
      &methods = options.method.empty() ? by_default : options.method;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const double each = 0.7 / static_cast<double>(methods.size()), done = 0.3 + each * static_cast<double>(i);
    Result<ComparedCurve> curve = simulate_curve(recording, chosen, result.curves[1], methods[i], step,
                                                 result.notices, part_of(watch, done, done + each));
    if (!curve) return curve.error();
    result.complete = result.complete && curve->complete;
    result.curves.push_back(std::move(*curve));
    if (watch.progress) watch.progress(done + each);
  }
  return result;
}

namespace {

// A driven motion is compared with free ones all the same, and a notice says so.
Result<CompareResult> compare_driven(const Recording& recording, const FittedRecording& driven,
                                     const CompareOptions& options, const Watch& watch) {
  CompareOptions free = options;
  free.fit.recognise_drive = false;
  free.fit.run = driven.series.run;
  const Result<std::vector<FittedRecording>> fits = fit(recording, free.fit, part_of(watch, 0, of_fits));
  if (!fits) return fits.error();
  FittedRecording one = fits->front();
  one.one_of_several = driven.one_of_several;
  if (driven.of_file == 0) {  // said with another run
    one.notices.erase(one.notices.begin(), one.notices.begin() + static_cast<std::ptrdiff_t>(one.of_file));
    one.of_record -= one.of_file;
    one.of_file = 0;
  }
  Result<CompareResult> result = compare_fitted(one, free, part_of(watch, of_fits, 1));
  if (!result) return result;
  result->doubts.insert(result->doubts.begin(), driven.notices.back());
  for (const Notice& notice : driven.notices) add_once(result->notices, notice);
  return result;
}

// The row of a run that was fitted and cannot be compared. What was said of the file stays.
CompareResult not_compared(const FittedRecording& fitted, const Notice& why) {
  CompareResult row;
  row.recording = not_fitted(fitted.file, fitted.series.run, why);
  row.recording.one_of_several = fitted.one_of_several;
  row.recording.of_file = fitted.of_file;
  row.notices.assign(fitted.notices.begin(),
                     fitted.notices.begin() + static_cast<std::ptrdiff_t>(fitted.of_file));
  return row;
}

}  // namespace

Result<std::vector<CompareResult>> compare(const Recording& recording, const CompareOptions& options,
                                           const Watch& watch) {
  if (const Result<void> known = check_methods(options); !known) return known.error();
  if (is_driven(options.fit)) return Error{"compare_has_no_drive"};
  const Result<std::vector<FittedRecording>> fits = fit(recording, options.fit, part_of(watch, 0, of_fits));
  if (!fits) return fits.error();
  std::vector<CompareResult> results;
  std::optional<Error> first_error;
  bool any_compared = false;
  for (const FittedRecording& fitted : *fits) {
    if (fitted.wrong_input) {
      results.emplace_back().recording = fitted;
      continue;
    }
    const double each = (1 - of_fits) / static_cast<double>(fits->size()),
                 done = of_fits + each * static_cast<double>(results.size());
    const Watch part = part_of(watch, done, done + each);
    Result<CompareResult> one = fitted.driven ? compare_driven(recording, fitted, options, part)
                                              : compare_fitted(fitted, options, part);
    any_compared = any_compared || one.ok();
    results.push_back(one ? std::move(*one) : not_compared(fitted, one.error().notice));
    if (!one && !first_error) first_error = one.error();
  }
  if (!any_compared && first_error) return *first_error;
  return results;
}

}  // namespace cromer::core
