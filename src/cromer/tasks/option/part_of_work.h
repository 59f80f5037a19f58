// Progress of one part of a longer work.
#pragma once

#include "cromer/base/interrupt.h"

namespace cromer::core {

/// A Watch for the part of the work from share `from` to share `to`, 0 <= from <= to <= 1. `whole` must
/// outlive it.
inline Watch part_of(const Watch& whole, double from, double to) {
  Watch part{whole.interrupt, {}};
  if (whole.progress)
    part.progress = [&whole, from, to](double fraction) { whole.progress(from + (to - from) * fraction); };
  return part;
}

}  // namespace cromer::core
