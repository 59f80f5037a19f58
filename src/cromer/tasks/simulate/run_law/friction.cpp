#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_friction(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  return with_dry_friction(run.oscillator, run.drive, by_method(run, keep, watch));
}

}  // namespace cromer::core
