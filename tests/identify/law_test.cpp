#include "cromer/identify/law.h"

#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Law, ReadsAnySumInAnyOrder) {
  for (const char* text : {"viscous+drag+cubic", "cubic+viscous+drag", " drag + cubic + viscous "}) {
    const Result<Law> law = parse_law(text);
    ASSERT_TRUE(law.ok()) << text;
    EXPECT_EQ(to_text(*law), "viscous+drag+cubic");
  }
  EXPECT_EQ(to_text(*parse_law("drag")), "drag");
  EXPECT_FALSE(parse_law("drag")->has<Viscous>());
}

TEST(Law, WritesWhatItReads) {
  for (std::uint32_t set = 2; set < 1U << term_count; set += 2) {
    Law law{set};
    if (!law.shares(springs)) law = law.with(law_with<Spring>);
    if (to_text(law).empty()) continue;
    ASSERT_TRUE(parse_law(to_text(law)).ok());
    EXPECT_EQ(*parse_law(to_text(law)), law);
  }
}

TEST(Law, SuggestsTheNearestTerm) {
  const Result<Law> law = parse_law("viscous+darg");
  ASSERT_FALSE(law.ok());
  EXPECT_NE(in_words(law.error()).find("\"darg\""), std::string::npos);
  EXPECT_NE(in_words(law.error()).find("did you mean drag"), std::string::npos);
}

TEST(Law, RefusesEmptyAndRepeatedTerms) {
  for (const char* text : {"", "+", "viscous+", "viscous+viscous", "viscous drag", "spring"})
    EXPECT_FALSE(parse_law(text).ok()) << text;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
