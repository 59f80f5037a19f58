// What the tasks found, as callers get it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/methods.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// Marks the messages of a result as being about arrays, if it is of arrays (words.h).
void put_in_arguments(FittedRecording& fitted, bool of_arrays);
void put_in_arguments(CompareResult& compared, bool of_arrays);
void put_in_arguments(SimulateResult& simulated, bool of_arrays);
void put_in_arguments(NetworkRun& run);
void put_in_arguments(FittedNetwork& fitted, bool of_arrays);
void put_in_arguments(ModesResult& modes, bool of_arrays);

/// An Error about a network, or the channels of one: its argument is `network` or `channels` where it is no
/// other.
Error of_network(const Error& error, bool of_arrays = false);

/// Why a fit has no values that may be looked at.
Error no_values(const FittedRecording& fitted);

/// The law's motion at times [s] that strictly increase from the first used sample's on. An Error where the
/// fit has no values, or a recorded force drives the motion.
Result<Trajectory> motion_at(const FittedRecording& fitted, std::span<const double> t);

cromer::MethodEffect effect_of(const MethodEffect& effect);

/// All rows; a point of more steps than memory can count is an Error, not the end of the program.
Result<SweepResult> run_sweep(const SweepOptions& options, const Watch& watch);

/// A column of the rows, by its index.
std::vector<double> column_of(const SweepResult& result, std::size_t column);

/// "1.5,2,3": values as a grid that an option takes.
std::string list_of(std::span<const double> values);

}  // namespace cromer::core
