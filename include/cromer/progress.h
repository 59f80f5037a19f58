// Watching long work, and ending it early.
#pragma once

#include <functional>

namespace cromer {

/// Called up to twenty times a second with the share done, 0 to 1: from the calling thread or from one that
/// works for it, never from two at once. Returning false ends the work: what exists by then comes back, with
/// `interrupted` true. May be empty.
using Progress = std::function<bool(double done)>;

}  // namespace cromer
