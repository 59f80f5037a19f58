// The latest place where the bytes before were the same: what followed there is expected here.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cromer::pack {

class Match {
 public:
  explicit Match(const std::uint8_t* bytes) : bytes_(bytes) {}

  /// Bytes that are the same, 31 at most; 0 without a match.
  std::size_t length() const { return length_ < 31 ? length_ : 31; }
  std::uint8_t next() const { return bytes_[place_]; }

  /// After `count` bytes, the last of which are `recent`.
  void take(std::size_t count, std::uint64_t recent) {
    if (length_ > 0 && next() == bytes_[count - 1]) {
      ++length_;
      ++place_;
    } else {
      length_ = 0;
    }
    const std::uint32_t hash = static_cast<std::uint32_t>(recent) * 0x9e3779b1u +
                               static_cast<std::uint8_t>(recent >> 32) * 0x85ebca6bu;
    std::uint32_t& last = last_[(hash ^ hash >> 15) * 0x2c1b3c6du >> (32 - table_bits)];
    if (length_ == 0) {
      place_ = last;
      while (length_ < 31 && length_ < place_ && bytes_[place_ - 1 - length_] == bytes_[count - 1 - length_])
        ++length_;
      if (length_ < shortest) length_ = 0;
    }
    last = static_cast<std::uint32_t>(count);
  }

 private:
  static constexpr int table_bits = 18;
  static constexpr std::size_t shortest = 5;

  const std::uint8_t* bytes_;
  std::size_t place_ = 0, length_ = 0;
  /// By the hash of five bytes, where they were last.
  std::uint32_t last_[1 << table_bits] = {};
};

}  // namespace cromer::pack
