// What a report tells of one recording: its words, its quantities and their units.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/base/extent.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/pi.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/catalogue.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/terms/term.h"
#include "cromer/read/column_kind.h"
#include "cromer/study/lab_report.h"
#include "cromer/study/study_writer.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fitted_motion.h"

namespace cromer::core {

/// The unit that is read most easily for values of a size in an SI unit; "" where there is only this one.
inline std::string readable_unit(std::string_view si, double size) {
  const std::string length(length_unit(size).symbol);
  return si == "m" ? length : si == "m/s" ? length + "/s" : "";
}

/// One recording with its fit, in the words of the report. Numbers stand in them as results of the study, by
/// the name `id` of its task: "{lab.stiffness}".
class LabTold {
 public:
  /// `file`: what the page calls it.
  LabTold(const ReportedRecording& recording, std::string file, std::string id, bool alone,
          const ReportFront& front)
      : fitted_(recording.fitted),
        compared_(recording.compared ? &*recording.compared : nullptr),
        path_(recording.path),
        file_(std::move(file)),
        id_(std::move(id)),
        alone_(alone),
        front_(front),
        units_(motion_units(fitted_)) {
    if (!fitted_.fit.has_values()) return;
    const auto [low, high] = extent_of(fitted_.series.y);
    spread_ = (high - low) / 2;
    period_ = two_pi / fitted_.fit.motion.angular_frequency();
    if (const Parameter* known = named(fitted_.derived, "period")) period_ = known->estimate.value;
    duration_ = fitted_.series.t.back() - fitted_.series.t.front();
  }

  /// The recording's name; in a report of one file's runs, whose name it then has, the run alone.
  std::string title() const {
    if (file_.empty()) return say(Notice{"report_run", {{"run", fitted_.series.run}}});
    return fitted_.one_of_several
               ? say(Notice{"report_run_of", {{"file", file_}, {"run", fitted_.series.run}}})
               : file_;
  }

  /// Whether more is known of the recording's parts than of the whole.
  bool has_only_parts() const { return lacks_a_law() && fitted_.decay_by_amplitude.size() > 1; }

 protected:
  /// The steps that a period has in the simulations of the two methods, how many periods they last, and how
  /// often as far as the law they may swing.
  static constexpr double steps_per_period = 200, most_periods = 10, drawn_periods = 5, most_times_as_far = 3;

  std::string words(std::string_view code, std::vector<NoticeValue> values = {}) const {
    Notice notice{std::string(code)};
    notice.values = std::move(values);
    return say(notice);
  }
  std::string say(const Notice& notice) const { return in_words(notice, {front_.language}); }

  /// The name of a quantity, of its parameter or as it is.
  std::string name_of(const std::string& parameter) const {
    return find_entry(parameter) ? words(parameter) : readable_name(parameter);
  }

  std::string no_law() const {
    return words("report_no_law", {{"file", verbatim(title())}, {"why", verbatim(say(fitted_.fit.message))}});
  }

  std::string in_braces(std::string_view inside) const { return fmt::format("{{{}.{}}}", id_, inside); }

  std::string interval(std::string_view name, const Estimate& e) const {
    return interval_of(fmt::format("{}.{}", id_, name), e, front_.language);
  }

  std::string figure_id(std::string_view name) const {
    return alone_ ? std::string(name) : fmt::format("{}-{}", id_, name);
  }

  /// Why the numbers may not mean what they seem to mean; empty if they do.
  Notice first_doubt() const {
    if (compared_)
      return compared_->doubts.empty() ? Notice{} : without_uncertainties(compared_->doubts.front());
    for (const Notice& notice : fitted_.notices)
      if (severity(notice) == Severity::wrong_if_ignored) return without_uncertainties(notice);
    return {};
  }

  /// Whether the law leaves so much that its numbers are not those of the motion.
  bool is_poorly_described() const {
    constexpr double much = 0.1;  // of the swing
    return lacks_a_law() && fitted_.fit.residual.rms > much * spread_;
  }

  /// Whether no law that was tried describes the recording: what follows from the law may be far off.
  bool lacks_a_law() const { return lack_a_law(compared_ ? compared_->doubts : fitted_.notices); }

