// Which of several things belong together, where that is known pair by pair (B. A. Galler & M. J. Fisher,
// Commun. ACM 7, 301 (1964)).
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace cromer::core {

/// Sets of the numbers from 0 to before `size`, each by itself at first.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : next_(size) {
    std::iota(next_.begin(), next_.end(), std::size_t{0});
  }

  /// The member that stands for i's set.
  std::size_t leader(std::size_t i) {
    while (next_[i] != i) i = next_[i] = next_[next_[i]];
    return i;
  }

  /// Makes one set of two; the leader of b's leads it.
  void join(std::size_t a, std::size_t b) { next_[leader(a)] = leader(b); }

 private:
  std::vector<std::size_t> next_;  ///< towards the leader
};

}  // namespace cromer::core
