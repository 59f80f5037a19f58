// What a call of the C interface found, kept for the documents and motions that are asked for later.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cromer/figures/figures.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
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

struct ListedMethods {
  MethodsOptions options;
  std::vector<MethodRow> rows;
};

struct ReadFile {
  ReadOptions options;
  Inspection inspection;
};

/// monostate: nothing yet, or a refusal.
using Found = std::variant<std::monostate, ReadFile, std::vector<FittedRecording>, SimulateResult,
                           std::vector<CompareResult>, ListedMethods, RecogniseResult, ModesResult,
                           std::vector<NetworkRun>, FittedNetwork, SpectrumResult, SweepResult>;

inline constexpr const char* no_command = "";  ///< nothing to say of where the numbers come from

/// As an SVG document, which needs no library and cannot fail.
std::string drawn(const Figure& figure);

/// The result as the program writes it. `form`: "text", "csv" or "svg". An Error where there is no result, or
/// none in that form.
Result<std::string> written_as(const Found& found, std::string_view form);

/// The law's motion of a fit's run at times [s], as LawFit::at gives it.
Result<Trajectory> motion_of_run(const Found& found, int run, std::span<const double> t);

}  // namespace cromer::core
