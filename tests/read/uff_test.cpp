// Universal files written here from known numbers: text and binary, both byte orders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdio>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

struct Response {
  int type = 2;  ///< 2 single, 4 double, 5 complex
  bool even = true;
  double start = 0.5, step = 0.25;
  int kind = 12;  ///< 12: acceleration
  const char* unit = "m/s^2";
  int node = 3, direction = 3, function = 1, abscissa = 17;
  int points = 3;
};

/// The eleven lines of the header, in their fixed columns.
std::string header(const Response& r) {
  const auto axis = [](int kind, const char* label, const char* unit) {
    return formatted("%10d%5d%5d%5d %-20s %-20s\n", kind, 0, 0, 0, label, unit);
  };
  return concat(
      {"a beam\nNONE\n02-JUN-20 10:00:00\nNONE\nNONE\n",
       formatted("%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d\n", r.function, 0, 0, 0, "NONE", r.node,
                 r.direction, "NONE", 0, 0),
       formatted("%10d%10d%10d%13.5E%13.5E%13.5E\n", r.type, r.points, r.even ? 1 : 0, r.start, r.step, 0.0),
       axis(r.abscissa, "Time", "s"), axis(r.kind, "NONE", r.unit), axis(0, "NONE", "NONE"),
       axis(0, "NONE", "NONE")});
}

std::string text_set(const Response& r, const std::string& values) {
  return concat({"    -1\n    58\n", header(r), values, "    -1\n"});
}

template <class Bits, class Real>
std::string bytes_of(Real value, bool little) {
  const auto bits = std::bit_cast<Bits>(value);
  std::string bytes(sizeof bits, '\0');
  for (std::size_t k = 0; k < sizeof bits; ++k)
    bytes[little ? k : sizeof bits - 1 - k] = static_cast<char>(bits >> (8 * k) & 0xFFu);
  return bytes;
}

std::string binary_set(const Response& r, const std::string& values, bool little, const char* end = "\r\n") {
  return concat({"    -1\n",
                 formatted("%6d%s%6d%6d%12d%12d%6d%6d%12d%12d\n", 58, "b", little ? 1 : 2, 2, 11,
                           static_cast<int>(values.size()), 0, 0, 0, 0),
                 header(r), values, end, "    -1\n"});
}

std::vector<std::string> headings(const Recording& recording) {
  std::vector<std::string> all;
  for (const Column& column : recording.table.columns) all.push_back(column_title(column));
  return all;
}

TEST(Uff, TextInSinglesAndDoubles) {
  const Recording r =
      read("    -1\n   151\nmodel\n    -1\n" + text_set({}, "  1.50000E+00 -2.50000E+00-3.75000E-05\n") +
           text_set({.type = 4, .kind = 8, .unit = "mm", .node = 4, .direction = -1},
                    "  1.250000000000E+00 -2.500000000000E+00  3.000000000000E+00\n"));
  EXPECT_EQ(r.dialect.name, "UFF 58");
  EXPECT_THAT(headings(r), ElementsAre("Time (s)", "Acceleration 3 +Z (m/s^2)", "Displacement 4 -X (mm)"));
  EXPECT_THAT(r.table.columns[0].values, ElementsAre(0.5, 0.75, 1));
  EXPECT_THAT(r.table.columns[1].values, ElementsAre(1.5, -2.5, -3.75e-5));
  EXPECT_THAT(r.table.columns[2].values, ElementsAre(1.25, -2.5, 3));
  EXPECT_EQ(r.table.columns[2].quantity, "position");
  EXPECT_THAT(in_words(r.notices), ElementsAre());
  EXPECT_EQ(line_of(r, 1, 0), 18);
}

TEST(Uff, UnevenTimesStandBeforeTheValues) {
  const Recording r = read(text_set(
      {.even = false}, " 0.00000E+00 1.00000E+00 5.00000E-01-2.00000E+00 7.50000E-01 3.00000E+00\n"));
  EXPECT_THAT(r.table.columns[0].values, ElementsAre(0, 0.5, 0.75));
  EXPECT_THAT(r.table.columns[1].values, ElementsAre(1, -2, 3));
}

TEST(Uff, BinaryInBothByteOrders) {
  for (const bool little : {true, false}) {
    std::string singles, pairs;
    // Bytes that look like line ends are values all the same.
    for (const float value : {1.5f, std::bit_cast<float>(0x0A0D0A0Du), -2.5f})
      singles += bytes_of<std::uint32_t>(value, little);
    for (const double value : {0.5, 0.1, -2.25}) {
      pairs += bytes_of<std::uint32_t>(static_cast<float>(4 * value + 10), little);
      pairs += bytes_of<std::uint64_t>(value, little);
    }
    const Recording r = read(binary_set({}, singles, little) +
                             binary_set({.type = 4, .even = false, .node = 9}, pairs, little, ""));
    EXPECT_EQ(r.dialect.encoding, "binary");
    ASSERT_EQ(r.table.columns.size(), 4u);
    EXPECT_THAT(r.table.columns[1].values,
                ElementsAre(1.5, static_cast<double>(std::bit_cast<float>(0x0A0D0A0Du)), -2.5));
    EXPECT_THAT(r.table.columns[2].values, ElementsAre(12, static_cast<double>(10.4f), 1));
    EXPECT_THAT(r.table.columns[3].values, ElementsAre(0.5, 0.1, -2.25));
  }
}

TEST(Uff, WhatIsNoTimeResponseIsLeftOut) {
  const std::string good = text_set({}, " 1 2 3\n");
  const Recording r =
      read(text_set({.type = 5}, " 1 2 3 4 5 6\n") + text_set({.function = 4, .abscissa = 18}, " 1 2 3\n") +
           good + text_set({.node = 7, .points = 9}, " 1 2 3\n"));
  EXPECT_EQ(r.table.columns.size(), 3u);
  EXPECT_THAT(in_words(r.notices),
              testing::UnorderedElementsAre(HasSubstr("1 dataset left out: its values are complex"),
                                            HasSubstr("1 dataset left out: it is no time response"),
                                            HasSubstr("announces 9 points and holds 3")));
  const auto refused = read_recording(text_set({.type = 5}, " 1 2\n"), "lab.txt", {});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()), HasSubstr("holds no time response"));
  // A single column of numbers is none.
  EXPECT_EQ(read("-1\n58\n1.5\n2\n").table.columns.size(), 1u);
}

TEST(Uff, AWordAmongTheNumbersIsNoEndOfThem) {
  const auto recording = read_recording(text_set({}, "  1.00000E+00  2.00000E+00\n  three\n"), "lab.txt", {});
  ASSERT_FALSE(recording);
  EXPECT_THAT(in_words(recording.error()), HasSubstr("lab.txt:15"));
  EXPECT_THAT(in_words(recording.error()), HasSubstr("three"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
