// Response spectra of oscillators with hysteretic damping: a sum of steady states.
#pragma once

#include <span>
#include <vector>

namespace cromer::core {

/// Peak displacements [m], relative to a ground that shakes as recorded, of unit masses on springs w^2 (1 +
/// i eta), w = 2 pi/T. Each frequency of the recording is answered as hysteretic_response() says. Between
/// samples the ground is band-limited. The record repeats, after pauses so long that the peaks are off by
/// some 1e-4, by 1e-3 where the loss factor is above 0.4 and the period a quarter of the record; longer
/// periods, and a ground that is fast at its end, make up to 1e-2. Reading them off by a quartic through five
/// values adds at most 1e-4. Periods and the loss factor are positive.
std::vector<double> hysteretic_peaks(std::span<const double> acceleration, double h,
                                     std::span<const double> periods, double loss_factor);

/// How many samples the longest period takes; memory is about 64 bytes for each.
double hysteretic_samples(std::size_t samples, double h, double longest_period, double loss_factor);

}  // namespace cromer::core
