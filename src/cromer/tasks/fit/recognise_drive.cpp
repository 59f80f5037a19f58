#include "cromer/tasks/fit/fit_driven.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "cromer/base/for_page.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/identify/choose/kind_of_motion.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/diagnose/free_part.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/read/column_kind.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

constexpr double structured = 0.3, unstructured = 0.5;  // autocorrelation of residuals

MotionJudgement judged(const FittedRecording& free, const FittedRecording& driven, bool frequency_known) {
  const FittedSamples samples = without_outliers(driven.series);
  return judge_motion({samples.t, samples.y, driven.series.resolution}, free.fit, driven.fit,
                      frequency_known);
}

// Amplitude of the steady oscillation, over that of a sinusoid with the record's variance.
double share_of_steady(const FittedRecording& driven) {
  const Motion& law = driven.fit.motion;
  const double w0 = law.angular_frequency(), w = law.drive_frequency;
  const double steady = std::pow(w, std::max(0, derivative_order(driven.series.quantity))) *
                        driven.fit["drive_amplitude"].value /
                        std::hypot(w0 * w0 - w * w, 2 * law.decay_rate() * w);
  const FittedSamples samples = without_outliers(driven.series);
  double square = 0;
  for (const double y : samples.y) square += (y - law.equilibrium) * (y - law.equilibrium);
  return steady / std::sqrt(2 * square / static_cast<double>(samples.y.size()));
}

// A drive that explains next to nothing is no drive.
constexpr double next_to_nothing = 0.9;

bool drive_helps(const FittedRecording& driven, const FittedRecording& free) {
  return driven.fit.residual.rms < next_to_nothing * free.fit.residual.rms;
}

bool is_steadily_driven(const FittedRecording& driven, const FittedRecording& free) {
  if (driven.fit.status != FitStatus::converged) return false;
  const Residual& left = driven.fit.residual;
  return drive_helps(driven, free) && std::abs(left.autocorrelation) <= unstructured &&
         driven.fit["drive_amplitude"].low > 0 && share_of_steady(driven) >= 0.3;
}

std::string in_hertz(const Estimate& w) {
  return format_quantity({w.value / two_pi, w.standard_error / two_pi}, "Hz");
}

Notice mode_notice(const Mode& mode, std::string_view unit) {
  const Estimate& g = mode.decay_rate;
  return Notice{"mode",
                {{"frequency", in_hertz(mode.angular_frequency)},
                 {"amplitude", mode.amplitude},
                 {"unit", unit},
                 {"decay_rate", format_quantity({g.value, g.standard_error}, "1/s")}}};
}

// Neither of two lines decays. The first is for a drive that was searched for, the second for one that was
// given.
Notice either_reading(const TwoModes& modes, std::string_view unit) {
  return Notice{"two_steady_lines",
                {{"one", mode_notice(modes.modes[0], unit)}, {"other", mode_notice(modes.modes[1], unit)}}};
}

Notice either_reading(const TwoModes& modes, std::string_view unit, double drive) {
  const auto& [one, other] = modes.modes;
  const bool other_is_drive =
      std::abs(other.angular_frequency.value - drive) < std::abs(one.angular_frequency.value - drive);
  return Notice{"line_beside_the_drive", {{"line", mode_notice(other_is_drive ? one : other, unit)}}};
}

Notice of_two_modes(const TwoModes& found, std::string_view unit) {
  const double apart =
      std::abs(found.modes[0].angular_frequency.value - found.modes[1].angular_frequency.value);
  return Notice{"two_modes",
                {{"one", mode_notice(found.modes[0], unit)},
                 {"other", mode_notice(found.modes[1], unit)},
                 {"beat", two_pi / apart}}};
}

// No record can tell which of two readings is right.
void leave_undetermined(FittedRecording& result, const TwoModes& found, Notice readings) {
  result.modes.assign(found.modes.begin(), found.modes.end());
  result.headline.clear();
  result.fit.status = FitStatus::undetermined;
  result.fit.message = Notice{"two_readings",
                              {{"readings", readings},
                               {"own", in_hertz(result.fit.angular_frequency())},
                               {"drive", in_hertz(result.fit["drive_frequency"])}}};
  result.notices.push_back(std::move(readings));
}

