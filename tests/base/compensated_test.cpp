#include "cromer/base/compensated.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

TEST(Compensated, SumsKeepWhatDoublesDrop) {
  Compensated sum = 1;
  double plain = 1;
  for (int i = 0; i < 1000; ++i) {
    sum += 1e-17;
    plain += 1e-17;
  }
  EXPECT_EQ(plain, 1);
  EXPECT_NEAR(((sum - 1) / 1e-14).value, 1, 1e-12);
}

TEST(Compensated, TheRestStaysBelowTheLastPlace) {
  Compensated sum = 0;
  for (int i = 1; i < 1000; ++i) {
    sum += 1.0 / i;
    EXPECT_EQ(sum.value + sum.rest, sum.value);
  }
}

TEST(Compensated, CancellationIsExact) {
  const Compensated a = Compensated(1) + 1e-20, b = a - 1;
  EXPECT_EQ(b.value, 1e-20);
  EXPECT_EQ((a - a).value, 0);
}

TEST(Compensated, ProductsAndQuotientsCarryTheRestsAlong) {
  const Compensated a(3, 1e-17), b(2, -1e-17);
  EXPECT_EQ((a * b).value, 6);
  EXPECT_NEAR((a * b).rest, -1e-17, 1e-30);  // 2 * 1e-17 - 3 * 1e-17
  EXPECT_EQ((a / b).value, 1.5);
  EXPECT_NEAR((a / b).rest, 1.25e-17, 1e-30);
}

TEST(Compensated, OrdersByTheRestWhereTheValuesAgree) {
  EXPECT_LT(Compensated(1, -1e-17), Compensated(1, 1e-17));
  EXPECT_GE(Compensated(2), Compensated(1, 1e-17));
  EXPECT_EQ(abs(Compensated(-2, 1e-17)), Compensated(2, -1e-17));
  EXPECT_EQ(sgn(Compensated(-2)), Compensated(-1));
}

}  // namespace
}  // namespace cromer
