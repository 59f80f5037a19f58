// Stage 8: what the values of a series are like: rounding, spikes, drop-outs, tops cut off.
#pragma once

#include <span>
#include <vector>

#include "cromer/read/recording.h"

namespace cromer::core::dialects {

/// Stands for a size that is unknown because of a gap in the times.
constexpr double unseen = -1;
/// The median of the known sizes; 0 if there are none.
double median_seen(std::span<const double> sizes);

/// The step of evenly quantised values: the smallest difference that occurs, if nearly all others are its
/// multiples; else, of groups of few values that come again and again, evenly spaced and far apart, the step
/// from group to group; else the last decimal place, if there are at most six. 0 where none is seen. Where
/// only two values occur, their difference is the step.
double rounding_step(std::span<const double> values);

/// Single samples that stick out: their distance from the cubic through the four neighbours is more than 12
/// robust standard deviations (1.4826 MAD) of such distances, near by and overall, more than 6 rounding steps
/// and more than 6 usual small changes; at either end, from the cubic through the next four samples and more
/// than 6 times that. Conservative: steps, kinks, flicker and clean oscillations have none.
std::vector<std::size_t> spikes(std::span<const double> t, std::span<const double> y, double step,
                                double resolution);

/// Where the tops of the swing are cut off: its largest or smallest value, where that comes again and again,
/// in runs longer than a sinusoid of this size and frequency stays within one `resolution` of its top. `step`
/// [s] between samples.
std::vector<double> tops_cut_off(std::span<const double> y, double step, double resolution);

/// One stretch of samples, from `first` up to, but without, `end`.
struct DropOut {
  std::size_t first, end;
};

/// Stretches that the sensor did not see: two to ten samples, or three and more equal ones, between a jump
/// away and a jump back. Both jumps are larger than 12 robust standard deviations of the changes near by, on
/// the livelier side. A signal that mostly stands still has none (plateaus are no drop-outs), nor has one of
/// which they would be more than a tenth. `step` [s] is the median step; a gap in the times is not a jump.
std::vector<DropOut> drop_outs(std::span<const double> t, std::span<const double> y, double step,
                               double resolution);

}  // namespace cromer::core::dialects
