#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/documents/json/recording.h"

namespace cromer::core {

Json comparison_object(const CompareResult& comparison, const Voice& voice) {
  const LawFit& fit = comparison.recording.fit;
  Json object;
  object["recording"] = recording_object(comparison.recording);
  object["status"] = name(fit.status);
  if (fit.status != FitStatus::converged)
    object["message"] = said(fit.message, voice);
  else if (!comparison.complete)
    object["message"] = said(comparison.notices.back(), voice);
  Json& curves = object["curves"] = Json::array();
  for (const auto& curve : comparison.curves)
    curves.push_back({{"label", curve.label},
                      {"law", to_text(curve.law)},
                      {"method", curve.method},
                      {"rms", curve.rms},
                      {"r_squared", curve.r_squared},
                      {"amplitude_ratio_end", curve.amplitude_ratio_end},
                      {"phase_drift", curve.phase_drift},
                      {"step", curve.step},
                      {"law_rms", curve.law_rms},
                      {"method_amplitude_ratio", curve.method_amplitude_ratio},
                      {"method_phase", curve.method_phase},
                      {"diverged", curve.diverged}});
  if (!comparison.curves.empty()) object["measured_at_rest"] = comparison.curves.front().measured_at_rest;
  if (const Notice sentence = explanation(comparison); !sentence.empty())
    object["explanation"] = said(sentence, voice);
  object["fit"] = fit_object(comparison.recording, voice);
  add_notices(object, comparison.notices, voice);
  return object;
}

std::string to_json(std::span<const CompareResult> comparisons, const Voice& voice) {
  if (comparisons.size() == 1) return to_text(comparison_object(comparisons.front(), voice));
  Json all;
  Json& list = all["comparisons"] = Json::array();
  std::size_t failed = 0;
  for (const auto& comparison : comparisons) {
    list.push_back(comparison_object(comparison, voice));
    failed += comparison.recording.fit.status != FitStatus::converged;
  }
  if (failed > 0)
    all["message"] =
        std::to_string(failed) + " of " + std::to_string(comparisons.size()) + " fits did not succeed";
  return to_text(all);
}

}  // namespace cromer::core
