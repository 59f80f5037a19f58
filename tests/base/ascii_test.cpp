#include "cromer/base/ascii.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Ascii, OnlyItsLettersAndDigitsCount) {
  for (int i = 0; i < 256; ++i) {
    const char c = static_cast<char>(i);
    const std::size_t upper = std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZ").find(c);
    EXPECT_EQ(is_digit(c), std::string_view("0123456789").find(c) != std::string_view::npos) << i;
    EXPECT_EQ(lower(c), upper == std::string_view::npos ? c : "abcdefghijklmnopqrstuvwxyz"[upper]) << i;
  }
  EXPECT_EQ(lower("ÄB@[Z"), "Äb@[z");
}

TEST(Ascii, BlanksAtBothEndsGo) {
  EXPECT_EQ(trimmed(" \t\r\na b \n"), "a b");
  EXPECT_EQ(trimmed("\u00a0 \u00a0a\u00a0b \u00a0"), "a\u00a0b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(OptionName, IsSpeltInTwoWays) {
  EXPECT_EQ(with_underscores("drive-frequency"), "drive_frequency");
  EXPECT_EQ(with_hyphens("drive_frequency"), "drive-frequency");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
