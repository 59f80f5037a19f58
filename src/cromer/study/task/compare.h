// Task: a recording beside simulations of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/run/trajectory.h"
#include "cromer/study/task/fit.h"

namespace cromer {

struct CompareOptions {
  FitOptions fit{};
  std::string method = "euler-cromer";
  std::optional<double>
      step;  // [s] > 0; by default the sample spacing divided so that a period has at least 200 steps
};

/// One simulation laid beside the recording, at the recording's own times; x is the displacement from the
/// fitted equilibrium.
struct ComparedCurve {
  std::string label;  ///< "one constant decay rate", "viscous+drag"
  Law law;
  std::string method;
  Trajectory trajectory;
  bool complete = true;  ///< reached the recording's end; the figures are NaN where not
  double rms = 0;        // [m] or the column's SI unit
  double r_squared = 0;
  double amplitude_ratio_end =
      0;                   ///< simulated over measured, at the end (carried there from the last ten periods)
  double phase_drift = 0;  // [rad] simulated minus measured, at the end
};

struct CompareResult {
  FittedRecording recording;
  std::vector<ComparedCurve> curves;
  bool complete = true;  ///< all curves are, and none is missing but for the fit's status
  std::vector<std::string> warnings;
};

/// Whether one decay rate is enough, with its numbers, for people; empty where nothing was simulated to the
/// end.
std::string explanation(const CompareResult& comparison);

/// The simulations beside one fitted recording; of a run that ended early (diverged, interrupted) the figures
/// are NaN and a warning says when; one that grows tenfold is said to be unstable. A method that does not
/// exist, or cannot integrate the law, and a step that is not positive or that no run could be made of, are
/// Errors. No curves where the fit was refused.
Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch = {});

/// The constant rate is the mean of the segments' rates where segments were asked for, else that of the
/// viscous fit.
Result<std::vector<CompareResult>> compare(std::string_view bytes, std::string_view file,
                                           const CompareOptions& options, const Watch& watch = {});

}  // namespace cromer