// Where one of two modes is small the law is that of the other: it accounts for the motion, and swings with
// one of the two. A drive only stands in for the other one.
bool is_of_one_mode(const FittedRecording& result, const TwoModes& found) {
  if (result.driven) return false;
  constexpr double well = 0.9;  // of the variance
  const Estimate* frequency = result.find("frequency");
  if (!frequency || result.fit.explained < well) return false;
  const double one = found.modes[0].angular_frequency.value, other = found.modes[1].angular_frequency.value;
  const double w = two_pi * frequency->value;
  return std::min(std::abs(w - one), std::abs(w - other)) < 0.25 * std::abs(one - other);
}

// The recording with what no law is needed for.
FittedRecording without_law(const FittedRecording& fitted, const Refusal& why) {
  FittedRecording bare;
  bare.file = fitted.file;
  bare.series = fitted.series;
  bare.samples = fitted.samples;
  bare.options = fitted.options;
  bare.fit = fitted.fit;
  refuse(bare.fit, why);
  bare.notices.assign(fitted.notices.begin(),
                      fitted.notices.begin() + static_cast<std::ptrdiff_t>(fitted.of_record));
  bare.of_record = fitted.of_record;
  return bare;
}

void name_two_modes(FittedRecording& result, const TwoModes& found) {
  const Notice modes = of_two_modes(found, unit_of(result.series));
  if (!is_of_one_mode(result, found)) {
    const FitStatus refused = result.parameters.empty() ? result.fit.status : FitStatus::no_oscillation;
    result = without_law(result, {refused, Notice{"no_single_swing", {{"modes", modes}}}});
    result.modes.assign(found.modes.begin(), found.modes.end());
    return;
  }
  result.modes.assign(found.modes.begin(), found.modes.end());
  result.notices.push_back(
      Notice{"modes_beside_the_law",
             {{"modes", modes}, {"together", found.residual.rms}, {"law", result.fit.residual.rms}}});
}

// A refused fit in which one line explains some of the variance, and the rest is no noise.
bool may_be_beats(const LawFit& fit) {
  const bool refused = fit.status == FitStatus::no_oscillation || fit.status == FitStatus::too_noisy;
  return refused && fit.explained > 0.1 && fit.residual.rms > 0 && fit.residual.autocorrelation >= structured;
}

bool may_recognise(const FitOptions& options) {
  return options.recognise_drive && !law_is_chosen(options) && !is_driven(options);
}

// Whether the motion keeps its amplitude, at the drive's frequency if that is known: a settled driven motion.
bool is_settled(const FittedRecording& free, std::optional<double> drive) {
  const double resolution = two_pi / (free.series.t.back() - free.series.t.front());
  return free.says("swing_does_not_die_down") &&
         (!drive || std::abs(free.fit.motion.angular_frequency() - *drive) < resolution);
}

// The drive is off resonance by more than the half-power bandwidth, and at least one beat is recorded. Only a
// drive makes such a beat; near resonance a swing that feeds itself grows alike.
bool drives_beside_resonance(const FittedRecording& fitted) {
  const LawFit& fit = fitted.fit;
  const std::optional<double> own = damped_frequency_of(fit);
  if (!fitted.driven || fit.status != FitStatus::converged || !own) return false;
  const double apart = std::abs(fit.motion.drive_frequency - *own);
  return apart > 2 * fit.motion.decay_rate() &&
         apart * (fitted.series.t.back() - fitted.series.t.front()) > two_pi;
}

// A drive beside resonance that stands against the simplest free law stands against every other: none of them
// beats.
bool beats_under_viscous_damping(const FittedRecording& driven, const Series& motion, FitOptions without,
                                 bool frequency_known, const Watch& watch) {
  if (law_is_chosen(without) || !drives_beside_resonance(driven)) return false;
  without.law = "viscous";
  const Result<FittedRecording> free = fit_series(motion, driven.file, without, without_progress(watch));
  return free && !free->parameters.empty() && driven.fit["drive_amplitude"].low > 0 &&
         judged(*free, driven, frequency_known).kind == MotionKind::driven;
}

