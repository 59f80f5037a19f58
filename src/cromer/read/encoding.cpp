#include "cromer/read/encoding.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cromer/base/concat.h"
#include "cromer/base/utf8.h"
#include "cromer/result.h"

namespace cromer::core::dialects {
namespace {

/// Text in units of two bytes.
struct Utf16 {
  std::string_view units;  ///< behind the byte order mark
  bool marked = false;     ///< it begins with a byte order mark
  bool big = false;        ///< the high byte of a unit stands first
};

/// Whether the high byte stands first: in plain letters and digits of two bytes each, nearly every second
/// byte is zero and no other. Nothing if the text does not begin like that.
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

/// UTF-16 by its byte order mark, else by its zeros.
std::optional<Utf16> find_utf16(std::string_view bytes) {
  for (const bool big : {false, true})
    if (bytes.starts_with(big ? "\xFE\xFF" : "\xFF\xFE")) return Utf16{bytes.substr(2), true, big};
  const auto big = big_end_first(bytes);
  if (!big) return std::nullopt;
  return Utf16{bytes, false, *big};
}

/// As UTF-8. Half a surrogate pair, a zero, and half a unit at the end, are an Error that names byte and
/// line.
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

/// "UTF-16 LE", "UTF-16 BE with BOM".
std::string utf16_name(const Utf16& text) {
  return concat({"UTF-16 ", text.big ? "BE" : "LE", text.marked ? " with BOM" : ""});
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
    append_utf8(utf8, byte >= 0x80 && byte < 0xA0 ? cp1252[byte - 0x80u] : byte);
  }
  return utf8;
}

}  // namespace

Result<Decoded> decode(std::string_view bytes) {
  if (bytes.empty()) return Error{"empty_file"};
  if (const auto wide = find_utf16(bytes)) {
    auto text = from_utf16(*wide);
    if (!text) return text.error();
    if (text->empty()) return Error{"empty_file"};
    return Decoded{std::move(*text), {}, utf16_name(*wide)};
  }
  if (bytes.starts_with("PK\x03\x04")) return Error{"archive_or_spreadsheet"};
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const bool marked = bytes.starts_with(mark);
  const std::string_view body = marked ? bytes.substr(mark.size()) : bytes;
  if (const std::size_t zero = body.find('\0'); zero != std::string_view::npos)
    return Error{"binary_file", {{"offset", zero}}};
  if (is_utf8(body)) return Decoded{{}, body, marked ? "UTF-8 with BOM" : "UTF-8"};
  return Decoded{from_cp1252(body), {}, "cp1252"};
}

}  // namespace cromer::core::dialects
