#include "cromer/document.h"

#include <span>

#include "cromer/documents/json.h"

namespace cromer {
namespace {

core::Voice voice_of(Language language) { return {language, core::Audience::caller}; }

}  // namespace

std::string json(const LawFit& fit, Language language) {
  if (!fit.detail) return "";
  return core::to_json(std::span<const core::FittedRecording>(fit.detail.get(), 1), false,
                       voice_of(language));
}

std::string json(const Comparison& comparison, Language language) {
  if (!comparison.detail) return "";
  return core::to_json(std::span<const core::CompareResult>(comparison.detail.get(), 1), voice_of(language));
}

std::string json(const ResponseSpectrum& spectrum, Language language) {
  return spectrum.detail ? core::to_json(*spectrum.detail, false, voice_of(language)) : "";
}

std::string json(const FrequencyResponse& response, Language language) {
  return response.detail ? core::to_json(*response.detail, true, voice_of(language)) : "";
}

std::string json(const Simulation& simulation, bool with_states, Language language) {
  return simulation.detail ? core::to_json(*simulation.detail, with_states, voice_of(language)) : "";
}

}  // namespace cromer
