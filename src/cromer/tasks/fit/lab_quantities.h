// What a lab asks of a fitted law beside its parameters, and the options that simulate the law.
#pragma once

#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// The body that the options describe.
Body body_of(const FitOptions& options);

/// A law that leaves up to a third more, and gives another spring constant.
struct OtherStiffness {
  Law law;
  double stiffness = 0;  // [N/m]
  double rms = 0;        ///< what it leaves, in the SI unit of the column
};

/// The law whose spring constant is farthest from the fit's, by more than half its 95 % interval's width;
/// none where laws agree, or nothing is known of the mass.
std::optional<OtherStiffness> other_stiffness(const FittedRecording& fitted);

/// What a reader looks for first, as far as the fit knows it: frequency, stiffness, decay_rate_ends() and
/// reynolds_max.
std::vector<Parameter> headline_of(const FittedRecording& fitted);

/// [rad/s] As among the result's parameters, with its doubts; of a result without any as its law has it.
Estimate angular_frequency_of(const FittedRecording& fitted);

/// Adds force_parameters() to the fit of a length; to any other, if a mass was given, the notice that it
/// gives no stiffness.
void add_force_parameters(FittedRecording& result, const Body& body);

/// Fills stiffness_budget and, if asked for, monte_carlo of a result with a stiffness.
void add_stiffness_budget(FittedRecording& result, const Body& body, const Watch& watch);

/// Fills headline, decay_by_amplitude, keulegan_carpenter (with a disc), stiffness_budget and monte_carlo
/// (with a mass), plan and textbook (if asked for). `record` holds the samples that were fitted. A goal for
/// what this fit does not have is an Error.
Result<void> add_lab_quantities(FittedRecording& result, const Record& record, const Body& body,
                                const Watch& watch);

/// The options of simulate for a fitted law with this mass [kg], by rk4, from the first sample of the series
/// to the last, with the digits that the law is known to and three more. A sample spacing is a whole number
/// of steps. Empty under a recorded force, whose samples are in a file, and without a spring.
std::vector<TypedOption> simulate_settings(const LawFit& fit, const Series& series, double mass);

/// The options of simulate that lay the fitted samples under those runs: file, column, run, how it is read,
/// the time of the first used sample and the equilibrium. Empty where there is no file, or the column
/// holds neither positions nor angles.
std::vector<TypedOption> over_settings(const FittedRecording& fitted);

/// Both.
inline std::vector<TypedOption> simulate_and_lay_over(const FittedRecording& fitted) {
  std::vector<TypedOption> settings = fitted.simulate, over = over_settings(fitted);
  settings.insert(settings.end(), over.begin(), over.end());
  return settings;
}

}  // namespace cromer::core
