// The page's choice of laws: smooth ones and dry friction under a harmonic drive. It takes the place of
// study/task/run_law/run_law.cpp, which has every drive compiled.
#include <cassert>

#include "cromer/model/terms.h"
#include "cromer/study/task/run_law/units.h"

namespace cromer {

Outcome run_law(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  assert(!run.compensated && !run.general);
  const Terms present = terms_of(run.oscillator, run.drive);
  return present.friction ? run_friction(run, keep, watch) : run_harmonic(run, keep, watch);
}

}  // namespace cromer
