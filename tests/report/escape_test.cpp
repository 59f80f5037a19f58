#include "cromer/report/escape.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

TEST(Escaped, NothingEndsAnAttributeOrATag) {
  EXPECT_EQ(escaped("a&<>\"'b"), "a&amp;&lt;&gt;&quot;&#39;b");
  for (int c = 1; c < 32; ++c) {
    const bool kept = c == '\n' || c == '\r' || c == '\t';
    EXPECT_EQ(escaped(std::string(1, static_cast<char>(c))).size(), kept ? 1u : 0u) << c;
    EXPECT_EQ(well_formed("a" + std::string(1, static_cast<char>(c)) + "b").size(), kept ? 3u : 2u) << c;
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

}  // namespace
}  // namespace cromer
