#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/record/dialects/column_kind.h"
#include "cromer/study/task/compare.h"

namespace cromer {
namespace {

std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{}{}{}", rounded(value, 3), unit.empty() ? "" : "\u00a0", unit);
}

/// "10 % too small", "0.3 % too large".
std::string amplitude_at_the_end(double ratio) {
  const double off = 100 * std::abs(ratio - 1);
  return off < 0.05 ? "right to 0.05\u00a0%"
                    : fmt::format("{}\u00a0% too {}", rounded(off, 2), ratio > 1 ? "large" : "small");
}

}  // namespace

std::string explanation(const CompareResult& comparison) {
  const auto& curves = comparison.curves;
  if (curves.size() < 2 || !curves.front().complete || !curves.back().complete) return "";
  const ComparedCurve& one = curves.front();
  const ComparedCurve& law = curves.back();
  const std::string_view unit = si_unit_of(comparison.recording.series.quantity);
  const auto& rates = comparison.recording.decay_by_amplitude;
  const double first = rates.empty() ? 0 : rates.front().law_rate,
               last = rates.empty() ? 0 : rates.back().law_rate;
  const bool constant = std::abs(first - last) < 0.02 * std::max(first, last);
  const std::string left = fmt::format("with one rate {} (rms) are left", with_unit(one.rms, unit));
  if (law.law == Law{})
    return fmt::format("One decay rate is enough: {}, and the amplitude at the end is {}.", left,
                       amplitude_at_the_end(one.amplitude_ratio_end));
  const std::string with_law = fmt::format("with {} {}", to_text(law.law), with_unit(law.rms, unit));
  if (rates.empty() || constant)
    return fmt::format(
        "One decay rate describes the amplitude, but not the motion: {}, {}. The frequency changes as the "
        "swing "
        "dies down.",
        left, with_law);
  return fmt::format(
      "One decay rate is not enough. It {} from {} to {}\u00a01/s as the swing dies down from {} to {}; {} "
      "and the "
      "amplitude at the end is {}, {}. Quote the law instead.",
      last < first ? "falls" : "rises", rounded(first, 3), rounded(last, 3),
      with_unit(rates.front().amplitude, unit), with_unit(rates.back().amplitude, unit), left,
      amplitude_at_the_end(one.amplitude_ratio_end), with_law);
}

}  // namespace cromer
