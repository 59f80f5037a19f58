// Colours of maps: even steps, or even ratios where the values span decades; the PNG, taken apart again.
#include "cromer/report/heat_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <zlib.h>
#include <cmath>
#include <map>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace CROMER_FILE {

unsigned number(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

struct Chunks {
  std::string order;
  std::map<std::string, std::string> contents;
};

Chunks chunks_of(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1A\n");
  Chunks chunks;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t length = number(png, at);
    const std::string type = png.substr(at + 4, 4);
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(png.data()) + at + 4, static_cast<uInt>(length + 4));
    EXPECT_EQ(number(png, at + 8 + length), sum) << type;
    chunks.order += type + " ";
    chunks.contents[type] = png.substr(at + 8, length);
    at += length + 12;
  }
  return chunks;
}

std::string inflated(const std::string& packed, std::size_t size) {
  std::string bytes(size + 1, '\0');
  uLongf count = static_cast<uLongf>(bytes.size());
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &count,
                       reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size())),
            Z_OK);
  bytes.resize(count);
  return bytes;
}

std::string colour(const std::string& palette, std::size_t index) {
  std::string text = "#";
  for (std::size_t i = 3 * index; i < 3 * index + 3; ++i) {
    char hex[3];
    std::snprintf(hex, sizeof hex, "%02X", static_cast<unsigned char>(palette.at(i)));
    text += hex;
  }
  return text;
}

TEST(MapPng, HasItsRowsTopDownAndNoColourForWhatIsNoNumber) {
  const Chunks png = chunks_of(map_png({0, 1, 0.5, NAN, 7, -3}, 2, 3));
  EXPECT_EQ(png.order, "IHDR PLTE tRNS IDAT IEND ");
  const std::string& header = png.contents.at("IHDR");
  EXPECT_EQ(number(header, 0), 2u);
  EXPECT_EQ(number(header, 4), 3u);
  EXPECT_EQ(header.substr(8),
            std::string("\x08\x03\0\0\0", 5));  // 8 bits, of a palette, neither filter nor interlace
  const std::string expected("\0\xFF\x01\0\x80\0\0\x01\xFF", 9);
  EXPECT_EQ(inflated(png.contents.at("IDAT"), expected.size()), expected);
  EXPECT_EQ(png.contents.at("tRNS"), std::string(1, '\0'));
  EXPECT_EQ(png.contents.at("IEND"), "");
}

TEST(MapPng, ThePaletteIsTheMapsColours) {
  const std::string palette = chunks_of(map_png({0}, 1, 1)).contents.at("PLTE");
  ASSERT_EQ(palette.size(), 3 * 256u);
  EXPECT_EQ(colour(palette, 1), "#440154");
  EXPECT_EQ(colour(palette, 128), map_colour(0.5));
  EXPECT_EQ(colour(palette, 255), "#FDE725");
}

// RFC 4648, chapter 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFB\xFF\xBE"), "+/++");
}

HeatMap map_of(std::vector<double> z, bool decades) {
  return {.x = {0, 1}, .y = {0, 1}, .z = std::move(z), .name = "amplitude (m)", .decades = decades};
}

TEST(MapScale, ValuesOverDecadesGetEvenRatios) {
  const MapScale scale = map_scale(map_of({2e-3, 1, 30, 0.1}, true));
  EXPECT_TRUE(scale.range.logarithmic);
  EXPECT_DOUBLE_EQ(scale.share(2e-3), 0);
  EXPECT_DOUBLE_EQ(scale.share(30), 1);
  EXPECT_NEAR(scale.share(0.1) - scale.share(0.01), scale.share(10) - scale.share(1), 1e-15);
  std::vector<std::string> labels;
  for (const Tick& tick : scale.ticks)
    if (!tick.label.empty()) labels.push_back(tick.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"0.01", "0.1", "1", "10"}));
  EXPECT_GT(scale.ticks.size(), labels.size());
}

TEST(MapScale, OthersGetEvenSteps) {
  for (const HeatMap& map : {map_of({2e-3, 1, 30, 0.1}, false), map_of({0, 1, 30, 0.1}, true),
                             map_of({-1, 1, 30, 0.1}, true), map_of({1.51, 2, 30, 2}, true)}) {
    const MapScale scale = map_scale(map);
    EXPECT_FALSE(scale.range.logarithmic);
    for (const Tick& tick : scale.ticks) EXPECT_NE(tick.label, "");
    EXPECT_DOUBLE_EQ(scale.share((scale.range.low + scale.range.high) / 2), 0.5);
  }
}

TEST(MapScale, ReachesToWhatIsBesideIt) {
  HeatMap map = map_of({1, 2, 3, 4}, true);
  map.reach = {0.01, 8};
  EXPECT_EQ(map_scale(map).range.low, 0.01);
  EXPECT_EQ(map_scale(map).range.high, 8);
}

