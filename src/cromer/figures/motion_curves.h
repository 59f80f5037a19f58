// Measured and computed motions as curves of a panel, and the axes they are drawn on: displacement from the
// fitted equilibrium against time, in suitable units.
#pragma once

#include <string>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Names and units may be used as texts of a figure.
struct MeasuredAxis {
  std::string name;      ///< "displacement {/:Italic x} (cm)"
  std::string unit;      ///< "cm"; that of the file unless it is in metres
  double unit_size = 1;  ///< in the SI unit of the column
  double equilibrium = 0;
  std::string time_name;  ///< "time {/:Italic t} (s)"; names `time_from` if that is not 0
  double time_unit = 1;   // [s]
  double time_from = 0;   // [s] that is drawn as 0

  /// Recorded values in SI units as displacements in `unit`.
  std::vector<double> displacements(std::vector<double> values) const;
  /// Displacements in SI units, in `unit`.
  std::vector<double> scaled(std::vector<double> values) const;
  /// Times [s] in the unit of the axis, from `time_from` on.
  std::vector<double> times(std::vector<double> t) const;
};

/// "Position, run 2".
std::string run_title(const FittedRecording& fitted);

/// The law, or why none was found.
std::string law_found(const FittedRecording& fitted);

MeasuredAxis measured_axis(const FittedRecording& fitted);

/// The unit that amplitudes are drawn in. They are amplitudes of the displacement, whatever was recorded.
struct AmplitudeUnit {
  std::string symbol;  ///< may be used as a text of a figure
  double size = 1;     ///< in the SI unit of the displacement
};
AmplitudeUnit amplitude_unit(const FittedRecording& fitted, double largest);

/// A motion at increasing times.
struct SampledMotion {
  std::vector<double> t;  // [s]
  std::vector<double> y;  ///< in the unit of the axis, from the equilibrium
};

/// A measured motion, in the unit of the axis, as dots, broken at NaN and where samples are missing.
Curve measured_dots(const FittedRecording& fitted, const MeasuredAxis& axis, const SampledMotion& motion);

/// Adds the samples of the fit as dots, and those set aside as crosses, which do not widen the axes.
void add_measured(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis);

/// The motion by the law, from the equilibrium, at the times of the samples; with `smooth` at times close
/// enough for a smooth curve.
SampledMotion law_motion(const FittedRecording& fitted, const MeasuredAxis& axis, bool smooth);

/// Measured minus fitted at the samples of the fit, as dots.
Curve residual_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Whether a recorded force drives the motion; its swings then follow no envelope.
bool irregular(const FittedRecording& fitted);

/// `fitted` with only the samples within 12 periods of its largest swing; with all of them if it has no
/// period.
FittedRecording largest_swings(const FittedRecording& fitted);

/// `fitted` with only the samples within 6 periods of the first one; with all of them if it has no period.
FittedRecording first_swings(const FittedRecording& fitted);

/// The samples that were held out, as a recording of their own.
FittedRecording held_out_part(const FittedRecording& fitted);

/// Adds a computed motion, in the units of the axis, as a line broken at gaps. `look` has its name and style.
void add_line(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis,
              const SampledMotion& motion, Curve look);

/// Adds the same line, or, if it has too many swings to tell apart, its upper and lower envelope: then it
/// gives true.
bool add_motion(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis, SampledMotion motion,
                const Curve& look);

}  // namespace cromer::core
