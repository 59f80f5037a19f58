#include "cromer/tasks/fit/fit_driven.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cromer/analysis/frequency_response.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/read/column_kind.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

/// Whether the body's own swing beats with the drive's while it dies down: both show, they are close, and at
/// least one whole beat is seen before the swing is gone. Else empty.
Notice beats_at_first(const FittedRecording& result) {
  const LawFit& fit = result.fit;
  const Estimate *push = fit.find("drive_amplitude"), *phase = fit.find("drive_phase");
  const std::optional<double> swings_at = damped_frequency_of(fit);
  if (!push || !phase || !swings_at) return {};
  const double w0 = fit.motion.angular_frequency(), g = fit.motion.decay_rate(),
               w = fit.motion.drive_frequency, own = *swings_at;
  const SteadyState steady =
      frequency_response({.mass = 1, .stiffness = w0 * w0, .damping = 2 * g}, push->value, w);
  const double angle = phase->value - steady.phase_lag;
  const double x = fit.motion.position - steady.amplitude * std::cos(angle),
               v = fit.motion.velocity + w * steady.amplitude * std::sin(angle);
  const double swing = std::hypot(x, (v + g * x) / own), beat = two_pi / std::abs(w - own);
  const double duration = result.series.t.back() - result.series.t.front();
  constexpr double shows = 0.2, close = 3, gone = 2;
  if (swing < shows * steady.amplitude || steady.amplitude < shows * swing || beat < close * two_pi / w ||
      beat * g > gone || beat > duration)
    return {};
  const Estimate* rate = result.find("decay_rate");  // with its doubt
  return Notice{"beats_at_first",
                {{"beat", beat},
                 {"own", own / two_pi},
                 {"drive", w / two_pi},
                 {"rate", format_quantity({g, rate ? rate->standard_error : 0}, "1/s")}}};
}

}  // namespace

std::optional<double> damped_frequency_of(const LawFit& driven) {
  const double w0 = driven.motion.angular_frequency(), g = driven.motion.decay_rate();
  const double w = damped_frequency({.decay_rate = g, .stiffness = w0 * w0});
  return is_linear(driven.law) && g > 0 && w > 0 ? std::optional(w) : std::nullopt;
}

void describe_driven_fit(FittedRecording& result, LawChoice&& choice, const Record& record,
                         const std::vector<double>& t, std::string_view force_unit, const Watch& watch) {
  result.fit = std::move(choice.chosen);
  result.of_record = result.notices.size();
  result.notices.insert(result.notices.end(), result.fit.notices.begin(), result.fit.notices.end());
  for (const LawFit& candidate : choice.candidates)
    if (candidate.residual.rms > 0)
      result.candidates.push_back(
          {candidate.law, candidate.residual.rms, candidate.bic, candidate.status == FitStatus::converged,
           candidate.motion.angular_frequency(),
           is_recorded(candidate.drive.kind) ? std::string(name(candidate.drive.force.between)) : ""});
  const LawFit& fit = result.fit;
  if (!fit.is_usable()) return;
  const FitOptions& options = result.options;
  const Body body = body_of(options);
  const std::string unit = unit_of(result.series);
  const int derivative = std::max(0, derivative_order(result.series.quantity));
  if (derivative > 0) result.notices.push_back(fitted_as_it_is(result.series.quantity, result.series.column));
  DrivenMotion& motion = result.driven.emplace();
  motion.states = motion_of(fit, t);
  motion.motion = observed_motion(fit.motion, fit.drive, t, derivative, fit.step);
  result.parameters = law_parameters(fit, unit, derivative, force_unit);
  add_force_parameters(result, body);
  result.derived = derived_quantities(fit, unit, derivative, motion.states.x, force_unit);
  result.law_doubts = law_doubts(result, choice.candidates, force_unit);
  add_doubts(result.parameters, result.law_doubts);
  add_doubts(result.derived, result.law_doubts);
  result.headline = headline_of(result);
  if (result.find("stiffness")) add_stiffness_budget(result, body, watch);
  for (Notice& doubt : driven_doubts(record, fit, residuals_of(fit, record), fit.motion.drive_frequency,
                                     law_is_chosen(options), unit))
    result.notices.push_back(std::move(doubt));
  if (fit.law.shares(springs) && fit.motion.decay_rate() >= fit.motion.angular_frequency())
    result.notices.push_back(Notice{"overdamped_law"});
  if (fit.explained < 0.9 && fit.residual.autocorrelation > 0.5)
    result.notices.push_back(Notice{"something_else_drives", {{"share", 100 * fit.explained}}});
  if (Notice wide = widening(fit, result.series.t.size()); !wide.empty())
    result.notices.push_back(std::move(wide));
}

void add_unused_notices(FittedRecording& result) {
  const FitOptions& options = result.options;
  for (const std::string_view unused : unused_if_driven(options))
    result.notices.push_back(Notice{"unused_if_driven", {{"option", unused}}});
  const bool has_drag = result.find("drag_coefficient") != nullptr;
  if (options.disc_diameter)
    result.notices.push_back(Notice{has_drag ? "driven_has_no_reynolds" : "driven_has_no_drag_number"});
}

Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch, double rms_to_beat,
                                   const std::optional<KnownMotion>& start) {
  Result<Series> used = samples_in_use(motion, options);
  if (!used) return used.error();
  const Result<std::optional<Law>> law = law_of(options);
  if (!law) return law.error();
  const Result<std::optional<double>> drive = drive_of(options);
  if (!drive) return drive.error();

  FittedRecording result = row_to_fit(motion, *std::move(used), file, options);
  const Series& series = result.series;
  const auto [t, y] = without_outliers(series);
  if (t.empty()) return Error{"all_set_aside", {{"column", motion.column}}};
  const double highest = 0.5 * static_cast<double>(t.size() - 1) / (t.back() - t.front());  // [Hz]
  if (*drive && **drive > two_pi * highest)
    return Error{"drive_not_seen",
                 {{"asked", **drive / two_pi}, {"rate", 2 * highest}, {"highest", highest}}};
  // The law's motion begins at the first sample that the fit sees.
  if (series.t.front() < t.front()) {
    FitOptions later;
    later.from = t.front();
    result.series = *used_part(std::move(result.series), later);
  }
  LawFitOptions settings{.drive = Drive::harmonic(), .hysteresis_exponent = options.hysteresis_exponent};
  settings.drive_frequency = *drive;
  settings.rms_to_beat = rms_to_beat;
  settings.start = start;
  const Record record = record_of(series, t, y);
  describe_driven_fit(result, choose_law(record, settings, watch, {*law, {}}), record, series.t, "", watch);
  add_unused_notices(result);
  const LawFit& fit = result.fit;
  if (!result.driven) return result;
  const Body body = body_of(options);
  result.simulate = simulate_settings(fit, series, body.mass ? body.effective_mass().value : 1);
  const double found = fit.motion.drive_frequency;
  if (fit.status == FitStatus::converged && *drive &&
      std::abs(found - **drive) > 4 * two_pi / (t.back() - t.front()))
    result.notices.push_back(
        Notice{"drive_is_another", {{"found", found / two_pi}, {"asked", **drive / two_pi}}});
  if (Notice beats = beats_at_first(result); fit.status == FitStatus::converged && !beats.empty())
    result.notices.push_back(std::move(beats));
  return result;
}

}  // namespace cromer::core
