// The viscous law by its closed form.
#pragma once

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"

namespace cromer {

/// One decaying sinusoid over the whole record, or a refusal.
LawFit fit_sinusoid(const Record& record, const LawFitOptions& options, const Watch& watch);

/// The same; where the first periods alone are a clear oscillation, a record that is out of step with every
/// sinusoid is none to refuse, and a warning says so.
LawFit fit_viscous(const Record& record, const LawFitOptions& options, const Watch& watch);

}  // namespace cromer
