#include "cromer/read/encoding.h"

#include <array>
#include <cstdint>

#include "cromer/base/utf8.h"
#include "cromer/read/utf16.h"

namespace cromer::core::dialects {
namespace {

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
