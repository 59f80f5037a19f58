#include "cromer/documents/json/drive.h"

#include <variant>

#include "cromer/tasks/simulate/drive_setup.h"

namespace cromer::core {
namespace {

void add(Json& parameters, const PulseDrive<double>& pulse) {
  parameters["drive_amplitude"] = pulse.amplitude;
  parameters["drive_start"] = pulse.start;
  if (pulse.shape != PulseShape::step) parameters["drive_duration"] = pulse.duration;
}

void add(Json& parameters, const ChirpDrive<double>& chirp) {
  parameters["drive_amplitude"] = chirp.amplitude;
  parameters["drive_frequency"] = chirp.from;
  parameters["drive_to"] = chirp.to;
  parameters["drive_phase"] = chirp.phase;
  parameters["drive_start"] = chirp.start;
  parameters["drive_duration"] = chirp.duration;
}

void add(Json&, const SampledDrive&) {}

}  // namespace

void add_drive(Json& parameters, const SimulatedRun& run, const SimulateOptions& options) {
  parameters["drive"] = drive_name(options);
  parameters["drive_amplitude"] = run.drive.amplitude;
  parameters["drive_frequency"] = run.drive.frequency;
  parameters["drive_phase"] = run.drive.phase;
  if (run.general) std::visit([&](const auto& drive) { add(parameters, drive); }, *run.general);
  if (options.unbalance_mass) {
    parameters["unbalance_mass"] = *options.unbalance_mass;
    parameters["eccentricity"] = *options.eccentricity;
  }
  if (options.base_displacement) parameters["base_displacement"] = *options.base_displacement;
  if (!options.drive_record) return;
  parameters["drive_file"] = options.base_motion.empty() ? options.drive_file : options.base_motion;
  parameters["between_samples"] = options.between_samples.empty() ? "linear" : options.between_samples;
}

}  // namespace cromer::core
