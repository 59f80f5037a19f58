#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/tasks/curves/method_map.h"
#include "cromer/tasks/curves/work_precision.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(MethodMap, IsTheClosedFormOfTheEulers) {
  MethodMapOptions options;
  options.simulate.natural_frequency = 1;
  options.simulate.damping_ratio = 0.02;
  options.simulate.method = {"forward-euler", "euler-cromer"};
  options.points = 20;
  const auto map = method_map(options);
  ASSERT_TRUE(map.ok());
  EXPECT_NEAR(map->decay_rate, 0.02, 1e-15);
  for (std::size_t i = 0; i < 20; ++i) {
    const double h = map->curves[0].wh[i];
    EXPECT_NEAR(map->curves[0].at[i].decay_rate, -std::log(1 - 0.04 * h + h * h) / (2 * h), 1e-12);
    if (h < 1.9) {
      EXPECT_NEAR(map->curves[1].at[i].decay_rate, -std::log(1 - 0.04 * h) / (2 * h), 1e-12);
    }
  }
  EXPECT_NEAR(map->curves[0].at_a_tenth.decay_rate, -std::log(1 - 0.004 + 0.01) / 0.2, 1e-12);
  EXPECT_NEAR(*map->curves[0].stable_up_to, 0.04, 1e-9) << "2 b/w^2";
  EXPECT_NEAR(map->curves[0].wh.front(), 0.02, 1e-15);
  EXPECT_NEAR(map->curves[0].wh.back(), 2.5, 1e-12);
}

TEST(MethodMap, ShowsAnAdaptiveMethodAtTheStepsItMightChoose) {
  MethodMapOptions options;
  options.simulate.method = {"dormand-prince", "rk4", "exact"};
  options.from = 0.1, options.to = 0.2, options.points = 2;
  const auto map = method_map(options);
  ASSERT_TRUE(map.ok());
  const auto error = [&](std::size_t method, std::size_t i) {
    return map->curves[method].at[i].frequency_error;
  };
  // Undamped, an error in frequency is even in the step: one power more than the method's odd order.
  EXPECT_NEAR(std::log2(error(0, 1) / error(0, 0)), 6, 0.1);
  EXPECT_NEAR(std::log2(error(1, 1) / error(1, 0)), 4, 0.1);
  EXPECT_LT(error(0, 0), error(1, 0) / 10);
  EXPECT_EQ(error(2, 0), 0);
  // RK4 on the imaginary axis: sqrt 8.
  EXPECT_NEAR(*map->curves[1].stable_up_to, std::sqrt(8), 1e-6);
  EXPECT_FALSE(map->curves[2].stable_up_to);
}

TEST(MethodMap, RefusesWhatHasNoOneFrequency) {
  MethodMapOptions options;
  options.simulate.law.cubic = 1;
  EXPECT_FALSE(method_map(options).ok());
  options.simulate.law.cubic = 0;
  options.simulate.damping = 5;
  EXPECT_FALSE(method_map(options).ok());
}

TEST(WorkPrecision, FallsWithTheOrder) {
  WorkPrecisionOptions options;
  options.simulate.damping = 0.04;
  options.simulate.until = 20;
  options.simulate.method = {"verlet", "rk4", "dormand-prince"};
  options.halvings = 9;
  const auto work = work_precision(options);
  ASSERT_TRUE(work.ok());
  EXPECT_NEAR(work->curves[0].slope, -2, 0.1);
  EXPECT_NEAR(work->curves[1].slope, -4, 0.15);
  EXPECT_NEAR(work->curves[2].slope, -5, 0.5);
  for (const auto& curve : work->curves)
    for (std::size_t i = 1; i < curve.evaluations.size(); ++i)
      EXPECT_GT(curve.evaluations[i], curve.evaluations[i - 1]) << curve.method;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
