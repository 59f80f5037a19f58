// Cells that are no numbers: the message says what they are and how to write them.
#include "cromer/record/dialects/bad_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/concat.h"
#include "cromer/record/dialects/recording.h"

namespace cromer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(std::string_view text, bool skip = false) {
  ReadOptions options;
  options.skip_bad_rows = skip;
  const auto recording = read_recording(text, "lab.csv", options);
  return recording ? "read" : recording.error().message;
}

TEST(BadCell, IsCalledByItsName) {
  using dialects::bad_cell;
  EXPECT_EQ(bad_cell("1,000.0", '.'), "it has thousands separators: write 1000.0");
  EXPECT_EQ(bad_cell("-1.234.567,5", ','), "it has thousands separators: write -1234567,5");
  EXPECT_EQ(bad_cell("12:00:00.50", '.'), "it is a clock time: write the seconds since the start");
  EXPECT_EQ(bad_cell("2024-03-01T12:00:00", '.'), "it is a date: write the seconds since the start");
  EXPECT_EQ(bad_cell("01.03.2024", '.'), "it is a date: write the seconds since the start");
  EXPECT_EQ(bad_cell("1.5D-03", '.'), "it has Fortran's exponent: write 1.5E-03");
  EXPECT_THAT(bad_cell("-1e309", '.'), HasSubstr("too large"));
  EXPECT_THAT(bad_cell("1,5", '.'), HasSubstr("the decimal mark of this file is a point"));
  EXPECT_EQ(bad_cell("abc", '.'), "");
  EXPECT_EQ(bad_cell("", '.'), "");
  EXPECT_EQ(bad_cell("1.2.3.4", '.'), "");
}

TEST(BadCell, IsNamedInAColumn) {
  EXPECT_THAT(refusal("t;x\n0;1.5\n1;1,000.0\n2;2.5\n"),
              AllOf(StartsWith("lab.csv:3: column \"x\": \"1,000.0\""), HasSubstr("write 1000.0")));
  EXPECT_THAT(refusal("t,x\n0,1.5\n1,-1e309\n2,2.5\n"),
              AllOf(StartsWith("lab.csv:3: column \"x\": \"-1e309\""), HasSubstr("too large")));
}

TEST(BadCell, IsNamedWhereNoRowIsLeft) {
  for (const bool skip : {false, true}) {
    EXPECT_THAT(
        refusal("t,x\n12:00:00.50,1.5\n12:00:00.60,2.5\n", skip),
        AllOf(StartsWith("lab.csv:2: "), HasSubstr("\"12:00:00.50\" is not a number; it is a clock time")));
    EXPECT_THAT(refusal("t;x\n0;1,001.0\n1;1,000.0\n", skip),
                AllOf(StartsWith("lab.csv:2: "), HasSubstr("write 1001.0")));
    EXPECT_THAT(refusal("t x\n0.0D0 1.5D-03\n1.0D0 2.5D-03\n", skip),
                AllOf(StartsWith("lab.csv:2: "), HasSubstr("Fortran")));
  }
}

TEST(BadCell, MostRowsLostIsSaidFirst) {
  std::string text = "t;x\n0;1\n1;2\n2;3\n";
  for (int i = 3; i < 7; ++i) text += concat({std::to_string(i), ";1,000.5\n"});
  ReadOptions options;
  options.skip_bad_rows = true;
  const auto recording = read_recording(text, "lab.csv", options);
  ASSERT_TRUE(recording.ok());
  EXPECT_THAT(recording->warnings.at(0),
              AllOf(StartsWith("MOST ROWS ARE LOST: 4 bad rows left out, 3 rows kept, the first in line 5"),
                    HasSubstr("thousands")));
}

}  // namespace
}  // namespace cromer
