// The laws of other people's recordings, with --law auto.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/support/shared_data.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;

// Empty if the recording is not here.
std::optional<FittedRecording> fitted(const char* name, const FitOptions& options) {
  const std::string path = data(name);
  if (!std::filesystem::exists(path)) return std::nullopt;
  auto fits = fit(bytes_of(path), path, options);
  EXPECT_TRUE(fits.ok()) << in_words(fits.error());
  if (!fits.ok()) return std::nullopt;
  EXPECT_EQ(fits->front().fit.status, FitStatus::converged) << in_words(fits->front().fit.message);
  return std::move(fits->front());
}

#define SKIP_WITHOUT_FIT(result) \
  if (!result) GTEST_SKIP() << "the recording is not here"

TEST(MeasuredLaws, TheFullDiscsResidualIsThatOfAnIndependentFit) {
  const auto result = fitted("spring-disc-pasco/molla_durissima_discopieno_14.91945_0.2016_1.csv", {});
  SKIP_WITHOUT_FIT(result);
  EXPECT_LT(result->fit.residual.rms, 0.57e-3);  // drag, cubic and viscous elsewhere: 0.882 mm
  EXPECT_EQ(to_text(result->fit.law), "viscous+drag+odd-quadratic");
}

TEST(MeasuredLaws, TheSpringConstantIsTheStaticOne) {
  const char* file = "spring-disc-capstone-mm/Oscillazioni non_pretensionata_cd_3e1masse.csv";
  const double masses[] = {0.09472, 0.05519}, residuals[] = {0.32e-3, 0.18e-3};
  for (int run : {1, 2}) {
    FitOptions options{
        .run = run, .mass = {Quantity{masses[run - 1], 0}}, .spring_mass = Quantity{0.01543, 0}};
    options.read.rate = 100;
    const auto result = fitted(file, options);
    SKIP_WITHOUT_FIT(result);
    EXPECT_LT(result->fit.residual.rms, residuals[run - 1]);
    EXPECT_NEAR(result->find("stiffness")->value, 3.226, 0.015 * 3.226);
  }
}

TEST(MeasuredLaws, NoLawIsTriedTwice) {
  const auto result = fitted("pendulum-phyphox/RawData_converted_from_xls.csv", {});
  SKIP_WITHOUT_FIT(result);
  std::vector<std::string> laws;
  for (const Candidate& each : result->candidates) laws.push_back(to_text(each.law));
  std::sort(laws.begin(), laws.end());
  EXPECT_EQ(std::adjacent_find(laws.begin(), laws.end()), laws.end());
}

// Swung by a hand at first, and stopped by one.
TEST(MeasuredLaws, APhoneBetweenTwoHandsIsAPendulum) {
  const auto result = fitted("pendulum-phyphox/RawData_converted_from_xls.csv", {});
  SKIP_WITHOUT_FIT(result);
  EXPECT_TRUE(result->fit.law.has<Pendulum>());
  EXPECT_GT(result->series.t.front(), 2);
  EXPECT_LT(result->series.t.back(), 8.5);  // the next half swing is a seventh smaller, and has two humps
}

TEST(MeasuredLaws, APendulumOnFilm) {
  const auto result = fitted("pendulum-tracker/8047.txt", {.column = "x"});
  SKIP_WITHOUT_FIT(result);
  EXPECT_LT(result->fit.residual.rms, 1.8e-3);  // 9.9 mm with one exponential
}

TEST(MeasuredLaws, APendulumOnAnEncoderIsAPendulum) {
  const auto result = fitted("pendulum-plain/encoder_comma_space.csv", {});
  SKIP_WITHOUT_FIT(result);
  EXPECT_TRUE(result->fit.law.has<Pendulum>());
  EXPECT_LT(result->fit.residual.rms, 0.03);  // 0.43 with one exponential
}

TEST(MeasuredLaws, TheReleaseOfADrivenPendulumIsFound) {
  const auto result = fitted("torsion-50hz/0.96500.1.csv", {.column = "Pendolo"});
  SKIP_WITHOUT_FIT(result);
  EXPECT_NEAR(result->series.t.front(), 210.06, 2);  // where its drive's own column ends
  EXPECT_GE(result->series.t.front(), 210.06);
  EXPECT_THAT(in_words(result->notices), Contains(HasSubstr("as when a drive stops")));
  // --from overrides.
  const auto own = fitted("torsion-50hz/0.96500.1.csv", {.column = "Pendolo", .from = 220});
  EXPECT_NEAR(own->series.t.front(), 220, 0.02);
  EXPECT_NEAR(own->fit.decay_rate().value, result->fit.decay_rate().value,
              0.05 * result->fit.decay_rate().value);
}

TEST(MeasuredLaws, ARateGyroIsFittedAsOne) {
  const auto result =
      fitted("wheel-gyro/bicycle-wheel-radial-inertia-rate-gyro-measurement.csv", {.law = "viscous"});
  SKIP_WITHOUT_FIT(result);
  EXPECT_EQ(result->fit.names.size(), 5u);
  for (const Parameter& parameter : result->parameters) {
    if (parameter.name == "equilibrium") {
      EXPECT_EQ(parameter.unit, "rad/s");
    }
    if (parameter.name == "position") {
      EXPECT_EQ(parameter.unit, "rad");
    }
    if (parameter.name == "velocity") {
      EXPECT_EQ(parameter.unit, "rad/s");
    }
  }
  EXPECT_THAT(in_words(result->notices), Contains(HasSubstr("is fitted as such")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
