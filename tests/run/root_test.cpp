#include "cromer/run/root.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

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

TEST(FindRoot, OfEndsThatAreNoBetterTheSecondCounts) {
  const auto f = [](double x) { return x * x; };
  EXPECT_EQ(find_root(f, -2, 4, 2, 4), 2);
  EXPECT_EQ(find_root(f, -1, 1, 2, 4), -1);
  EXPECT_EQ(find_root(f, 1, 0, 2, 0), 2);
  EXPECT_EQ(find_root([](double x) { return -x; }, 1, -1, 3, -3), 1);
}

TEST(FindRoot, IsTheSideOfTheSecondEndWhicheverWayItGoes) {
  for (const double place : {0.3, -0.3, 1e-3, 0.999})
    for (const double sign : {1.0, -1.0}) {
      const auto jump = [&](double x) { return x < place ? -sign : 3 * sign; };
      const double forth = find_root(jump, -1, jump(-1), 1, jump(1)),
                   back = find_root(jump, 1, jump(1), -1, jump(-1));
      EXPECT_GE(forth, place);
      EXPECT_NEAR(forth, place, 5e-16);
      EXPECT_LT(back, place);
      EXPECT_NEAR(back, place, 5e-16);
    }
}

TEST(FindRoot, NeverTakesMoreThanSomeSixtyEvaluations) {
  int evaluations = 0;
  const auto root = [&](auto f, double a, double b) {
    evaluations = 0;
    const auto counted = [&](double x) {
      ++evaluations;
      return f(x);
    };
    return find_root(counted, a, f(a), b, f(b));
  };
  for (const double place : {0.1, 1.0 / 3, 0.7, 0.999999}) {
    EXPECT_NEAR(root([&](double x) { return x < place ? -1.0 : 1e5; }, 0, 1), place, 5e-16);
    EXPECT_LE(evaluations, 65) << place;
    EXPECT_NEAR(root([&](double x) { return x < place ? -1.0 : 1e5; }, -1, 0.9999999), place, 5e-16);
    EXPECT_LE(evaluations, 65) << place;
    EXPECT_NEAR(root([&](double x) { return std::cbrt(x - place); }, 0, 1), place, 5e-16);
    EXPECT_LE(evaluations, 65) << place;
    EXPECT_NEAR(root([&](double x) { return std::exp(8 * x) - std::exp(8 * place); }, 0, 1), place, 5e-16);
    EXPECT_LE(evaluations, 14) << place;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
