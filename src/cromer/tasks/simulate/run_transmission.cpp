#include "cromer/tasks/simulate/run_transmission.h"

#include <cmath>
#include "cromer/model/linear_quantities.h"

#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace {

std::optional<Transmission> simulated(const RunTransmission& asked, const SimulatedRun& run) {
  if (!run.effect || !run.effect->effective.steady_state) return std::nullopt;
  const EffectiveOscillator& effective = run.effect->effective;
  if (asked.of_motion) return transmitted_motion(asked.sent, *effective.steady_state);
  return transmitted_force(run.oscillator, asked.sent, *effective.steady_state, *effective.steady_velocity);
}

}  // namespace

bool sends_motion(const SimulateOptions& options) { return drive_name(options) == "base"; }

double sent_amplitude(const SimulateOptions& options, const SimulatedRun& run) {
  return sends_motion(options) ? *options.base_displacement : run.drive.amplitude;
}

std::optional<RunTransmission> transmission_of(const SimulateOptions& options, const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  const bool harmonic = !run.general && run.drive.amplitude > 0 && run.drive.frequency > 0;
  if (!harmonic || !is_linear(law_of(law)) || !(law.stiffness > 0)) return std::nullopt;
  RunTransmission found;
  found.of_motion = sends_motion(options);
  found.sent = sent_amplitude(options, run);
  found.frequency_ratio = run.drive.frequency / natural_frequency(law);
  found.exact = transmissibility(law, run.drive.frequency);
  found.simulated = simulated(found, run);
  return found;
}

std::string_view transmission_title(const RunTransmission& transmission) {
  return transmission.of_motion ? "transmissibility: displacement of the mass over that of the base"
                                : "transmissibility: force on the ground over force on the mass";
}

}  // namespace cromer::core
