// What librsvg and cairo make of an SVG, taken apart again; skipped where they are not installed.
#include "cromer/report/librsvg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;
using testing::StartsWith;

/// A blue rectangle in a picture of 40 x 20 px.
std::string blue(const std::string& place) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\" width=\"40\" height=\"20\">"
         "<rect " +
         place + " fill=\"#0000FF\"/></svg>";
}
const std::string blue_ground = blue("width=\"40\" height=\"20\"");

class Librsvg : public testing::Test {
 protected:
  void SetUp() override {
    const auto picture = png_of(blue_ground, 40, 20);
    if (!picture && picture.error().notice.code == "librsvg_is_missing")
      GTEST_SKIP() << in_words(picture.error());
  }
};

std::string inflated(const std::string& packed) {
  std::string bytes(100000, '\0');
  uLongf count = static_cast<uLongf>(bytes.size());
  uncompress(reinterpret_cast<Bytef*>(bytes.data()), &count, reinterpret_cast<const Bytef*>(packed.data()),
             static_cast<uLong>(packed.size()));
  bytes.resize(count);
  return bytes;
}

int at(const std::string& bytes, std::size_t i) { return static_cast<unsigned char>(bytes.at(i)); }

int predicted(int filter, int left, int up, int left_up) {
  const int guess = left + up - left_up;
  const int off_left = std::abs(guess - left), off_up = std::abs(guess - up),
            off_both = std::abs(guess - left_up);
  if (filter == 4)
    return off_left <= off_up && off_left <= off_both ? left : off_up <= off_both ? up : left_up;
  return filter == 0 ? 0 : filter == 1 ? left : filter == 2 ? up : (left + up) / 2;
}

/// The bytes of an RGB PNG's rows: PNG specification, chapter 9.
std::string pixels(const std::string& png, std::size_t width, std::size_t height) {
  const std::size_t data = png.find("IDAT");
  const std::string filtered = inflated(png.substr(data + 4));
  const std::size_t row = 3 * width;
  std::string seen;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < row; ++x) {
      const int left = x < 3 ? 0 : at(seen, y * row + x - 3), up = y == 0 ? 0 : at(seen, (y - 1) * row + x);
      const int left_up = x < 3 || y == 0 ? 0 : at(seen, (y - 1) * row + x - 3);
      const int filter = at(filtered, y * (row + 1));
      seen += static_cast<char>(at(filtered, y * (row + 1) + 1 + x) + predicted(filter, left, up, left_up));
    }
  return seen;
}

TEST_F(Librsvg, FillsAPngOfTwiceThePx) {
  const auto png = png_of(blue_ground, 40, 20);
  ASSERT_TRUE(png.ok()) << in_words(png.error());
  EXPECT_EQ(png->substr(16, 10), std::string("\0\0\0\x50\0\0\0\x28\x08\x02", 10));  // 80 x 40, 8 bits, RGB
  std::string blue;
  for (int i = 0; i < 80 * 40; ++i) blue += std::string("\0\0\xFF", 3);
  EXPECT_EQ(pixels(*png, 80, 40), blue);
}

TEST_F(Librsvg, FillsAPdfOfThreeQuartersOfAPointForEachPx) {
  const auto pdf = pdf_of(blue("x=\"4\" y=\"4\" width=\"20\" height=\"8\""), 40, 20);
  ASSERT_TRUE(pdf.ok()) << in_words(pdf.error());
  EXPECT_THAT(*pdf, HasSubstr("/MediaBox [ 0 0 30 15 ]"));
  EXPECT_THAT(inflated(pdf->substr(pdf->find("stream\n") + 7)),
              testing::ContainsRegex("0 0 1 rg .*\n3 3 15 6 re f"));
}

TEST_F(Librsvg, SaysWhyItCannotDraw) {
  for (const auto& picture : {png_of("no svg", 40, 20), pdf_of("no svg", 40, 20)}) {
    ASSERT_FALSE(picture.ok());
    EXPECT_THAT(in_words(picture.error()), StartsWith("librsvg could not draw the figure: "));
  }
}

TEST_F(Librsvg, APictureTooLargeForCairoIsAnError) {
  const auto png = png_of(blue_ground, 40000, 20);
  ASSERT_FALSE(png.ok());
  EXPECT_THAT(in_words(png.error()), HasSubstr("too big"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
