// The viscous law by its closed form.
#pragma once

#include "cromer/base/interrupt.h"
#include "cromer/identify/free_decay.h"

namespace cromer {

/// One decaying sinusoid over the whole record, or a refusal.
FreeDecay fit_sinusoid(const Record& record, const FreeDecayOptions& options, const Watch& watch);

/// The same; where the first periods alone are a clear oscillation, a record that is out of step with every
/// sinusoid is none to refuse, and a warning says so.
FreeDecay fit_viscous(const Record& record, const FreeDecayOptions& options, const Watch& watch);

}  // namespace cromer
