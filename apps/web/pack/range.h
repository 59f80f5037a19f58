// The interval that a stream of bits narrows down, each by its probability.
#pragma once

#include <cstdint>

namespace cromer::pack {

struct Range {
  std::uint32_t first = 0, last = 0xffffffff;

  /// Where those end that stand for 1. `p`: of 65536.
  std::uint32_t split(int p) const { return first + ((last - first) >> 16) * static_cast<std::uint32_t>(p); }
  void narrow(std::uint32_t split, bool one) {
    if (one)
      last = split;
    else
      first = split + 1;
  }
  /// Whether its first byte is known.
  bool known() const { return (first ^ last) >> 24 == 0; }
  void widen() {
    first <<= 8;
    last = last << 8 | 255;
  }
};

}  // namespace cromer::pack
