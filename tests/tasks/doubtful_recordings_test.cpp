// Recordings from which no spectrum, or a doubtful one, is made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

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
    EXPECT_THAT(in_words(result.error()), HasSubstr(part));
}

TEST(DoubtfulRecordings, OneSampleIsSaidToBeOne) {
  const SpectrumFile file{"one.csv", "time (s),a (m/s^2)\n0,1\n"};
  const auto result = response_spectrum({&file, 1}, one_period());
  ASSERT_FALSE(result);
  EXPECT_THAT(in_words(result.error()), HasSubstr("one.csv: column \"a (m/s^2)\" has one sample"));
}

TEST(DoubtfulRecordings, TheSameComponentTwiceIsSaid) {
  const SpectrumFile same[] = {shake("a.csv", 1), shake("b.csv", 1)};
  const auto result = response_spectrum(same, one_period());
  ASSERT_TRUE(result);
  EXPECT_THAT(in_words(result->notices),
              Contains(AllOf(HasSubstr("a.csv"), HasSubstr("b.csv"), HasSubstr("the same samples"))));
  EXPECT_NEAR(result->spectra[0].rotd100[0] / result->spectra[0].displacement[0][0], std::sqrt(2.0), 1e-12);
  const SpectrumFile other[] = {shake("a.csv", 1), shake("b.csv", 2)};
  EXPECT_THAT(in_words(response_spectrum(other, one_period())->notices),
              Not(Contains(HasSubstr("the same samples"))));
}

TEST(DoubtfulRecordings, ComponentsOfTwoMotionsAreSaid) {
  const auto peer = [](const char* name, const char* motion, const char* values) {
    return SpectrumFile{name, std::string("PEER NGA STRONG MOTION DATABASE RECORD\n") + motion +
                                  "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  5, DT=   .0100 SEC,\n" +
                                  values + "\n"};
  };
  const auto warnings = [&](const char* first, const char* second) {
    const SpectrumFile files[] = {peer("a.AT2", first, "0 .1 0 -.1 0"),
                                  peer("b.AT2", second, "0 .1 .2 .1 0")};
    const auto result = response_spectrum(files, one_period());
    return result ? in_words(result->notices) : std::vector<std::string>{in_words(result.error())};
  };
  EXPECT_THAT(warnings("Loma Prieta, 10/18/1989, Corralitos, 0", "Loma Prieta, 10/18/1989, Corralitos, 90"),
              Not(Contains(HasSubstr("two motions"))));
  EXPECT_THAT(warnings("Loma Prieta, 10/18/1989, Corralitos, 0", "Loma Prieta, 10/18/1989, Capitola, 90"),
              Contains(AllOf(HasSubstr("a.AT2 is of \"Loma Prieta, 10/18/1989, Corralitos\""),
                             HasSubstr("b.AT2 of \"Loma Prieta, 10/18/1989, Capitola\""))));
  EXPECT_THAT(warnings("recorded here", "recorded there"), Not(Contains(HasSubstr("two motions"))));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
