// Recordings that cannot be fitted: each has its status, a message and exit status 1, and no numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;

struct Unfit {
  const char* name;
  const char* law;
  int samples;  // at 100 a second
  std::function<double(double t, double normal)> position;
  const char* status;
  const char* said;
};

double decaying_swing(double t, double frequency = 8.8, double decay_rate = 0.05) {
  return 0.05 * std::exp(-decay_rate * t) * std::cos(frequency * t);
}

const Unfit unfit[] = {
    {"FewSamples", "auto", 7, [](double t, double) { return decaying_swing(t); }, "too_short", "too few"},
    {"FewerSamplesThanParameters", "viscous+drag+cubic", 6,
     [](double t, double) { return decaying_swing(100 * t); }, "too_short", "needs at least 10"},
    {"LessThanAPeriodAndAHalf", "auto", 100, [](double t, double) { return decaying_swing(t, 6.28); },
     "too_short", "periods"},
    {"Noise", "auto", 1000, [](double, double normal) { return 0.01 * normal; }, "no_oscillation",
     "no oscillation"},
    {"MoreNoiseThanSwing", "viscous", 4000,
     [](double t, double normal) { return 0.33 * decaying_swing(t, 8.8, 0) + 0.06 * normal; }, "too_noisy",
     "noisy"},
    {"NoReturn", "auto", 1000,
     [](double t, double normal) { return 0.06 * std::exp(-t) - 0.01 * std::exp(-6 * t) + 1e-5 * normal; },
     "overdamped", "without an oscillation"},
    {"Rest", "auto", 500, [](double, double) { return 0.2; }, "no_oscillation", "nothing moves"},
};

class UnfitRecording : public ::testing::TestWithParam<Unfit> {};

TEST_P(UnfitRecording, HasAStatusAMessageAndNoNumbers) {
  const Unfit& one = GetParam();
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  std::string text = "Time (s),Position (m)\n";
  char line[64];
  for (int i = 0; i < one.samples; ++i) {
    const double t = i / 100.0;
    std::snprintf(line, sizeof line, "%.2f,%.6f\n", t, one.position(t, normal(engine)));
    text += line;
  }
  const Folder folder;
  folder.write("lab.csv", text);
  const Finished end = folder.run({"fit", "lab.csv", "--law", one.law, "--json"});
  EXPECT_EQ(end.status, 1) << end.err;
  const auto document = end.json();
  EXPECT_EQ(document["status"], one.status);
  EXPECT_THAT(document.value("message", ""), HasSubstr(one.said));
  for (const char* numbers : {"parameters", "derived"})
    EXPECT_TRUE(!document.contains(numbers) || document[numbers].empty()) << document[numbers].dump();
  // People are told as well.
  const Finished words = folder.run({"fit", "lab.csv", "--law", one.law});
  EXPECT_EQ(words.status, 1);
  EXPECT_THAT(words.out + words.err, HasSubstr(one.said));
}

INSTANTIATE_TEST_SUITE_P(Fit, UnfitRecording, ::testing::ValuesIn(unfit),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
