// The results of the tasks as the JSON documents that contract.md promises. Not-finite numbers are null.
// Their sentences are in the words of `voice`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/inspect/inspect.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// {"runs": [...], "warnings": [...]}, with "message" when a run ended early. `with_states` adds the kept
/// states of each run.
std::string to_json(const SimulateResult& result, bool with_states, const Voice& voice = {});

/// {"methods": [...]}
std::string to_json(std::span<const MethodRow> methods, const Voice& voice = {});

/// The sweep's swept options and columns, on one line; `with_rows` adds the rows.
std::string to_json(const SweepResult& result, bool with_rows = true, const Voice& voice = {});

/// What is in the file; `with_values` adds the columns' numbers.
std::string to_json(const Inspection& inspection, bool with_values, const Voice& voice = {});

/// The fit's object; {"fits": [...]} unless there is exactly one and no list is wanted.
std::string to_json(std::span<const FittedRecording> fits, bool as_list = false, const Voice& voice = {});

/// The spring constant by held extensions: parameters{stiffness}, line, holds.
std::string to_json(const StaticStiffness& found);

/// {"fits": [...], "mass_line": {...}}
std::string to_json(std::span<const FittedRecording> fits, const MassLine& line);

/// The comparison's object; {"comparisons": [...]} unless there is exactly one.
std::string to_json(std::span<const CompareResult> comparisons, const Voice& voice = {});

/// {"components": [...], "spectra": [...], "arias_intensity", "duration_5_95", ...}; `with_fourier` adds the
/// Fourier amplitudes, all on one line.
std::string to_json(const SpectrumResult& result, bool with_fourier, const Voice& voice = {});

}  // namespace cromer::core
