#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/column_kind.h"

namespace cromer::core {
namespace {

std::string with_unit(std::string name, const CompareResult& comparison) {
  const std::string unit = unit_of(comparison.recording.series);
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

/// Nothing of what was not reached; a fixed number of decimals where that is short.
std::string with_decimals(double value, int decimals) {
  if (!std::isfinite(value)) return "";
  const double size = std::abs(value);
  return size < 1e4 && (size >= 0.01 || size == 0) ? fmt::format("{:.{}f}", value, decimals)
                                                   : fmt::format("{:.{}g}", value, decimals);
}

/// What is known about the apparatus, and what else was asked, says nothing of the curves: it is answered by
/// the fit.
bool asks_for_the_fit(const FitOptions& options) {
  return !options.mass.empty() || options.disc_diameter || !options.goal.empty() || options.textbook;
}

}  // namespace

std::string compare_text(const std::vector<CompareResult>& comparisons) {
  std::string out;
  for (const auto& comparison : comparisons) {
    const FittedRecording& recording = comparison.recording;
    if (asks_for_the_fit(recording.options)) out += fit_text({recording}) + "\n";
    out += recording_title(recording);
    if (!recording.succeeded()) out += ": " + in_words(recording.fit.message);
    out += '\n';
    std::vector<std::vector<std::string>> rows{{with_unit("rms", comparison), "R squared",
                                                "amplitude ratio at the end", "phase drift (rad)", "method",
                                                "simulated"}};
    for (const auto& curve : comparison.curves)
      rows.push_back(
          {std::isfinite(curve.rms) ? fmt::format("{:.4g}", curve.rms) : "",
           with_decimals(curve.r_squared, 6), with_decimals(curve.amplitude_ratio_end, 4),
           with_decimals(curve.phase_drift, 4), curve.method,
           in_words(curve.label) + (curve.measured_at_rest ? ", at the end the measured motion rests" : "")});
    if (!comparison.curves.empty()) out += text_table(rows, 0, 4);
    if (const Notice sentence = explanation(comparison); !sentence.empty()) out += in_words(sentence) + "\n";
  }
  return out;
}

}  // namespace cromer::core
