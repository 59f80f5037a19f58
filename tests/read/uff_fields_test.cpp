// The fixed columns of a dataset 58, and where its limits are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/formats/uff.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

// Every field is filled to its borders by digits.
TEST(UffFields, StandInTheirColumns) {
  const UffFunction read = uff_function({
      "  a beam",
      "",
      "",
      "",
      "",
      "12345abcdefghijABCDE0123456789 response  0987654321-123zzz",
      "0111111111022222222200000000011.111111111112.22222222222xyz",
      "0000000017aaaaabbbbbccccc Time                 s                   ",
      "        12aaaaabbbbbccccc 12345678901234567890 abcdefghijklmnopqrstuvw",
  });
  EXPECT_EQ(read.identity, "a beam");
  EXPECT_EQ(read.function, 12345);
  EXPECT_EQ(read.load_case, 123456789);
  EXPECT_EQ(read.node, 987654321);
  EXPECT_EQ(read.direction, -123);
  EXPECT_EQ(read.type, 111111111);
  EXPECT_EQ(read.points, 222222222);
  EXPECT_TRUE(read.even);
  EXPECT_EQ(read.start, 1.11111111111);
  EXPECT_EQ(read.step, 2.22222222222);
  EXPECT_EQ(read.abscissa.kind, 17);
  EXPECT_EQ(read.abscissa.label, "Time");
  EXPECT_EQ(read.abscissa.unit, "s");
  EXPECT_EQ(read.ordinate.kind, 12);
  EXPECT_EQ(read.ordinate.label, "12345678901234567890");
  EXPECT_EQ(read.ordinate.unit, "abcdefghijklmnopqrst");
}

std::string dataset(const std::string& values,
                    const std::string& numbers = "         2         3         1") {
  return concat(
      {"    -1\n    58\nbeam\n\n\n\n\n    1                             0 NONE               3   1\n",
       numbers, "  0.00000E+00  5.00000E-01\n        17                Time                 NONE\n",
       "         8                NONE                 mm\n\n\n", values, "    -1\n"});
}

TEST(UffFields, ASetIsReadToItsPoints) {
  EXPECT_THAT(in_words(read(dataset(" 1 2 3\n")).notices), IsEmpty());
  const Recording fewer = read(dataset(" 1 2\n"));
  EXPECT_THAT(in_words(fewer.notices), ElementsAre("the dataset in line 2 announces 3 points and holds 2"));
  const Recording more = read(dataset(" 1 2 3 4\n"));
  EXPECT_THAT(in_words(more.notices), IsEmpty());
  EXPECT_THAT(more.table.columns.at(1).values, ElementsAre(1, 2, 3));
  EXPECT_THAT(in_words(read(dataset(" 1 2\n", "         2         0         1")).notices),
              ElementsAre("the dataset in line 2 announces 0 points and holds 2"));
}

TEST(UffFields, WhatIsLeftOutIsCounted) {
  const std::string good = dataset(" 1 2 3\n"),
                    complex = dataset(" 1 2 3\n", "         5         3         1");
  EXPECT_THAT(in_words(read(good + complex).notices),
              ElementsAre("1 dataset left out: its values are complex, in line 17"));
  EXPECT_THAT(in_words(read(complex + good + complex).notices),
              ElementsAre("2 datasets left out: its values are complex, the first in line 2"));
  EXPECT_EQ(refusal(complex),
            "lab.txt: the universal file holds no time response of a dataset 58; 1 dataset left "
            "out: its values are complex, in line 2");
  EXPECT_EQ(refusal("    -1\n    58\n"), refusal("    -1\n    58\n    -1\n"));
  EXPECT_THAT(in_words(read(good + dataset("")).notices),
              ElementsAre("1 dataset left out: it has no values, in line 17"));
  for (const char* other : {"   151", "   164"})
    EXPECT_THAT(in_words(read(concat({"    -1\n", other, "\nx\n    -1\n", good})).notices), IsEmpty())
        << other;
  EXPECT_THAT(in_words(read(concat({good, "    -1\n    55\nx\n    -1\n"})).notices),
              ElementsAre("1 dataset left out: its kind \"55\" is not 58, in line 17"));
  EXPECT_EQ(refusal(dataset(" 1 x 3\n")), "lab.txt:14: \"x\" is not a number");
  EXPECT_EQ(refusal(good + dataset(" 1 x 3\n")), "lab.txt:29: \"x\" is not a number");
}

