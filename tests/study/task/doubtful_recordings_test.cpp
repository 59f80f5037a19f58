// Recordings from which no spectrum, or a doubtful one, is made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cromer/study/task/response_spectrum.h"

namespace cromer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SpectrumFile shake(const std::string& name, double scale, const std::string& sixth = "") {
  std::string bytes = "time (s),a (m/s^2)\n";
  for (int i = 0; i < 50; ++i)
    bytes += std::to_string(0.01 * i) + "," +
             (i == 5 && !sixth.empty() ? sixth : std::to_string(scale * std::sin(0.3 * i))) + "\n";
  return {name, bytes};
}

SpectrumOptions one_period() {
  SpectrumOptions options;
  options.periods = "0.2";
  options.peaks = "samples";
  return options;
}

TEST(DoubtfulRecordings, ValuesWhoseSquareOverflowsAreRefused) {
  const SpectrumFile file = shake("huge.csv", 1, "1e300");
  const auto result = response_spectrum({&file, 1}, one_period());
  ASSERT_FALSE(result);
  for (const char* part : {"huge.csv", "1e+300", "sample 6"})
    EXPECT_THAT(result.error().message, HasSubstr(part));
}

TEST(DoubtfulRecordings, OneSampleIsSaidToBeOne) {
  const SpectrumFile file{"one.csv", "time (s),a (m/s^2)\n0,1\n"};
  const auto result = response_spectrum({&file, 1}, one_period());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("one.csv: column \"a (m/s^2)\" has one sample"));
}

TEST(DoubtfulRecordings, TheSameComponentTwiceIsSaid) {
  const SpectrumFile same[] = {shake("a.csv", 1), shake("b.csv", 1)};
  const auto result = response_spectrum(same, one_period());
  ASSERT_TRUE(result);
  EXPECT_THAT(result->warnings,
              ElementsAre(AllOf(HasSubstr("a.csv"), HasSubstr("b.csv"), HasSubstr("the same samples"))));
  EXPECT_NEAR(result->spectra[0].rotd100[0] / result->spectra[0].displacement[0][0], std::sqrt(2.0), 1e-12);
  const SpectrumFile other[] = {shake("a.csv", 1), shake("b.csv", 2)};
  EXPECT_THAT(response_spectrum(other, one_period())->warnings, IsEmpty());
}

}  // namespace
}  // namespace cromer
