#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_free(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  return with_smooth_terms<false>(run.oscillator, HarmonicForce<double>{}, by_method(run, keep, watch));
}

}  // namespace cromer::core