[[maybe_unused]] bool amplitude_may_rise(const Series& motion, const FitOptions& options) {
  const Result<Series> used = samples_in_use(motion, options);
  if (!used) return false;
  const FittedSamples samples = without_outliers(*used);
  const Record record{samples.t, samples.y, used->resolution};
  const std::optional<double> period = period_at_start(record);
  return !period || may_rise(record, *period);
}

}  // namespace

std::optional<FittedRecording> fit_beats(const Series& motion, std::string_view file,
                                         const FitOptions& options, const Watch& watch) {
  // Of longer ones laws are compared on a part, and a fit to the whole costs more than it saves.
  constexpr std::size_t most = 200'000;
  if (!may_recognise(options) || motion.t.size() > most) return std::nullopt;
  // Saves a fit; the page must be small.
  if constexpr (!for_page)
    if (!amplitude_may_rise(motion, options)) return std::nullopt;
  FitOptions viscous;
  viscous.law = "viscous";
  viscous.from = options.from;
  viscous.to = options.to;
  Result<FittedRecording> free = fit_series(motion, file, viscous, without_progress(watch));
  if (!free || !free->succeeded() || !free->says("amplitude_rises")) return std::nullopt;
  free->options = options;
  FittedRecording driven = recognise_drive(*std::move(free), motion, options, watch);
  if (!drives_beside_resonance(driven)) return std::nullopt;
  return driven;
}

FittedRecording recognise_drive(FittedRecording free, const Series& motion, const FitOptions& options,
                                const Watch& caller) {
  const bool refused = free.parameters.empty();
  const Residual& left = free.fit.residual;
  const bool is_noise = left.autocorrelation < structured || is_arithmetic(left.rms, free.series.y);
  if (!may_recognise(options) || (refused && !may_be_beats(free.fit)) || is_noise || caller.interrupted())
    return free;
  const FittedSamples samples = without_outliers(free.series);
  const Watch watch = within_steps(caller, {samples.t, samples.y}, DriveKind::harmonic);
  FitOptions same = options;
  same.drive_frequency = "auto";
  same.from = free.series.t.front();
  same.to = free.series.t.back();
  // The drive alone, without another law, must explain what the free law leaves: one fit then tells most free
  // motions. But a swing that feeds itself may be a driven one in disguise, of another law.
  const bool loses = !free.fit.law.shares(bounding_terms);
  if (loses) same.law = refused ? "viscous" : to_text(free.fit.law);
  // Where it surely explains next to nothing it is not refined: 1.05, by the 1.2 of LawFitOptions.
  const double to_beat = loses && !refused ? 1.05 / 1.2 * next_to_nothing * free.fit.residual.rms : HUGE_VAL;
  Result<FittedRecording> driven = fit_driven(motion, free.file, same, watch, to_beat);
  if (!driven || watch.interrupted()) return free;
  MotionJudgement judgement = judged(free, *driven, false);
  const bool settled = (driven->fit.has_values() && !drive_helps(*driven, free)) ||
                       (driven->fit.status == FitStatus::converged &&
                        (judgement.kind == MotionKind::free || judgement.kind == MotionKind::two_modes));
  // Where every free law was refused, a drive must explain more than half.
  const bool worth_more = !refused || driven->fit.explained > 0.5;
  if (loses && !settled && worth_more) {
    same.law = options.law;
    std::optional<KnownMotion> start;
    if (driven->fit.law == law_of("viscous") && driven->fit.status == FitStatus::converged)
      start = KnownMotion{driven->fit.motion, driven->series.t.size(), 0};
    driven = fit_driven(motion, free.file, same, watch, HUGE_VAL, start);
    if (!driven || watch.interrupted()) return free;
    judgement = judged(free, *driven, false);
  }
  if (judgement.kind == MotionKind::two_modes &&
      judgement.modes->residual.rms < 0.9 * free.fit.residual.rms) {
    name_two_modes(free, *judgement.modes);
    return free;
  }
  const bool undecided = judgement.kind == MotionKind::driven_or_two_modes;
  if (!(judgement.kind == MotionKind::driven || undecided) || !is_steadily_driven(*driven, free)) return free;
  driven->options = options;
  // What was taken for a catch is the end of the drive.
  for (const Notice& notice : free.notices)
    if (notice.code == "swing_until_caught") driven->notices.emplace_back(notice).code = "driven_until_stop";
  if (undecided) {
    leave_undetermined(*driven, *judgement.modes, either_reading(*judgement.modes, unit_of(driven->series)));
  } else {
    driven->notices.push_back(Notice{"motion_is_driven",
                                     {{"frequency", driven->fit.motion.drive_frequency / two_pi},
                                      {"free", free.fit.residual.rms},
                                      {"driven", driven->fit.residual.rms},
                                      {"unit", unit_of(driven->series)}}});
  }
  return *std::move(driven);
}

