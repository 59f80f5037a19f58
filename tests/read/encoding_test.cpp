// Text in units of two bytes, as Windows programs save it, and its damages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;

struct Form {
  const char* name;
  bool big, marked;
};

void PrintTo(const Form& form, std::ostream* out) { *out << form.name; }

std::string utf16(std::u16string_view text, const Form& form) {
  std::string bytes;
  const auto add = [&](char16_t unit) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += form.big ? high : low;
    bytes += form.big ? low : high;
  };
  if (form.marked) add(u'\uFEFF');
  for (const char16_t unit : text) add(unit);
  return bytes;
}

class Utf16 : public testing::TestWithParam<Form> {};

TEST_P(Utf16, IsReadAsUtf8Is) {
  // One, two, three and four bytes in UTF-8: letters, µ and Ü, a true minus sign, a letter beyond U+FFFF.
  const auto r = read_recording(
      utf16(u"Übung \U0001D703\r\nZeit (s);Auslenkung (µm)\r\n0;1,5\r\n0,5;\u22122\r\n1;2\r\n", GetParam()),
      "lab.txt", {});
  ASSERT_TRUE(r.ok()) << in_words(r.error());
  EXPECT_EQ(r->dialect.encoding, GetParam().name);
  ASSERT_EQ(r->table.columns.size(), 2u);
  EXPECT_EQ(r->table.columns[1].name, "Auslenkung");
  EXPECT_EQ(r->table.columns[1].unit, "µm");
  EXPECT_THAT(r->table.columns[1].values, ElementsAre(1.5, -2, 2));
  EXPECT_THAT(r->lines, ElementsAre(3, 4, 5));
}

TEST(Cp1252, HasOneByteForEachLetter) {
  // Its first and last sign between 0x80 and 0x9F, and their neighbours: € and Ÿ, a blank that keeps a line
  // together, ¡ and ÿ; the first hole.
  const auto name_of = [](const std::string& bytes) {
    const Recording r = read("t,x" + bytes + "y\n0,1\n1,2\n");
    EXPECT_EQ(r.dialect.encoding, "cp1252");
    return r.table.columns.at(1).name;
  };
  EXPECT_EQ(name_of("\x80"), "x€y");
  EXPECT_EQ(name_of("\x9F"), "xŸy");
  EXPECT_EQ(name_of("\xA0"), "x\u00A0y");
  EXPECT_EQ(name_of("\xA1"), "x¡y");
  EXPECT_EQ(name_of("\xFF"), "xÿy");
  EXPECT_EQ(name_of("\x7F\xFF"), "x\x7Fÿy");
  EXPECT_EQ(name_of("\x81"), "x\uFFFDy");
}

TEST_P(Utf16, DamageIsToldWithItsPlace) {
  std::u16string start = u"t,x\n";  // beyond what is looked at to tell the form
  for (int i = 0; i < 100; ++i) start += u"0,1\n";
  const std::string place = GetParam().marked ? "at byte 810, in line 102" : "at byte 808, in line 102";
  for (const std::u16string_view half : {u"\xD834", u"\xDD1E", u"\xD834\xD834"})
    for (const std::u16string_view behind : {u"", u",3\n"})
      EXPECT_THAT(refusal(utf16(start + std::u16string(half) + std::u16string(behind), GetParam())),
                  testing::AllOf(HasSubstr("half a surrogate pair " + place), HasSubstr("as UTF-8")));
  EXPECT_THAT(refusal(utf16(start, GetParam()) + "2"), HasSubstr("half a character " + place));
  EXPECT_THAT(refusal(utf16(start + std::u16string(1, u'\0') + u",3\n", GetParam())),
              HasSubstr("a zero " + place));
}

INSTANTIATE_TEST_SUITE_P(Forms, Utf16,
                         testing::Values(Form{"UTF-16 LE with BOM", false, true},
                                         Form{"UTF-16 BE with BOM", true, true},
                                         Form{"UTF-16 LE", false, false}, Form{"UTF-16 BE", true, false}));

