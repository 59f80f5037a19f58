// Results as CSV.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// All columns of a recording, whatever its dialect: time first and strictly increasing, the others in the
/// file's own units. An Error where the recording has no such time.
Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options);

/// Columns of numbers under headings with their units: "SD (m)".
struct NamedColumns {
  std::vector<std::string> headers{};
  std::vector<std::vector<double>> values{};

  std::vector<double>& add(std::string header) { return insert(headers.size(), std::move(header)); }
  std::vector<double>& insert(std::size_t at, std::string header) {
    headers.insert(headers.begin() + static_cast<std::ptrdiff_t>(at), std::move(header));
    return *values.insert(values.begin() + static_cast<std::ptrdiff_t>(at), std::vector<double>{});
  }
};

/// The kept states of a run: t, x, v, energy and, if there is one, the simulated sensor.
NamedColumns state_columns(const SimulatedRun& run);

/// "run,t (s),x (m),v (m/s),energy (J)". With a simulated sensor, what a logger would write:
/// "Time (s),Position (m)", several runs side by side. Comments at the head say where the numbers come from,
/// unless `command` is empty.
std::string simulate_csv(const SimulateResult& result, const std::string& command);

/// One row per recording and run: "file,run,column,law,status", then every quantity that any of the fits has,
/// each with its standard error and its 95 % interval ("stiffness (N/m),stiffness standard error (N/m)"),
/// then the residual and the message. A cell is empty where a fit does not have the quantity.
std::string fit_csv(std::span<const FittedRecording> fits);

/// The fitted motions, sample by sample: "file,run,t (s),measured (m),x (m),v (m/s),energy (J),residual (m),
/// v from the samples (m/s),set aside". The units depend on the column. A fit without values has no rows.
std::string motion_csv(std::span<const FittedRecording> fits);

/// The kept states: "t (s)", then x and v of each mass by its name, "floor 1 x (m),floor 1 v (m/s)", then
/// "energy (J)" and what each link stores, "ground-floor 1 energy (J)". Of several runs with their number in
/// front, "run".
std::string network_csv(std::span<const NetworkRun> runs, const std::string& command);

/// A row for each value found of a link.
std::string network_fit_csv(const FittedNetwork& fitted);

/// A row for each mode: frequency and damping ratio with their standard errors and 95 % intervals, the
/// participation, the real and the imaginary part of its shape at each name, and what each method makes of
/// it.
std::string modes_csv(const ModesResult& result);

/// "run,curve,t (s),measured displacement (m),simulated displacement (m)". Displacements are from the fitted
/// equilibrium, in the SI unit of the column.
std::string compare_csv(std::span<const CompareResult> comparisons);

/// The periods and the spectral values at them, accelerations in the unit asked for.
NamedColumns spectrum_columns(const SpectrumResult& result, const ResponseSpectrum& spectrum);

/// One row for each damping ratio and period, in the order asked for.
std::string spectrum_csv(const SpectrumResult& result, const std::string& command);

/// Appends the rows of a motion of many: those of spectrum_csv behind a column "file", two files joined by
/// " + ". The header and `command` come with the first one.
void append_spectra(std::string& out, const MotionSpectra& motion, const std::string& command, bool first);

/// The motion of the ground sample by sample: "t (s),acceleration (m/s²),velocity (m/s),displacement (m)", of
/// two components "acceleration 1 (m/s²)" and so on.
std::string ground_csv(const SpectrumResult& result, const std::string& command);

/// Fourier amplitudes against frequency, one column for each component.
std::string fourier_csv(const SpectrumResult& result, const std::string& command);

/// A row for each hold; the spring constant stands in each of them.
std::string static_csv(const StaticStiffness& found);

/// A row for each recording: mass, period squared, what the line leaves; and what follows from the line.
std::string mass_line_csv(const MassLine& line);

/// The swept options, then the measures; one row for each point. What made it stands in comments at the head,
/// unless `command` is empty.
std::string sweep_csv(const SweepResult& result, const std::string& command);

/// The swept options, t, x and v: a block of states of the point with these values. The header and the
/// comments come before the first block.
void append_trajectory(std::string& out, const SweepPlan& plan, const std::vector<double>& values,
                       const Trajectory& states, std::span<const std::string> comments, bool first);

}  // namespace cromer::core
