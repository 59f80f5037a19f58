// The first 128 bits of powers of five, which are needed to read decimal numbers. They are computed when the
// core starts: a table would be 10 kB more to load, and does not compress.
//
// D. Lemire, "Number parsing at a gigabyte per second", Software: Practice and Experience 51 (2021)
// 1700-1727.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cromer::core::page {

/// A whole number of up to 1152 bits, in words of 32 bits, the lowest first.
class LongNumber {
 public:
  /// 2^exponent
  constexpr explicit LongNumber(int exponent) { limbs_[index(exponent / 32)] = 1u << exponent % 32; }

  constexpr void multiply_by_5() {
    std::uint64_t carry = 0;
    for (std::uint32_t& limb : limbs_) {
      carry += 5ull * limb;
      limb = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }

  /// Drops the remainder.
  constexpr void divide_by_5() {
    std::uint64_t rest = 0;
    for (std::size_t i = limbs_.size(); i-- > 0;) {
      rest = rest << 32 | limbs_[i];
      limbs_[i] = static_cast<std::uint32_t>(rest / 5);
      rest %= 5;
    }
  }

  /// The first 128 bits, the upper 64 first; a shorter number is filled up with zeros.
  constexpr std::array<std::uint64_t, 2> first_bits() const {
    int highest = static_cast<int>(limbs_.size()) * 32 - 1;
    while (!bit(highest)) --highest;
    std::array<std::uint64_t, 2> first{};
    for (int i = 0; i < 128; ++i) {
      std::uint64_t& half = first[i < 64 ? 0 : 1];
      half = half << 1 | (i <= highest && bit(highest - i) ? 1 : 0);
    }
    return first;
  }

 private:
  static constexpr std::size_t index(int limb) { return static_cast<std::size_t>(limb); }
  constexpr bool bit(int place) const { return limbs_[index(place / 32)] >> place % 32 & 1; }

  std::array<std::uint32_t, 36> limbs_{};
};

/// 5^least to 5^most, two numbers each; rounded down, except 5^-27 to 5^-1, which are rounded up.
template <int least, int most>
std::array<std::uint64_t, 2 * (most - least + 1)> powers_of_five() {
  std::array<std::uint64_t, 2 * (most - least + 1)> powers;
  const auto put = [&](int power, const std::array<std::uint64_t, 2>& first) {
    const auto at = static_cast<std::size_t>(2 * (power - least));
    powers[at] = first[0];
    powers[at + 1] = first[1];
  };
  LongNumber positive(0);
  for (int power = 0; power <= most; ++power, positive.multiply_by_5()) put(power, positive.first_bits());
  // The quotient keeps at least 200 bits.
  LongNumber negative(1100);
  for (int power = -1; power >= least; --power) {
    negative.divide_by_5();
    auto first = negative.first_bits();
    // None of these ends in 64 ones, so there is no carry.
    if (power >= -27) ++first[1];
    put(power, first);
  }
  return powers;
}

}  // namespace cromer::core::page
