#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_harmonic(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  return with_smooth_terms<true>(run.oscillator, force_of(run.drive, run.oscillator.mass),
                                 by_method(run, keep, watch));
}

}  // namespace cromer::core
