#include "cromer/base/dual.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

using D = Dual<double, 2>;

TEST(Dual, ProductAndQuotientRules) {
  const D x = D::variable(3, 0), y = D::variable(-2, 1);
  const D z = (x * y + 2.0 * x - y / x) / (1.0 + y * y);
  const double f = (3 * -2 + 6 + 2.0 / 3) / 5;
  EXPECT_DOUBLE_EQ(z.value, f);
  EXPECT_DOUBLE_EQ(z.derivative[0], (-2 + 2 - 2.0 / 9) / 5);
  EXPECT_DOUBLE_EQ(z.derivative[1], ((3 - 1.0 / 3) - f * -4) / 5);
}

TEST(Dual, FunctionsAgreeWithTheirDerivatives) {
  const double u = 0.7;
  const D x = D::variable(u, 0);
  EXPECT_DOUBLE_EQ(sin(x).derivative[0], std::cos(u));
  EXPECT_DOUBLE_EQ(cos(x).derivative[0], -std::sin(u));
  EXPECT_DOUBLE_EQ(exp(x).derivative[0], std::exp(u));
  EXPECT_DOUBLE_EQ(expm1(x).derivative[0], std::exp(u));
  EXPECT_DOUBLE_EQ(expm1(x).value, std::expm1(u));
  EXPECT_DOUBLE_EQ(log(x).derivative[0], 1 / u);
  EXPECT_DOUBLE_EQ(sqrt(x).derivative[0], 0.5 / std::sqrt(u));
  EXPECT_DOUBLE_EQ(abs(-x).derivative[0], 1);
  EXPECT_EQ(sin(x).derivative[1], 0);
  const D y = D::variable(-0.4, 1);
  EXPECT_DOUBLE_EQ(hypot(x, y).derivative[1], -0.4 / std::hypot(u, 0.4));
  EXPECT_DOUBLE_EQ(atan2(y, x).derivative[0], 0.4 / (u * u + 0.16));
  EXPECT_DOUBLE_EQ(atan2(y, x).derivative[1], u / (u * u + 0.16));
}

TEST(Dual, QuadraticDragIsSmoothAtRest) {
  const D v = D::variable(0, 0);
  EXPECT_EQ((v * abs(v)).derivative[0], 0);
}

TEST(Dual, SignHasNoSlope) {
  EXPECT_EQ(sgn(D::variable(-3, 0)).value, -1);
  EXPECT_EQ(sgn(D::variable(0, 0)).value, 0);
  EXPECT_EQ(sgn(D::variable(2, 0)).derivative[0], 0);
}

TEST(Dual, ComparesByValue) {
  EXPECT_TRUE(D::variable(1, 0) < D(2.0));
  EXPECT_TRUE(D::variable(1, 0) == D(1.0));
  EXPECT_TRUE(D(2) >= D(2.0));
}

TEST(Dual, NestsForSecondDerivatives) {
  using Inner = Dual<double, 1>;
  using Outer = Dual<Inner, 1>;
  const Outer x(Inner::variable(0.3, 0), {Inner(1.0)});
  const Outer y = x * x * sin(x);
  // (x^2 sin x)'' = 2 sin x + 4 x cos x - x^2 sin x
  EXPECT_NEAR(y.derivative[0].derivative[0], 2 * std::sin(0.3) + 1.2 * std::cos(0.3) - 0.09 * std::sin(0.3),
              1e-15);
  EXPECT_EQ(value_of(y), 0.09 * std::sin(0.3));
}

TEST(Dual, MayBeDividedAndMultipliedByItself) {
  auto x = Dual<double, 1>::variable(3, 0);
  x *= x;
  EXPECT_EQ(x.value, 9);
  EXPECT_EQ(x.derivative[0], 6);
  const auto& itself = x;
  x /= itself;
  EXPECT_EQ(x.value, 1);
  EXPECT_EQ(x.derivative[0], 0);
}

TEST(Dual, EveryOperationHasItsSlopes) {
  const D x = D::variable(3, 0), y = D::variable(-2, 1);
  EXPECT_EQ((-x).value, -3);
  EXPECT_EQ((-x).derivative, (std::array<double, 2>{-1, 0}));
  EXPECT_EQ((x - y).derivative, (std::array<double, 2>{1, -1}));
  EXPECT_EQ((x + y).derivative, (std::array<double, 2>{1, 1}));
  EXPECT_EQ((x * y).derivative, (std::array<double, 2>{-2, 3}));
  EXPECT_EQ((x / y).derivative, (std::array<double, 2>{-0.5, -0.75}));
  EXPECT_EQ((4 * y).value, -8);
  EXPECT_EQ((4 * y).derivative, (std::array<double, 2>{0, 4}));
  EXPECT_EQ((4.0 * y).derivative, (std::array<double, 2>{0, 4}));
  EXPECT_EQ(pow(x, 3).value, 27);
  EXPECT_EQ(pow(x, 3).derivative, (std::array<double, 2>{27, 0}));
  EXPECT_EQ(hypot(x, D(4.0)).value, 5);
  EXPECT_DOUBLE_EQ(hypot(x, D(4.0)).derivative[0], 0.6);
  EXPECT_EQ(log(x).value, std::log(3));
  EXPECT_EQ(sqrt(D(9.0)).value, 3);
  EXPECT_EQ(atan2(y, x).value, std::atan2(-2, 3));
  EXPECT_EQ(abs(y).value, 2);
  EXPECT_EQ(value_of(2.5L), 2.5);
}

TEST(Dual, ComparesAtAndBesideTheLimit) {
  const D one = D::variable(1, 0), same(1.0), two(2.0);
  EXPECT_FALSE(one < same);
  EXPECT_FALSE(one > same);
  EXPECT_TRUE(one <= same);
  EXPECT_TRUE(one >= same);
  EXPECT_TRUE(two > one);
  EXPECT_TRUE(one <= two);
  EXPECT_FALSE(two <= one);
  EXPECT_FALSE(one >= two);
  EXPECT_FALSE(one == two);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
