// PEER strong-motion records: .AT2 (acceleration, g), .VT2 (velocity, cm/s), .DT2 (displacement, cm). Header
// lines with the quantity, the number of values NPTS and the step DT; then several values a line.
// Source: PEER NGA databases; older records write "4096 0.01 NPTS, DT", records of the NRC have seven lines.
#pragma once

#include "cromer/read/sets.h"

namespace cromer::core::dialects {

bool is_peer(const Source& source);

/// Reads values one after the other, up to NPTS, even if nothing but a minus sign separates them.
Result<Sets> read_peer(const Source& source);

}  // namespace cromer::core::dialects
