#include "cromer/record/dialects/encoding.h"

#include <algorithm>
#include <array>
#include <cstdint>

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

/// Windows code page 1252, 0x80 to 0x9F; the five holes become the replacement character.
constexpr std::array<std::uint16_t, 32> cp1252{
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::string from_cp1252(std::string_view s) {
  std::string utf8;
  utf8.reserve(s.size() + s.size() / 8);
  for (const char c : s) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
      continue;
    }
    const unsigned code = byte < 0xA0 ? cp1252[byte - 0x80u] : byte;
    if (code < 0x800) {
      utf8 += static_cast<char>(0xC0u | (code >> 6));
    } else {
      utf8 += static_cast<char>(0xE0u | (code >> 12));
      utf8 += static_cast<char>(0x80u | ((code >> 6) & 0x3Fu));
    }
    utf8 += static_cast<char>(0x80u | (code & 0x3Fu));
  }
  return utf8;
}

/// Every second byte of the beginning is zero, and no other: plain letters and digits in two bytes each.
bool looks_utf16(std::string_view bytes) {
  const std::size_t looked_at = std::min<std::size_t>(bytes.size() & ~std::size_t{1}, 512);
  std::size_t even = 0, odd = 0;
  for (std::size_t i = 0; i < looked_at; i += 2) {
    even += bytes[i] == '\0';
    odd += bytes[i + 1] == '\0';
  }
  const std::size_t pairs = looked_at / 2;
  return pairs > 1 && ((even == 0 && 10 * odd >= 9 * pairs) || (odd == 0 && 10 * even >= 9 * pairs));
}

}  // namespace

Result<Decoded> decode(std::string_view bytes) {
  if (bytes.empty()) return Error{"the file is empty"};
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") || looks_utf16(bytes))
    return Error{"the text is UTF-16: save it as UTF-8 (Notepad: Save as, Encoding)"};
  if (bytes.starts_with("PK\x03\x04"))
    return Error{"this is a ZIP archive or a spreadsheet: unpack it, or export the sheet as CSV"};
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const bool marked = bytes.starts_with(mark);
  const std::string_view body = marked ? bytes.substr(mark.size()) : bytes;
  if (const std::size_t zero = body.find('\0'); zero != std::string_view::npos)
    return Error{"this is a binary file (a zero byte at offset " + std::to_string(zero) +
                 "): a text or CSV file is expected"};
  if (is_utf8(body)) return Decoded{{}, body, marked ? "UTF-8 with BOM" : "UTF-8"};
  return Decoded{from_cp1252(body), {}, "cp1252"};
}

}  // namespace cromer::dialects
