#include "cromer/base/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace cromer::core {
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

/// Of one whole sequence.
std::uint32_t code_point(std::string_view sequence) {
  auto code = static_cast<std::uint32_t>(static_cast<unsigned char>(sequence.front()));
  if (sequence.size() > 1) code &= 0x7Fu >> sequence.size();
  for (const char c : sequence.substr(1)) code = (code << 6) | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

bool is_control(std::uint32_t code) {
  return (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7F && code < 0xA0);
}

/// Unicode Standard Annex 9, table of the bidirectional formatting characters; and the ends of line and
/// paragraph.
bool turns_writing(std::uint32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Replaces whatever may not be shown, a code point or a byte that is part of none, by what `replace` gives
/// for it.
template <class Replace>
std::string without_hidden(std::string_view text, const Replace& replace) {
  std::string plain;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 0x20 && byte < 0x7F) {
      ++i;
      continue;
    }
    const std::size_t length = sequence_length(text, i);
    const std::uint32_t code = length > 0 ? code_point(text.substr(i, length)) : byte;
    const std::size_t next = i + std::max<std::size_t>(length, 1);
    if (length == 0 || is_control(code) || turns_writing(code)) {
      plain += text.substr(kept, i - kept);
      plain += replace(code, length == 0);
      kept = next;
    }
    i = next;
  }
  return plain += text.substr(kept);
}

}  // namespace

std::string as_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    valid += length > 0 ? text.substr(i, length) : "\uFFFD";
    i += std::max<std::size_t>(length, 1);
  }
  return valid;
}

std::string printable(std::string_view text) {
  return without_hidden(text, [](std::uint32_t code, bool) {
    return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
  });
}

std::string printable_json(std::string_view document) {
  return without_hidden(document, [](std::uint32_t code, bool broken) {
    return broken ? std::string("\uFFFD") : fmt::format("\\u{:04x}", code);
  });
}

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

}  // namespace cromer::core
