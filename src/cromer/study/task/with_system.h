// The system that a run integrates, whatever drives it.
#pragma once

#include <utility>

#include "cromer/model/driven_oscillator.h"
#include "cromer/model/general_drive.h"
#include "cromer/study/task/simulate.h"

namespace cromer {

/// Calls f with the run's law and drive as with_terms does.
template <class F>
decltype(auto) with_system(const SimulatedRun& run, F&& f) {
  return run.general ? with_terms(run.oscillator, *run.general, f) : with_terms(run.oscillator, run.drive, f);
}

}  // namespace cromer
