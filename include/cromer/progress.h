// Watching long work, and ending it early.
#pragma once

#include <functional>

namespace cromer {

/// Called up to twenty times a second, from a working thread, with the share done, 0 to 1. Returning false
/// ends the work: what exists by then comes back, with `interrupted` true. May be empty.
using Progress = std::function<bool(double done)>;

}  // namespace cromer
