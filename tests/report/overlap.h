// Whether two words or pictures lie on each other.
#pragma once

#include "cromer/report/thinning.h"

namespace cromer::core {

inline bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

}  // namespace cromer::core
