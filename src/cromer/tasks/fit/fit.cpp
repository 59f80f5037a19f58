#include "cromer/tasks/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "cromer/analysis/air.h"
#include "cromer/analysis/ground_motion.h"
#include "cromer/base/for_page.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/diagnose/free_part.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/diagnose/second_mode.h"
#include "cromer/identify/diagnose/slip.h"
#include "cromer/identify/diagnose/undisturbed.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/read/angle_about_pivot.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/in_file.h"
#include "cromer/tasks/fit/beside_pendulum.h"
#include "cromer/tasks/fit/fit_driven.h"
#include "cromer/tasks/fit/fit_forced.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/one_mass.h"
#include "cromer/tasks/fit/perhaps_held.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/inspect/take_motion.h"

namespace cromer::core {
namespace {

void add_reynolds(FittedRecording& result, const Quantity& diameter, const Quantity& temperature,
                  const Watch& watch) {
  const int order = derivative_order(result.series.quantity);
  const bool length = is_linear_quantity(result.series.quantity) && order < 2;
  if (!length) {
    result.notices.push_back(Notice{"no_reynolds_number", {{"column", result.series.column}}});
    return;
  }
  constexpr double window = 0.5;  // [s]
  const LawFit& fit = result.fit;
  const double t0 = result.series.t.front(), duration = result.series.t.back() - t0;
  const double period = two_pi / fit.motion.angular_frequency();
  if (period >= 1) result.notices.push_back(Notice{"long_period_for_reynolds", {{"period", period}}});
  // A whole number of samples in each window, at least eighty in a period.
  const double step = window / std::ceil(80 * window / std::min(period, 80 * window));
  std::vector<double> t;
  for (std::size_t i = 0; static_cast<double>(i) * step <= duration * (1 + 1e-12); ++i)
    t.push_back(t0 + static_cast<double>(i) * step);
  if (watch.interrupted()) return;
  const Trajectory motion = motion_of(fit, t);
  const auto windows = speed_windows(motion.t, motion.v, window);
  const double nu = air_kinematic_viscosity(temperature.value);
  const SpeedWindow* top = nullptr;
  for (const SpeedWindow& w : windows) {
    result.reynolds.push_back({w.t, reynolds_number(w.speed, diameter.value, nu)});
    if (!top || w.speed > top->speed) top = &w;
  }
  if (!top) return;

  // At its maximum the speed does not change with time: its derivatives are those of the velocity there.
  double variance = 0;
  const VelocityGradient gradient = velocity_gradient(
      fitted_parameters(fit.law, DriveKind::none, {}, fit.motion), fit.motion, top->at - t0, fit.step);
  const std::size_t n = fit.names.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      variance += gradient.derivative[i] * fit.covariance[i * n + j] * gradient.derivative[j];
  // How the viscosity changes with temperature, as a difference: exact enough.
  const double warmer = air_kinematic_viscosity(temperature.value + temperature.uncertainty);
  const double relative = std::hypot(std::sqrt(std::max(0.0, variance)) / top->speed,
                                     diameter.uncertainty / diameter.value, warmer / nu - 1);
  const double value = reynolds_number(top->speed, diameter.value, nu);
  result.reynolds_max = make_estimate(value, relative * value, fit.student);
  result.reynolds_max_t = top->at;
}

// A pause so long that the motion cannot be followed through it is a wrong time, or two recordings in one.
Result<void> check_pauses(const Series& series) {
  constexpr double longest_pause = 1e6;  // [sample spacings]
  for (std::size_t i = 1; i < series.t.size(); ++i)
    if ((series.t[i] - series.t[i - 1]) * series.rate > longest_pause)
      return Error{"time_jumps",
                   {{"line", i < series.lines.size() ? series.lines[i] : 0},
                    {"from", series.t[i - 1]},
                    {"to", series.t[i]}}};
  return {};
}

// Fits the law that is asked for, or chooses one.
Result<LawChoice> law_of_record(const Record& record, const Series& series, const FitOptions& options,
                                std::vector<Notice>& notices, const Watch& watch) {
  LawFitOptions decay;
  decay.angle = series.quantity.starts_with("ang");
  decay.on_arc = series.scale_error > 0;
  decay.hysteresis_exponent = options.hysteresis_exponent;
  if (record.derivative > 0) notices.push_back(fitted_as_it_is(series.quantity, series.column));
  const Result<std::optional<Law>> law = law_of(options);
  if (!law) return law.error();
  if (!*law) return choose_law(record, decay, watch);
  if ((*law)->has<Pendulum>() && !decay.angle && !series.quantity.empty())
    return Error{"pendulum_without_angle",
                 {{"law", options.law}, {"column", series.column}, {"kind", kind_of(series.quantity)}}};
  decay.law = **law;
  LawChoice choice;
  choice.chosen = fit_law(record, decay, counting_passes(watch));
  choice.candidates = {choice.chosen};
  return choice;
}

// The samples from part.from to part.to alone.
void keep_part(const FitOptions& part, Series& series, FittedSamples& samples) {
  series = *used_part(std::move(series), part);
  samples = without_outliers(series);
}

Notice free_part_taken(const Notice& reason, const Series& kept, std::size_t samples) {
  return Notice{
      "free_part_taken",
      {{"reason", reason}, {"from", kept.t.front()}, {"kept", kept.t.size()}, {"samples", samples}}};
}

// What is driven or held at first is left out, with a notice.
void begin_where_free(Series& series, FittedSamples& samples, std::vector<Notice>& notices) {
  const auto part = find_free_part({samples.t, samples.y, series.resolution});
  if (!part) return;
  const std::size_t all = series.t.size();
  keep_part({.from = part->from}, series, samples);
  notices.push_back(free_part_taken(part->reason, series, all));
}

// A swing that is caught in full swing is taken until then, with a notice.
void end_where_caught(Series& series, FittedSamples& samples, std::vector<Notice>& notices) {
  const Record record{samples.t, samples.y, series.resolution};
  const auto period = period_at_start(record);
  const auto stop = period ? find_stop(record, *period, true) : std::nullopt;
  if (!stop) return;
  const std::size_t all = series.t.size();
  // A catch where the swing turns shows only later, and so does a brake that takes hold slowly.
  keep_part({.to = stop->from - *period}, series, samples);
  Notice caught = stop->notice("swing_until_caught", unit_of(series));
  caught.values.push_back({"until", series.t.back()});
  caught.values.push_back({"kept", series.t.size()});
  caught.values.push_back({"samples", all});
  notices.push_back(std::move(caught));
}

// Why no law settles: the swing stops. Else empty. A viscous law is fitted without integration.
Notice stop_of(const Record& record, bool angle, std::string_view unit, const Watch& watch) {
  LawFitOptions viscous;
  viscous.angle = angle;
  const LawFit fit = fit_law(record, viscous, watch);
  if (!fit.is_usable() || watch.interrupted()) return {};
  return sudden_stop(record, two_pi / fit.swing_frequency().value, unit, false);
}

// An accelerometer of a phone that is not told to leave gravity out.
Notice gravity_in(const Series& series, const FittedSamples& samples) {
  if (series.quantity != "acceleration" || samples.y.empty()) return {};
  double mean = 0;
  for (const double y : samples.y) mean += y / static_cast<double>(samples.y.size());
  return std::abs(std::abs(mean) - standard_gravity) < 0.1 * standard_gravity
             ? Notice{"axis_holds_gravity", {{"mean", mean}}}
             : Notice{};
}

bool radians_are_assumed(const Series& series) {
  return std::any_of(series.notices.begin(), series.notices.end(), [](const Notice& notice) {
    return notice.code == "unit_assumed" && std::find(notice.values.begin(), notice.values.end(),
                                                      NoticeValue{"unit", "rad"}) != notice.values.end();
  });
}

// What only a report tells is not found for the page.
constexpr bool is_reported = !for_page;

// By how much the decay rate changes from the first sample to the last, by the law [1/s].
std::optional<double> change_of_rate(const LawFit& fit, double duration) {
  const std::vector<Parameter> ends = decay_rate_ends(fit, duration);
  if (ends.size() != 2) return std::nullopt;
  return ends.back().estimate.value - ends.front().estimate.value;
}

// The decay rate that a law has in common with others that fit as well, where it changes otherwise by them.
std::optional<MeanDecay> common_decay(const Record& record, const LawFit& chosen,
                                      const std::vector<LawFit>& candidates) {
  const std::optional<MeanDecay> mean = mean_decay(chosen, record);
  const double duration = record.t.back() - record.t.front();
  const std::optional<double> change = change_of_rate(chosen, duration);
  constexpr double otherwise = 0.1;  // of the rate
  if (!mean || !change) return std::nullopt;
  const bool is_open = std::any_of(candidates.begin(), candidates.end(), [&](const LawFit& rival) {
    if (!fits_as_well(rival, chosen)) return false;
    const std::optional<double> other = change_of_rate(rival, duration);
    return other && std::abs(*other - *change) > otherwise * std::abs(mean->rate.value);
  });
  return is_open ? mean : std::nullopt;
}

// What the fit's message says is not said again. What was stopped has not come to rest by friction, after
// whatever number of half swings. Of a record that is no free swing of one law nothing is known whichever law
// is right.
void drop_what_no_longer_holds(std::vector<Notice>& notices, const Notice& message) {
  if (message.code == "swing_stops")
    std::erase_if(notices, [&](const Notice& each) { return each.code == message.code; });
  const auto drop_beside = [&](std::initializer_list<std::string_view> said, std::string_view dropped) {
    const auto is_said = [&](const Notice& each) {
      return std::find(said.begin(), said.end(), each.code) != said.end();
    };
    if (std::any_of(notices.begin(), notices.end(), is_said))
      std::erase_if(notices, [&](const Notice& each) { return each.code == dropped; });
  };
  drop_beside({"law_over_a_stop"}, "half_swings_before_rest_unsure");
  drop_beside({"law_over_a_stop", "swing_stops", "zero_jumps", "zero_drifts", "no_law_describes"},
              "rival_laws");
}

// The fit of the times without a slip. --from and --to mean the times as recorded.
Result<FittedRecording> fit_without(const TimeSlip& slip, const FittedRecording& with, const Series& series,
                                    FitOptions options, const Watch& watch) {
  for (auto* time : {&options.from, &options.to})
    if (*time && **time >= slip.at) **time -= slip.by;
  return fit_series(without_slip(series, slip), with.file, options, watch);
}

// The fit of the times without the slip that `with` found in them, with a notice; nothing where one was taken
// out before, the fit is no better, or the phase changes slowly there.
std::optional<FittedRecording> fit_mended(TimeSlip slip, const Record& record, const FittedRecording& with,
                                          const Series& series, const Watch& watch) {
  if (series.slips_at < HUGE_VAL) return std::nullopt;
  const FitOptions& options = with.options;
  Result<FittedRecording> mended = fit_without(slip, with, series, options, watch);
  if (!mended || !mended->succeeded()) return std::nullopt;
  // Another law shows it better.
  const TimeSlip better = slip_under(mended->fit.law, slip, record, watch);
  constexpr double alike = 0.02;  // of the time between samples
  if (better.at != slip.at || std::abs(better.by - slip.by) * series.rate > alike) {
    slip = better;
    mended = fit_without(slip, with, series, options, watch);
    if (!mended || !mended->succeeded()) return std::nullopt;
  }
  const FittedSamples samples = without_outliers(mended->series);
  const Record kept{samples.t, samples.y, record.resolution, record.derivative};
  if (!(mended->fit.residual.rms <= with.fit.residual.rms) ||
      !is_sudden(mended->series.slips_at, kept, mended->fit))
    return std::nullopt;
  mended->options = options;
  mended->samples = with.samples;
  mended->notices.insert(mended->notices.begin(), slip.notice_when_removed(with.fit));
  ++mended->of_record;
  return *std::move(mended);
}

}  // namespace

const Estimate* FittedRecording::find(std::string_view wanted) const {
  for (const auto* list : {&parameters, &derived})
    for (const Parameter& number : *list)
      if (number.name == wanted) return &number.estimate;
  return nullptr;
}

bool FittedRecording::says(std::string_view code) const {
  return std::any_of(notices.begin(), notices.end(),
                     [&](const Notice& notice) { return notice.code == code; });
}

std::size_t FittedRecording::used() const { return without_outliers(series).t.size(); }

FittedRecording not_fitted(std::string_view file, int run, const Notice& why) {
  FittedRecording row;
  row.file = file;
  row.series.run = run;
  row.wrong_input = true;
  row.fit.status = FitStatus::no_oscillation;
  row.fit.message = without_file(why, file);
  return row;
}

Result<FittedRecording> fit_series(const Series& series, std::string_view file, const FitOptions& options,
                                   const Watch& watch) {
  if (const Result<void> checked = check_fit_options(options); !checked) return checked.error();
  Result<Series> used = samples_in_use(series, options);
  if (!used) return used.error();
  if (const Result<void> checked = check_pauses(*used); !checked) return checked.error();

  FittedRecording result = row_to_fit(series, *std::move(used), file, options);
  FittedSamples samples = without_outliers(result.series);
  // Without its peaks a swing seems to keep its amplitude.
  const bool has_all_peaks = !result.says("cut_tops_aside");
  if (!options.from && has_all_peaks) begin_where_free(result.series, samples, result.notices);
  if (!options.to) end_where_caught(result.series, samples, result.notices);
  // The law's motion begins at the first sample that the fit sees; so must the series.
  if (!samples.t.empty() && result.series.t.front() < samples.t.front()) {
    FitOptions later = options;
    later.from = samples.t.front();
    std::vector<Outlier> aside = std::move(result.series.outliers);
    result.series.outliers.clear();
    result.series = *used_part(std::move(result.series), later);
    result.series.outliers = std::move(aside);
  }
  const Record record = record_of(result.series, samples.t, samples.y);

  if (result.series.quantity == "angle")
    if (Notice over = turning_over(record); !over.empty()) {
      if (over.code == "turns_over" && radians_are_assumed(result.series)) over.code = "perhaps_degrees";
      result.notices.push_back(std::move(over));
    }
  if (Notice gravity = gravity_in(result.series, samples); !gravity.empty())
    result.notices.push_back(std::move(gravity));
  Result<LawChoice> choice = law_of_record(record, result.series, options, result.notices, watch);
  if (!choice) return choice.error();
  result.fit = choice->chosen;
  list_outliers(result.series, samples, result.fit.outliers, result.notices);
  result.of_record = result.notices.size();
  const std::string unit = unit_of(result.series);
  if (result.fit.status == FitStatus::iteration_limit && !watch.interrupted())
    if (Notice stop = stop_of(record, result.series.quantity.starts_with("ang"), unit, watch); !stop.empty())
      result.fit.message = std::move(stop);
  result.notices.insert(result.notices.end(), result.fit.notices.begin(), result.fit.notices.end());
  for (const LawFit& candidate : choice->candidates)
    if (candidate.is_usable())
      result.candidates.push_back({candidate.law, candidate.residual.rms, candidate.bic,
                                   candidate.status == FitStatus::converged,
                                   candidate.motion.angular_frequency()});
  if (!result.fit.is_usable()) return result;

  const FittedSamples good = without_outliers(result.series);
  Record kept{good.t, good.y, record.resolution, record.derivative};
  kept.slips_at = record.slips_at;
  Notice slip;
  if constexpr (looks_for_slips)
    if (const auto found = find_slip(kept, result.fit, choice->candidates, watch)) {
      if (auto mended = fit_mended(*found, kept, result, series, watch)) return *std::move(mended);
      slip = found->notice();
    }

  const Body body = body_of(options);
  result.parameters = law_parameters(result.fit, unit, record.derivative);
  add_force_parameters(result, body);
  result.derived = derived_quantities(result.fit, unit, record.derivative);
  result.law_doubts = law_doubts(result, choice->candidates);
  add_doubts(result.parameters, result.law_doubts);
  add_doubts(result.derived, result.law_doubts);
  result.simulate = simulate_settings(result.fit, result.series, body.mass ? body.effective_mass().value : 1);

  const DecaySegments segments = fit_segments(kept, two_pi / result.fit.swing_frequency().value,
                                              options.segment, options.segments, watch);
  result.segments = segments.segments;
  result.decay_rate_mean = segments.mean;
  result.notices.insert(result.notices.end(), segments.notices.begin(), segments.notices.end());
  if (options.disc_diameter) add_reynolds(result, *options.disc_diameter, body.temperature, watch);
  const std::vector<ResidualLine> lines = residual_lines(record, result.fit);
  result.decay_by_amplitude = decay_by_amplitude(kept, result.fit, lines, watch);
  if constexpr (is_reported) add_doubts_of_stretches(result.law_doubts, result.decay_by_amplitude);
  if (const Result<void> asked = add_lab_quantities(result, kept, body, watch); !asked) return asked.error();
  if (watch.interrupted() && result.fit.status == FitStatus::converged) {
    result.fit.status = FitStatus::iteration_limit;
    result.fit.message = Notice{"fit_interrupted"};
    return result;
  }
  result.doubts = doubts(record, result.fit, law_is_chosen(options), unit);
  if (!has_all_peaks)
    std::erase_if(result.doubts, [](const Notice& each) { return each.code == "amplitude_rises"; });
  result.notices.insert(result.notices.end(), result.doubts.begin(), result.doubts.end());
  // Beside a law that leaves much there is no telling what else swings.
  constexpr double well = 0.9;  // of the variance
  if (result.fit.explained > well) {
    const std::vector<Notice> modes = second_modes(lines, result.fit, record.derivative, unit);
    result.notices.insert(result.notices.end(), modes.begin(), modes.end());
  }
  if (!slip.empty()) result.notices.push_back(std::move(slip));
  if constexpr (is_reported)
    for (Notice (*beside)(const FittedRecording&) : {arc_beside_pendulum, cubic_beside_pendulum})
      if (Notice told = beside(result); !told.empty()) result.notices.push_back(std::move(told));
  drop_what_no_longer_holds(result.notices, result.fit.message);
  drop_what_no_longer_holds(result.doubts, result.fit.message);
  if constexpr (is_reported)
    if (result.says("rival_laws")) result.common_decay = common_decay(record, result.fit, choice->candidates);
  if (Notice wide = widening(result.fit, record.t.size()); !wide.empty())
    result.notices.push_back(std::move(wide));
  return result;
}

namespace {

// Whether no law was found, or one that leaves a seventh of the swing.
bool is_without_a_law(const FittedRecording& fitted) {
  constexpr double nearly_all = 0.98;  // of the motion's squares
  if (fitted.fit.is_usable()) return fitted.says("no_law_describes") && fitted.fit.explained < nearly_all;
  const FitStatus status = fitted.fit.status;
  return (status == FitStatus::no_oscillation || status == FitStatus::too_noisy) && !fitted.wrong_input;
}

// Whether the law goes over a stop, or the zero jumps within three periods of an end, as where a hand holds
// the body for a moment.
bool is_held_at_an_end(const FittedRecording& fitted) {
  if (!is_reported || !fitted.succeeded()) return false;
  constexpr double periods = 3;
  const double near = periods * two_pi / fitted.fit.swing_frequency().value;
  return std::any_of(fitted.doubts.begin(), fitted.doubts.end(), [&](const Notice& doubt) {
    if (doubt.code != "zero_jumps") return doubt.code == "law_over_a_stop";
    const auto at = std::find_if(doubt.values.begin(), doubt.values.end(),
                                 [](const NoticeValue& each) { return each.name == "time"; });
    const double t = std::get<double>(at->value);
    return t < fitted.series.t.front() + near || t > fitted.series.t.back() - near;
  });
}

// Where no one law is found for the whole, or it is held at an end: the fit of what swings freely, with a
// notice.
Result<FittedRecording> fit_free_swing(FittedRecording whole, const Series& series, std::string_view file,
                                       const FitOptions& options, const Watch& watch) {
  if (options.from || options.to || whole.driven || !whole.modes.empty() ||
      !(is_without_a_law(whole) || is_held_at_an_end(whole)))
    return whole;
  // Also in what was cut off as after a stop: while a hand moves it, it seems to stop early.
  Result<Series> used = samples_in_use(series, options);
  if (!used) return whole;
  const Series uncut = row_to_fit(series, *std::move(used), file, options).series;
  const auto [t, y] = without_outliers(uncut);
  const std::optional<FreeSwing> swing =
      find_free_swing({t, y, uncut.resolution, std::max(0, derivative_order(uncut.quantity))}, watch);
  if (!swing) return whole;
  FitOptions later = options;
  later.from = swing->from;
  later.to = swing->to;
  Series handled = series;
  handled.handled_first = swing->period;
  if (swing->to) handled.handled_last = swing->period;
  Result<FittedRecording> part = fit_series(handled, file, later, watch);
  if (!part || !part->succeeded() || is_without_a_law(*part) || is_held_at_an_end(*part)) return whole;
  const Notice taken = swing->to ? Notice{"free_middle_taken",
                                          {{"from", swing->from},
                                           {"to", *swing->to},
                                           {"kept", part->series.t.size()},
                                           {"samples", series.t.size()}}}
                                 : free_part_taken(Notice{"disturbed_until", {{"time", swing->from}}},
                                                   part->series, series.t.size());
  part->notices.insert(part->notices.begin(), taken);
  ++part->of_record;
  return part;
}

Result<FittedRecording> fit_motion(const Recording& recording, const Series& series, std::string_view file,
                                   const FitOptions& options, const Watch& watch) {
  if (!options.drive_frequency.empty()) {
    Result<FittedRecording> driven = fit_driven(series, file, options, watch);
    if (!driven) return driven;
    return check_drive(*std::move(driven), series, options, watch);
  }
  if (!fits_recorded_forces || options.force_column.empty()) {
    if (auto beating = fit_beats(series, file, options, watch)) return *std::move(beating);
    Result<FittedRecording> free = fit_series(series, file, options, watch);
    if (!free) return free;
    return fit_free_swing(recognise_drive(*std::move(free), series, options, watch), series, file, options,
                          watch);
  }
  const Result<Series> force = take_force(recording, options, series.run);
  if (!force) return force.error();
  return fit_forced(series, *force, file, options, watch);
}

LeftOut outside(const Series& all, const Series& used) {
  LeftOut left;
  if (used.t.empty()) return left;
  const auto as_recorded = [&](double t) { return t < used.slips_at ? t : t + used.slips_by; };
  const double first = as_recorded(used.t.front()), last = as_recorded(used.t.back());
  for (std::size_t i = 0; i < all.t.size(); ++i)
    if (all.t[i] < first || all.t[i] > last) {
      left.t.push_back(all.t[i]);
      left.y.push_back(all.y[i]);
    }
  return left;
}

// A column other than the fitted one that may hold the force; "" if there is none, or one is named.
std::string column_of_a_force(const Recording& recording, const std::string& fitted,
                              const FitOptions& options) {
  if (!options.force_column.empty()) return "";
  for (const Column& column : recording.table.columns)
    if (column.quantity == "force" && column_title(column) != fitted) return column.name;
  return "";
}

// Whether x of a point was fitted whose y was recorded too, on an arc: as of a pendulum on film.
bool is_perhaps_on_a_string(const Recording& recording, const FittedRecording& fitted) {
  const int run = fitted.series.run;
  const auto x = find_column(recording.table, "x", run);
  if (!x || !fitted.fit.is_usable() || column_title(recording.table.columns[*x]) != fitted.series.column)
    return false;
  const auto angle = computed_angle(recording.table, "angle(x,y)", run);
  return angle && *angle;
}

Result<FittedRecording> fit_run(const Recording& recording, int run, std::string_view file,
                                const FitOptions& options, const Watch& watch) {
  const Result<Series> series = take_motion(recording, options.column, run, options.read);
  if (!series) return series.error();
  Result<FittedRecording> fitted = fit_motion(recording, *series, file, options, watch);
  if constexpr (is_reported)
    if (fitted) fitted->left_out = outside(*series, fitted->series);
  constexpr double well = 0.9;  // of the variance: a drive leaves more than that unexplained
  if (fitted && (fitted->driven || !fitted->succeeded() || fitted->fit.explained <= well ||
                 fitted->says("no_law_describes")))
    if (const std::string force = column_of_a_force(recording, fitted->series.column, options);
        !force.empty())
      fitted->notices.push_back(Notice{"may_be_the_force", {{"column", force}}});
  if (fitted && is_perhaps_on_a_string(recording, *fitted))
    fitted->notices.push_back(Notice{"perhaps_on_a_string", {{"column", fitted->series.column}}});
  // The inner force at the start is no parameter of the fit.
  if (fitted && options.from && fitted->fit.law.has<Hysteresis>())
    fitted->notices.push_back(Notice{"hysteresis_from_zero"});
  if (fitted && options.hysteresis_exponent != 1 && !fitted->fit.law.has<Hysteresis>())
    fitted->notices.push_back(Notice{"exponent_without_hysteresis", {{"law", to_text(fitted->fit.law)}}});
  return fitted;
}

// Whether the Error names neither file nor option, but a column or a line.
bool needs_a_file(const Notice& what) {
  static constexpr std::string_view codes[] = {"column_has_no_values", "values_too_small", "values_too_large",
                                               "time_jumps", "all_set_aside"};
  if constexpr (fits_recorded_forces)
    if (is_about_a_force(what)) return true;
  return std::find(std::begin(codes), std::end(codes), what.code) != std::end(codes);
}

}  // namespace

Result<std::vector<FittedRecording>> fit(const Recording& recording, const FitOptions& options,
                                         const Watch& watch) {
  if (const Result<void> checked = check_fit_options(options); !checked) return checked.error();
  const std::string& file = recording.file;
  const std::vector<int> wanted = options.run ? std::vector<int>{*options.run} : runs(recording);
  std::vector<FittedRecording> fits;
  std::optional<Error> first_error;
  bool any_read = false;
  const std::vector<Quantity>& masses = options.mass;
  if (masses.size() > 1 && masses.size() != wanted.size())
    return unlike_runs("mass", file, masses.size(), wanted.size());
  FitOptions of_run = options;
  for (int run : wanted) {
    if (masses.size() > 1) of_run.mass = {masses[fits.size()]};
    const auto done = static_cast<double>(fits.size()), all = static_cast<double>(wanted.size());
    const Watch part = part_of(watch, done / all, (done + 1) / all);
    Result<FittedRecording> one = fit_run(recording, run, file, of_run, part);
    if (one) {
      // Notices on the file are given once, with the first run that could be read.
      if (!any_read) {
        one->notices.insert(one->notices.begin(), recording.notices.begin(), recording.notices.end());
        one->of_file = recording.notices.size();
        one->of_record += one->of_file;
      }
      any_read = true;
      fits.push_back(std::move(*one));
      continue;
    }
    const Notice& what = one.error().notice;
    fits.push_back(not_fitted(file, run, what));
    const bool nameless = needs_a_file(what) && !file.empty();
    if (!first_error) first_error = nameless ? Error{in_file(file, what)} : one.error();
  }
  if (!any_read && first_error) return *first_error;
  for (FittedRecording& each : fits) each.one_of_several = fits.size() > 1;
  const auto say_of_file = [&](Notice said) {
    FittedRecording& first = fits.front();
    first.notices.insert(first.notices.begin() + static_cast<std::ptrdiff_t>(first.of_file), std::move(said));
    ++first.of_file;
    ++first.of_record;
  };
  if (options.mass.size() == 1)
    if (const auto spread = unlike_frequencies(fits))
      say_of_file(Notice{"one_mass_for_unlike_runs", {{"percent", spread->percent}}});
  if constexpr (fits_held_masses)
    if (Notice held = perhaps_held(fits); !held.empty()) say_of_file(std::move(held));
  return fits;
}

}  // namespace cromer::core
