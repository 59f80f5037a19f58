// What followed in each context: counters of eight contexts at a time.
#pragma once

#include "contexts.h"
#include "eight.h"

namespace cromer::pack {

/// How often a bit was 1: 2048 + counter / 16 in 4096. The lowest four bits count how often it was seen.
using Counter = std::int16_t;

inline constexpr int most_seen = 10;

inline Eight chance_of(Eight counters) { return wasm_i16x8_shr(counters, 4); }
inline Eight seen_of(Eight counters) { return wasm_v128_and(counters, all(15)); }

/// By less the more it has seen: by 1 / (n + 1.1) of what it was off.
inline Eight learnt(Eight counters, bool bit) {
  // The shares, of 128.
  const Eight shares = wasm_i8x16_const(116, 60, 41, 31, 25, 20, 18, 15, 14, 12, 11, 0, 0, 0, 0, 0);
  const Eight chance = chance_of(counters), seen = seen_of(counters);
  const Eight share = wasm_i16x8_shl(wasm_i8x16_swizzle(shares, seen), 8);
  const Eight off = wasm_i16x8_shl(wasm_i16x8_sub(all(bit ? 2047 : -2048), chance), 3);
  const Eight now = wasm_i16x8_add(chance, wasm_i16x8_shr(product(off, share), 3));
  return wasm_v128_or(wasm_i16x8_shl(now, 4), wasm_i16x8_min(wasm_i16x8_add(seen, all(1)), all(most_seen)));
}

/// The counters of half a byte in one context: one for each course of its bits.
struct HalfByte {
  std::int16_t check;
  Counter after[15];
};

class Counters {
 public:
  /// Those of half a byte. `hashes`: of the contexts; `known`: 1, then the bits of the byte's first half.
  void find(const std::uint32_t (&hashes)[contexts], std::uint32_t known, HalfByte* (&found)[contexts]) {
    const Eight low = mixed(hashes, known), high = mixed(hashes + 4, known);
    found[0] = half_byte(0, wasm_u32x4_extract_lane(low, 0));
    found[1] = half_byte(1, wasm_u32x4_extract_lane(low, 1));
    found[2] = half_byte(2, wasm_u32x4_extract_lane(low, 2));
    found[3] = half_byte(3, wasm_u32x4_extract_lane(low, 3));
    found[4] = half_byte(4, wasm_u32x4_extract_lane(high, 0));
    found[5] = half_byte(5, wasm_u32x4_extract_lane(high, 1));
    found[6] = half_byte(6, wasm_u32x4_extract_lane(high, 2));
    found[7] = half_byte(7, wasm_u32x4_extract_lane(high, 3));
  }

 private:
  /// Four at once.
  static Eight mixed(const std::uint32_t* hashes, std::uint32_t known) {
    Eight hash = wasm_i32x4_add(wasm_v128_load(hashes), wasm_u32x4_splat(known * 0x3d4d51cbu));
    hash = wasm_i32x4_mul(hash, wasm_u32x4_splat(0x9e3779b1u));
    hash = wasm_v128_xor(hash, wasm_u32x4_shr(hash, 15));
    hash = wasm_i32x4_mul(hash, wasm_u32x4_splat(0x85ebca6bu));
    return wasm_v128_xor(hash, wasm_u32x4_shr(hash, 13));
  }

  /// Where others were, these begin anew. Without a branch: it would be guessed wrongly too often.
  HalfByte* half_byte(std::size_t context, std::uint32_t hash) {
    HalfByte* const place = &table_[context << table_bits | hash >> (32 - table_bits)];
    const Eight first = wasm_v128_load(place), second = wasm_v128_load(&place->after[7]);
    const Eight check = all(static_cast<int>(hash));
    Eight same = wasm_i16x8_eq(first, check);
    same = wasm_i16x8_shuffle(same, same, 0, 0, 0, 0, 0, 0, 0, 0);
    const Eight only_check = wasm_v128_and(check, wasm_i16x8_const(-1, 0, 0, 0, 0, 0, 0, 0));
    wasm_v128_store(place, wasm_v128_or(wasm_v128_and(first, same), only_check));
    wasm_v128_store(&place->after[7], wasm_v128_and(second, same));
    return place;
  }

  static constexpr int table_bits = 16;

  alignas(64) HalfByte table_[contexts << table_bits] = {};
};

}  // namespace cromer::pack
