// Two pieces of work at once.
#pragma once

#ifndef CROMER_PAGE
#include <system_error>
#include <thread>
#endif

namespace cromer::core {

/// Does both, on two threads where threads are to be had. Neither may throw, nor write what the other reads.
template <class One, class Other>
void both(const One& one, const Other& other) {
#ifndef CROMER_PAGE
  try {
    std::thread beside(other);
    one();
    beside.join();
    return;
  } catch (const std::system_error&) {  // no thread was begun
  }
#endif
  one();
  other();
}

}  // namespace cromer::core
