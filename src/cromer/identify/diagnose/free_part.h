// The part of a recording in which nothing drives or holds the body, and in which the sensor sees it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "cromer/identify/record.h"
#include "cromer/notice.h"

namespace cromer::core {

/// Where an amplitude that rises or is level begins to fall at once, as where a drive stops.
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

struct FreePart {
  double from = 0;  // [s] the first time at which the motion is surely free
  Notice reason;    ///< a clause: "it is held still until 1.2 s"
};

/// Where the motion becomes free after the record's beginning: it is held still and then let go, or its
/// amplitude rises or stays level, as a drive makes it, and from some moment on only falls. Empty where it is
/// free from the start, or where that cannot be told: of beats, for one.
std::optional<FreePart> find_free_part(const Record& record);

/// The median time between upward crossings of what it swings about in the first third [s]; empty with fewer
/// than five of them.
std::optional<double> period_at_start(const Record& record);

struct LostMotion {
  std::size_t seen = 0;  ///< samples that show the motion: the first ones
  double value = 0;      ///< that most others have
  double share = 0;      ///< of those others
};

/// Where the record stops in full swing: from one sample to the next it stays at one value for good, spikes
/// aside, three fifths of what is left at least and for a period or more. A motion that has died down, or
/// that friction holds, comes to rest at a turning point of its own size, and is not lost.
std::optional<LostMotion> find_lost_motion(const Record& record);

}  // namespace cromer::core