  /// In braces; where no law describes the recording without its uncertainty, to so many digits.
  std::string as_far_as_known(std::string_view inside, int digits = 3) const {
    return in_braces(lacks_a_law() ? fmt::format("{}, {}", inside, digits) : std::string(inside));
  }

  /// Where this rate holds, in the unit that suits an amplitude of this size.
  std::string amplitude_of(std::string_view rate, double size) const {
    const std::string unit = readable_unit(units_.displacement, size);
    return in_braces(fmt::format("{}.amplitude, {}3", rate, unit.empty() ? "" : unit + ", "));
  }

  /// Of the first stretch, of the last, or of all.
  std::string amplitude_of(std::string_view rate) const {
    const auto& all = fitted_.decay_by_amplitude;
    return amplitude_of(rate, rate == "common_decay"    ? fitted_.common_decay->amplitude
                              : rate == "first_stretch" ? all.front().amplitude
                                                        : all.back().amplitude);
  }

  /// The rates of the first and the last stretch; where another is lower or higher than both, if only by
  /// chance, the lowest and the highest.
  std::string rates_of_stretches() const {
    const auto& all = fitted_.decay_by_amplitude;
    const auto [lowest, highest] = extreme_rates(all);
    const auto is_end = [&](const AmplitudeRate& each) {
      return &each == &all.front() || &each == &all.back();
    };
    const bool ends = is_end(lowest) && is_end(highest);
    const std::string_view one = ends ? "first_stretch" : "lowest_stretch",
                           other = ends ? "last_stretch" : "highest_stretch";
    return words(ends ? "report_rate_of_stretches" : "report_rate_between",
                 {{"one", in_braces(one)},
                  {"one_amplitude", ends ? amplitude_of(one) : amplitude_of(one, lowest.amplitude)},
                  {"other", in_braces(other)},
                  {"other_amplitude", ends ? amplitude_of(other) : amplitude_of(other, highest.amplitude)}});
  }

  /// Why the rate changes, under the law; "" where it does not for sure, or by no one term.
  std::string why_the_rate_changes() const {
    const Parameter *start = named(fitted_.headline, "decay_rate_start"),
                    *end = named(fitted_.headline, "decay_rate_end");
    if (!first_doubt().empty() || !start || !end || !are_apart(start->estimate, end->estimate)) return "";
    const auto is_sure = [&](std::string_view term) {
      const Estimate* found = fitted_.find(term);
      return found && found->low > 0;
    };
    const auto& stretches = fitted_.decay_by_amplitude;
    if (!stretches.empty() && stretches.back().amplitude > stretches.front().amplitude) return "";
    const bool rises = end->estimate.value > start->estimate.value;
    if (rises && is_sure("friction")) return words("report_friction_makes_it_rise");
    if (!rises && is_sure("drag")) return words("report_drag_makes_it_fall");
    return "";
  }

  /// Whether rival laws leave open how the rate changes as the swing dies down.
  bool has_only_a_common_rate() const {
    return fitted_.common_decay && !stretches_fall() && !stretches_rise();
  }

  /// Whether the rate is the same at the start and at the end, by the law.
  bool has_one_rate() const {
    const Parameter *start = named(fitted_.headline, "decay_rate_start"),
                    *end = named(fitted_.headline, "decay_rate_end");
    return start && end && is_one_rate(start->estimate, end->estimate);
  }

  /// Whether the first and the last stretch, by themselves, show it.
  bool stretches_fall() const { return stretches_differ(fitted_.decay_by_amplitude, 1); }
  bool stretches_rise() const { return stretches_differ(fitted_.decay_by_amplitude, -1); }

  /// Whether the frequency of the last stretch is another than the first's.
  bool has_another_frequency_at_last() const {
    if (fitted_.decay_by_amplitude.empty()) return false;
    const Estimate &first = fitted_.decay_by_amplitude.front().angular_frequency,
                   &last = fitted_.decay_by_amplitude.back().angular_frequency;
    const double off = std::abs(first.value - last.value);
    constexpr double worth_telling = 0.01;
    return off > worth_telling * first.value &&
           off > 3 * std::hypot(first.standard_error, last.standard_error);
  }

