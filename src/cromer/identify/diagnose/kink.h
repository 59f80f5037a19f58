// Where an amplitude that rises or is level begins to fall at once, as where a drive stops.
#pragma once

#include <optional>
#include <span>

namespace cromer::core {

struct Kink {
  double t = 0;       // [s]
  double before = 0;  // [1/s] rate at which it grows up to there
  double after = 0;   // [1/s] and right after
};

/// The place at which a line that goes over into a parabola fits the logarithm of the amplitudes best. Empty
/// where a smooth curve fits nearly as well: the squares that a polynomial of as many parameters leaves, and
/// those of two sinusoids that beat and decay, must be thrice those of the kink. `t` [s] increasing,
/// amplitudes positive, at least eight on each side of a kink. Takes time as the square of their number: some
/// 200 say all.
std::optional<Kink> find_kink(std::span<const double> t, std::span<const double> amplitude);

}  // namespace cromer::core
