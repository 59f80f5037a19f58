#include "cromer/identify/diagnose/drop_outs.h"

#include <gtest/gtest.h>

#include "tests/identify/synthetic.h"

namespace cromer {
namespace {

TEST(DropOuts, RunsOfZerosOutsideTheMotion) {
  SyntheticRecord record = viscous_record({.position = 0.05}, even_times(3000, 0.01), 1e-4, 1e-4);
  std::vector<std::size_t> expected;
  for (const std::size_t first : {500u, 1700u})
    for (std::size_t i = first; i < first + 10; ++i) {
      record.y[i] = 0;
      expected.push_back(i);
    }
  EXPECT_EQ(drop_outs(record.record()), expected);
}

TEST(DropOuts, NoneInAMotion) {
  for (const double g : {0.01, 0.3, 2.0})  // also where most of the record is at rest
    for (const double resolution : {0.0, 1e-4, 5e-3, 2e-2})
      for (const double h : {0.01, 0.08})
        EXPECT_TRUE(
            drop_outs(
                viscous_record({.g = g, .position = 0.05}, even_times(3000, h), 1e-5, resolution).record())
                .empty())
            << g << " " << resolution << " " << h;
}

TEST(DropOuts, ATopThatIsCutOffIsNone) {
  SyntheticRecord record = viscous_record({.position = 0.05}, even_times(3000, 0.01), 0, 1e-4);
  for (double& y : record.y) y = std::min(y, 0.23);
  EXPECT_TRUE(drop_outs(record.record()).empty());
}

}  // namespace
}  // namespace cromer
