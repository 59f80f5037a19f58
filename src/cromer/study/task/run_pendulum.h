// The free motion of a pendulum by any method.
#pragma once

#include "cromer/study/task/run_law.h"

namespace cromer {

/// As run_law, with the restoring force stiffness sin x in place of stiffness x, x an angle [rad]; drives are
/// not looked at. By any method but `exact`.
Outcome run_pendulum(const LawRun& run, KeepEvery& keep, const Watch& watch = {});

}  // namespace cromer
