#include "cromer/report/escape.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace {

TEST(Escaped, NothingEndsAnAttributeOrATag) {
  EXPECT_EQ(escaped("a&<>\"'b"), "a&amp;&lt;&gt;&quot;&#39;b");
  for (int c = 1; c < 32; ++c) {
    const bool kept = c == '\n' || c == '\t';
    EXPECT_EQ(well_formed("a" + std::string(1, static_cast<char>(c)) + "b").size(), kept ? 3u : 6u) << c;
  }
  EXPECT_EQ(escaped(" µ"), " µ");
}

TEST(WellFormed, NoncharactersAreReplacedWhereverTheyStand) {
  EXPECT_EQ(well_formed("\xEF\xBF\xBE"
                        "a"
                        "\xEF\xBF\xBF\xEF\xBF\xBE"),
            "\uFFFDa\uFFFD\uFFFD");
  EXPECT_EQ(well_formed("\xEF\xBF\xBD\xff"), "\uFFFD\uFFFD");
}

TEST(WellFormed, WhatIsHiddenOrTurnsTheWritingIsSpelledOut) {
  EXPECT_EQ(well_formed("a\u202Eb\u2066c\u009Bd\x7F"
                        "e\x1B[0m"),
            "a\\u202eb\\u2066c\\x9bd\\x7fe\\x1b[0m");
}

}  // namespace
}  // namespace cromer::core
