#include <algorithm>

#include "cromer/analysis/energy.h"
#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/drive.h"
#include "cromer/documents/json/effect.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"

namespace cromer::core {
namespace {

/// "static-friction" as "static_friction".
std::string key_of(std::string_view option) {
  std::string key(option);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

Json parameters(const SimulatedRun& run, const SimulateOptions& options) {
  const auto& law = run.oscillator;
  Json all = {{"mass", law.mass}};
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i)
      all[key_of(T::coefficients[i].option)] = law.*T::template members<double>[i];
  });
  all["hysteresis_exponent"] = law.hysteresis_exponent;
  all["static_friction"] = std::max(law.friction, law.static_friction);
  add_drive(all, run, options);
  all["position"] = run.start.x;
  all["velocity"] = run.start.v;
  return all;
}

Json sensor(const SensorOptions& options) {
  if (!options.used) return nullptr;
  return {{"noise", options.noise},
          {"resolution", options.resolution},
          {"offset", options.offset},
          {"seed", options.seed}};
}

Json accuracy(const Accuracy& found) {
  return {{"asked", found.asked},
          {"step", found.step},
          {"frequency_error", json_or_null(found.frequency_error)},
          {"decay_error", json_or_null(found.decay_error)},
          {"amplitude_error", found.amplitude_error}};
}

Json energy_balance(const EnergyBalance& balance) {
  Json all = {{"start", balance.start}, {"end", balance.end}, {"drive", balance.drive}};
  for_each_resistance(
      [&]<class T>() { all[key_of(T::coefficients[0].option)] = balance.template taken_by<T>(); });
  all["method"] = balance.method();
  return all;
}

Json modified_energy(const ModifiedEnergy& found) {
  return {{"start", found.start},
          {"end", found.end},
          {"drift", found.drift},
          {"states", found.states},
          {"energy_swing", found.energy_swing}};
}

Json measured(const MeasuredOscillator& found) {
  return {{"angular_frequency", found.angular_frequency},
          {"decay_rate", found.decay_rate},
          {"first_amplitude", found.first_amplitude},
          {"last_amplitude", found.last_amplitude},
          {"half_cycles", found.half_cycles}};
}

Json events(const SimulatedRun& run, const SimulateOptions& options) {
  Json all = Json::array();
  for (const FoundEvent& found : run.events.found)
    all.push_back(
        {{"event", options.event[found.event]}, {"t", found.t}, {"x", found.y.x}, {"v", found.y.v}});
  return all;
}

Json states(const SimulatedRun& run) {
  Json columns = {{"t", run.trajectory.t}, {"x", run.trajectory.x}, {"v", run.trajectory.v}};
  columns["energy"] = energies(run);
  if (!run.sensor.empty()) columns["sensor"] = run.sensor;
  return columns;
}

/// What was set of the method, and what it really simulates.
void add_method(Json& object, const SimulatedRun& run, const Voice& voice) {
  if (run.method == "newmark") {
    object["beta"] = run.settings.beta;
    object["gamma"] = run.settings.gamma;
  }
  if (run.method == "generalized-alpha") object["rho_inf"] = run.settings.rho_inf;
  if (const Notice words = run_notice(run); !words.empty()) object["in_words"] = said(words, voice);
  add_effect(object, run.effect);
}

Json transmissibility(const RunTransmission& found) {
  Json object{{"of", found.of_motion ? "displacement" : "force"},
              {"frequency_ratio", found.frequency_ratio},
              {"ratio", found.exact.amplitude},
              {"phase_lag", found.bounded() ? Json(found.exact.phase_lag) : Json(nullptr)},
              {"sent", found.sent},
              {"transmitted", found.sent * found.exact.amplitude},
              {"simulated", nullptr}};
  if (found.simulated)
    object["simulated"] = {{"ratio", found.simulated->amplitude},
                           {"phase_lag", found.simulated->phase_lag},
                           {"error", json_or_null(found.error())}};
  return object;
}

Json document(const SimulatedRun& run, const SimulateOptions& options, const Voice& voice) {
  const Outcome& outcome = run.outcome;
  Json object;
  object["method"] = run.method;
  object["label"] = run.label;
  object["parameters"] = parameters(run, options);
  object["step"] = run.step;
  object["until"] = run.until;
  object["tolerance"] = run.tolerance;
  object["every"] = options.every;
  object["compensated"] = run.compensated;
  object["status"] = name(outcome.status);
  if (!run.message.empty()) object["message"] = said(run.message, voice);
  object["interrupted"] = outcome.interrupted;
  object["last_step"] = outcome.last_step == 0 ? run.step : outcome.last_step;
  object["counts"] = {{"accepted", outcome.counts.accepted},
                      {"rejected", outcome.counts.rejected},
                      {"evaluations", outcome.counts.evaluations},
                      {"newton_iterations", outcome.counts.newton_iterations}};
  object["final"] = {{"t", outcome.t},
                     {"x", outcome.y.x},
                     {"v", outcome.y.v},
                     {"energy", energy(run.oscillator, outcome.y)}};
  object["events"] = events(run, options);
  if (run.accuracy) object["accuracy"] = accuracy(*run.accuracy);
  object["energy_balance"] = run.energy_balance ? energy_balance(*run.energy_balance) : Json(nullptr);
  if (run.modified_energy) object["modified_energy"] = modified_energy(*run.modified_energy);
  if (run.measured) object["measured"] = measured(*run.measured);
  add_method(object, run, voice);
  if (run.transmission) object["transmissibility"] = transmissibility(*run.transmission);
  object["sensor"] = sensor(options.sensor);
  return object;
}

}  // namespace

std::string to_json(const SimulateResult& result, bool with_states, const Voice& voice) {
  Json document_of_all;
  Json& runs = document_of_all["runs"] = Json::array();
  std::string message;
  for (const auto& run : result.runs) {
    runs.push_back(document(run, result.options, voice));
    if (with_states) runs.back()["states"] = states(run);
    if (!run.message.empty())
      message += (message.empty() ? "" : "; ") + run.label + ": " + in_words(run.message, voice);
  }
  add_notices(document_of_all, result.notices, voice);
  if (!message.empty()) document_of_all["message"] = message;
  return to_text(document_of_all, with_states);
}

}  // namespace cromer::core
