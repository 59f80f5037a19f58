// Eight numbers of 16 bits in one register. Fractions are of 32768.
#pragma once

#include <wasm_simd128.h>

#include <cstdint>

namespace cromer::pack {

using Eight = v128_t;

inline Eight all(int value) { return wasm_i16x8_splat(static_cast<std::int16_t>(value)); }
inline Eight sum(Eight a, Eight b) { return wasm_i16x8_add_sat(a, b); }
inline Eight product(Eight a, Eight b) { return wasm_i16x8_q15mulr_sat(a, b); }

/// The numbers at eight places.
inline Eight gather(const std::int16_t* const (&at)[8]) {
  return wasm_i16x8_make(*at[0], *at[1], *at[2], *at[3], *at[4], *at[5], *at[6], *at[7]);
}

inline void scatter(Eight values, std::int16_t* const (&at)[8]) {
  *at[0] = wasm_i16x8_extract_lane(values, 0);
  *at[1] = wasm_i16x8_extract_lane(values, 1);
  *at[2] = wasm_i16x8_extract_lane(values, 2);
  *at[3] = wasm_i16x8_extract_lane(values, 3);
  *at[4] = wasm_i16x8_extract_lane(values, 4);
  *at[5] = wasm_i16x8_extract_lane(values, 5);
  *at[6] = wasm_i16x8_extract_lane(values, 6);
  *at[7] = wasm_i16x8_extract_lane(values, 7);
}

/// function of each, which is none below zero.
template <class Function>
Eight each(Eight values, const Function& function) {
  const auto of = [&](unsigned value) { return static_cast<std::int16_t>(function(value)); };
  return wasm_i16x8_make(of(wasm_u16x8_extract_lane(values, 0)), of(wasm_u16x8_extract_lane(values, 1)),
                         of(wasm_u16x8_extract_lane(values, 2)), of(wasm_u16x8_extract_lane(values, 3)),
                         of(wasm_u16x8_extract_lane(values, 4)), of(wasm_u16x8_extract_lane(values, 5)),
                         of(wasm_u16x8_extract_lane(values, 6)), of(wasm_u16x8_extract_lane(values, 7)));
}

}  // namespace cromer::pack
