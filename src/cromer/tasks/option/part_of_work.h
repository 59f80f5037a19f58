// Progress of work that is one part of a longer one.
#pragma once

#include "cromer/base/interrupt.h"

namespace cromer::core {

/// A Watch for the part of the work that takes it from `from` to `to`, 0 <= from <= to <= 1. `whole` outlives
/// it.
inline Watch part_of(const Watch& whole, double from, double to) {
  Watch part{whole.interrupt, {}};
  if (whole.progress)
    part.progress = [&whole, from, to](double fraction) { whole.progress(from + (to - from) * fraction); };
  return part;
}

}  // namespace cromer::core
