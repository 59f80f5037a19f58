#include "cromer/identify/diagnose/second_mode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

// A decaying swing of amplitude 0.036 at 8.849 rad/s and something else, with noise.
template <class Other>
std::vector<ResidualLine> lines_beside(const Other& other, std::vector<std::string>* sentences = nullptr,
                                       unsigned seed = 1) {
  SyntheticRecord record = viscous_record({.g = 0.02, .velocity = 0}, even_times(4000, 0.01), 3e-4, 0, seed);
  for (std::size_t i = 0; i < record.t.size(); ++i) record.y[i] += other(record.t[i]);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous")});
  EXPECT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  if (sentences)
    *sentences =
        in_words(second_modes(residual_lines(record.record(), fit), fit, record.record().derivative, "m"));
  return residual_lines(record.record(), fit);
}

TEST(SecondMode, NoneInWhiteNoise) {
  for (unsigned seed = 1; seed <= 50; ++seed)
    EXPECT_TRUE(lines_beside([](double) { return 0.0; }, nullptr, seed).empty()) << seed;
}

TEST(SecondMode, NoneWhereTheLawIsWrongButTheSwingIsOne) {
  // Drag and a cubic spring seen by the viscous law: what is left lies about the swing's own line, and at
  // its third harmonic at most.
  const TrueSwing motion{.angular_frequency = 8.849, .drag = 0.5, .cubic = 3000, .position = 0.036};
  SyntheticRecord record{even_times(4000, 0.01), {}, 0};
  record.y = free_motion(motion, record.t, 1e-3).x;
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous")});
  for (const ResidualLine& line : residual_lines(record.record(), fit)) EXPECT_EQ(line.harmonic, 3);
}

TEST(SecondMode, ASecondModeHasItsFrequencyAndAmplitude) {
  for (const double w : {5.3, 10.1, 13.7, 31.0}) {
    std::vector<std::string> sentences;
    const auto lines =
        lines_beside([&](double t) { return 0.002 * std::exp(-0.03 * t) * std::cos(w * t + 1); }, &sentences);
    ASSERT_EQ(lines.size(), 1u) << w;
    EXPECT_NEAR(lines[0].angular_frequency, w, 0.02);
    EXPECT_NEAR(lines[0].amplitude, 0.002, 0.0004);
    EXPECT_EQ(lines[0].harmonic, 0);
    ASSERT_EQ(sentences.size(), 1u);
    EXPECT_THAT(sentences[0], HasSubstr("a second mode"));
  }
}

// It may die down in another way than an exponential.
TEST(SecondMode, OfAHarmonicTellsTheAmplitudeThatItHadAtFirst) {
  std::vector<std::string> sentences;
  const auto lines = lines_beside(
      [](double t) { return 0.002 * std::sqrt(std::max(0.0, 1 - t / 36)) * std::cos(2 * 8.849 * t); },
      &sentences);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_GT(lines[0].amplitude, 0.0023);
  EXPECT_NEAR(lines[0].told_amplitude, 0.002, 0.0002);
  EXPECT_THAT(sentences[0], HasSubstr(", at first with an amplitude of 0.0019 m"));
}

// More is left close beside the swing's own line, where no line is told from it.
TEST(SecondMode, ALineBesideALargerRestIsNotTheLargestPart) {
  std::vector<std::string> sentences;
  const auto lines = lines_beside(
      [](double t) { return 0.004 * std::cos(9.34 * t) + 0.002 * std::cos(9.86 * t); }, &sentences);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].angular_frequency, 9.86, 0.03);
  EXPECT_THAT(sentences[0], HasSubstr("not the largest part of the residual"));
}

TEST(SecondMode, TheModesOfCoupledPendulums) {
  const auto lines = lines_beside([](double t) { return 0.03 * std::exp(-0.02 * t) * std::cos(9.9 * t); });
  ASSERT_FALSE(lines.empty());
  EXPECT_NEAR(lines[0].angular_frequency, 9.9, 0.02);
  EXPECT_NEAR(lines[0].amplitude, 0.03, 0.004);
}

TEST(SecondMode, NearTwiceTheFrequencyIsNoHarmonic) {
  std::vector<std::string> sentences;
  const auto lines = lines_beside(
      [](double t) { return 0.001 * std::exp(-0.03 * t) * std::cos(2.0375 * 8.849 * t); }, &sentences);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].harmonic, 0);
  EXPECT_THAT(sentences[0], HasSubstr("a second mode"));
}

TEST(SecondMode, HarmonicsAreCalledThat) {
  for (const int multiple : {2, 3, 5, 7}) {
    std::vector<std::string> sentences;
    const auto lines = lines_beside(
        [&](double t) { return 0.001 * std::exp(-0.04 * t) * std::cos(multiple * 8.849 * t); }, &sentences);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].harmonic, multiple);
    EXPECT_THAT(sentences[0], HasSubstr("harmonic"));
  }
}

TEST(SecondMode, TheSwingOfAHarmonicHasItsFrequencyAtThatAmplitude) {
  // A hardening spring, half as fast again where it swings widely, and five times that.
  const TrueSwing motion{.angular_frequency = 6, .decay_rate = 0.02, .cubic = 60, .position = 0.9};
  SyntheticRecord record{even_times(4000, 0.01), {}, 0};
  record.y = free_motion(motion, record.t, 1e-3).x;
  const double wide = std::sqrt(36 + 0.75 * 60 * 0.9 * 0.9), line = 5 * 0.98 * wide;
  for (std::size_t i = 0; i < record.t.size(); ++i)
    record.y[i] += 0.01 * std::exp(-0.05 * record.t[i]) * std::cos(line * record.t[i]);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+cubic")});
  ASSERT_EQ(fit.status, FitStatus::converged);
  bool found = false;
  for (const Notice& notice :
       second_modes(residual_lines(record.record(), fit), fit, record.record().derivative, "m")) {
    const auto value = [](const Notice& of, std::string_view name) {
      for (const NoticeValue& each : of.values)
        if (each.name == name) return std::get<double>(each.value);
      return 0.0;
    };
    const double frequency = value(notice, "frequency");
    if (std::abs(frequency - line / two_pi) > 0.01) continue;
    const Notice& name = std::get<std::vector<Notice>>(notice.values.back().value).front();
    EXPECT_EQ(name.code, "higher_harmonic");
    EXPECT_NEAR(5 * value(name, "swing"), frequency, 1e-9);
    EXPECT_THAT(in_words(name), testing::HasSubstr("5 times the swing's frequency where that is 1.3"));
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST(SecondMode, IsLookedForInSixtyFourSamplesOrMore) {
  SyntheticRecord record = viscous_record({.g = 0.02, .velocity = 0}, even_times(64, 0.1), 1e-4);
  std::vector<double> other;
  for (const double t : record.t) other.push_back(0.003 * std::cos(15 * t));
  for (std::size_t i = 0; i < other.size(); ++i) record.y[i] += other[i];
  const Record all = record.record(), fewer = all.first(63), line{record.t, other, 0};
  const auto fitted = [](const Record& part) { return fit_law(part, {.law = law_of("viscous")}); };
  EXPECT_EQ(residual_lines(all, fitted(all)).size(), 1u);
  EXPECT_TRUE(residual_lines(fewer, fitted(fewer)).empty());
  EXPECT_EQ(second_drives(line, 8, "m").size(), 1u);
  EXPECT_TRUE(second_drives(line.first(63), 8, "m").empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
