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

/// Notices on options without effect, steps beyond stability, and ends that the steps do not meet.
std::vector<Notice> setup_notices(const SimulateOptions& options, const std::vector<SimulatedRun>& runs);

/// Says that the steps do not fill a run: the last is shorter. Empty where they do, where step or end is a
/// default, as the remainder then is, and for an adaptive method.
Notice shorter_last_step(const SimulateOptions& options, double until, double step, std::string_view method);

/// How many states a run keeps if it reaches its end. An Error if it has too many steps to tell them apart.
Result<long long> kept_states(double until, double step, long long every);

/// An Error if states of so many numbers each take more than the memory [bytes]; 0 means that it is not
/// known.
Result<void> check_memory(double states, double numbers, double memory);

/// For --accuracy: sets step and accuracy of every run. An Error if there is no such step, or its states
/// would take too much memory.
Result<void> choose_steps(const SimulateOptions& options, std::vector<SimulatedRun>& runs,
                          const Watch& watch);

/// The law, or an Error that names the option which prevents it.
Result<Oscillator<double>> oscillator_of(const SimulateOptions& options);

/// The settings of the method of that name, which must be in the list.
MethodSettings settings_of(const SimulateOptions& options, std::string_view method);

/// Whether a run can have all the law's terms: hysteresis and friction both remember, and no run has both.
inline bool runs_together(const Law& law) { return !(law.has<Hysteresis>() && law.has<Friction>()); }

/// The state in which the motion begins.
State<double> start_of(const SimulateOptions& options);

/// Reads an --event: `position=VALUE`, `velocity=VALUE` or `turning-point` (velocity = 0), then any of
/// `:rising`, `:falling` (which way the quantity goes) and `:stop` (the run ends there), as in "position=1
/// cm:falling:stop". An Error names what was expected.
Result<Event> parse_event(std::string_view text);

inline constexpr double default_steps_per_period = 200;
inline constexpr double default_periods = 20;

/// Motions of more steps than these are refused.
inline constexpr double most_steps_of_a_run = 1e8;

/// The shorter of two periods [s]; 0 means that there is none.
double shorter_period(double one, double other);

/// The default step [s]: a 200th of the shorter of natural and drive period; 0 if there is neither.
double default_step(double natural_period, double drive_period);

/// The default end [s]: 20 natural periods, or drive periods if the law has none.
double default_end(double natural_period, double drive_period);

/// Period of small oscillations [s] about the rest position: x = 0, or the bottom of a double well. 0 if
/// there is none.
double natural_period(const Oscillator<double>& oscillator);

/// The Error for a law without a natural period, if no drive has one to choose step and end by.
Error no_period(const Oscillator<double>& oscillator, const SimulateOptions& options);

}  // namespace cromer::core
