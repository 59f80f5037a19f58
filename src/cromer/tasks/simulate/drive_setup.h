// From the options of `simulate` to the drive of a run.
#pragma once

#include <optional>
#include <string_view>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The drive that is asked for: a name that --drive takes, "drive-file" or "base-motion"; "none" if nothing
/// drives.
std::string_view drive_name(const SimulateOptions& options);

/// Checks that the drive is known, that all it needs is given, and nothing that has no effect on it. An Error
/// names the option.
Result<void> check_drive(const SimulateOptions& options);

/// The drive at this frequency [rad/s] on a body of that mass [kg], if it is harmonic (none, a force, an
/// unbalance, a shaking base); empty for the others.
std::optional<HarmonicDrive<double>> harmonic_drive(const SimulateOptions& options, double frequency,
                                                    double mass);

/// Sets the run's drive at this frequency [rad/s]. A chirp without a duration gets one in end_drive.
Result<void> set_drive(const SimulateOptions& options, double frequency, SimulatedRun& run);

/// Period of a harmonic drive [s]; 0 if nothing swings.
double drive_period(const HarmonicDrive<double>& drive);

/// The time by which step and end are chosen [s]: the period of the drive, the shortest period of a chirp,
/// the duration of a pulse; 0 if there is none.
double drive_period(const SimulatedRun& run);

/// When the drive begins [s]; 0 if it acts from the start, or there is none.
double drive_begin(const SimulatedRun& run);

/// When the drive ends [s]; 0 if it does not.
double drive_end(const SimulatedRun& run);

/// Lets a chirp without a duration sweep until the end of the run. Errors: a chirp that begins after the end,
/// a recording that ends before it, a drive of which `exact` knows no closed form.
Result<void> end_drive(const SimulateOptions& options, SimulatedRun& run);

/// Whether the base moves, and a displacement is transmitted; otherwise a force is.
bool sends_motion(const SimulateOptions& options);

/// Amplitude of the base's displacement [m], or of the force [N].
double sent_amplitude(const SimulateOptions& options, const SimulatedRun& run);

}  // namespace cromer::core
