#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/read/column_kind.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer::core {
namespace {

std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{}{}{}", rounded(value, 3), unit.empty() ? "" : "\u00a0", unit);
}

/// "the amplitude at the end is 10 % too small"
std::string amplitude_at_the_end(const ComparedCurve& curve) {
  if (curve.measured_at_rest)
    return curve.at_rest ? "the swing has died down where the measured one has"
                         : "it still swings where the measured motion has died down";
  const double off = 100 * std::abs(curve.law_amplitude_ratio_end - 1);
  return "the amplitude at the end is " +
         (off < 0.05 ? std::string("right to 0.05\u00a0%")
                     : fmt::format("{}\u00a0% too {}", rounded(off, 2),
                                   curve.law_amplitude_ratio_end > 1 ? "large" : "small"));
}

std::string simulated_by(const ComparedCurve& curve) {
  return fmt::format("Simulated by {} in steps of {}\u00a0s", curve.method, rounded(curve.step, 3));
}

/// What the method adds to the law's own misfit; empty where that is nothing to speak of.
std::string method_adds(const ComparedCurve& curve, std::string_view unit) {
  const double phase = std::abs(curve.method_phase), change = std::abs(curve.method_amplitude_ratio - 1);
  if (!(curve.rms > 1.02 * curve.law_rms || phase > 0.01 || change > 0.005)) return "";
  std::string out =
      fmt::format(" {} the same law leaves {}", simulated_by(curve), with_unit(curve.rms, unit));
  std::string adds;
  if (phase > 1e-3) adds = fmt::format("adds a phase of {}\u00a0rad", rounded(curve.method_phase, 2));
  if (change > 1e-3)
    adds += fmt::format("{}makes the amplitude {}\u00a0% {}", adds.empty() ? "" : " and ",
                        rounded(100 * change, 2), curve.method_amplitude_ratio > 1 ? "larger" : "smaller");
  return out +
         (adds.empty() ? "; the rest is the method's." : fmt::format(": the method {} by the end.", adds));
}

/// A simulation that left the motion is no word on the law.
std::string divergence(const std::vector<ComparedCurve>& curves) {
  for (const ComparedCurve& curve : curves)
    if (curve.diverged)
      return fmt::format(
          "{} the motion runs away: that step is too long for the method, and nothing follows about the law. "
          "Take a smaller --step or another --method.",
          simulated_by(curve));
  return "";
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

std::string explanation(const CompareResult& comparison) {
  const auto& curves = comparison.curves;
  if (curves.size() < 2) return "";
  if (std::string gone = divergence(curves); !gone.empty()) return gone;
  if (!curves.front().complete || !curves.back().complete) return "";
  const ComparedCurve& one = curves.front();
  const ComparedCurve& law = curves.back();
  const std::string_view unit = si_unit_of(comparison.recording.series.quantity);
  const std::string left =
      fmt::format("with one rate{} {} (rms) are left",
                  comparison.recording.decay_rate_mean ? ", the mean of the segments'," : "",
                  with_unit(one.law_rms, unit));
  const std::string with_law = fmt::format("with {} {}", to_text(law.law), with_unit(law.law_rms, unit));
  if (!comparison.doubts.empty())
    return fmt::format("{}. No verdict on the damping: {}{}.", capitalised(comparison.doubts.front()), left,
                       law.law == law_of("viscous") ? "" : ", " + with_law);

  const auto& rates = comparison.recording.decay_by_amplitude;
  const double first = rates.empty() ? 0 : rates.front().law_rate,
               last = rates.empty() ? 0 : rates.back().law_rate;
  const bool constant = std::abs(first - last) < 0.02 * std::max(std::abs(first), std::abs(last));
  const std::string method = method_adds(law, unit);
  if (law.law == law_of("viscous"))
    return fmt::format("{}: {}, and {}.{}",
                       comparison.others_tried ? "One decay rate is enough" : "No other law was tried", left,
                       amplitude_at_the_end(one), method);
  if (rates.empty()) return fmt::format("One decay rate is not enough: {}, {}.{}", left, with_law, method);
  if (constant)
    return fmt::format(
        "One decay rate describes the amplitude, but not the motion: {}, {}. The frequency changes as the "
        "swing dies down.{}",
        left, with_law, method);
  return fmt::format(
      "One decay rate is not enough. It {} from {} to {}\u00a01/s as the swing {} from {} to {}; {} and {}, "
      "{}. Quote the law instead.{}",
      last < first ? "falls" : "rises", rounded(first, 3), rounded(last, 3),
      rates.back().amplitude > rates.front().amplitude ? "grows" : "dies down",
      with_unit(rates.front().amplitude, unit), with_unit(rates.back().amplitude, unit), left,
      amplitude_at_the_end(one), with_law, method);
}

}  // namespace cromer::core
