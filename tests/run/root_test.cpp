#include "cromer/run/root.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer {
namespace {

TEST(FindRoot, IsRightToRoundingWithFewEvaluations) {
  int evaluations = 0;
  const auto counted = [&](auto f) {
    return [&evaluations, f](double x) {
      ++evaluations;
      return f(x);
    };
  };
  const auto root = [&](auto f, double a, double b) { return find_root(counted(f), a, f(a), b, f(b)); };
  EXPECT_NEAR(root([](double x) { return std::cos(x); }, 0, 3), std::acos(0), 1e-15);
  EXPECT_NEAR(root([](double x) { return x * x - 2; }, 0, 2), std::sqrt(2), 1e-15);
  EXPECT_NEAR(root([](double x) { return 1e9 * (x - 0.3); }, 0, 1), 0.3, 1e-16);
  EXPECT_LT(evaluations, 40);
  // Flat at the root: bisection, all the way.
  EXPECT_NEAR(root([](double x) { return std::pow(x - 0.7, 9); }, 0, 1), 0.7, 1e-15);
}

TEST(FindRoot, GivesTheFarSideOfAJump) {
  const auto jump = [](double x) { return x < 0.3 ? -1.0 : 2.0; };
  const double x = find_root(jump, 0, -1, 1, 2);
  EXPECT_GE(x, 0.3);
  EXPECT_NEAR(x, 0.3, 5e-16);
}

TEST(FindRoot, TakesAnEndThatIsARoot) {
  const auto f = [](double x) { return x - 1; };
  EXPECT_EQ(find_root(f, 0, -1, 1, 0), 1);
  EXPECT_EQ(find_root(f, 1, 0, 2, 1), 1);
  EXPECT_EQ(find_root(f, 3, 2, 2, 1), 2) << "no change of sign: the better end";
}

}  // namespace
}  // namespace cromer
