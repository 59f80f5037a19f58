// How long work is watched, and ended early.
#pragma once

#include <functional>

namespace cromer {

/// Called up to twenty times a second, from a working thread, with the share done, 0 to 1. Returning false
/// ends the work: what exists by then comes back, its `interrupted` true. May be empty.
using Progress = std::function<bool(double done)>;

}  // namespace cromer