  /// "0.047 1/s at the start and 0.014 1/s at the end"; "" where it is not known.
  std::string decay_ends() const {
    const Parameter *start = named(fitted_.headline, "decay_rate_start"),
                    *end = named(fitted_.headline, "decay_rate_end");
    if (!start) return "";
    if (has_only_parts()) return rates_of_stretches();
    if (has_only_a_common_rate())
      return words("report_rate_common",
                   {{"rate", in_braces("common_decay")}, {"amplitude", amplitude_of("common_decay")}});
    if (!end) return words("report_rate_starts", {{"start", in_braces("decay_rate_start")}});
    const Estimate &a = start->estimate, &b = end->estimate;
    if (has_one_rate()) return words("report_rate_is", {{"rate", in_braces("decay_rate_start")}});
    const bool apart = are_apart(a, b) || (b.value < a.value ? stretches_fall() : stretches_rise());
    return words(!first_doubt().empty() ? "report_rate_by_the_law"
                 : !apart               ? "report_rate_at_both"
                 : b.value < a.value    ? "report_rate_falls"
                                        : "report_rate_rises",
                 {{"start", in_braces("decay_rate_start")}, {"end", in_braces("decay_rate_end")}});
  }

  std::string_view si() const { return units_.measured; }

  std::string shown() const { return readable_unit(si(), spread_); }

  static std::string with_unit(const std::string& name, std::string_view unit) {
    return unit.empty() ? name : fmt::format("{} ({})", name, unit);
  }

  /// The name of an axis of the recorded quantity.
  std::string with_own_unit(const std::string& name, const std::string& unit) const {
    return with_unit(name, !unit.empty()  ? unit
                           : si().empty() ? words("report_as_recorded")
                                          : std::string(si()));
  }

  std::string quantity() const {
    const std::string& known = fitted_.series.quantity;
    if (known == "position") return words("report_position");
    if (known == "angle") return words("report_angle");
    if (known == "velocity") return words("report_velocity");
    if (known == "angular velocity") return words("report_angular_velocity");
    if (known == "acceleration" || known == "angular acceleration") return words("report_acceleration");
    return known.empty() ? words("report_value") : known;
  }

  std::string time_axis() const { return words("report_time"); }

  /// Of a velocity or an acceleration the level is the sensor's own zero, no position.
  bool is_zero() const { return !of_position(); }
  std::string level(std::string_view unit) const {
    const std::string inside = unit.empty() ? "equilibrium" : fmt::format("equilibrium, {}", unit);
    const Parameter* level = named(fitted_.parameters, "equilibrium");
    const bool is_unsure = !lacks_a_law() && level && is_wider(level->estimate);
    return is_unsure ? in_braces(inside + ", 3") : as_far_as_known(inside, 4);
  }

  /// Whether the interval is wider than the uncertainty suggests: there are less than some three degrees of
  /// freedom.
  static bool is_wider(const Estimate& e) {
    constexpr double wide = 3;  // of a standard uncertainty, to each side
    return reach(e) > wide * e.standard_error;
  }
  /// Of the interval, to its farther end.
  static double reach(const Estimate& e) { return std::max(e.high - e.value, e.value - e.low); }

  std::string rms() const { return rms("rms", fitted_.fit.residual.rms); }
  /// Of the result `name`, whose value this is.
  std::string rms(std::string_view name, double value) const {
    const std::string unit = readable_unit(si(), value);
    return in_braces(fmt::format("{}, {}3", name, unit.empty() ? "" : unit + ", "));
  }

  std::string equation() const {
    std::string sum;
    for_each_term([&]<class T>() {
      if (!fitted_.fit.law.has<T>()) return;
      sum += std::string(sum.empty() ? "" : " + ") + std::string(T::info.formula);
    });
    return fmt::format("{} x'' + {} = {}", turns() ? "I" : "m", sum,
                       !fitted_.driven                                 ? "0"
                       : fitted_.fit.drive.kind == DriveKind::harmonic ? "F cos(w t + phi)"
                                                                       : "F(t)");
  }

  bool turns() const { return units_.displacement == "rad"; }

  double begin() const { return fitted_.series.t.front(); }

  double swings(double periods) const { return std::min(duration_, periods * period_); }

  bool of_position() const { return units_.measured == units_.displacement; }

  bool of_velocity() const { return !of_position() && units_.measured == units_.velocity; }

  std::string displacement() const {
    return words(units_.displacement == "rad" ? "report_angle" : "report_displacement");
  }

