// The part of a recording in which nothing drives or holds what swings.
#pragma once

#include <optional>
#include <string>

#include "cromer/identify/record.h"

namespace cromer {

struct FreePart {
  double from = 0;     // [s] the first time at which the motion is surely free
  std::string reason;  ///< for people: "it is held still until 1.2 s"
};

/// Where the motion becomes free after the record's beginning: it is held still and then let go, or its
/// amplitude rises or stays level, as a drive makes it, and from some moment on only falls. Empty where it is
/// free from the start, or where that cannot be told: of beats, for one.
std::optional<FreePart> find_free_part(const Record& record);

}  // namespace cromer
