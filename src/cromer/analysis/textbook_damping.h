// Damping as textbooks read it off: from peaks, and from the width of the resonance. Both are biased, as
// noted beside each. They are shown next to a fit, never instead of one.
#pragma once

#include <optional>
#include <span>

namespace cromer::core {

/// ln of the ratio of neighbouring peaks on one side, as the slope of ln(peak) over all peaks.
struct PeakDecrement {
  double value = 0;           ///< logarithmic decrement of a period
  double standard_error = 0;  ///< from the scatter about the straight line
  int peaks = 0;
};

/// The largest value of `y` (about 0) within half a period of the first top and of each time a whole number
/// of periods later, until one is below four times `noise`; at its samples the vertex of the parabola. Empty
/// with fewer than three. Biases: the largest of several noisy samples reads high, the more the smaller the
/// peak, so that the decrement comes out low; where the damping changes with amplitude it is a mean over the
/// record.
std::optional<PeakDecrement> peak_decrement(std::span<const double> t, std::span<const double> y,
                                            double period, double noise);

/// The line of the record's spectrum (no window) at 1/sqrt(2) of its height.
struct HalfPowerBandwidth {
  double width = 0;              // [rad/s] full
  double angular_frequency = 0;  // [rad/s] where it is highest
  double narrowest = 0;          // [rad/s] an undamped line's width in a record of this length, 5.57/T
};

/// Of an exponential seen to its end the width is twice the decay rate. Bias: a record that ends earlier
/// broadens the line, and no line can be narrower than `narrowest`. `w` is where the line is, roughly.
/// Empty where the line does not fall to half its power within w/2 on both sides.
std::optional<HalfPowerBandwidth> half_power_bandwidth(std::span<const double> t, std::span<const double> y,
                                                       double w);

}  // namespace cromer::core