Result<FittedRecording> check_drive(FittedRecording driven, const Series& motion, const FitOptions& options,
                                    const Watch& watch) {
  // A fit that did not converge, or was refused for noise, has found no drive either, if the motion is a free
  // one.
  const bool searched = options.drive_frequency == "auto", refused = driven.parameters.empty();
  const bool settled = !refused && driven.fit.status == FitStatus::converged;
  const bool failed =
      driven.fit.status == FitStatus::iteration_limit || driven.fit.status == FitStatus::too_noisy;
  if (!(settled || failed) || watch.interrupted()) return driven;
  FitOptions without = options;
  without.drive_frequency.clear();
  without.recognise_drive = false;
  without.from = driven.series.t.front();
  without.to = driven.series.t.back();
  if (beats_under_viscous_damping(driven, motion, without, !searched, watch)) return driven;
  Result<FittedRecording> free = fit_series(motion, driven.file, without, watch);
  if (!free || free->parameters.empty() || watch.interrupted()) return driven;
  if (!settled && (free->fit.status != FitStatus::converged || (!refused && drive_helps(driven, *free))))
    return driven;
  const MotionJudgement judgement = judged(*free, driven, !searched);
  if (judgement.kind == MotionKind::driven_or_two_modes) {
    const std::string unit = unit_of(driven.series);
    leave_undetermined(driven, *judgement.modes,
                       searched ? either_reading(*judgement.modes, unit)
                                : either_reading(*judgement.modes, unit, **drive_of(options)));
    return driven;
  }
  if (judgement.kind == MotionKind::two_modes) {
    FittedRecording& result = searched ? *free : driven;
    result.options = options;
    name_two_modes(result, *judgement.modes);
    return result;
  }
  // Of a drive that was named its size need not be known, where nothing is left to explain.
  const bool shows = !settled || driven.fit["drive_amplitude"].low > 0 ||
                     (!searched && driven.fit.residual.autocorrelation <= structured);
  if (judgement.kind != MotionKind::free && shows) return driven;
  const bool settles = is_settled(*free, searched ? std::nullopt : *drive_of(options));
  const double found = free->fit.motion.angular_frequency() / two_pi;
  if (settles && !searched) {
    driven.fit.status = FitStatus::no_oscillation;
    driven.fit.message = Notice{"motion_has_settled", {{"frequency", found}}};
    return driven;
  }
  const Notice compared{"free_beside_driven",
                        {{"free", free->fit.residual.rms},
                         {"driven", driven.fit.residual.rms},
                         {"unit", unit_of(driven.series)}}};
  free->options = options;
  if (searched) {
    free->notices.push_back(settles ? Notice{"settled_or_free", {{"frequency", found}}}
                                    : Notice{"no_drive_found", {{"compared", compared}}});
    return free;
  }
  const double asked = **drive_of(options) / two_pi;
  if (!free->fit.residual.white && free->fit.residual.autocorrelation > structured) {
    driven.fit.status = FitStatus::no_oscillation;
    driven.fit.message = Notice{"neither_driven_nor_free", {{"asked", asked}, {"compared", compared}}};
    return driven;
  }
  free->notices.push_back(Notice{"no_drive_there", {{"asked", asked}, {"compared", compared}}});
  return free;
}

}  // namespace cromer::core
