#include "cromer/tasks/simulate/run_invariants.h"

#include <algorithm>

#include "cromer/analysis/energy.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace {

/// The modified energy is positive, and the motion bounded, for w h < 2.
bool conserves_modified_energy(const SimulatedRun& run) {
  const Oscillator<double>& o = run.oscillator;
  return run.method == EulerCromer::info.name && !run.general && terms_of(o, run.drive) == Terms{} &&
         o.stiffness > 0 && o.stiffness * run.step * run.step < 4 * o.mass;
}

/// The kept states but the last where that was reached by part of a step.
std::size_t states_of_whole_steps(const SimulatedRun& run) {
  const bool partly = run.outcome.last_step > 0 ||
                      (run.outcome.status == Status::stopped_by_event && !run.outcome.interrupted);
  const std::size_t size = run.trajectory.size();
  return size - (partly && size > 0 && run.trajectory.t.back() == run.outcome.t);
}

}  // namespace

std::optional<ModifiedEnergy> modified_energy_of(const SimulatedRun& run) {
  if (!conserves_modified_energy(run)) return std::nullopt;
  const std::size_t size = states_of_whole_steps(run);
  if (size < 2) return std::nullopt;
  const auto state = [&](std::size_t i) { return State<double>{run.trajectory.x[i], run.trajectory.v[i]}; };
  const auto modified = [&](std::size_t i) { return modified_energy(run.oscillator, run.step, state(i)); };
  ModifiedEnergy found{
      .start = modified(0), .end = modified(size - 1), .states = static_cast<long long>(size)};
  if (!(found.start > 0)) return std::nullopt;
  Drift drift;
  double least = energy(run.oscillator, state(0)), most = least;
  for (std::size_t i = 0; i < size; ++i) {
    drift(modified(i));
    least = std::min(least, energy(run.oscillator, state(i)));
    most = std::max(most, energy(run.oscillator, state(i)));
  }
  found.drift = drift.largest();
  found.energy_swing = (most - least) / (most + least);
  return found;
}

Notice modified_energy_notice(const SimulatedRun& run) {
  if (!run.modified_energy) return {};
  const ModifiedEnergy& found = *run.modified_energy;
  return Notice{"conserves_modified_energy",
                {{"run", run.label},
                 {"energy", found.start},
                 {"drift", found.drift},
                 {"states", found.states},
                 {"sums", run.compensated ? Notice{"of_compensated_sums"} : Notice{}},
                 {"swing", 100 * found.energy_swing}}};
}

}  // namespace cromer::core
