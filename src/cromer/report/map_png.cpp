#include "cromer/report/map_png.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

constexpr char blank = 0;  // of the palette; the colours follow
constexpr int colours = 255;

char colour_index(double value) {
  if (!std::isfinite(value)) return blank;
  return static_cast<char>(1 + std::lround(std::clamp(value, 0.0, 1.0) * (colours - 1)));
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& content) {
  const std::string checked = type + content;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return big_endian(static_cast<std::uint32_t>(content.size())) + checked +
         big_endian(static_cast<std::uint32_t>(sum));
}

std::string palette_bytes() {
  std::string bytes(3, '\xFF');  // of the blank
  for (int i = 0; i < colours; ++i) {
    const long rgb = std::strtol(map_colour(i / (colours - 1.0)).c_str() + 1, nullptr, 16);
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(rgb >> shift & 0xFF);
  }
  return bytes;
}

/// Each row begins with a byte that says it is not filtered; PNG has the highest row first.
std::string rows_of_indices(const std::vector<double>& values, int columns, int rows) {
  std::string bytes;
  for (int row = rows - 1; row >= 0; --row) {
    bytes += '\0';
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row) * columns;
    std::transform(first, first + columns, std::back_inserter(bytes), colour_index);
  }
  return bytes;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string map_png(const std::vector<double>& values, int columns, int rows) {
  const std::string eight_bits_of_a_palette("\x08\x03\0\0\0", 5);
  return "\x89PNG\r\n\x1A\n" +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(columns)) +
                           big_endian(static_cast<std::uint32_t>(rows)) + eight_bits_of_a_palette) +
         chunk("PLTE", palette_bytes()) + chunk("tRNS", std::string(1, '\0')) +
         chunk("IDAT", deflated(rows_of_indices(values, columns, rows))) + chunk("IEND", "");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace cromer::core
