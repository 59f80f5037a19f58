#include "cromer/tasks/simulate/run_law.h"

#include <variant>

#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_law(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  if (run.compensated) return run_compensated(run, keep, watch);
  if (law_of(run.oscillator).has<Hysteresis>()) return run_hysteresis(run, keep, watch);
  if (run.general)
    return std::visit([&](const auto& drive) { return run_driven(run, drive, keep, watch); }, *run.general);
  const Terms present = terms_of(run.oscillator, run.drive);
  if (present.law.has<Friction>()) return run_friction(run, keep, watch);
  return present.drive ? run_harmonic(run, keep, watch) : run_free(run, keep, watch);
}

}  // namespace cromer::core
