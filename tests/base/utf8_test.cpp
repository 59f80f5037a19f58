#include "cromer/base/utf8.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

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

}  // namespace
}  // namespace cromer
