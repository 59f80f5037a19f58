// Results as texts for people.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// The last states of the runs, their events, the steps that --accuracy chose, the steady motion and the
/// transmissibility, and what each method makes of the law.
std::string simulate_text(const SimulateResult& result);

/// For each recording a list of its quantities with units and uncertainties.
std::string fit_text(const std::vector<FittedRecording>& fits);

/// One line for each recording and run, with the quantities that most laws have. A fit that failed says why.
std::string fit_table(const std::vector<FittedRecording>& fits);

/// A table for each damping ratio, of at most 24 periods, and where the spectrum is highest.
std::string spectrum_text(const SpectrumResult& result);

/// Component `c` of two, by its column: "east"; "component 1" if both columns have the same name.
std::string component_name(const SpectrumResult& result, std::size_t c);

/// What was swept and how, then every row of a short sweep; of a longer one each measure's smallest and
/// largest value, and where they are.
std::string sweep_text(const SweepResult& result);

/// How the points are found: "euler-cromer, closed form, steps of 0.01 s".
std::string how(const SweepPlan& plan);

}  // namespace cromer::core
