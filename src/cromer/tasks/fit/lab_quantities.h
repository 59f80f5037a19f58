// What a lab asks of a fitted law beside its parameters.
#pragma once

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// What the options say of the body.
Body body_of(const FitOptions& options);

/// Adds the force_parameters of a length, or the notice that a mass gives none.
void add_force_parameters(FittedRecording& result, const Body& body);

/// Fills decay_by_amplitude, keulegan_carpenter (with a disc), stiffness_budget and monte_carlo (with a
/// mass), plan and textbook (where asked for). `record` holds the samples that were fitted. A goal that this
/// fit cannot have is an Error.
Result<void> add_lab_quantities(FittedRecording& result, const Record& record, const Body& body,
                                const Watch& watch);

}  // namespace cromer::core
