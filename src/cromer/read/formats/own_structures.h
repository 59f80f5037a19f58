// Text formats with a structure of their own, each in its file of this folder; the common stages read all
// other tables.
#pragma once

#include <array>

#include "cromer/read/sets.h"

namespace cromer::core::dialects {

struct OwnStructure {
  bool (*recognised)(const Source& source);
  Result<Sets> (*read)(const Source& source);  ///< without sets where the file has no rows
};

extern const OwnStructure vernier_format, labview, peer;

/// The first one that recognises a file reads it.
inline constexpr std::array own_structures{&vernier_format, &labview, &peer};

}  // namespace cromer::core::dialects
