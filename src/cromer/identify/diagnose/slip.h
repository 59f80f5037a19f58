// Times that slip: samples that a recorder lost, or told twice, while its times went on evenly.
#pragma once

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// Where a viscous law whose times slip once, by half a step between samples or more, leaves no more than the
/// fit with its bent spring, or clearly less than the fit without one: a notice that tells when and by how
/// much. A shift of the phase at one time looks like a frequency that changes as the swing dies down. Else
/// empty.
Notice slipped_times(const Record& record, const LawFit& fit, const Watch& watch = {});

}  // namespace cromer::core
