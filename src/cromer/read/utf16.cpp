#include "cromer/read/utf16.h"

#include <algorithm>
#include <cstdint>

#include "cromer/base/concat.h"
#include "cromer/base/utf8.h"

namespace cromer::core::dialects {
namespace {

/// Every second byte of the beginning is zero, and no other: plain letters and digits in two bytes each. The
/// high byte stands first where the even bytes are the zeros.
std::optional<bool> big_end_first(std::string_view bytes) {
  const std::size_t looked_at = std::min<std::size_t>(bytes.size() & ~std::size_t{1}, 512);
  std::size_t even = 0, odd = 0;
  for (std::size_t i = 0; i < looked_at; i += 2) {
    even += bytes[i] == '\0';
    odd += bytes[i + 1] == '\0';
  }
  const std::size_t pairs = looked_at / 2;
  if (pairs > 1 && even == 0 && 10 * odd >= 9 * pairs) return false;
  if (pairs > 1 && odd == 0 && 10 * even >= 9 * pairs) return true;
  return std::nullopt;
}

}  // namespace

std::optional<Utf16> find_utf16(std::string_view bytes) {
  for (const bool big : {false, true})
    if (bytes.starts_with(big ? "\xFE\xFF" : "\xFF\xFE")) return Utf16{bytes.substr(2), true, big};
  const auto big = big_end_first(bytes);
  if (!big) return std::nullopt;
  return Utf16{bytes, false, *big};
}

Result<std::string> from_utf16(const Utf16& text) {
  const std::string_view s = text.units;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(s[i]), second = static_cast<unsigned char>(s[i + 1]);
    return text.big ? first << 8 | second : second << 8 | first;
  };
  std::string utf8;
  utf8.reserve(s.size() / 2 + s.size() / 16);
  const auto damaged = [&](Notice what, std::size_t i) {
    const auto line = 1 + std::count(utf8.begin(), utf8.end(), '\n');
    return Error{"damaged_utf16",
                 {{"what", std::move(what)}, {"byte", i + (text.marked ? 2 : 0)}, {"line", line}}};
  };
  std::size_t i = 0;
  for (; i + 1 < s.size(); i += 2) {
    std::uint32_t code = unit(i);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (surrogate) {
      const std::uint32_t low = code <= 0xDBFF && i + 3 < s.size() ? unit(i + 2) : 0;
      if (low < 0xDC00 || low > 0xDFFF) return damaged(Notice{"half_surrogate_pair"}, i);
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      i += 2;
    }
    if (code == 0)
      return damaged(Notice{"a_zero"}, i);  // whole numbers in binary, or text of four bytes a character
    append_utf8(utf8, code);
  }
  if (i < s.size()) return damaged(Notice{"half_character"}, i);
  return utf8;
}

std::string utf16_name(const Utf16& text) {
  return concat({"UTF-16 ", text.big ? "BE" : "LE", text.marked ? " with BOM" : ""});
}

}  // namespace cromer::core::dialects
