// Results as texts for people.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/inspect/inspect.h"
#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/recognise/recognise.h"
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

/// "lab.csv: run 1: too_short: ..." of a fit that did not succeed.
std::string failure_text(const FittedRecording& fitted);

/// A table for each damping ratio, of at most 24 periods, and where the spectrum is highest.
std::string spectrum_text(const SpectrumResult& result);

/// "relative displacement"
std::string readable_response(ShockResponse of);

/// What was taken off the recordings; "" for nothing: "corrected: linear baseline taken off; ...". `brief`
/// leaves out how the filter was run.
std::string correction_text(const Correction& correction, bool brief = false);

/// The recordings of many motions, and where the spectra of each are highest. Without those that could not be
/// computed.
std::string spectra_text(std::span<const MotionSpectra> motions);

/// The name of each motion, by its files without their folders where these are not needed: "a.AT2",
/// "RSN1_090.AT2 + ...360.AT2".
std::vector<std::string> motion_names(std::span<const MotionSpectra> motions);

/// Component `c` of two, by its column: "east"; "component 1" if both columns have the same name.
std::string component_name(const SpectrumResult& result, std::size_t c);

/// What was swept and how, then every row of a short sweep; of a longer one each measure's smallest and
/// largest value, and where they are.
std::string sweep_text(const SweepResult& result);

/// How the points are found: "euler-cromer, closed form, steps of 0.01 s".
std::string sweep_method_text(const SweepPlan& plan);

/// The holds, and the spring constant that they give.
std::string static_text(const StaticStiffness& found);

/// One line, to stand under the table of the fits.
std::string mass_line_text(const MassLine& line);

/// A table of the curves of each run, and whether one decay rate is enough; what else was asked of the fit
/// comes first.
std::string compare_text(const std::vector<CompareResult>& comparisons);

/// Dialect, columns, rate, gaps and outliers, a line each; of long lists the first twenty.
std::string inspect_text(const Inspection& inspection);

/// What an option is, what it must satisfy, and in brackets its default.
std::string option_text(const Option& option);

/// Their table; where `options` ask for a step, what each of them simulates instead.
std::string methods_text(const MethodsOptions& options, std::span<const MethodRow> methods);

/// A table of the modes, their shapes where they are few, and what each method simulates.
std::string modes_text(const ModesResult& result);

/// Where each mass is at the end of each run, and where the energy went.
std::string network_text(std::span<const NetworkRun> runs);

/// The values found of a network's links, and what is left of each column.
std::string network_fit_text(const FittedNetwork& fitted);

/// Which method made the rows, and a table of the nearest.
std::string recognise_text(const RecogniseResult& result);

}  // namespace cromer::core
