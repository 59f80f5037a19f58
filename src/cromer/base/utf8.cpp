#include "cromer/record/dialects/utf8.h"

namespace cromer::dialects {
namespace {

/// Bytes of the valid UTF-8 sequence that begins at `i`, 0 if there is none.
std::size_t sequence_length(std::string_view s, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < s.size() ? static_cast<unsigned char>(s[k]) : 0u; };
  const auto follows = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(i);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return follows(i + 1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && byte(i + 1) < 0xA0;
    const bool surrogate = lead == 0xED && byte(i + 1) > 0x9F;
    return follows(i + 1) && follows(i + 2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && byte(i + 1) < 0x90;
    const bool beyond = lead == 0xF4 && byte(i + 1) > 0x8F;
    return follows(i + 1) && follows(i + 2) && follows(i + 3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

}  // namespace

bool is_utf8(std::string_view s) {
  for (std::size_t i = 0; i < s.size();) {
    if (i + 8 <= s.size()) {  // eight plain bytes at a time
      unsigned char high = 0;
      for (std::size_t k = 0; k < 8; ++k)
        high = static_cast<unsigned char>(high | static_cast<unsigned char>(s[i + k]));
      if (high < 0x80) {
        i += 8;
        continue;
      }
    }
    const std::size_t length = sequence_length(s, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto follow = [&](unsigned shift) { add(0x80u | ((code >> shift) & 0x3Fu)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0u | (code >> 6));
    follow(0);
  } else if (code < 0x10000) {
    add(0xE0u | (code >> 12));
    follow(6);
    follow(0);
  } else {
    add(0xF0u | (code >> 18));
    follow(12);
    follow(6);
    follow(0);
  }
}

}  // namespace cromer::dialects
