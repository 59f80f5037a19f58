// Butterworth filters of sampled signals.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace cromer::core {

/// What passes: everything between two corners. At a corner the filter takes off 3 dB.
struct PassBand {
  double low = 0;                                         // [Hz] 0: down to zero frequency
  double high = std::numeric_limits<double>::infinity();  // [Hz] infinity: up to the highest one

  bool has_low() const { return low > 0; }
  bool has_high() const { return high < std::numeric_limits<double>::infinity(); }
};

/// y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y'', each dash one sample earlier.
struct FilterSection {
  double b0, b1, b2, a1, a2;
};

/// The filter of order n (with both corners 2 n poles) for samples h [s] apart, as sections one after the
/// other: the analogue filter by the bilinear transform, its corners prewarped, so that with
/// W = tan(pi f h) and the corners likewise |H|^2 = 1/(1 + ((W^2 - Wl Wh)/((Wh - Wl) W))^2n), of a single
/// corner 1/(1 + (W/Wh)^2n) or 1/(1 + (Wl/W)^2n) (A. V. Oppenheim & R. W. Schafer, Discrete-Time Signal
/// Processing, 7.1). order >= 1; 0 < low < high < 1/(2 h), one corner at least.
std::vector<FilterSection> butterworth(int order, const PassBand& band, double h);

/// Seconds until what the filter keeps of the past has fallen to a millionth.
double memory_of(std::span<const FilterSection> sections, double h);

/// Filters in place, from rest.
void filter(std::span<const FilterSection> sections, std::vector<double>& samples);

/// The same forwards and backwards: no phase, |H|^2 in place of |H|, so 6 dB at a corner. The signal is at
/// rest at both ends.
void filter_both_ways(std::span<const FilterSection> sections, std::vector<double>& samples);

}  // namespace cromer::core
