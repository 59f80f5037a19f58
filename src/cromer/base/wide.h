// Loops over long arrays, with as many numbers at a time as the processor takes. Each number is made by the
// same operations whatever their count, so results are the same to the bit on every machine (products and
// sums are not contracted).
#pragma once

#include <cstddef>

// The loop is compiled for each set where the compiler can do that within a function.
#if defined(__x86_64__) && defined(__GNUC__)
#define CROMER_WIDE_LOOPS 1
#endif

namespace cromer::core {

#ifdef CROMER_WIDE_LOOPS
enum class InstructionSet { sse2, avx2, avx512 };

inline InstructionSet widest_here() {
  static const InstructionSet widest = [] {
    if (__builtin_cpu_supports("avx512f")) return InstructionSet::avx512;
    return __builtin_cpu_supports("avx2") ? InstructionSet::avx2 : InstructionSet::sse2;
  }();
  return widest;
}

template <class Body>
[[gnu::target("avx512f"), gnu::noinline]] Body loop_by_avx512(std::size_t size, Body body) {
  for (std::size_t i = 0; i < size; ++i) body(i);
  return body;
}
template <class Body>
[[gnu::target("avx2"), gnu::noinline]] Body loop_by_avx2(std::size_t size, Body body) {
  for (std::size_t i = 0; i < size; ++i) body(i);
  return body;
}
#endif

/// Calls body(i) for each i below size, and returns it with what it has gathered.
template <class Body>
Body for_each_index(std::size_t size, Body body) {
#ifdef CROMER_WIDE_LOOPS
  constexpr std::size_t few = 16;
  if (size > few) {
    const InstructionSet widest = widest_here();
    if (widest == InstructionSet::avx512) return loop_by_avx512(size, body);
    if (widest == InstructionSet::avx2) return loop_by_avx2(size, body);
  }
#endif
  for (std::size_t i = 0; i < size; ++i) body(i);
  return body;
}

}  // namespace cromer::core
