// Peaks of two horizontal components in every direction.
#pragma once

#include <span>
#include <vector>

#include "cromer/ensemble/response_peaks.h"

namespace cromer::core {

/// Median and largest, over the directions 0, 1, ... 179 degrees, of the peak displacement in a direction
/// (D. M. Boore, Bull. Seism. Soc. Am. 100, 1830 (2010)). The largest of whole degrees is at most 4e-5 below
/// that of all directions.
struct RotatedPeaks {
  double median;   // [m] RotD50
  double largest;  // [m] RotD100
};

/// Of two components sampled alike, as response_peaks() would find them on each of the rotated motions. With
/// continuous peaks the free motion after the last sample counts too. The unit is of choose_unit(); none: the
/// fastest here.
std::vector<RotatedPeaks> rotated_peaks(const GroundMotion& first, const GroundMotion& second,
                                        std::span<const LinearLaw<double>> laws, Peaks peaks,
                                        const cromer_walk::Functions& unit = {});

}  // namespace cromer::core
