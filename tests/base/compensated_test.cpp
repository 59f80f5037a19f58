#include "cromer/base/compensated.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

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

TEST(Compensated, TheSignTurnsWithItsRest) {
  EXPECT_EQ(-Compensated(2, 1e-17), Compensated(-2, -1e-17));
  EXPECT_EQ(sgn(Compensated(3)), Compensated(1));
  EXPECT_EQ(sgn(Compensated(0)), Compensated(0));
  EXPECT_EQ(abs(Compensated(2, -1e-17)), Compensated(2, -1e-17));
  Compensated x(6, 1e-17);
  x -= Compensated(2);
  EXPECT_EQ(x.value, 4);
  x *= Compensated(3);
  EXPECT_EQ(x.value, 12);
  x /= Compensated(6);
  EXPECT_EQ(x.value, 2);
  EXPECT_EQ(value_of(x), 2);
}

TEST(Compensated, ComparesTheValueFirst) {
  const Compensated low(1, 1e-17), high(2, -1e-17);
  EXPECT_TRUE(low < high);
  EXPECT_FALSE(high < low);
  EXPECT_FALSE(low < low);
  EXPECT_FALSE(low > low);
  EXPECT_TRUE(high > low);
  EXPECT_TRUE(low <= low);
  EXPECT_TRUE(low >= low);
  EXPECT_FALSE(low >= high);
  EXPECT_FALSE(high <= low);
}

TEST(Compensated, SineAndCosineCarryTheRestByTheirSlopes) {
  const double u = 0.7;
  const Compensated x(u, 1e-17);
  EXPECT_EQ(sin(x), Compensated(std::sin(u), std::cos(u) * 1e-17));
  EXPECT_EQ(cos(x), Compensated(std::cos(u), -std::sin(u) * 1e-17));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
