#include "cromer/simulate.h"

#include <memory>
#include <utility>

#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/tasks/simulate/run_energy.h"

namespace cromer {
namespace {

/// Sets what a drive is in the options of the task; an Error of what those cannot say.
struct SetDrive {
  core::SimulateOptions& o;

  Result<void> operator()(std::monostate) const { return {}; }
  Result<void> operator()(const Harmonic& drive) const {
    o.drive_amplitude = drive.amplitude;
    return goes_on("", drive);
  }
  Result<void> operator()(const Unbalance& drive) const {
    o.unbalance_mass = drive.mass;
    o.eccentricity = drive.eccentricity;
    return goes_on("unbalance", drive);
  }
  Result<void> operator()(const ShakingBase& drive) const {
    o.base_displacement = drive.displacement;
    return goes_on("base", drive);
  }
  Result<void> operator()(const Pulse& drive) const {
    constexpr const char* shapes[] = {"step", "rectangular", "half-sine", "triangular"};
    if (auto good = core::check_enumerator(drive.shape, std::size(shapes), "shape"); !good) return good;
    o.drive = shapes[static_cast<int>(drive.shape)];
    o.drive_amplitude = drive.amplitude;
    o.drive_start = drive.start;
    if (drive.shape != Pulse::Shape::step) o.drive_duration = drive.duration;
    return {};
  }
  Result<void> operator()(const Chirp& drive) const {
    o.drive = drive.logarithmic ? "logarithmic-chirp" : "chirp";
    o.drive_amplitude = drive.amplitude;
    o.drive_frequency = {drive.from};
    o.drive_to = drive.to;
    o.drive_start = drive.start;
    o.drive_duration = drive.duration;
    o.drive_phase = drive.phase;
    return {};
  }
  Result<void> operator()(const SampledForce& drive) const {
    return recorded(core::RecordOf::force, drive.force, drive);
  }
  Result<void> operator()(const GroundMotion& drive) const {
    return recorded(core::RecordOf::ground, drive.acceleration, drive);
  }

 private:
  Result<void> goes_on(const char* kind, const auto& drive) const {
    o.drive = kind;
    o.drive_frequency = {drive.frequency};
    o.drive_phase = drive.phase;
    return {};
  }
  Result<void> recorded(core::RecordOf what, std::span<const double> values, const auto& drive) const {
    if (auto good = core::check_enumerator(drive.between, 3, "between"); !good) return good;
    o.between_samples = name(drive.between);
    return core::set_record(o, what, values, drive.spacing);
  }
};

Result<core::SimulateOptions> task_options(const Oscillator& oscillator, const SimulateOptions& options) {
  core::SimulateOptions o;
  o.mass = oscillator.mass;
  o.stiffness = oscillator.stiffness;
  o.damping = oscillator.damping;
  if (oscillator.static_friction != 0) o.static_friction = oscillator.static_friction;
  o.law = oscillator;
  if (auto good = std::visit(SetDrive{o}, options.drive); !good) return good.error();
  o.position = options.position;
  o.velocity = options.velocity;
  core::set_integration(o, options);
  o.accuracy = options.accuracy;
  o.compensated = options.compensated;
  return o;
}

Simulation simulation_of(std::shared_ptr<const core::SimulateResult> result) {
  const core::SimulatedRun& run = result->runs.front();
  Simulation simulation;
  static_cast<Trajectory&>(simulation) = run.trajectory;
  simulation.energy = core::energies(run);
  simulation.status = run.outcome.status;
  simulation.interrupted = run.outcome.interrupted;
  simulation.message = core::message_of(run.message);
  simulation.counts = run.outcome.counts;
  simulation.step = run.step;
  if (run.effect) simulation.effect = core::effect_of(*run.effect);
  simulation.notices = result->notices;
  simulation.detail = std::move(result);
  return simulation;
}

}  // namespace

Result<Simulation> simulate(const Oscillator& oscillator, const SimulateOptions& options) {
  const auto asked = task_options(oscillator, options);
  if (!asked) return asked.error();
  const bool of_arrays = asked->drive_record.has_value();
  const core::Watching watching(options.progress);
  auto result = core::simulate(*asked, watching.watch());
  if (!result) return core::in_arguments(result.error(), of_arrays);
  core::put_in_arguments(*result, of_arrays);
  return simulation_of(std::make_shared<const core::SimulateResult>(*std::move(result)));
}

}  // namespace cromer
