// Task: a recording beside simulations of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/fit/fit.h"
#include "cromer/trajectory.h"

namespace cromer::core {

struct CompareOptions {
  FitOptions fit{};
  std::string method = "euler-cromer";
  std::optional<double>
      step;  // [s] > 0; by default the sample spacing divided so that a period has at least 200 steps
};

/// One simulation laid beside the recording, at the recording's own times; x is the displacement from the
/// fitted equilibrium. Samples that the fit set aside are in none of the figures.
struct ComparedCurve {
  std::string label;  ///< "one constant decay rate", "viscous+drag"
  Law law;
  std::string method;
  double step = 0;  // [s]
  Trajectory trajectory;
  bool complete = true;   ///< reached the recording's end; the figures are NaN where not
  bool diverged = false;  ///< the method is not stable at this step: the figures say nothing of the law
  double rms = 0;         // [m] or the column's SI unit
  double r_squared = 0;
  double amplitude_ratio_end = 0;  ///< simulated over measured, at the end (carried there from the last ten
                                   ///< periods); NaN where the measured motion has stopped
  double phase_drift = 0;          // [rad] simulated minus measured, at the end; NaN likewise
  bool measured_at_rest = false;   ///< the measured swing is below the noise at the end
  bool at_rest = false;            ///< the simulated one is
  double law_rms = 0;              ///< the law itself leaves, without the method's error [as rms]
  double law_amplitude_ratio_end = 0;  ///< of the law itself; NaN where the measured motion has stopped
  double method_amplitude_ratio =
      1;                    ///< simulated over the law itself, at the end; NaN where that has stopped
  double method_phase = 0;  // [rad] simulated minus the law itself, at the end; NaN likewise
};

struct CompareResult {
  FittedRecording recording;
  std::vector<ComparedCurve> curves;
  bool complete = true;         ///< all curves are, and none is missing but for the fit's status
  bool others_tried = true;     ///< no law was asked for: the fit chose among several
  std::vector<Notice> doubts;   ///< why no law tried says what the motion is; among the notices
  std::vector<Notice> notices;  ///< the fit's first
};

/// Whether one decay rate is enough, with its numbers, for people; empty where nothing was simulated to the
/// end.
Notice explanation(const CompareResult& comparison);

/// The simulations beside one fitted recording; of a run that ended early (diverged, interrupted) the figures
/// are NaN and a notice says when; one that grows tenfold is said to be unstable. A method that does not
/// exist, or cannot integrate the law, and a step that is not positive or that no run could be made of, are
/// Errors. No curves where the fit was refused.
Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch = {});

/// The motion of one constant rate is the viscous fit's own; where segments were asked for, it begins as the
/// chosen law does and its rate is the mean of theirs.
Result<std::vector<CompareResult>> compare(std::string_view bytes, std::string_view file,
                                           const CompareOptions& options, const Watch& watch = {});

}  // namespace cromer::core
