#include "cromer/base/coupled.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

TEST(Coupled, AddsAndMultipliesByComponents) {
  const Coupled<double> a{1, 2}, b{10, 20};
  EXPECT_EQ(a + b, (Coupled<double>{11, 22}));
  EXPECT_EQ(b - a, (Coupled<double>{9, 18}));
  EXPECT_EQ(2 * a, (Coupled<double>{2, 4}));
  EXPECT_EQ(b / 2.0, (Coupled<double>{5, 10}));
  EXPECT_EQ(value_of(b), 10);
}

}  // namespace
}  // namespace cromer
