// Mixes what the contexts say of a bit: a sum of their log odds, by weights that learn.
//
// M. V. Mahoney, "Adaptive weighing of context models for lossless data compression", Florida Institute of
// Technology, Technical Report CS-2005-16, 2005.
#pragma once

#include <cstddef>

#include "eight.h"

namespace cromer::pack {

/// Log odds, of 256, and probabilities, of 65536.
class Odds {
 public:
  Odds() {
    // By exp(24 / 4096) from one to the next.
    const double x = 24.0 / 4096, step = 1 + x * (1 + x / 2 * (1 + x / 3 * (1 + x / 4)));
    double odds = 1, before = 0.5;
    int k = 0;
    for (int i = 0; i < 2048; ++i, odds *= step) {
      const double p = odds / (1 + odds);
      const int least = 2, of_65536 = static_cast<int>(p * 65536);
      probabilities_[2048 + i] =
          static_cast<std::uint16_t>(of_65536 < 65536 - least ? of_65536 : 65536 - least);
      probabilities_[2047 - i] = static_cast<std::uint16_t>(65536 - probabilities_[2048 + i]);
      // Between them lie those of the counters' chances.
      for (; k < 2048 && chance(k) <= p; ++k) {
        const double place = i - (p - chance(k)) / (p - before);
        logits[2048 + k] = static_cast<std::int16_t>(i == 0 ? 0 : place * (24.0 / 4096 * 256));
        logits[2047 - k] = static_cast<std::int16_t>(-logits[2048 + k]);
      }
      before = p;
    }
  }

  /// Of chances of so many in 4096.
  std::int16_t logits[4096] = {};
  /// `logit`: of 4096 / 24.
  int probability(int logit) const {
    const int place = logit + 2048;
    return probabilities_[place < 0 ? 0 : place > 4095 ? 4095 : place];
  }

 private:
  static double chance(int k) { return (2048.5 + k) / 4096; }

  std::uint16_t probabilities_[4096];
};

inline constexpr std::size_t inputs = 3;  // times eight

struct Weights {
  Eight of[inputs] = {all(98 * 32), all(0), all(3000)};
};

/// The log odds, of 4096 / 24. Two sets of weights are added up.
inline int mixed(const Eight (&input)[inputs], const Weights& a, const Weights& b) {
  Eight total = wasm_i32x4_splat(0);
  for (std::size_t i = 0; i < inputs; ++i)
    total = wasm_i32x4_add(total, wasm_i32x4_dot_i16x8(input[i], sum(a.of[i], b.of[i])));
  total = wasm_i32x4_add(total, wasm_i32x4_shuffle(total, total, 2, 3, 0, 1));
  total = wasm_i32x4_add(total, wasm_i32x4_shuffle(total, total, 1, 0, 3, 2));
  return (wasm_i32x4_extract_lane(total, 0) >> 8) * 341 >> 16;
}

/// Towards what would have said it better.
inline void learn(const Eight (&input)[inputs], Weights& a, Weights& b, int error) {
  for (std::size_t i = 0; i < inputs; ++i) {
    const Eight step = product(input[i], all(error));
    a.of[i] = sum(a.of[i], step);
    b.of[i] = sum(b.of[i], step);
  }
}

}  // namespace cromer::pack
