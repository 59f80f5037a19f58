#include "cromer/methods/dormand_prince.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/model/driven_oscillator.h"

namespace cromer::core {
namespace CROMER_FILE {

const DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous")}> swinging({1, 9, 0.4, 0, 0, 0},
                                                                                        {1.0, 2.0, 0.3});
static_assert(AdaptiveMethod<DormandPrince, decltype(swinging), double>);

const State<double> start{0.5, -0.3};

double distance(const State<double>& a, const State<double>& b) { return std::hypot(a.x - b.x, a.v - b.v); }

TEST(DormandPrince, DenseOutputIsOfFourthOrder) {
  const DormandPrince method;
  const auto worst = [&](double h) {
    auto memory = method.start(swinging, 0.0, start);
    method.step(swinging, 0.0, h, start, memory);
    double most = 0;
    for (const double theta : {0.1, 0.3, 0.5, 0.8})
      most = std::fmax(most,
                       distance(method.dense_output(memory)(theta), swinging.propagate(0, theta * h, start)));
    return most;
  };
  // One step of a method of order 4 is off by h^5.
  EXPECT_NEAR(std::log2(worst(0.1) / worst(0.05)), 5, 0.15);
}

TEST(DormandPrince, DenseOutputMeetsTheEnds) {
  const DormandPrince method;
  auto memory = method.start(swinging, 0.0, start);
  const auto end = method.step(swinging, 0.0, 0.2, start, memory).y;
  EXPECT_EQ(method.dense_output(memory)(0.0), start);
  EXPECT_LT(distance(method.dense_output(memory)(1.0), end), 1e-16);
}

TEST(DormandPrince, TheEstimateIsTheErrorOfTheFourthOrderSolution) {
  const DormandPrince method;
  for (const double h : {0.02, 0.05}) {
    auto memory = method.start(swinging, 0.0, start);
    const auto trial = method.step(swinging, 0.0, h, start, memory);
    const State<double> fourth{trial.y.x - trial.error.x, trial.y.v - trial.error.v};
    const State<double> exact = swinging.propagate(0, h, start);
    EXPECT_LT(distance(trial.y, exact), 0.1 * distance(fourth, exact));
    EXPECT_GT(distance(trial.error, {0, 0}), 0.9 * distance(fourth, exact));
  }
}

TEST(DormandPrince, ARejectedCopyLeavesTheMemoryAsItWas) {
  const DormandPrince method;
  const auto memory = method.start(swinging, 0.0, start);
  auto rejected = memory, accepted = memory, fresh = method.start(swinging, 0.0, start);
  method.step(swinging, 0.0, 1.0, start, rejected);
  EXPECT_EQ(method.step(swinging, 0.0, 0.1, start, accepted).y,
            method.step(swinging, 0.0, 0.1, start, fresh).y);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
