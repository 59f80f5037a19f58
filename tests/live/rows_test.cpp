#include "cromer/live/rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

TEST(SampleRows, TakeOthersAndKeepTheLastOnes) {
  SampleRows some, more;
  some.width = more.width = 2;
  some.add(0, std::vector{10.0, 20.0});
  some.add(1, std::vector{11.0, 21.0});
  more.add(2, std::vector{12.0, 22.0});
  some.add(more);
  some.keep_last(3);
  EXPECT_THAT(some.t, ElementsAre(0, 1, 2));
  some.keep_last(2);
  EXPECT_THAT(some.t, ElementsAre(1, 2));
  EXPECT_THAT(some.values, ElementsAre(11, 21, 12, 22));
  SampleRows none;
  none.add(some);
  EXPECT_EQ(none.width, 2u);
  EXPECT_EQ(none.row(1)[1], 22);
}

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

}  // namespace CROMER_FILE
}  // namespace cromer::core