TEST(MapScale, TheMapIsColouredByIt) {
  const HeatMap map = map_of({0.01, 0.1, 1, 10}, true);
  Panel panel;
  panel.map = map;
  const PlacedMap placed = place_map(map, map_x_range(panel), map_y_range(panel), {0, 0, 2, 2});
  ASSERT_EQ(placed.values.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(placed.values[i], static_cast<double>(i) / 3, 1e-14);
}

PlacedMap placed(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                 const Box& frame, bool logarithmic = false) {
  Panel panel;
  panel.map = HeatMap{.x = x, .y = y, .z = z, .name = ""};
  panel.x.logarithmic = logarithmic;
  return place_map(*panel.map, map_x_range(panel), map_y_range(panel), frame);
}

TEST(HeatMaps, EveryCellStandsAtItsMiddle) {
  // Two px a cell; the values are shares already.
  const std::vector<double> z{0, 0.25, 0.5, 0.75, 1, 0.125};
  const PlacedMap map = placed({1, 2, 3}, {10, 20}, z, {5, 7, 6, 4});
  EXPECT_EQ(map.columns, 6);
  EXPECT_EQ(map.rows, 4);
  const std::vector<double> low{0, 0, 0.25, 0.25, 0.5, 0.5}, high{0.75, 0.75, 1, 1, 0.125, 0.125};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(map.values[i], low[i]);
    EXPECT_DOUBLE_EQ(map.values[6 + i], low[i]);
    EXPECT_DOUBLE_EQ(map.values[12 + i], high[i]);
    EXPECT_DOUBLE_EQ(map.values[18 + i], high[i]);
  }
}

TEST(HeatMaps, AFallingAxisIsDrawnTheOtherWayRound) {
  const std::vector<double> rising{0, 0.25, 0.5, 0.75, 1, 0.125};
  const Box frame{0, 0, 9, 4};
  EXPECT_EQ(placed({1, 2, 4}, {1, 2}, rising, frame).values,
            placed({4, 2, 1}, {2, 1}, {0.125, 1, 0.75, 0.5, 0.25, 0}, frame).values);
  EXPECT_EQ(placed({1, 2, 4}, {1, 2}, rising, frame).values,
            placed({1, 2, 4}, {2, 1}, {0.75, 1, 0.125, 0, 0.25, 0.5}, frame).values);
}

TEST(HeatMaps, OnALogarithmicAxisCellsAreEvenRatios) {
  const PlacedMap map = placed({1, 10, 100}, {0, 1}, {0, 0.5, 1, 0, 0.5, 1}, {0, 0, 9, 2}, true);
  EXPECT_EQ(std::vector<double>(map.values.begin(), map.values.begin() + 9),
            (std::vector<double>{0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}));
}

TEST(HeatMaps, AxesReachHalfACellBeyondTheMiddles) {
  Panel panel;
  panel.map = HeatMap{.x = {4, 3, 2}, .y = {0.1, 10}, .z = std::vector<double>(6), .name = ""};
  panel.y.logarithmic = true;
  EXPECT_EQ(map_x_range(panel).low, 1.5);
  EXPECT_EQ(map_x_range(panel).high, 4.5);
  EXPECT_DOUBLE_EQ(map_y_range(panel).low, 0.01);
  EXPECT_DOUBLE_EQ(map_y_range(panel).high, 100);
  EXPECT_TRUE(map_y_range(panel).logarithmic);
  EXPECT_FALSE(map_x_range(panel).logarithmic);
}

TEST(MapScale, BeginsAtZeroWhereTheDataComeNearIt) {
  EXPECT_EQ(map_scale(map_of({0.9, 4, 1, 1}, false)).range.low, 0);
  EXPECT_EQ(map_scale(map_of({1, 4, 1, 1}, false)).range.low, 1);  // a quarter
  EXPECT_EQ(map_scale(map_of({-1, 4, 1, 1}, false)).range.low, -1);
  EXPECT_EQ(map_scale(map_of({-9, -4, -5, -5}, false)).range.low, -9);
}

TEST(MapScale, OfOneValueOrNoneHasALengthToo) {
  const auto range = [](std::vector<double> z) { return map_scale(map_of(std::move(z), true)).range; };
  EXPECT_EQ(range({3, 3, 3, 3}).low, 3);
  EXPECT_EQ(range({3, 3, 3, 3}).high, 3.03);
  EXPECT_EQ(range({-3, -3, -3, -3}).high, -2.97);
  EXPECT_EQ(range({0, 0, 0, 0}).high, 1);
  const double none = std::nan("");
  EXPECT_EQ(range({none, none, none, none}).low, 0);
  EXPECT_EQ(range({none, none, none, none}).high, 1);
  EXPECT_EQ(range({none, 2, 3, none}).high, 3);
}

TEST(MapScale, MoreThanTwentyfoldGetsEvenRatios) {
  EXPECT_FALSE(map_scale(map_of({1, 20, 10, 10}, true)).range.logarithmic);
  EXPECT_TRUE(map_scale(map_of({1, 20.1, 10, 10}, true)).range.logarithmic);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
