// Where bytes come in and go out.
#pragma once

#include <cstddef>
#include <cstdint>

/// A module may have so many.
inline constexpr std::size_t most_bytes = 1'200'000;

inline std::uint8_t plain_bytes[most_bytes], packed_bytes[most_bytes];

extern "C" {
__attribute__((export_name("plain"))) inline std::uint8_t* plain() { return plain_bytes; }
__attribute__((export_name("packed"))) inline std::uint8_t* packed() { return packed_bytes; }
__attribute__((export_name("most"))) inline std::size_t most() { return most_bytes; }
}
