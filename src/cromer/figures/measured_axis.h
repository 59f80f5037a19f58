// The axes measured motions are drawn on: displacement from the fitted equilibrium against time, in units
// that suit them.
#pragma once

#include <string>
#include <vector>

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

}  // namespace cromer::core
