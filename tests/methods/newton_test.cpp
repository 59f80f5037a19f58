#include "cromer/methods/newton.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

TEST(Newton, ConvergesQuadratically) {
  const auto square = [](const Dual<double, 1>& u) { return u * u - 2.0; };
  const auto solved = newton(square, 1.5, {1, 0}, {.tolerance = 1e-14});
  EXPECT_TRUE(solved.converged);
  EXPECT_DOUBLE_EQ(solved.root, std::sqrt(2.0));
  EXPECT_LE(solved.iterations, 5);
}

TEST(Newton, AToleranceLargerThanTheFirstUpdateTakesOneIteration) {
  const auto linear = [](const Dual<double, 1>& u) { return 3.0 * u - 3.3; };
  EXPECT_EQ(newton(linear, 1.0, {1, 0}, {.tolerance = 0.2}).iterations, 1);
  EXPECT_EQ(newton(linear, 1.0, {1, 0}, {.tolerance = 1e-12}).iterations, 2);
}

TEST(Newton, StallingAtRoundingLevelIsConvergence) {
  // The residual is known to 1e-13 only: below that it is noise of either sign.
  const auto noisy = [](const Dual<double, 1>& u) { return (u - 1.0) + (u.value > 1 ? 1e-13 : -1e-13); };
  const auto solved = newton(noisy, 0.5, {1, 0}, {.tolerance = 1e-15});
  EXPECT_TRUE(solved.converged);
  EXPECT_LT(solved.iterations, 10);
  EXPECT_NEAR(solved.root, 1, 3e-13);
}

TEST(Newton, StallingAboveItIsNot) {
  const auto jump = [](const Dual<double, 1>& u) { return u + 0.5 * sgn(u); };
  const auto solved = newton(jump, 0.1, {1, 0}, {.tolerance = 1e-12, .iteration_limit = 12});
  EXPECT_FALSE(solved.converged);
  EXPECT_EQ(solved.iterations, 12);
}

TEST(Newton, FindsTwoUnknowns) {
  using Two = std::array<Dual<double, 2>, 2>;
  const auto circle_and_line = [](const Two& u) {
    return Two{u[0] * u[0] + u[1] * u[1] - 25.0, u[0] - u[1] + 1.0};
  };
  const auto solved = newton(circle_and_line, std::array{2.0, 5.0}, {1, 0}, {.tolerance = 1e-14});
  EXPECT_TRUE(solved.converged);
  EXPECT_DOUBLE_EQ(solved.root[0], 3);
  EXPECT_DOUBLE_EQ(solved.root[1], 4);
  EXPECT_LE(solved.iterations, 7);

  const auto parallel = [](const Two& u) { return Two{u[0] + u[1] - 1.0, u[0] + u[1] - 2.0}; };
  EXPECT_FALSE(newton(parallel, std::array{0.0, 0.0}, {1, 0}, {}).converged);
}

TEST(Newton, NotANumberIsNotConvergence) {
  const auto broken = [](const Dual<double, 1>& u) { return sqrt(u - 5.0); };
  EXPECT_FALSE(newton(broken, 1.0, {1, 0}, {}).converged);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
