#include "cromer/live/headings.h"

#include <gtest/gtest.h>

namespace cromer::core {
namespace {

TEST(Headings, StandInAFileWithoutQuotes) {
  EXPECT_EQ(plain_heading(" \"Position\", raw\t(mm) "), "Position   raw (mm)");
  EXPECT_EQ(plain_heading("H\xc3\xb6he (m)"), "H\xc3\xb6he (m)");
}

TEST(Headings, AreNamedWithOrWithoutTheirUnit) {
  EXPECT_TRUE(is_named("Position (mm)", "Position (mm)"));
  EXPECT_TRUE(is_named("Position (mm)", "Position"));
  EXPECT_FALSE(is_named("Position (mm)", "Postion"));
  EXPECT_FALSE(is_named("Position (mm)", "mm"));
}

}  // namespace
}  // namespace cromer::core
