// Results as CSV.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// The columns of a recording, for inspect -o: time first and strictly increasing, the other columns in the
/// file's own units, whatever the dialect was.
Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options);

/// "run,t (s),x (m),v (m/s),energy (J)"; with a sensor what a logger would write, "Time (s),Position (m)",
/// several runs side by side. Comments at the head say where the numbers come from.
std::string simulate_csv(const SimulateResult& result, const std::string& command);

/// One row per recording and run: "file,run,column,law,status", then every quantity that any of them has,
/// with its standard error beside it ("stiffness (N/m),stiffness standard error (N/m)"), the residual and the
/// message. What a recording has not is an empty cell.
std::string fit_csv(const std::vector<FittedRecording>& fits);

/// "file,run,t (s),measured (m),x (m),v (m/s),energy (J),residual (m),v from the samples (m/s),set aside" of
/// every fit that has values; the units are the column's.
std::string motion_csv(const std::vector<FittedRecording>& fits);

/// "run,curve,t (s),measured displacement (m),simulated displacement (m)": from the fitted equilibrium, in
/// the SI unit of the column.
std::string compare_csv(const std::vector<CompareResult>& comparisons);

/// Columns that are computed, with their headers: "SD (m)".
struct NamedColumns {
  std::vector<std::string> headers{};
  std::vector<std::vector<double>> values{};

  std::vector<double>& add(std::string header) {
    headers.push_back(std::move(header));
    return values.emplace_back();
  }
};

/// What a spectrum's files say of each period: one value for each, in the unit that was asked for.
NamedColumns spectrum_columns(const SpectrumResult& result, const ResponseSpectrum& spectrum);

/// One row for each damping ratio and period, in the order asked for.
std::string spectrum_csv(const SpectrumResult& result, const std::string& command);

/// Fourier amplitudes of the recording, one column for each component.
std::string fourier_csv(const SpectrumResult& result, const std::string& command);

}  // namespace cromer::core