  std::string from_level() const { return of_position() ? displacement() : quantity(); }

  bool simulates() const {
    return fitted_.fit.is_usable() && !fitted_.simulate.empty() && period_ > 0 && !is_poorly_described();
  }

  double step() const { return std::stod(fmt::format("{:.2g}", period_ / steps_per_period)); }

  bool exactly() const { return fitted_.fit.law == law_of("viscous"); }

  std::string rate() const {
    if (!(fitted_.series.rate > 0)) return "";
    return words(
        fitted_.series.time_column.empty() && !fitted_.of_arrays ? "report_rate_given" : "report_rate",
        {{"rate", in_braces("rate, 4, bare")}});
  }

  /// The column that was taken, behind the file's name.
  std::string column() const {
    return fitted_.series.column.empty()
               ? ""
               : words("report_column", {{"column", verbatim(fitted_.series.column)}});
  }

  bool all_are_used() const { return fitted_.series.t.size() == fitted_.samples; }

  /// The samples that the fit used, and of how many where a part was left out: the words of samples.
  std::string used() const {
    const std::string count = in_braces("used, bare");
    return all_are_used()
               ? words("report_samples_used", {{"used", count}})
               : words("report_used_of", {{"used", count}, {"samples", in_braces("samples, bare")}});
  }

  /// From when to when, where a part was left out.
  std::string part() const {
    return all_are_used()
               ? ""
               : words("report_part", {{"from", in_braces("from, 4")}, {"to", in_braces("to, 4")}});
  }

  std::string set_aside() const {
    std::string text;
    if (!fitted_.series.gaps.empty()) text += words("report_gaps", {{"gaps", fitted_.series.gaps.size()}});
    if (!fitted_.series.outliers.empty() && fitted_.succeeded())
      text += words("report_outliers", {{"outliers", fitted_.series.outliers.size()}});
    return text;
  }

  std::string name_in_table(const std::string& name) const {
    const std::string part = viscous_part_in_words(fitted_.fit.law, name, front_.language);
    return !part.empty()                 ? part
           : name == "decay_rate_start"  ? words("report_rate_at_start")
           : name == "decay_rate_end"    ? words("report_rate_at_end")
           : name == "reynolds_max"      ? words("report_reynolds_max")
           : name == "at_amplitude"      ? words("report_at_amplitude")
           : name == "angular_frequency" ? words("report_small_swings")
           : name == "drive_frequency"   ? words("report_drive_angular_frequency")
           : name == "drag"              ? words(turns() ? "report_drag_per_inertia" : "report_drag_per_mass")
           : name == "equilibrium" && is_zero() ? words("report_zero")
           : name == "damping"                  ? words("report_damping_constant")
           : name == "position"                 ? words("report_position_at_start")
           : name == "velocity"                 ? words("report_velocity_at_start")
                                                : name_of(name);
  }

  std::string row_of(const Parameter& each) const {
    const std::string place = each.name == "reynolds_max" ? "reynolds.max" : each.name;
    const bool is_fitted =
        std::find(fitted_.fit.names.begin(), fitted_.fit.names.end(), each.name) != fitted_.fit.names.end();
    const std::string ends = lacks_a_law() ? ""
                             : each.estimate.standard_error > 0
                                 ? toml_text(interval(place, each.estimate)) + ", "
                             : is_fitted ? toml_text(words("report_assumed")) + ", "
                                         : toml_text("–") + ", ";
    const std::string_view term = term_of(fitted_.fit.law, each.name);
    return fmt::format("  [{}, {}, {}{}],\n", toml_text(name_in_table(each.name)),
                       toml_text(as_far_as_known(place)), ends,
                       toml_text(term.empty() ? "" : fmt::format("`{}`", term)));
  }

  CurveLines measured_swing(double until) const {
    return {.of = id_,
            .role = "measured",
            .name = words("report_is_measured"),
            .x = "since_start",
            .y = "displacement",
            .to = begin() + until,
            .dots = true};
  }

  const FittedRecording& fitted_;
  const CompareResult* compared_;
  const std::string& path_;
  std::string file_, id_;
  bool alone_;
  const ReportFront& front_;
  MotionUnits units_;
  double spread_ = 0, period_ = 0, duration_ = 0;
};

}  // namespace cromer::core
