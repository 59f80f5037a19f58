// The PNG of a map, taken apart again.
#include "cromer/report/map_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <map>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

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

}  // namespace
}  // namespace cromer::core
