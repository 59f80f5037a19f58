// What a call takes from the heap.
#pragma once

#include <cstddef>

#include "cromer/base/function_ref.h"

namespace cromer::core {

/// The most bytes held at any time during the call beyond those held before it, as operator new gives them:
/// a vector reserved is counted whether it is filled or not.
std::size_t most_bytes_held(FunctionRef<void()> call);

}  // namespace cromer::core
