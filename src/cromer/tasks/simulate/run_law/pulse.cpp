#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_driven(const LawRun& run, const PulseDrive<double>& drive, KeepEvery& keep, const Watch& watch) {
  return with_terms_under(run.oscillator, drive, by_method(run, keep, watch));
}

}  // namespace cromer::core
