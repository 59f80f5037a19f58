// The extremes of oscillators of many periods on recorded ground motion.
#pragma once

#include <span>
#include <vector>

#include "cromer/analysis/interval_peak.h"
#include "cromer/ensemble/filter_walk.h"
#include "cromer/model/sampled_drive.h"
#include "cromer/spectrum.h"

namespace cromer::core {

/// Acceleration of the ground, evenly sampled; at least two samples. With `hold` the last one lasts a spacing
/// more.
struct GroundMotion {
  std::span<const double> acceleration;  // [m/s^2]
  double spacing = 0;                    // [s] > 0
  BetweenSamples between = BetweenSamples::linear;
  std::size_t refinement = 1;  ///< every n-th sample was recorded, the others were interpolated
};

enum class ResponseOf {
  displacement,           // [m] relative to the ground, its sign turned
  velocity,               // [m/s] likewise; step by step, some hundred times slower
  absolute_acceleration,  // [m/s^2]
};

/// What is looked for, and by which unit.
struct PeakSearch {
  Peaks peaks = Peaks::continuous;
  ResponseOf quantity = ResponseOf::displacement;
  bool after_the_end = true;         ///< look at the free motion after the last sample too
  bool largest_alone = true;         ///< only the largest magnitude of the whole motion must be right
  cromer_walk::Functions unit = {};  ///< of choose_unit(); none: the fastest unit here
};

struct ResponsePeaks {
  Extremes during;  ///< while the ground shakes, rest at the beginning included
  Extremes after;   ///< of the free motion from the last sample on; 0 where it was not looked at

  double overall() const { return std::max(during.magnitude(), after.magnitude()); }
};

/// The fewest equal parts of an interval that are at most T/10 long: ceil(10 h/T - 1e-9), at least 1.
std::size_t substeps(double spacing, double period);

/// The peaks of each law (stiffness > 0), from rest at the first sample, by the exact recurrence; the ground
/// motion is the drive. Error of the peaks: about 1e-13 of the largest for continuous ones, 1e-11 after 1e5
/// samples at long periods. Work and memory grow with spacing/period.
std::vector<ResponsePeaks> response_peaks(const GroundMotion& ground, std::span<const LinearLaw<double>> laws,
                                          const PeakSearch& search);

}  // namespace cromer::core
