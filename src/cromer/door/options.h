// The door's options as those of the tasks, and checks of arrays.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "cromer/fit.h"
#include "cromer/result.h"
#include "cromer/simulate.h"
#include "cromer/study/task/fit.h"
#include "cromer/study/task/simulate.h"

namespace cromer::core {

inline constexpr double memory_for_results = 16e9;  // [bytes] beyond which a result is refused

/// That there are so many samples at least and all are finite; the Error names the argument.
Result<void> check_samples(std::span<const double> values, const std::string& argument, std::size_t least);

/// That an enumerator is one of the first `count`: other languages pass numbers.
template <class Enum>
Result<void> check_enumerator(Enum value, int count, const char* argument) {
  if (static_cast<int>(value) >= 0 && static_cast<int>(value) < count) return {};
  return Error{std::string(argument) + ": there is no enumerator " + std::to_string(static_cast<int>(value)),
               argument};
}

/// That samples lie so far apart [s].
Result<void> check_spacing(double spacing);

SimulateOptions simulate_options(const Oscillator<double>& oscillator,
                                 const cromer::SimulateOptions& options);

Simulation simulation_of(std::shared_ptr<const SimulateResult> result, std::size_t which);

FitOptions fit_options(const cromer::FitOptions& options, const Selection& selection);

/// Arrays as a recording of columns t, y and, where there is one, force. The Error names the argument.
Result<Recording> recording_of(std::span<const double> t, std::span<const double> y,
                               std::span<const double> force, Observed observed);

}  // namespace cromer::core
