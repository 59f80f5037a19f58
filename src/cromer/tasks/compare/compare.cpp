#include "cromer/tasks/compare/compare.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/methods/all.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/in_file.h"
#include "cromer/tasks/compare/compared_curve.h"
#include "cromer/tasks/fit/forced_options.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/option/part_of_work.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double most_steps = 1e8;
constexpr double of_fits = 0.7;  // of the work, roughly

// A period has at least the default steps, and a sample is a whole number of them.
double dividing_step(double spacing, double period) {
  return spacing / std::max(1.0, std::ceil(default_steps_per_period * spacing / period - 1e-9));
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

// The viscous law as fitted, or with the mean of the segments' rates.
Result<NamedLaw> constant_rate(const FittedRecording& recording, const Watch& watch) {
  Motion constant = recording.fit.motion;
  if (!(recording.fit.law == law_of("viscous"))) {
    const Result<FittedRecording> fitted = with_law(recording, law_of("viscous"), watch);
    if (!fitted) return fitted.error();
    if (watch.interrupted()) return NamedLaw{};
    if (recording.decay_rate_mean || fitted->fit.status != FitStatus::converged) {
      // The segments' mean goes from where the chosen law begins.
      const Motion& begun = recording.fit.motion;
      constant =
          Motion{.equilibrium = begun.equilibrium, .position = begun.position, .velocity = begun.velocity};
      constant.set_angular_frequency(fitted->fit.angular_frequency().value);
      constant.set_decay_rate(fitted->fit.decay_rate().value);
    } else {
      constant = fitted->fit.motion;
    }
  }
  if (recording.decay_rate_mean) constant.set_decay_rate(recording.decay_rate_mean->value);
  return NamedLaw{"one constant decay rate", law_of("viscous"), constant};
}

}  // namespace

Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch) {
  if (const Result<void> known = check_method_name(options.method); !known)
    return Error{"method_is_wrong", {{"what", known.error().notice}}};
  if (recording.driven) return Error{"compared_is_driven", {{"file", recording.file}}};
  CompareResult result;
  result.recording = recording;
  result.notices = recording.notices;
  const LawFit& fit = recording.fit;
  const bool fitted = fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit;
  if (!fitted || !(fit.angular_frequency().value > 0)) return result;
  if (derivative_order(recording.series.quantity) > 0)
    return Error{"compared_is_no_position",
                 {{"file", recording.file},
                  {"column", recording.series.column},
                  {"kind", kind_of(recording.series.quantity)}}};

  const Series& series = recording.series;
  FittedSamples samples = without_outliers(series);
  if (samples.t.front() > series.t.front()) {  // the motion begins there
    samples.t.insert(samples.t.begin(), series.t.front());
    samples.y.insert(samples.y.begin(), series.y.front());
  }
  result.doubts = doubts({samples.t, samples.y, series.resolution}, fit, law_is_chosen(options.fit),
                         si_unit_of(series.quantity));
  result.others_tried = !law_is_chosen(options.fit);
  const double period = two_pi / fit.angular_frequency().value, duration = series.t.back() - series.t.front();
  const double spacing = series.rate > 0 ? 1 / series.rate : period / default_steps_per_period;
  const double step = options.step.value_or(dividing_step(spacing, period));
  if (!(step > 0) || duration / step > most_steps)
    return Error{"compared_step", {{"step", step}, {"most", most_steps}, {"duration", duration}}};

  const Result<NamedLaw> constant = constant_rate(recording, part_of(watch, 0, 0.2));
  if (!constant) return constant.error();
  if (watch.interrupted()) {
    result.notices.push_back(Notice{"interrupted_before_simulating"});
    result.complete = false;
    return result;
  }
  const NamedLaw chosen{to_text(fit.law), fit.law, fit.motion};
  for (const NamedLaw& law : {*constant, chosen}) {
    const double done = result.curves.empty() ? 0.2 : 0.6;
    const Watch part = part_of(watch, done, done + 0.4);
    Result<ComparedCurve> curve = simulate_curve(recording, law, options, step, result.notices, part);
    if (!curve) return curve.error();
    result.complete = result.complete && curve->complete;
    result.curves.push_back(std::move(*curve));
  }
  return result;
}

namespace {

// A motion that is a driven one: free ones are laid beside it all the same, and it is said.
Result<CompareResult> compare_driven(std::string_view bytes, std::string_view file,
                                     const FittedRecording& driven, const CompareOptions& options,
                                     const Watch& watch) {
  CompareOptions free = options;
  free.fit.recognise_drive = false;
  free.fit.run = driven.series.run;
  const Result<std::vector<FittedRecording>> fits = fit(bytes, file, free.fit, part_of(watch, 0, of_fits));
  if (!fits) return fits.error();
  Result<CompareResult> result = compare_fitted(fits->front(), free, part_of(watch, of_fits, 1));
  if (!result) return result;
  result->doubts.insert(result->doubts.begin(), driven.notices.back());
  for (const Notice& notice : driven.notices)
    if (std::find(result->notices.begin(), result->notices.end(), notice) == result->notices.end())
      result->notices.push_back(notice);
  return result;
}

}  // namespace

Result<std::vector<CompareResult>> compare(std::string_view bytes, std::string_view file,
                                           const CompareOptions& options, const Watch& watch) {
  if (const Result<void> known = check_method_name(options.method); !known)
    return Error{"method_is_wrong", {{"what", known.error().notice}}};
  if (is_driven(options.fit)) return Error{"compare_has_no_drive"};
  const Result<std::vector<FittedRecording>> fits = fit(bytes, file, options.fit, part_of(watch, 0, of_fits));
  if (!fits) return fits.error();
  std::vector<CompareResult> results;
  for (const FittedRecording& recording : *fits) {
    if (recording.wrong_input) return Error{in_file(file, recording.fit.message)};
    const double each = (1 - of_fits) / static_cast<double>(fits->size()),
                 done = of_fits + each * static_cast<double>(results.size());
    const Watch part = part_of(watch, done, done + each);
    Result<CompareResult> one = recording.driven ? compare_driven(bytes, file, recording, options, part)
                                                 : compare_fitted(recording, options, part);
    if (!one) return one.error();
    results.push_back(std::move(*one));
  }
  return results;
}

}  // namespace cromer::core
