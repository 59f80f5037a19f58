#include "cromer/base/utf8.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Printable, KeepsWhatPeopleRead) {
  for (const char* text : {"", "abc", "two\nlines\tand a tab", "µ = 0.5 ± 0.1 m/s²", "Länge – 長さ 😀"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, SpellsOutWhatDrivesATerminal) {
  EXPECT_EQ(printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(printable("\x1b]0;title\a"), "\\x1b]0;title\\x07");
  EXPECT_EQ(printable("a\rb\x7f"), "a\\x0db\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\x9b31m");  // U+009B, the short CSI
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "cba"),
            "\\u202ecba");  // writes backwards
  EXPECT_EQ(printable("\xE2\x81\xA6"
                      "\xD8\x9C"),
            "\\u2066\\u061c");  // isolates, Arabic mark
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, IsUtf8Always) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string bytes{'a', static_cast<char>(first), static_cast<char>(second), 'b'};
      EXPECT_TRUE(is_utf8(printable(bytes))) << first << ' ' << second;
      EXPECT_TRUE(is_utf8(as_utf8(bytes))) << first << ' ' << second;
    }
  EXPECT_EQ(printable("caf\xe9"), "caf\\xe9");
  EXPECT_EQ(as_utf8("caf\xe9!"), "caf\uFFFD!");
  EXPECT_EQ(printable("\xC0\x80"), "\\xc0\\x80");           // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // half of a pair
}

TEST(Printable, SpellsAsJsonDoesWithinADocument) {
  EXPECT_EQ(printable_json("{\n  \"name\": \"\xC2\x9Bx\xE2\x80\xAE\"\n}\n"),
            "{\n  \"name\": \"\\u009bx\\u202e\"\n}\n");
}

/// The encoding as RFC 3629, section 3, says it.
std::string encoded(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits); };
  if (code <= 0x7F) return {byte(code)};
  if (code <= 0x7FF) return {byte(0xC0 + code / 64), byte(0x80 + code % 64)};
  if (code <= 0xFFFF) return {byte(0xE0 + code / 4096), byte(0x80 + code / 64 % 64), byte(0x80 + code % 64)};
  return {byte(0xF0 + code / 262144), byte(0x80 + code / 4096 % 64), byte(0x80 + code / 64 % 64),
          byte(0x80 + code % 64)};
}

bool is_hidden(std::uint32_t code) {
  const bool control = code <= 0x08 || (code >= 0x0B && code <= 0x1F) || (code >= 0x7F && code <= 0x9F);
  // LRM, RLM, ALM; the ends of line and paragraph; embeddings and overrides; isolates.
  const bool turns = code == 0x200E || code == 0x200F || code == 0x61C ||
                     (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return control || turns;
}

TEST(Utf8, EveryCodePointIsWrittenReadAndShownAsItShould) {
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    std::string text;
    append_utf8(text, code);
    ASSERT_EQ(text, encoded(code)) << code;
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    ASSERT_EQ(is_utf8(text), !surrogate) << code;
    if (!surrogate) {
      ASSERT_EQ(printable(text) != text, is_hidden(code)) << code;
    }
  }
}

TEST(Utf8, TwoToFourBytesAreOneSequenceOnlyAsTheStandardHasIt) {
  // Unicode 15, table 3-7: the first byte, what may follow it, how many bytes.
  const auto wanted = [](int a, int b) -> std::size_t {
    if (b < 0x80 || b > 0xBF) return 0;
    if (a >= 0xC2 && a <= 0xDF) return 2;
    if (a == 0xE0) return b >= 0xA0 ? 3 : 0;
    if (a == 0xED) return b <= 0x9F ? 3 : 0;
    if (a >= 0xE1 && a <= 0xEF) return 3;
    if (a == 0xF0) return b >= 0x90 ? 4 : 0;
    if (a == 0xF4) return b <= 0x8F ? 4 : 0;
    return a >= 0xF1 && a <= 0xF3 ? 4 : 0;
  };
  for (int a = 0x80; a < 256; ++a)
    for (int b = 0; b < 256; ++b)
      for (std::size_t length = 1; length <= 5; ++length) {
        std::string bytes{static_cast<char>(a), static_cast<char>(b)};
        bytes.resize(std::max<std::size_t>(2, length), '\x80');
        bytes.resize(length);
        ASSERT_EQ(is_utf8(bytes), wanted(a, b) == length) << a << ' ' << b << ' ' << length;
      }
  for (const char* broken : {"\xE2\x80"
                             "a",
                             "\xF0\x9F\x98"
                             "a",
                             "\xF0\x9F"
                             "a\x80",
                             "\xE2"
                             "a\x80"})
    EXPECT_FALSE(is_utf8(broken));
}

TEST(Utf8, WhereverInALongTextAByteIsNone) {
  for (std::size_t length = 1; length < 40; ++length)
    for (std::size_t at = 0; at < length; ++at) {
      std::string text(length, 'a');
      EXPECT_TRUE(is_utf8(text));
      text[at] = '\xff';
      EXPECT_FALSE(is_utf8(text)) << length << ' ' << at;
    }
  EXPECT_EQ(as_utf8("\xE2\x82\xAC\xE2\x82!\xF0\x9F\x98\x80"), "\u20AC\uFFFD\uFFFD!\U0001F600");
  EXPECT_EQ(printable("\x80 \xE2\x80\xAE x"), "\\x80 \\u202e x");
  EXPECT_EQ(printable_json("\x80\x1f"), "\uFFFD\\u001f");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
