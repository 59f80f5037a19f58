// The axis measured motions are drawn on: displacement from the fitted equilibrium in a unit that suits it.
#pragma once

#include <string>
#include <vector>

#include "cromer/report/figure.h"
#include "cromer/study/task/fit.h"

namespace cromer::cli {

struct MeasuredAxis {
  std::string name;      ///< "displacement {/:Italic x} (cm)"
  std::string unit;      ///< "cm"
  double unit_size = 1;  ///< in the SI unit of the column
  double equilibrium = 0;

  /// SI values of the recording as displacements in `unit`.
  std::vector<double> displacements(std::vector<double> values) const;
  /// SI displacements in `unit`.
  std::vector<double> scaled(std::vector<double> values) const;
};

MeasuredAxis measured_axis(const FittedRecording& fitted);

/// The samples used, as dots on that axis.
Curve measured_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Adds a computed motion to a panel of measured samples: as a line, or, where its swings are too many to be
/// told apart, as its envelope above and below.
void add_motion(Panel& panel, Curve motion);

}  // namespace cromer::cli
