// LabVIEW measurement files (.lvm): a header of tags, then segments of a header of tags, names and rows.
// Source: National Instruments, "Specification for the LabVIEW Measurement File (.lvm)".
#pragma once

#include "cromer/read/sets.h"

namespace cromer::core::dialects {

bool is_labview(const Source& source);

/// Segments that continue in time are joined; others are runs. The times are the rows' X_Value, whatever
/// Delta_X says; in rows without one they are X0 + i Delta_X.
Result<Sets> read_labview(const Source& source);

}  // namespace cromer::core::dialects
