#include "cromer/simulate.h"

#include <utility>

#include "cromer/analysis/energy.h"
#include "cromer/door/options.h"
#include "cromer/door/results.h"
#include "cromer/door/watching.h"
#include "cromer/door/words.h"
#include "cromer/study/task/simulate.h"

namespace cromer {
namespace {

core::DriveRecord record_of(std::span<const double> values, double spacing) {
  core::DriveRecord record;
  record.values.assign(values.begin(), values.end());
  record.spacing = spacing;
  return record;
}

/// Sets what a drive is in the options of the task.
struct SetDrive {
  core::SimulateOptions& o;

  void operator()(std::monostate) const {}
  void operator()(const Harmonic& drive) const {
    o.drive_amplitude = drive.amplitude;
    o.drive_frequency = {drive.frequency};
    o.drive_phase = drive.phase;
  }
  void operator()(const Unbalance& drive) const {
    o.drive = "unbalance";
    o.unbalance_mass = drive.mass;
    o.eccentricity = drive.eccentricity;
    o.drive_frequency = {drive.frequency};
    o.drive_phase = drive.phase;
  }
  void operator()(const ShakingBase& drive) const {
    o.drive = "base";
    o.base_displacement = drive.displacement;
    o.drive_frequency = {drive.frequency};
    o.drive_phase = drive.phase;
  }
  void operator()(const Pulse& drive) const {
    constexpr const char* shapes[] = {"step", "rectangular", "half-sine", "triangular"};
    o.drive = shapes[static_cast<int>(drive.shape)];
    o.drive_amplitude = drive.amplitude;
    o.drive_start = drive.start;
    if (drive.shape != Pulse::Shape::step) o.drive_duration = drive.duration;
  }
  void operator()(const Chirp& drive) const {
    o.drive = drive.logarithmic ? "logarithmic-chirp" : "chirp";
    o.drive_amplitude = drive.amplitude;
    o.drive_frequency = {drive.from};
    o.drive_to = drive.to;
    o.drive_start = drive.start;
    o.drive_duration = drive.duration;
    o.drive_phase = drive.phase;
  }
  void operator()(const SampledForce& drive) const {
    o.drive_file = "force";
    o.drive_record = record_of(drive.force, drive.spacing);
    o.between_samples = name(drive.between);
  }
  void operator()(const GroundMotion& drive) const {
    o.base_motion = "acceleration";
    o.drive_record = record_of(drive.acceleration, drive.spacing);
    o.between_samples = name(drive.between);
  }
};

/// What the options of a task cannot say: enumerators that are none, arrays that are no records.
Result<void> check_drive(const Drive& drive, const core::SimulateOptions& o) {
  if (const auto* record = std::get_if<SampledForce>(&drive))
    if (auto good = core::check_enumerator(record->between, 3, "between"); !good) return good;
  if (const auto* record = std::get_if<GroundMotion>(&drive))
    if (auto good = core::check_enumerator(record->between, 3, "between"); !good) return good;
  if (!o.drive_record) return {};
  const std::string argument = o.drive_file.empty() ? o.base_motion : o.drive_file;
  if (auto good = core::check_spacing(o.drive_record->spacing); !good) return good;
  return core::check_samples(o.drive_record->values, argument, 2);
}

}  // namespace

core::SimulateOptions core::simulate_options(const Oscillator<double>& oscillator,
                                             const cromer::SimulateOptions& options) {
  core::SimulateOptions o;
  o.mass = oscillator.mass;
  o.stiffness = oscillator.stiffness;
  o.damping = oscillator.damping;
  if (oscillator.static_friction != 0) o.static_friction = oscillator.static_friction;
  o.law = oscillator;
  std::visit(SetDrive{o}, options.drive);
  o.position = options.position;
  o.velocity = options.velocity;
  o.method = {options.method.name()};
  o.step = options.step;
  o.until = options.until;
  o.tolerance = options.tolerance;
  o.accuracy = options.accuracy;
  o.beta = options.beta;
  o.gamma = options.gamma;
  o.rho_inf = options.rho_inf;
  o.every = options.every;
  o.compensated = options.compensated;
  o.memory = core::memory_for_results / 3;  // energies and copies beside the states
  return o;
}

Simulation core::simulation_of(std::shared_ptr<const SimulateResult> result, std::size_t which) {
  const SimulatedRun& run = result->runs[which];
  Simulation simulation;
  static_cast<Trajectory&>(simulation) = run.trajectory;
  for (std::size_t i = 0; i < run.trajectory.size(); ++i)
    simulation.energy.push_back(
        core::energy(run.oscillator, State<double>{run.trajectory.x[i], run.trajectory.v[i]}));
  simulation.status = run.outcome.status;
  simulation.interrupted = run.outcome.interrupted;
  simulation.message = in_arguments(run.message);
  simulation.counts = run.outcome.counts;
  simulation.step = run.step;
  if (run.effect) simulation.effect = effect_of(*run.effect);
  simulation.warnings = in_arguments(result->warnings);
  simulation.detail = std::move(result);
  return simulation;
}

Result<Simulation> simulate(const Oscillator& oscillator, const SimulateOptions& options) {
  if (const auto* pulse = std::get_if<Pulse>(&options.drive))
    if (auto good = core::check_enumerator(pulse->shape, 4, "shape"); !good) return good.error();
  const core::SimulateOptions asked = core::simulate_options(oscillator, options);
  if (auto good = check_drive(options.drive, asked); !good) return good.error();
  const core::Watching watching(options.progress);
  auto result = core::simulate(asked, watching.watch());
  if (!result) return core::in_arguments(result.error(), asked.drive_record.has_value());
  return core::simulation_of(std::make_shared<const core::SimulateResult>(*std::move(result)), 0);
}

}  // namespace cromer
