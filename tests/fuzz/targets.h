// What is fuzzed beside recordings: each takes any bytes and aborts where what it must keep is broken.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cromer::core::fuzz {

using Target = int (*)(const std::uint8_t* data, std::size_t size);

/// Lines of a device, in one piece and in pieces: the same rows, finite times, memory for a line at most.
int live_lines(const std::uint8_t* data, std::size_t size);
/// A quantity with its unit: a finite value, no negative uncertainty, and what is printed of it reads back.
int quantity(const std::uint8_t* data, std::size_t size);
/// A study file: a study, or an Error that is UTF-8 and says something.
int study(const std::uint8_t* data, std::size_t size);

/// What a client sends to `cromer serve` at port 8000: nothing back, or an answer that is not the server's
/// fault.
int http(const std::uint8_t* data, std::size_t size);

}  // namespace cromer::core::fuzz
