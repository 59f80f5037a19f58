#include "cromer/document.h"

#include <span>

#include "cromer/documents/json/documents.h"

namespace cromer {

std::string json(const LawFit& fit) {
  return fit.detail ? core::to_json(std::span<const core::FittedRecording>(fit.detail.get(), 1)) : "";
}

std::string json(const Comparison& comparison) {
  return comparison.detail ? core::to_json(std::span<const core::CompareResult>(comparison.detail.get(), 1))
                           : "";
}

std::string json(const ResponseSpectrum& spectrum) {
  return spectrum.detail ? core::to_json(*spectrum.detail, false) : "";
}

std::string json(const FrequencyResponse& response) {
  return response.detail ? core::to_json(*response.detail) : "";
}

std::string json(const Simulation& simulation, bool with_states) {
  return simulation.detail ? core::to_json(*simulation.detail, with_states) : "";
}

}  // namespace cromer
