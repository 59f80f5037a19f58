// The results of the tasks as JSON documents, described in docs/results.md. Numbers that are not finite are
// null. `voice` is the language and the audience of the sentences.
#pragma once

#include <span>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/inspect/inspect.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/recognise/recognise.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// {"runs": [...], "warnings": [...]}, with "message" if a run ended early. `with_states` adds the kept
/// states of each run, all on one line.
std::string to_json(const SimulateResult& result, bool with_states, const Voice& voice = {});

/// {"methods": [...]}
std::string to_json(std::span<const MethodRow> methods, const Voice& voice = {});

/// {"method", "masses": [...], "links": [...], ...}, with "message" if the run ended early; of several runs
/// {"runs": [...]}. `with_states` adds the kept states, all on one line.
std::string to_json(std::span<const NetworkRun> runs, bool with_states, const Voice& voice = {});

/// {"links": [...], "masses": [...], ...}, with "message" if the fit did not succeed.
std::string to_json(const FittedNetwork& fitted, const Voice& voice = {});

/// {"names": [...], "modes": [...], ...}
std::string to_json(const ModesResult& result, const Voice& voice = {});

/// {"recognised": [...], "verdict", ...}, with "message" if no method made the rows.
std::string to_json(const RecogniseResult& result, const Voice& voice = {});

/// The swept options, the columns and how the points ended, on one line; `with_rows` adds the rows.
std::string to_json(const SweepResult& result, bool with_rows = true, const Voice& voice = {});

/// The contents of the file; `with_values` adds the numbers of the columns, all on one line.
std::string to_json(const Inspection& inspection, bool with_values, const Voice& voice = {});

/// The object of a single fit; of several, or `as_list`, {"fits": [...]}, with "missing" if an interruption
/// has left out any files.
std::string to_json(std::span<const FittedRecording> fits, bool as_list = false, const Voice& voice = {},
                    std::span<const std::string> missing = {});

/// The spring constant from held masses: {"parameters": {"stiffness"}, "line", "holds", ...}
std::string to_json(const StaticStiffness& found);

/// {"fits": [...], "mass_line": {...}}
std::string to_json(std::span<const FittedRecording> fits, const MassLine& line);

/// The object of a single comparison; of several {"comparisons": [...]}.
std::string to_json(std::span<const CompareResult> comparisons, const Voice& voice = {});

/// {"components": [...], "spectra": [...], "arias_intensity", "duration_5_95", ...}; `with_fourier` adds the
/// Fourier amplitudes and puts all on one line. Without `with_curves` the values at the periods are left out
/// of the spectra of a single component.
std::string to_json(const SpectrumResult& result, bool with_fourier, const Voice& voice = {},
                    bool with_curves = true);

/// {"motions": [...]}, with "message" if any of them failed and "missing" if an interruption has left out
/// any; all on one line.
std::string to_json(std::span<const MotionSpectra> motions, const Voice& voice = {},
                    std::span<const std::string> missing = {});

}  // namespace cromer::core
