#include "cromer/document.h"

#include <memory>
#include <span>

#include "cromer/documents/csv.h"
#include "cromer/documents/json.h"
#include "cromer/door/found.h"

namespace cromer {
namespace {

core::Voice voice_of(Language language) { return {language, core::Audience::caller}; }

/// For what writes several results.
template <class Detail>
std::span<const Detail> alone(const std::shared_ptr<const Detail>& detail) {
  return {detail.get(), 1};
}

}  // namespace

std::string json(const LawFit& fit, Language language) {
  if (!fit.detail) return "";
  return core::to_json(alone(fit.detail), false, voice_of(language));
}

std::string json(const Comparison& comparison, Language language) {
  if (!comparison.detail) return "";
  return core::to_json(alone(comparison.detail), voice_of(language));
}

std::string json(const ResponseSpectrum& spectrum, Language language) {
  return spectrum.detail ? core::to_json(*spectrum.detail, false, voice_of(language)) : "";
}

std::string json(const FrequencyResponse& response, Language language) {
  return response.detail ? core::to_json(*response.detail, true, voice_of(language)) : "";
}

std::string json(const Modes& modes, Language language) {
  return modes.detail ? core::to_json(*modes.detail, voice_of(language)) : "";
}

std::string json(const Simulation& simulation, bool with_states, Language language) {
  return simulation.detail ? core::to_json(*simulation.detail, with_states, voice_of(language)) : "";
}

std::string json(const NetworkSimulation& simulation, bool with_states, Language language) {
  return simulation.detail ? core::to_json(alone(simulation.detail), with_states, voice_of(language)) : "";
}

std::string json(const NetworkFit& fit, Language language) {
  return fit.detail ? core::to_json(*fit.detail, voice_of(language)) : "";
}

std::string csv(const LawFit& fit) { return fit.detail ? core::fit_csv(alone(fit.detail)) : ""; }

std::string csv(const Comparison& comparison) {
  return comparison.detail ? core::compare_csv(alone(comparison.detail)) : "";
}

std::string csv(const ResponseSpectrum& spectrum) {
  return spectrum.detail ? core::spectrum_csv(*spectrum.detail, core::no_command) : "";
}

std::string csv(const FrequencyResponse& response) {
  return response.detail ? core::sweep_csv(*response.detail, core::no_command) : "";
}

std::string csv(const Modes& modes) { return modes.detail ? core::modes_csv(*modes.detail) : ""; }

std::string csv(const Simulation& simulation) {
  return simulation.detail ? core::simulate_csv(*simulation.detail, core::no_command) : "";
}

std::string csv(const NetworkSimulation& simulation) {
  return simulation.detail ? core::network_csv(alone(simulation.detail), core::no_command) : "";
}

std::string csv(const NetworkFit& fit) { return fit.detail ? core::network_fit_csv(*fit.detail) : ""; }

std::string svg(const LawFit& fit) {
  return fit.detail ? core::drawn(core::fit_figure(alone(fit.detail))) : "";
}

std::string svg(const Comparison& comparison) {
  return comparison.detail ? core::drawn(core::compare_figure(alone(comparison.detail))) : "";
}

std::string svg(const ResponseSpectrum& spectrum) {
  return spectrum.detail && !spectrum.interrupted ? core::drawn(core::spectrum_figure(*spectrum.detail)) : "";
}

std::string svg(const FrequencyResponse& response) {
  if (!response.detail) return "";
  const auto figure = core::sweep_figure(*response.detail);
  return figure ? core::drawn(*figure) : "";
}

std::string svg(const Simulation& simulation) {
  return simulation.detail ? core::drawn(core::simulate_figure(*simulation.detail)) : "";
}

std::string svg(const Modes& modes) {
  return modes.detail ? core::drawn(core::modes_figure(*modes.detail)) : "";
}

std::string svg(const NetworkSimulation& simulation) {
  return simulation.detail ? core::drawn(core::network_figure(alone(simulation.detail))) : "";
}

std::string svg(const NetworkFit& fit) {
  return fit.detail ? core::drawn(core::network_fit_figure(*fit.detail)) : "";
}

}  // namespace cromer
