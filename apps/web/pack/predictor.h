// Predicts a module, bit by bit: so that the less is stored the better it is predicted.
#pragma once

#include "counters.h"
#include "match.h"
#include "mixer.h"

namespace cromer::pack {

class Predictor {
 public:
  /// `bytes`: where the module is or comes to be; what was not yet taken is not read.
  explicit Predictor(const std::uint8_t* bytes) : match_(bytes) { begin_byte(); }

  /// The next byte. code(p, bit) says whether its bit (7 first) is 1; p of 65536 is how likely that is.
  template <class Code>
  [[gnu::noinline]] std::uint8_t byte(const Code& code) {
    std::uint32_t known = 1;
    std::size_t course = 0;
    for (int bit = 7; bit >= 0; --bit) {
      if (bit == 3) {
        counters_.find(hashes_, known, halves_);
        course = 0;
      }
      // The processor guesses which way it goes, rightly nine times in ten, and does not wait.
      if (bit_is_1(bit, course, code)) {
        known = 2 * known + 1;
        course = 2 * course + 2;
      } else {
        known = 2 * known;
        course = 2 * course + 1;
      }
    }
    return static_cast<std::uint8_t>(known);
  }

  /// After that.
  void take(std::uint8_t byte) {
    walk_.take(byte);
    match_.take(++count_, walk_.recent());
    begin_byte();
  }

 private:
  void begin_byte() {
    contexts_of(walk_, hashes_);
    counters_.find(hashes_, 0, halves_);
    place_ = walk_.in_code() ? static_cast<std::size_t>(walk_.part()) << 3 | (walk_.place() & 7)
                             : 200u + (static_cast<std::size_t>(walk_.section()) & 15);
    instruction_ =
        walk_.in_code() && walk_.part() == Part::instruction ? walk_.instructions() & 0xff : 0x100 + place_;
    matches_ = match_.length() > 0;
    expected_byte_ = match_.next();
    rate_ = 10608 + static_cast<int>(49'152'000 / (8192 + count_));
  }

  template <class Code>
  [[gnu::always_inline]] bool bit_is_1(int bit, std::size_t course, const Code& code) {
    Counter* at[contexts];
    for (std::size_t i = 0; i < contexts; ++i) at[i] = &halves_[i]->after[course];
    const Eight counters = gather(at), chance = chance_of(counters);
    // The surer the more often it was seen.
    const Eight sure = product(wasm_i16x8_shl(chance, 3), wasm_i16x8_shl(seen_of(counters), 7));
    const bool expected = expected_byte_ >> bit & 1;
    Counter& matched = matched_[match_.length()];
    const Eight match = said_by_match(matched, expected);
    const Eight input[inputs] = {
        each(wasm_i16x8_add(chance, all(2048)), [&](unsigned c) { return odds_.logits[c]; }), sure, match};
    Weights& by_match = by_match_[place_][matches_ ? 1 + match_.length() / 11 : 0];
    Weights& by_bit = by_bit_[instruction_][bit];
    const int p = odds_.probability(mixed(input, by_match, by_bit));

    const auto learn_from = [&](bool one) __attribute__((always_inline)) {
      learn(input, by_match, by_bit, (((one ? 65536 : 0) - p) * rate_) >> 16);
      scatter(learnt(counters, one), at);
      if (!matches_) return;
      matched = learnt(matched, expected == one);
      matches_ = expected == one;
    };
    const bool one = code(p, bit);
    if (one)
      learn_from(true);
    else
      learn_from(false);
    return one;
  }

  Eight said_by_match(Counter counter, bool expected) const {
    if (!matches_) return wasm_i16x8_const(0, 0, 80, 0, 0, 0, 0, 0);
    const int chance = counter >> 4, sign = expected ? 1 : -1;
    return wasm_i16x8_make(sign * odds_.logits[2048 + chance], sign * (chance / 4), 80, 0, 0, 0, 0, 0);
  }

  /// Of a match; slower than the others.
  static Counter learnt(Counter counter, bool right) {
    const int chance = counter >> 4, seen = counter & 15;
    const int now = chance + ((right ? 2047 : -2048) - chance) / (2 * seen + 3);
    return static_cast<Counter>(now * 16 + (seen < 15 ? seen + 1 : 15));
  }
  static Eight learnt(Eight counters, bool bit) { return pack::learnt(counters, bit); }

  std::size_t count_ = 0;
  ModuleWalk walk_;
  Match match_;
  bool matches_ = false;
  std::uint8_t expected_byte_ = 0;
  /// By the length of the match: whether it was right.
  Counter matched_[32] = {};
  Odds odds_;
  Counters counters_;
  alignas(16) std::uint32_t hashes_[contexts];
  HalfByte* halves_[contexts];
  std::size_t place_ = 0, instruction_ = 0;
  int rate_ = 0;
  Weights by_match_[256][4], by_bit_[512][8];
};

}  // namespace cromer::pack
