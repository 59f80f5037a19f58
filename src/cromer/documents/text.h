// Results as texts for people.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// The runs' ends, their events, the steps that --accuracy chose, the steady motion and what gets through,
/// and what each method made of the law.
std::string simulate_text(const SimulateResult& result);

/// A list of quantities for each recording, each with unit and uncertainty.
std::string fit_text(const std::vector<FittedRecording>& fits);

/// One line per recording and run with what the laws have in common; one that failed says why.
std::string fit_table(const std::vector<FittedRecording>& fits);

/// A table for each damping ratio, of at most 24 periods, and where the spectrum is highest.
std::string spectrum_text(const SpectrumResult& result);

/// "east" where the two components are columns of one file, else "component 1".
std::string component_name(const SpectrumResult& result, std::size_t c);

/// What was swept and how, each measure's smallest and largest value with where they are; of a short sweep
/// every row.
std::string sweep_text(const SweepResult& result);

/// "euler-cromer, closed form, steps of 0.01 s".
std::string how(const SweepPlan& plan);

}  // namespace cromer::core
