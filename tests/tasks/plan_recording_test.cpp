#include "cromer/tasks/fit/plan_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/model/sensor.h"
#include "tests/tasks/disc_recording.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

/// A viscous decay: A exp(-g t) cos(w t) about 0.2 m, 100 a second; noise of correlation `rho` from one
/// sample to the next.
Series decay(double duration, double g, double noise, std::uint64_t seed, double rho = 0) {
  Series series;
  series.column = "Position (m)";
  series.quantity = "position";
  series.unit = "m";
  series.rate = 100;
  NormalDeviates normal(seed);
  double wander = noise * normal.next();
  for (int i = 0; i <= static_cast<int>(100 * duration); ++i) {
    const double t = i / 100.0;
    series.t.push_back(t);
    series.y.push_back(0.2 + 0.05 * std::exp(-g * t) * std::cos(9 * t) + wander);
    wander = rho * wander + std::sqrt(1 - rho * rho) * noise * normal.next();
  }
  return series;
}

FittedRecording fitted(const Series& series, const std::string& goal, const std::string& law = "viscous") {
  FitOptions options;
  options.law = law;
  options.goal = goal;
  const auto result = fit_series(series, "lab.csv", options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? *result : FittedRecording{};
}

/// The relative error of a quantity in records of the advised length, in the mean of several.
double reached(const char* quantity, double duration, double g, double rho) {
  double square = 0;
  constexpr int records = 12;
  for (int i = 0; i < records; ++i) {
    const FittedRecording result = fitted(decay(duration, g, 1e-3, 100 + static_cast<unsigned>(i), rho), "");
    const Estimate& estimate = *result.find(quantity);
    square += std::pow(estimate.standard_error / estimate.value, 2) / records;
  }
  return std::sqrt(square);
}

TEST(PlanRecording, TheAdvisedLengthReachesTheGoal) {
  // 5 cm, 1 mm, 100 a second, 0.05 1/s: known to 2 % after 5 s and to 0.37 % after 20 s.
  const FittedRecording result = fitted(decay(5, 0.05, 1e-3, 1), "decay_rate 0.5 %");
  ASSERT_TRUE(result.plan);
  EXPECT_FALSE(result.plan->met);
  EXPECT_TRUE(result.plan->possible);
  EXPECT_NEAR(result.plan->now / result.plan->value, 0.02, 0.004);
  EXPECT_NEAR(reached("decay_rate", result.plan->duration, 0.05, 0) / 0.005, 1, 0.1);
}

// The equilibrium is known the better the longer one records, with or without a swing: its error goes as one
// over the root of the number of samples. A larger swing does not help.
TEST(PlanRecording, TheEquilibriumGoesOnBeyondTheSwing) {
  const RecordingPlan plan = *fitted(decay(20, 0.2, 1e-3, 1), "equilibrium 3e-6 m").plan;
  EXPECT_TRUE(plan.possible);
  EXPECT_NEAR(plan.duration / std::pow(1e-3 / 3e-6, 2) * 100, 1, 0.1);
  const RecordingPlan never = *fitted(decay(20, 0.2, 1e-3, 1), "position 1e-5 m").plan;
  EXPECT_FALSE(never.possible);
  EXPECT_THAT(in_words(never.text), testing::Not(HasSubstr("start")));
  EXPECT_THAT(in_words(fitted(decay(20, 0.2, 1e-3, 1), "decay_rate 0.001 %").plan->text),
              HasSubstr("times as large"));
}

TEST(PlanRecording, CorrelatedNoiseTakesLonger) {
  const auto plan_of = [](double rho) {
    return *fitted(decay(20, 0.02, 1e-3, 1, rho), "frequency 0.001 %").plan;
  };
  const RecordingPlan white = plan_of(0), correlated = plan_of(0.7);
  EXPECT_NEAR(reached("frequency", white.duration, 0.02, 0) / 1e-5, 1, 0.1);
  EXPECT_NEAR(reached("frequency", correlated.duration, 0.02, 0.7) / 1e-5, 1, 0.1);
  EXPECT_GT(correlated.duration, 1.2 * white.duration);
}

TEST(PlanRecording, SaysThatItIsMetAndWhatWouldDo) {
  const FittedRecording result = fitted(decay(60, 0.05, 1e-3, 1), "decay_rate 1 %");
  ASSERT_TRUE(result.plan->met);
  EXPECT_LT(result.plan->duration, 20);
  EXPECT_NEAR(reached("decay_rate", result.plan->duration, 0.05, 0) / 0.01, 1, 0.1);
  EXPECT_THAT(in_words(result.plan->text), HasSubstr("the goal is met"));
}

TEST(PlanRecording, SaysWhenTheSwingDiesFirst) {
  // Long record: sd(b)/b = 4 sqrt(b h) sigma/A = 0.179 %, whatever follows.
  const FittedRecording result = fitted(decay(30, 0.05, 1e-3, 1), "decay_rate 0.1 %");
  ASSERT_FALSE(result.plan->possible);
  EXPECT_NEAR(result.plan->best / result.plan->value, 4 * std::sqrt(0.05 * 0.01) * 0.02, 0.08 * 0.00179);
  EXPECT_NEAR(result.plan->noise_ratio, 1.79, 0.15);
  EXPECT_THAT(in_words(result.plan->text), HasSubstr("the swing has died down"));
}

TEST(PlanRecording, HoldsForDragToo) {
  const FittedRecording first = fitted(disc_recording(5, 60), "drag 0.5 %", "viscous+drag");
  ASSERT_TRUE(first.plan && first.plan->possible && !first.plan->met);
  double square = 0;
  for (const unsigned seed : {6u, 7u, 8u, 9u}) {
    const FittedRecording then = fitted(disc_recording(seed, first.plan->duration), "", "viscous+drag");
    square += std::pow(then.fit["drag"].standard_error / then.fit["drag"].value, 2) / 4;
  }
  EXPECT_NEAR(std::sqrt(square) / 0.005, 1, 0.1);
}

TEST(PlanRecording, KnowsThatTheMassLimitsTheSpring) {
  FitOptions options;
  options.law = "viscous";
  options.mass = {Quantity{0.2, 0.001}};
  options.goal = "stiffness 0.1 %";
  const auto result = fit_series(decay(20, 0.05, 1e-3, 1), "lab.csv", options);
  ASSERT_TRUE(result.ok());
  EXPECT_FALSE(result->plan->possible);
  EXPECT_THAT(in_words(result->plan->text), HasSubstr("such as the mass"));
}

TEST(PlanRecording, RefusesGoalsThatAreNone) {
  EXPECT_THAT(in_words(parse_goal("dcay_rate 1 %").error()), HasSubstr("did you mean decay_rate?"));
  EXPECT_THAT(in_words(parse_goal("decay_rate").error()), HasSubstr("decay_rate 0.5 %"));
  EXPECT_THAT(in_words(parse_goal("decay rate 1 %").error()), HasSubstr("did you mean decay_rate?"));
  EXPECT_THAT(in_words(parse_goal("loudness 1 %").error()),
              HasSubstr("there are angular_frequency, decay_rate"));
  EXPECT_FALSE(parse_goal("decay_rate -1 %").ok());
  FitOptions options;
  options.law = "viscous";
  for (const char* goal : {"drag 1 %", "stiffness 1 %", "period 2 m", "period 0 s"}) {
    options.goal = goal;
    const auto result = fit_series(decay(10, 0.05, 1e-3, 1), "lab.csv", options);
    ASSERT_FALSE(result.ok()) << goal;
    EXPECT_THAT(in_words(result.error()), HasSubstr("--goal"));
    if (std::string(goal) == "drag 1 %") {
      EXPECT_THAT(in_words(result.error()), HasSubstr("fit one with drag by --law"));
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
