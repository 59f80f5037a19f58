#include "cromer/report/heat_map.h"

#include <zlib.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

constexpr double least_ratio = 20;  // of the largest to the smallest, for even ratios

double on_axis(double value, bool logarithmic) { return logarithmic ? std::log(value) : value; }

AxisRange range_of(const std::vector<double>& middles, bool logarithmic) {
  const double first = on_axis(middles.front(), logarithmic), last = on_axis(middles.back(), logarithmic);
  const double half = std::abs(last - first) / (2 * static_cast<double>(middles.size() - 1));
  const double low = std::min(first, last) - half, high = std::max(first, last) + half;
  AxisRange range;
  range.logarithmic = logarithmic;
  range.low = logarithmic ? std::exp(low) : low;
  range.high = logarithmic ? std::exp(high) : high;
  return range;
}

/// The nearest middle to each px, from the low end.
std::vector<std::size_t> nearest_cells(const std::vector<double>& middles, const AxisRange& range, int px) {
  std::vector<double> sorted(middles.size());
  const bool falls = middles.front() > middles.back();
  for (std::size_t i = 0; i < middles.size(); ++i)
    sorted[i] = on_axis(middles[falls ? middles.size() - 1 - i : i], range.logarithmic);
  const double low = on_axis(range.low, range.logarithmic), high = on_axis(range.high, range.logarithmic);
  std::vector<std::size_t> cells;
  for (int i = 0; i < px; ++i) {
    const double at = low + (i + 0.5) / px * (high - low);
    std::size_t above =
        static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), at) - sorted.begin());
    above = std::min(above, sorted.size() - 1);
    const std::size_t near = above > 0 && at - sorted[above - 1] < sorted[above] - at ? above - 1 : above;
    cells.push_back(falls ? middles.size() - 1 - near : near);
  }
  return cells;
}

}  // namespace

AxisRange map_x_range(const Panel& panel) { return range_of(panel.map->x, panel.x.logarithmic); }
AxisRange map_y_range(const Panel& panel) { return range_of(panel.map->y, panel.y.logarithmic); }

MapScale map_scale(const HeatMap& map) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<double>* values : {&map.z, &map.reach})
    for (const double z : *values) {
      if (!std::isfinite(z)) continue;
      low = std::min(low, z);
      high = std::max(high, z);
    }
  MapScale scale;
  if (!(low <= high)) low = 0, high = 1;
  if (low == high) high = low + (low != 0 ? 0.01 * std::abs(low) : 1);
  if (map.decades && low > 0 && high > least_ratio * low) {
    scale.range = {low, high, true};
    scale.ticks = logarithmic_ticks(low, high, 6);
    return scale;
  }
  // The bar begins at 0 if the data come near it.
  if (low > 0 && low < 0.25 * high) low = 0;
  scale.range = {low, high, false};
  scale.ticks = linear_ticks(low, high, tick_step(low, high, 6));
  return scale;
}

double MapScale::share(double z) const {
  const double bottom = on_axis(range.low, range.logarithmic), top = on_axis(range.high, range.logarithmic);
  return (on_axis(z, range.logarithmic) - bottom) / (top - bottom);
}

PlacedMap place_map(const HeatMap& map, const AxisRange& x, const AxisRange& y, const Box& frame) {
  PlacedMap placed;
  placed.columns = static_cast<int>(std::lround(frame.width));
  placed.rows = static_cast<int>(std::lround(frame.height));
  const auto across = nearest_cells(map.x, x, placed.columns), up = nearest_cells(map.y, y, placed.rows);
  const MapScale scale = map_scale(map);
  placed.values.reserve(across.size() * up.size());
  for (const std::size_t row : up)
    for (const std::size_t column : across)
      placed.values.push_back(scale.share(map.z[row * map.x.size() + column]));
  return placed;
}

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
