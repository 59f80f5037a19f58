#include "cromer/tasks/fit/mass_line.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/model/sensor.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

FittedRecording fitted(double w, double error) {
  FittedRecording result;
  result.file = "lab.csv";
  result.fit.student = 1.96;
  result.fit.names = {"angular_frequency"};
  result.fit.estimates = {make_estimate(w, error, 1.96)};
  return result;
}

TEST(MassLine, FindsTheSpringAndItsOwnMass) {
  const double k = 16, spring = 0.015;
  std::vector<FittedRecording> fits;
  std::vector<Quantity> masses;
  NormalDeviates normal(3);
  for (const double m : {0.1, 0.15, 0.2, 0.25}) {
    const double w = std::sqrt(k / (m + spring / 3)), error = 1e-4 * w;
    fits.push_back(fitted(w + error * normal.next(), error));
    masses.push_back({m, 1e-5});
  }
  const auto line = mass_line(fits, masses);
  ASSERT_TRUE(line.ok()) << in_words(line.error());
  EXPECT_NEAR(line->stiffness.value, k, 4 * line->stiffness.standard_error);
  EXPECT_LT(line->stiffness.standard_error, 1e-3 * k);
  EXPECT_NEAR(line->spring_mass.value, spring, 4 * line->spring_mass.standard_error);
  EXPECT_NEAR(line->effective_mass.value * 3, line->spring_mass.value, 1e-15);
}

TEST(MassLine, LeavesOutWhatFailedAndRefusesTheRest) {
  std::vector<FittedRecording> fits{fitted(10, 0.01), fitted(9, 0.01), fitted(8, 0.01)};
  fits[1].fit.status = FitStatus::too_noisy;
  fits[1].fit.message = Notice{"too noisy"};
  const std::vector<Quantity> masses{{0.1, 0}, {0.12, 0}, {0.16, 0}};
  const auto line = mass_line(fits, masses);
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->points.size(), 2u);
  EXPECT_THAT(in_words(line->notices).front(), HasSubstr("left out of the line: too noisy"));
  EXPECT_THAT(in_words(mass_line(fits, {{0.1, 0}}).error()), HasSubstr("1 masses are given for 3"));
  EXPECT_THAT(in_words(mass_line(fits, {{0.2, 0}, {0.15, 0}, {0.1, 0}}).error()), HasSubstr("in the order"));
}

}  // namespace
}  // namespace cromer::core
