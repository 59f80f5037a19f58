// Task: a recording compared with simulations of its motion.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/model/law_force.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/trajectory.h"

namespace cromer::core {

struct CompareOptions {
  FitOptions fit{};
  std::vector<std::string> method{};  ///< names; euler-cromer by default
  std::optional<double>
      step;  // [s] > 0; by default the sample spacing, divided until a period has at least 200 steps
};

/// The `method` of a law without any method's error: by its closed form, or integrated so finely that nothing
/// shows.
inline constexpr std::string_view without_method = "exact";

/// One motion at the recording's own times; x is the displacement from the fitted equilibrium. The figures
/// leave out the samples that the fit set aside.
struct ComparedCurve {
  Notice label;  ///< one constant decay rate, the law by its name, or the law by a method
  Law law;
  std::string method;
  double step = 0;  // [s] of the method; 0 without one
  Trajectory trajectory;
  bool complete = true;   ///< reached the recording's end; if not, the figures are NaN
  bool diverged = false;  ///< the method is not stable at this step: the figures say nothing about the law
  double rms = 0;         // [m] or the column's SI unit
  double r_squared = 0;
  double amplitude_ratio_end = 0;    ///< simulated over measured, at the end (extrapolated from the last ten
                                     ///< periods); NaN if the measured motion has stopped
  double amplitude_ratio_error = 0;  ///< standard error of amplitude_ratio_end, by the noise of the recording
  double phase_drift = 0;            // [rad] simulated minus measured, at the end; NaN likewise
  bool measured_at_rest = false;     ///< the measured swing is below the noise at the end
  bool at_rest = false;              ///< the simulated swing is
  double law_rms = 0;                ///< as rms, of the exact law: without the method's error
  double method_amplitude_ratio = 1;  ///< simulated over the exact law, at the end; NaN if that has stopped
  double method_phase = 0;            // [rad] simulated minus the exact law, at the end; NaN likewise
};

struct CompareResult {
  FittedRecording recording;
  std::vector<ComparedCurve> curves;  ///< one constant decay rate, the law, and the law by each method
  bool complete = true;  ///< every curve is, and none is missing unless the fit was refused or undetermined
  bool others_tried = true;     ///< the fit chose among several laws
  std::vector<Notice> doubts;   ///< why no law describes the motion; also among the notices
  std::vector<Notice> notices;  ///< the fit's first
};

inline const FittedRecording& fit_of_run(const CompareResult& result) { return result.recording; }

/// Whether a single decay rate is enough, with the numbers, and what each method adds. Empty without the
/// first two curves.
Notice explanation(const CompareResult& comparison);

/// Of a law that does not describe its recording what is said where no uncertainty is printed; every other
/// notice is returned as it is.
Notice without_uncertainties(const Notice& notice);

/// Whether one of them says that no law, or not the given one, describes the recording.
bool lack_a_law(const std::vector<Notice>& notices);

/// Simulates one fitted recording. A run that ended early (diverged, interrupted) has NaN figures and a
/// notice that says when; a run that grows to ten times its law's motion is said to be unstable. A refused
/// fit has no curves. Errors: a driven motion, a column that is no position or angle, a method that does not
/// exist or cannot integrate the law, a step that is not positive or would take more than 1e8 steps.
Result<CompareResult> compare_fitted(const FittedRecording& recording, const CompareOptions& options,
                                     const Watch& watch = {});

/// Fits every run of the file and simulates each. A run that cannot be read or compared is a row of its own,
/// as in `fit`, if others can. The curve of one constant rate is the viscous fit; with segments it starts as
/// the chosen law does and decays at the mean of their rates.
Result<std::vector<CompareResult>> compare(const Recording& recording, const CompareOptions& options,
                                           const Watch& watch = {});

/// Whether the one constant rate is the mean of the segments' rates: those of an amplitude, which are the
/// law's own where the springs are linear.
inline bool has_mean_rate(const FittedRecording& recording) {
  return recording.decay_rate_mean && !has_bent_spring(recording.fit.law);
}

}  // namespace cromer::core