TEST(UffFields, LineEndsMayStandBeforeTheDelimiter) {
  EXPECT_EQ(read("\r\n\n" + dataset(" 1 2 3\n\n")).table.rows(), 3u);
  EXPECT_EQ(read("\n\n" + dataset(" 1 2 3\r\n\r\n") + "\n").lines.size(), 3u);
}

TEST(UffFields, BothLinesStandAtTheRightOfSixColumns) {
  for (const char* text : {"    -1\n    58\n", "    -1\r\n    58\r\n", "    -1\n   58b     1     2\n",
                           "    -1\n  2414\n", "\n\r\n    -1\n     5"})
    EXPECT_TRUE(is_uff(text)) << text;
  for (const char* text :
       {"", "-1\n58\n", "    -1\n58\n", "-1\n    58\n", "    -2\n    58\n", "    -1\n    5x\n",
        "    -1\n    55b\n", "    -1\n  24145\n", "    -1\n      \n", "    -1\n    -1\n"})
    EXPECT_FALSE(is_uff(text)) << text;
}

TEST(UffFields, ABinarySetSaysHowItIsWritten) {
  const auto with = [](const std::string& line) {
    std::string text = dataset("abcdefghijkl\n");
    return refusal(text.replace(7, 6, line));
  };
  EXPECT_EQ(with("    58b     1     2          11          12"), "read");
  EXPECT_EQ(with("    58b     2     2          11          12"), "read");
  EXPECT_EQ(with("    58b     3     2          11          12"),
            "lab.txt:2: its byte order is neither 1 nor 2");
  EXPECT_EQ(with("    58b     1     1          11          12"),
            "lab.txt:2: its binary numbers are not IEEE 754: convert the file to dataset 58 as text");
  EXPECT_EQ(with("    58b     1     2          11          -1"),
            "lab.txt:2: its number of bytes is not valid");
  EXPECT_EQ(with("    58b     1     2          11        1e15"),
            "lab.txt:2: its number of bytes is not valid");
  EXPECT_NE(with("    58b     1     2          11"), "read");
}

UffFunction named(const char* label, int kind, long node, int direction, const char* identity = "") {
  UffFunction function;
  function.ordinate.label = label;
  function.ordinate.kind = kind;
  function.node = node;
  function.direction = direction;
  function.identity = identity;
  return function;
}

TEST(UffFields, NamesSayWhatIsMeasuredWhere) {
  EXPECT_EQ(uff_name(named("Strain", 8, 3, 1)), "Strain 3 +X");
  EXPECT_EQ(uff_name(named("", 8, 1, -2)), "Displacement 1 -Y");
  EXPECT_EQ(uff_name(named("", 9, 0, 3)), "Reaction force +Z");
  EXPECT_EQ(uff_name(named("", 11, 0, 4)), "Velocity +RX");
  EXPECT_EQ(uff_name(named("", 13, 0, -6)), "Force -RZ");
  EXPECT_EQ(uff_name(named("", 12, 0, 7)), "Acceleration");
  EXPECT_EQ(uff_name(named("", 99, 0, 0, "beam")), "beam");
  EXPECT_EQ(uff_name(named("", 99, 0, 0, "NONE")), "Response");
  EXPECT_EQ(uff_name(named("", 99, -1, 0)), "Response");
  EXPECT_EQ(uff_quantity({8, "", "mm"}, "a"), "position");
  EXPECT_EQ(uff_quantity({8, "", "V"}, "a"), "voltage");
  EXPECT_EQ(uff_quantity({11, "", ""}, "a"), "velocity");
  EXPECT_EQ(uff_quantity({13, "", "foo"}, "b"), "force");
  EXPECT_EQ(uff_quantity({0, "", ""}, "angle"), "angle");
}

TEST(UffFields, LoadCasesAreRuns) {
  std::string second = dataset(" 4 5 6\n");
  const std::size_t line = second.find("    1                             0");
  second.replace(line + 20, 10, "         2");
  EXPECT_THAT(in_words(read(dataset(" 1 2 3\n") + second).notices),
              ElementsAre("run 1 is called \"no load case\" in the file"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