TEST(Encoding, WhatIsNoTextOfTwoBytes) {
  EXPECT_EQ(refusal("\xFF\xFE"), "lab.txt: the file is empty");
  EXPECT_THAT(refusal(std::string(1000, '\0')), HasSubstr("binary"));
  // Four bytes a character.
  EXPECT_THAT(refusal(std::string("\xFF\xFE\0\0t\0\0\0,\0\0\0", 12)),
              HasSubstr("a zero at byte 2, in line 1"));
}

std::string encoding_of(const std::string& bytes) {
  const auto recording = read_recording(bytes, "lab.txt", {});
  return recording ? recording->dialect.encoding : in_words(recording.error());
}

TEST(Encoding, TwoBytesWithoutAMarkAreToldByTheirZeros) {
  const Form little{"", false, false}, big{"", true, false};
  for (const Form& form : {little, big}) {
    EXPECT_EQ(encoding_of(utf16(u"1 2\n3 4\n", form)), form.big ? "UTF-16 BE" : "UTF-16 LE");
    EXPECT_EQ(encoding_of(utf16(u"12", form)), form.big ? "UTF-16 BE" : "UTF-16 LE");
    EXPECT_THAT(encoding_of(utf16(u"1", form)), HasSubstr("this is a binary file"));
    // One of ten letters may have two bytes, of two hundred and fifty-six looked at.
    std::u16string rows = u"Weg \u0101 \n1 2\n3 4\n5 6\n";
    EXPECT_EQ(encoding_of(utf16(rows, form)), form.big ? "UTF-16 BE" : "UTF-16 LE");
    EXPECT_THAT(encoding_of(utf16(u"\u0101\u0102 7\n1 2\n3 4\n5 6\n", form)),
                HasSubstr("this is a binary file"));
    rows = u"";
    for (int i = 0; i < 64; ++i) rows += u"1 2\n";
    EXPECT_EQ(encoding_of(utf16(rows + u"# \u0100\u3000\n", form)), form.big ? "UTF-16 BE" : "UTF-16 LE");
    EXPECT_THAT(encoding_of(utf16(rows.substr(0, 252) + u"# \u3000\n", form)),
                HasSubstr("this is a binary file"));
  }
}

TEST(Encoding, SurrogatesReachFromEndToEnd) {
  for (const char16_t* letter : {u"\U00010000", u"\U0010FFFF", u"\uD7FF", u"\uE000"})
    EXPECT_EQ(encoding_of(utf16(std::u16string(u"x ") + letter + u"\n1\n2\n", {"", false, true})),
              "UTF-16 LE with BOM");
  const auto read = read_recording(utf16(u"x \U0010FFFF\n1\n2\n", {"", false, true}), "lab.txt", {});
  EXPECT_EQ(read->table.columns[0].name, "x \xF4\x8F\xBF\xBF");
  for (const std::u16string& half : {std::u16string{0xD800, 0xDBFF}, std::u16string{0xD800, 0xE000},
                                     std::u16string{0xDFFF, 0xDC00}, std::u16string{0xDBFF}})
    EXPECT_THAT(encoding_of(utf16(u"x" + half, {"", false, true})),
                HasSubstr("half a surrogate pair at byte 4"));
}

TEST(Encoding, WindowsLettersAreRead) {
  const auto name = [](const std::string& letter) {
    return read_recording("Weg " + letter + "\n1\n2\n", "lab.txt", {})->table.columns[0].name;
  };
  EXPECT_EQ(name("\x80"), "Weg \u20AC");
  EXPECT_EQ(name("\x81"), "Weg \uFFFD");
  EXPECT_EQ(name("\x9F"), "Weg \u0178");
  EXPECT_EQ(name("\xA1"), "Weg \u00A1");
  EXPECT_EQ(name("\xFF"), "Weg \u00FF");
  EXPECT_EQ(encoding_of(std::string("1 2\n3 4\n\0", 9)),
            "lab.txt: this is a binary file (a zero byte at offset 8): a text or CSV file is expected");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
