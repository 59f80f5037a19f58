// Fits of recordings whose times slip once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double w0 = 6, rate = 0.03, spacing = 0.02;

// A swing of 40 s, of which so many samples are lost at some time (told again, if negative) while the times
// go on.
std::string slipped(int lost, double at, unsigned seed, double noise = 2e-3) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, noise);
  const double w = std::sqrt(w0 * w0 - rate * rate);
  std::string bytes = "Time (s),Angle (rad)\n";
  for (int i = 0; i < 2000; ++i) {
    const double t = spacing * i, when = t + (t < at ? 0 : spacing * lost);
    bytes += std::to_string(t) + "," +
             std::to_string(0.1 + 0.3 * std::exp(-rate * when) * std::cos(w * when) + normal(engine)) + "\n";
  }
  return bytes;
}

FittedRecording fitted(const std::string& bytes) {
  const auto found = fit(bytes, "slip.csv", {});
  EXPECT_TRUE(found) << in_words(found.error());
  return found ? found->front() : FittedRecording{};
}

// The law is the viscous one and the uncertainties hold, that of the slip in them. With the one of seed 26 a
// pendulum had been chosen, and no slip looked for.
TEST(SlippedRecordings, AreFittedWithoutTheSlip) {
  double w_square = 0, g_square = 0, fits = 0;
  for (const int lost : {1, 3, -2})
    for (unsigned seed = 15; seed <= 26; ++seed, ++fits) {
      const FittedRecording found = fitted(slipped(lost, 12 + 0.4 * seed, seed));
      ASSERT_TRUE(found.succeeded());
      EXPECT_EQ(to_text(found.fit.law), "viscous") << lost << " " << seed;
      ASSERT_EQ(found.notices.front().code, "slip_taken_out") << lost << " " << seed;
      const Estimate w = found.fit.angular_frequency(), g = found.fit.decay_rate();
      w_square += std::pow((w.value - w0) / w.standard_error, 2);
      g_square += std::pow((g.value - rate) / g.standard_error, 2);
    }
  EXPECT_LT(std::sqrt(w_square / fits), 1.3);
  EXPECT_GT(std::sqrt(w_square / fits), 0.7);
  EXPECT_LT(std::sqrt(g_square / fits), 1.3);
}

// The slip widens the frequency's uncertainty: a part of the record before it and one after it know its phase
// apart from each other.
TEST(SlippedRecordings, KnowTheFrequencyLessWell) {
  const FittedRecording slips = fitted(slipped(2, 20, 1)), even = fitted(slipped(0, 20, 1));
  const double times =
      slips.fit.angular_frequency().standard_error / even.fit.angular_frequency().standard_error;
  EXPECT_GT(times, 1.5);
  EXPECT_LT(times, 2.5);
  EXPECT_EQ(even.notices.size(), 0u);
}

TEST(SlippedRecordings, SayWhatWasShiftedAndWhatTheTimesAsToldWouldGive) {
  const FittedRecording lost = fitted(slipped(3, 16, 4)), twice = fitted(slipped(-3, 16, 4));
  EXPECT_THAT(in_words(lost.notices.front()),
              testing::AllOf(testing::HasSubstr("the times slip by 0.06 s at 16"),
                             testing::HasSubstr("as if the recorder had lost samples there"),
                             testing::HasSubstr("later times are put later by as much"),
                             testing::HasSubstr("viscous")));
  EXPECT_THAT(
      in_words(twice.notices.front()),
      testing::HasSubstr("repeated samples there (a knock looks alike): later times are put earlier"));
  EXPECT_EQ(lost.samples, 2000u);
  EXPECT_EQ(lost.series.t.size(), 2000u);
  EXPECT_NEAR(lost.series.t.back(), 1999 * spacing + 0.06, 0.005);
  EXPECT_NEAR(static_cast<double>(twice.series.t.size()), 1997, 1);
  EXPECT_GT(lost.of_record, 0u);
  EXPECT_TRUE(lost.left_out.t.empty());
  EXPECT_TRUE(twice.left_out.t.empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
