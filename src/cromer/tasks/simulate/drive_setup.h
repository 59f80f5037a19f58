// From the options of `simulate` to the drive of a run.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// What is asked for: a name that --drive takes, "drive-file" or "base-motion"; "none" where nothing drives.
std::string_view drive_name(const SimulateOptions& options);

/// That the name is known, everything it needs is given, and nothing that it has no use for. An Error names
/// the option.
Result<void> check_drive(const SimulateOptions& options);

/// The drive at this frequency of a law of that mass, where it is a harmonic one (none, a force, an
/// unbalance, a shaking base); empty for the others.
std::optional<HarmonicDrive<double>> harmonic_drive(const SimulateOptions& options, double frequency,
                                                    double mass);

/// Sets the run's drive at this frequency. A chirp without a duration gets one in end_drive.
Result<void> set_drive(const SimulateOptions& options, double frequency, SimulatedRun& run);

/// Period of a harmonic drive [s]; 0 where nothing swings.
double drive_period(const HarmonicDrive<double>& drive);

/// The length by which step and end are chosen [s]: a period of the drive, the shortest of a chirp, the
/// duration of a pulse; 0 where there is none.
double drive_period(const SimulatedRun& run);

/// When the drive sets in [s]; 0 where it acts from the start, or none does.
double drive_begin(const SimulatedRun& run);

/// Where the drive itself ends [s]; 0 where it does not.
double drive_end(const SimulatedRun& run);

/// A chirp without a duration sweeps until the end of the run; a recording must last that long, and `exact`
/// needs a closed form.
Result<void> end_drive(const SimulateOptions& options, SimulatedRun& run);

/// Whether it is the base that moves.
bool sends_motion(const SimulateOptions& options);

/// The amplitude of what goes in.
double sent_amplitude(const SimulateOptions& options, const SimulatedRun& run);

}  // namespace cromer::core
