#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "cromer/base/length_unit.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/read/column_kind.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fitted_motion.h"

namespace cromer::core {
namespace {

std::string with_unit(double value, std::string_view unit) {
  if (unit == "m") {
    const LengthUnit length = length_unit(std::abs(value));
    return rounded(value / length.metres, 3).append("\u00a0").append(length.symbol);
  }
  std::string text = rounded(value, 3);
  if (!unit.empty()) text.append("\u00a0").append(unit);
  return text;
}

/// By how much the ratio of amplitudes may be off by noise alone.
double noise_at_the_end(const ComparedCurve& curve) { return 2 * curve.amplitude_ratio_error; }

/// "the amplitude at the end is 10 % too small"
Notice amplitude_at_the_end(const ComparedCurve& curve) {
  if (curve.measured_at_rest) return Notice{curve.at_rest ? "both_have_died_down" : "it_still_swings"};
  const double off = 100 * std::abs(curve.amplitude_ratio_end - 1);
  constexpr double right = 0.05;  // [%]
  const double noise = 100 * noise_at_the_end(curve);
  constexpr double no_test = 20;  // [%]
  if (off < noise && noise > no_test) return Notice{"end_is_near_the_noise"};
  if (off < noise && noise > right)
    return Notice{"end_is_right_within_noise", {{"noise", rounded(noise, 2)}}};
  if (off < right) return Notice{"end_is_right"};
  return Notice{curve.amplitude_ratio_end > 1 ? "end_too_large" : "end_too_small",
                {{"off", rounded(off, 2)}}};
}

/// Whether the amplitude at the end is off by more than the noise lets see, and than one may call right.
bool is_far_off_at_the_end(const ComparedCurve& curve) {
  if (curve.measured_at_rest) return !curve.at_rest;
  constexpr double far = 0.05;
  return std::abs(curve.amplitude_ratio_end - 1) > std::max(far, noise_at_the_end(curve));
}

/// The decay rates at both ends of the recording, by the law; none where one is not known.
std::optional<std::pair<double, double>> rates_at_the_ends(const FittedRecording& recording) {
  const Parameter *start = named(recording.headline, "decay_rate_start"),
                  *end = named(recording.headline, "decay_rate_end");
  if (!start || !end || is_one_rate(start->estimate, end->estimate)) return std::nullopt;
  return std::pair{start->estimate.value, end->estimate.value};
}

/// The least and the largest decay rate of single stretches, where they scatter about the law's by more than
/// the uncertainties that each has by itself and chance make: three standard deviations of their mean square.
std::optional<std::pair<double, double>> scattered_rates(const FittedRecording& recording) {
  constexpr double surely = 3;
  const auto& rates = recording.decay_by_amplitude;
  if (rates.size() < 3) return std::nullopt;
  double squares = 0, least = HUGE_VAL, largest = -HUGE_VAL;
  for (const AmplitudeRate& each : rates) {
    const double off = each.widened * (each.rate.value - each.law_rate) / each.rate.standard_error;
    squares += off * off / static_cast<double>(rates.size());
    least = std::min(least, each.rate.value);
    largest = std::max(largest, each.rate.value);
  }
  if (!(squares > 1 + surely * std::sqrt(2 / static_cast<double>(rates.size())))) return std::nullopt;
  return std::pair{least, largest};
}

/// Whether laws that fit as well have rates at the ends that differ by more than a tenth.
bool other_rates_fit(const FittedRecording& recording) {
  constexpr double otherwise = 0.1;
  return std::any_of(recording.law_doubts.begin(), recording.law_doubts.end(), [&](const LawDoubt& doubt) {
    const Parameter* rate = named(recording.headline, doubt.name);
    return rate && doubt.name.starts_with("decay_rate_") &&
           doubt.by > otherwise * std::abs(rate->estimate.value);
  });
}

/// Where no law describes the recording: that parts of it have other rates, whatever the law; else empty.
Notice rates_of_parts(const CompareResult& comparison, std::string_view displacement) {
  const auto& rates = comparison.recording.decay_by_amplitude;
  // Of two swings at once the rate of a part is that of their beat.
  const auto none_does = [](const Notice& doubt) { return doubt.code == "no_law_describes"; };
  if (comparison.doubts.empty() || !comparison.recording.modes.empty() ||
      !std::all_of(comparison.doubts.begin(), comparison.doubts.end(), none_does) ||
      !(stretches_differ(rates, 1) || stretches_differ(rates, -1)))
    return {};
  const auto rate = [](const AmplitudeRate& each) {
    return format_quantity({each.rate.value, each.rate.standard_error}, "1/s");
  };
  return Notice{"rates_of_parts",
                {{"first", rate(rates.front())},
                 {"last", rate(rates.back())},
                 {"from", with_unit(rates.front().amplitude, displacement)},
                 {"to", with_unit(rates.back().amplitude, displacement)}}};
}

/// What the method adds to the law's own misfit; empty if that is negligible.
Notice method_adds(const ComparedCurve& curve, std::string_view unit) {
  if (curve.diverged)
    return Notice{"simulation_runs_away", {{"method", curve.method}, {"step", rounded(curve.step, 3)}}};
  const double phase = std::abs(curve.method_phase), change = std::abs(curve.method_amplitude_ratio - 1);
  if (!(curve.rms > 1.02 * curve.law_rms || phase > 0.01 || change > 0.005)) return {};
  std::vector<Notice> adds;
  if (phase > 1e-3) adds.push_back(Notice{"adds_a_phase", {{"phase", rounded(curve.method_phase, 2)}}});
  if (change > 1e-3)
    adds.push_back(Notice{curve.method_amplitude_ratio > 1 ? "makes_it_larger" : "makes_it_smaller",
                          {{"change", rounded(100 * change, 2)}}});
  return Notice{adds.empty() ? "method_leaves" : "method_adds",
                {{"method", curve.method},
                 {"step", rounded(curve.step, 3)},
                 {"left", with_unit(curve.rms, unit)},
                 {"adds", adds}}};
}

}  // namespace

bool lack_a_law(const std::vector<Notice>& notices) {
  return std::any_of(notices.begin(), notices.end(), is_of_no_law);
}

Notice without_uncertainties(const Notice& notice) {
  if (is_of_no_law(notice))
    for (const NoticeValue& each : notice.values)
      if (const auto* what = std::get_if<std::vector<Notice>>(&each.value)) return what->front();
  return notice;
}

Notice explanation(const CompareResult& comparison) {
  const auto& curves = comparison.curves;
  if (curves.size() < 2) return {};
  const ComparedCurve& one = curves[0];
  const ComparedCurve& law = curves[1];
  const std::string unit = unit_of(comparison.recording.series),
                    displacement = motion_units(comparison.recording).displacement;
  const bool viscous = law.law == one.law;
  const Notice left{has_mean_rate(comparison.recording) ? "mean_rate_leaves" : "one_rate_leaves",
                    {{"left", with_unit(one.rms, unit)}}};
  const Notice with_law{"law_leaves", {{"law", to_text(law.law)}, {"left", with_unit(law.rms, unit)}}};
  if (const Notice parts = rates_of_parts(comparison, displacement); !parts.empty())
    return Notice{"parts_have_other_rates",
                  {{"doubt", without_uncertainties(comparison.doubts.front())},
                   {"parts", parts},
                   {"one_rate", left},
                   {"with_law", with_law}}};
  if (!comparison.doubts.empty())
    return Notice{viscous ? "no_verdict" : "no_verdict_with_law",
                  {{"doubt", without_uncertainties(comparison.doubts.front())},
                   {"one_rate", left},
                   {"with_law", with_law}}};

  const auto& rates = comparison.recording.decay_by_amplitude;
  const double first = rates.empty() ? 0 : rates.front().law_rate,
               last = rates.empty() ? 0 : rates.back().law_rate;
  const auto ends = rates_at_the_ends(comparison.recording);
  const bool alike = std::abs(first - last) <= alike_rates * std::max(std::abs(first), std::abs(last)),
             constant = !ends && alike;
  const Notice end = amplitude_at_the_end(one);
  Notice method;
  for (std::size_t i = curves.size(); i-- > 2;)
    if (Notice adds = method_adds(curves[i], unit); !adds.empty())
      method = Notice{"one_then_another", {{"one", std::move(adds)}, {"another", std::move(method)}}};
  const bool only_best = is_far_off_at_the_end(one);
  if (const auto scattered = scattered_rates(comparison.recording);
      viscous && scattered && comparison.others_tried)
    return Notice{"one_rate_while_stretches_scatter",
                  {{"one_rate", left},
                   {"least", rounded(scattered->first, 2)},
                   {"largest", rounded(scattered->second, 2)},
                   {"method", method}}};
  if (viscous && !is_linear(law.law) && !constant && comparison.others_tried)
    return Notice{only_best ? "viscous_is_best" : "viscous_is_enough",
                  {{"first", rounded(ends ? ends->first : first, 3)},
                   {"last", rounded(ends ? ends->second : last, 3)},
                   {"one_rate", left},
                   {"end", end},
                   {"method", method}}};
  if (viscous)
    return Notice{!comparison.others_tried                ? "no_other_law_tried"
                  : only_best                             ? "one_rate_is_best"
                  : other_rates_fit(comparison.recording) ? "one_rate_fits"
                                                          : "one_rate_is_enough",
                  {{"one_rate", left}, {"end", end}, {"method", method}}};
  const bool bent = has_bent_spring(law.law);
  if (rates.size() < 2 || alike)
    return Notice{
        !rates.empty() && constant && bent ? "one_rate_but_not_the_motion" : "one_rate_is_not_enough",
        {{"one_rate", left}, {"with_law", with_law}, {"method", method}}};
  const bool grows = rates.back().amplitude > rates.front().amplitude;
  return Notice{"rate_changes_with_amplitude",
                {{"goes", Notice{last < first ? "falls" : "rises"}},
                 {"first", rounded(first, 3)},
                 {"last", rounded(last, 3)},
                 {"swing", Notice{grows ? "swing_grows" : "swing_dies_down"}},
                 {"from", with_unit(rates.front().amplitude, displacement)},
                 {"to", with_unit(rates.back().amplitude, displacement)},
                 {"one_rate", left},
                 {"end", end},
                 {"with_law", with_law},
                 {"method", method}}};
}

}  // namespace cromer::core
