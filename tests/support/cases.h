// How many cases a long test looks at. The sanitizers watch the memory, which a few cases show as well as
// many.
#pragma once

#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <vector>

namespace cromer::core {

/// All of that number; a quarter, and at least one, where a sanitizer slows every step.
template <std::integral Number>
constexpr Number cases(Number all) {
#ifdef CROMER_SANITIZED
  return std::max<Number>(1, all / 4);
#else
  return all;
#endif
}

/// So many from the front of the list.
template <class T>
std::vector<T> cases(std::initializer_list<T> all) {
  return std::vector<T>(all.begin(), all.begin() + cases(static_cast<int>(all.size())));
}

}  // namespace cromer::core
