// What a lab asks of a fitted law beside its parameters, and the command that simulates the law.
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

/// The command that simulates a fitted law: with a mass [kg], by rk4, from the series' first sample to its
/// last, in steps that a sample is a whole number of. Empty where there is none: of a recorded force, whose
/// samples are in a file.
std::string simulate_line(const LawFit& fit, const Series& series, double mass);

}  // namespace cromer::core
