#include "cromer/fit.h"

#include <utility>

#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/identify/law.h"
#include "cromer/model/law.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/lab_quantities.h"

namespace cromer {
namespace {

/// nullptr where the fit has no values that may be looked at.
const core::FittedRecording* usable(const LawFit& fit) {
  return fit.detail && fit.detail->fit.is_usable() ? fit.detail.get() : nullptr;
}

Error no_values(const LawFit& fit) {
  if (!fit.detail) return {Notice{"fit_is_empty"}, "fit"};
  return core::no_values(*fit.detail);
}

Residual residual_of(const core::Residual& residual) {
  return {residual.rms, residual.normality, residual.autocorrelation, residual.white};
}

/// `of_arrays`: the record has samples, not lines.
LawFit fit_of(core::FittedRecording fitted, bool of_arrays) {
  core::put_in_arguments(fitted, of_arrays);
  LawFit fit;
  fit.status = fitted.fit.status;
  fit.message = core::message_of(fitted.fit.message);
  if (!fitted.wrong_input) fit.law = core::to_text(fitted.fit.law);
  fit.parameters = fitted.parameters;
  fit.derived = fitted.derived;
  if (!fitted.parameters.empty()) {
    fit.fitted = fitted.fit.names;
    fit.covariance = core::covariance_with_doubts(fitted);
  }
  fit.residual = residual_of(fitted.fit.residual);
  fit.samples = fitted.samples;
  fit.used = fitted.used();
  for (const core::Candidate& each : fitted.candidates)
    fit.candidates.push_back({core::to_text(each.law), each.rms, each.bic});
  for (const core::DecaySegment& each : fitted.segments)
    fit.segments.push_back({each.from, each.to, each.rate});
  fit.decay_rate_mean = fitted.decay_rate_mean;
  fit.reynolds_max = fitted.reynolds_max;
  fit.keulegan_carpenter = fitted.keulegan_carpenter;
  if (!of_arrays) {
    fit.file = fitted.file;
    fit.column = fitted.series.column;
  }
  fit.run = fitted.series.run;
  if (!fitted.series.t.empty()) fit.begin = fitted.series.t.front();
  fit.notices = fitted.notices;
  fit.detail = std::make_shared<const core::FittedRecording>(std::move(fitted));
  return fit;
}

/// What the tasks, whose options are texts, cannot see.
Result<void> check_enumerators(const FitOptions& options) {
  if (options.between_samples) return core::check_enumerator(*options.between_samples, 3, "between_samples");
  return {};
}

}  // namespace

std::optional<Estimate> LawFit::find(std::string_view wanted) const {
  for (const auto* list : {&parameters, &derived})
    for (const Parameter& each : *list)
      if (each.name == wanted) return each.estimate;
  return std::nullopt;
}

Result<Trajectory> LawFit::at(std::span<const double> t) const {
  if (!detail) return no_values(*this);
  return core::motion_at(*detail, t);
}

Result<FittedMotion> LawFit::motion() const {
  const core::FittedRecording* known = usable(*this);
  if (!known) return no_values(*this);
  core::FittedMotion made = core::law_motion(*known);
  FittedMotion motion;
  motion.t = std::move(made.t);
  motion.x = std::move(made.x);
  motion.v = std::move(made.v);
  motion.measured = std::move(made.measured);
  motion.residual = std::move(made.residual);
  return motion;
}

Result<Oscillator> LawFit::oscillator() const {
  const core::FittedRecording* known = usable(*this);
  if (!known) return no_values(*this);
  const core::Body body = core::body_of(known->options);
  return core::multiplied_by_mass(known->fit.motion.per_mass, body.mass ? body.effective_mass().value : 1.0);
}

Result<LawFit> fit(std::span<const double> t, std::span<const double> y, const FitOptions& options) {
  if (auto good = check_enumerators(options); !good) return good.error();
  const auto recording = core::recording_of(t, y, options.force, options.observed);
  if (!recording) return recording.error();
  core::FitOptions asked = core::fit_options(options, {});
  asked.column = "y";
  if (!options.force.empty()) asked.force_column = "force";
  const core::Watching watching(options.progress);
  auto fits = core::fit(*recording, asked, watching.watch());
  if (!fits) return core::in_arguments(fits.error(), true);
  LawFit found = fit_of(std::move(fits->front()), true);
  found.interrupted = watching.watch().interrupted();
  return found;
}

Result<std::vector<LawFit>> fit(const Recording& recording, const FitOptions& options,
                                const Selection& selection) {
  if (!recording.detail) return Error{Notice{"recording_is_empty"}, "recording"};
  if (!options.force.empty()) return Error{Notice{"force_is_a_column"}, "force"};
  if (auto good = check_enumerators(options); !good) return good.error();
  core::FitOptions asked = core::fit_options(options, selection);
  asked.read = recording.options;
  const core::Watching watching(options.progress);
  auto fits = core::fit(*recording.detail, asked, watching.watch());
  if (!fits) return core::in_arguments(fits.error());
  std::vector<LawFit> all;
  for (core::FittedRecording& each : *fits) {
    all.push_back(fit_of(std::move(each), false));
    all.back().interrupted = watching.watch().interrupted();
  }
  return all;
}

}  // namespace cromer
