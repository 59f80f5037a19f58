// Measured and computed motions as curves of a panel, and the axes they are drawn on: displacement from the
// fitted equilibrium against time, in units that suit them.
#pragma once

#include <string>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Names and units are safe for a figure's text.
struct MeasuredAxis {
  std::string name;      ///< "displacement {/:Italic x} (cm)"
  std::string unit;      ///< "cm"; the file's own but for metres
  double unit_size = 1;  ///< in the SI unit of the column
  double equilibrium = 0;
  std::string time_name;  ///< "time {/:Italic t} (s)"; with what was taken off where times are far from 0
  double time_unit = 1;   // [s]
  double time_from = 0;   // [s] drawn as 0

  /// SI values of the recording as displacements in `unit`.
  std::vector<double> displacements(std::vector<double> values) const;
  /// SI displacements in `unit`.
  std::vector<double> scaled(std::vector<double> values) const;
  /// Seconds as they are drawn.
  std::vector<double> times(std::vector<double> t) const;
};

MeasuredAxis measured_axis(const FittedRecording& fitted);

/// The unit amplitudes of the motion behind the column are drawn in: of the displacement, whatever was
/// recorded.
struct AmplitudeUnit {
  std::string symbol;  ///< safe for a figure's text
  double size = 1;     ///< in the SI unit of the displacement
};
AmplitudeUnit amplitude_unit(const FittedRecording& fitted, double largest);

/// A motion at increasing times.
struct SampledMotion {
  std::vector<double> t;  // [s]
  std::vector<double> y;  ///< in the unit of the axis, from the equilibrium
};

/// The samples that the fit was made of, as dots, broken where samples are missing.
Curve measured_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Those and, as crosses that the axes do not follow, the samples set aside.
void add_measured(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis);

/// What the law has less the equilibrium, at the samples of the series (`smooth`: closely enough in time for
/// a smooth curve).
SampledMotion law_motion(const FittedRecording& fitted, const MeasuredAxis& axis, bool smooth);

/// Measured less fitted at the samples of the fit, as dots.
Curve residual_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Whether a recorded force drives it: its swings follow no envelope.
bool irregular(const FittedRecording& fitted);

/// Of an irregular motion some periods about its largest swing: `fitted` with those samples alone, or all of
/// them where it has no period.
FittedRecording largest_swings(const FittedRecording& fitted);

/// What was held out, as a recording of its own.
FittedRecording held_out_part(const FittedRecording& fitted);

/// Adds a computed motion, in the axis's units, with the look of `look`, as a line broken at gaps.
void add_line(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis,
              const SampledMotion& motion, Curve look);

/// The same, or, where its swings are too many to be told apart, as its envelope above and below.
void add_motion(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis, SampledMotion motion,
                const Curve& look);

}  // namespace cromer::core
