// The eight contexts in which the bytes of a module are predicted: what came before, in one way or another.
#pragma once

#include <cstddef>

#include "module_walk.h"

namespace cromer::pack {

inline constexpr std::size_t contexts = 8;

/// A number for each context.
inline void contexts_of(const ModuleWalk& walk, std::uint32_t* hashes) {
  std::size_t count = 0;
  const std::uint32_t where = walk.in_code()
                                  ? (static_cast<std::uint32_t>(walk.part()) << 4 | walk.place()) + 1
                                  : 0x1000u + static_cast<std::uint32_t>(walk.section());
  const std::uint32_t known = (where * 0x2c1b3c6du ^ (walk.in_code() ? walk.operand() : 0)) * 0x297a2d39u;
  const auto add = [&](std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    std::uint32_t hash = known + a * 0x9e3779b1u + b * 0x85ebca6bu + c * 0xc2b2ae35u;
    hash = (hash ^ hash >> 15) * 0x2c1b3c6du;
    hashes[count] = hash + static_cast<std::uint32_t>(count) * 0x3d4d51cbu;
    ++count;
  };
  const auto bytes = [&](int number) { return walk.recent() & ((std::uint64_t{1} << 8 * number) - 1); };
  const auto last = [&](int number) {
    const std::uint64_t value = bytes(number);
    add(static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32));
  };
  if (walk.in_code()) {
    const std::uint32_t last_four = walk.instructions(), last_two = last_four & 0xffff;
    add(0);
    last(2);
    add(last_two, 1);
    add(last_four, 2);
    add(last_four & 0xff, 3, walk.function());
    add(last_four, 4, walk.older_instructions());
    add(last_two, walk.last_local() + 5, walk.function());
    add(last_two, walk.last_call() + 5);
  } else {
    for (int number = 0; number < 7; ++number) last(number);
    add(walk.word());
  }
}

}  // namespace cromer::pack
