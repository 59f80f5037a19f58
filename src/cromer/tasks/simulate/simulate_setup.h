// From the options of `simulate` to the runs they ask for: checks, then defaults.
#pragma once

#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/run/event.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The runs to do, method outermost, with law, drive, start, step and end; nothing is integrated yet. An
/// Error names option, value and constraint.
Result<std::vector<SimulatedRun>> set_up_runs(const SimulateOptions& options);

/// What the options say that has no effect or is not exact.
std::vector<Notice> setup_notices(const SimulateOptions& options, const std::vector<SimulatedRun>& runs);

/// Sets step and accuracy of every run; an Error also where its states would take too much memory.
Result<void> choose_steps(const SimulateOptions& options, std::vector<SimulatedRun>& runs,
                          const Watch& watch);

/// The law, or an Error that names the option which prevents it.
Result<Oscillator<double>> oscillator_of(const SimulateOptions& options);

/// What the method of that name, which must be in the list, is set to.
MethodSettings settings_of(const SimulateOptions& options, std::string_view method);

/// Where the motion begins.
State<double> start_of(const SimulateOptions& options);

/// Reads `position=VALUE`, `velocity=VALUE` or `turning-point` (velocity = 0), then any of `:rising`,
/// `:falling` (which way the quantity goes) and `:stop` (the run ends there): "position=1 cm:falling:stop".
/// An Error names what was expected.
Result<Event> parse_event(std::string_view text);

inline constexpr double default_steps_per_period = 200;
inline constexpr double default_periods = 20;

/// The shorter of two periods [s], of which 0 is none.
double shorter_period(double one, double other);

/// The step where none is asked for [s]: a 200th of the shorter of natural and drive period, of which 0 is
/// none; 0 where there is neither.
double default_step(double natural_period, double drive_period);

/// The end where none is asked for [s]: 20 natural periods, of the drive where the law has none.
double default_end(double natural_period, double drive_period);

/// Period of small oscillations [s] about the rest position: x = 0, or the bottom of a double well. 0 where
/// there is none.
double natural_period(const Oscillator<double>& oscillator);

/// What to say where it is 0 and no period of the drive is there to choose a step by.
Error no_period(const Oscillator<double>& oscillator, const SimulateOptions& options);

}  // namespace cromer::core
