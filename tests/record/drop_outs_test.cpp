// Stretches that a motion sensor did not see, told from what motions do.
#include "cromer/record/dialects/drop_outs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/record/dialects/recording.h"

namespace cromer::dialects {
namespace {

using testing::Contains;
using testing::IsEmpty;

constexpr int samples = 3000;
constexpr double step = 0.01;

/// A damped swing of 1 Hz; `spoil` may change a value.
template <class Spoil>
Series swing(Spoil spoil, const char* column = "Position (m)", double noise = 0.0005) {
  std::mt19937 random(3);
  std::normal_distribution<double> bell(0, noise);
  std::string text = concat({"Time (s),", column, "\n"});
  for (int i = 0; i < samples; ++i) {
    const double t = i * step,
                 x = 0.5 + 0.2 * std::exp(-0.05 * t) * std::cos(6.283185307179586 * t) + bell(random);
    text += concat({shortest(t), ",", shortest(std::nearbyint(1e4 * spoil(i, x)) / 1e4), "\n"});
  }
  const auto recording = read_recording(text, "lab.csv", {});
  EXPECT_TRUE(recording.ok());
  const auto series = take_series(*recording, "", 1, {});
  EXPECT_TRUE(series.ok());
  return *series;
}

std::vector<long> outlier_lines(const Series& series) {
  std::vector<long> lines;
  for (const Outlier& outlier : series.outliers) lines.push_back(outlier.line);
  return lines;
}

TEST(DropOuts, ShortExcursionsAreListed) {
  const Series s = swing([](int i, double x) {
    return i >= 700 && i < 702 ? x - 0.3 : i >= 1500 && i < 1505 ? 1.9 : x;
  });
  EXPECT_EQ(outlier_lines(s), (std::vector<long>{702, 703, 1502, 1503, 1504, 1505, 1506}));
  EXPECT_THAT(s.warnings, Contains("7 samples in 2 drop-outs of the sensor, the first in line 702"));
  EXPECT_EQ(s.t.size(), static_cast<std::size_t>(samples));  // listed, and left where they are
  EXPECT_EQ(s.y[1500], 1.9);
}

TEST(DropOuts, GoodSamplesBetweenTwoSpikesAreNone) {
  const Series s = swing([](int i, double x) { return i == 700 ? x + 0.7 : i == 707 ? x + 0.9 : x; });
  EXPECT_EQ(outlier_lines(s), (std::vector<long>{702, 709}));
}

TEST(DropOuts, LongFlatOnesAreListed) {
  const Series s = swing([](int i, double x) { return i >= 700 && i < 790 ? 2.5 : x; });
  EXPECT_EQ(s.outliers.size(), 90u);
  EXPECT_EQ(s.outliers.front().line, 702);
}

TEST(DropOuts, SpikesAtTheEndsAreListed) {
  EXPECT_EQ(outlier_lines(swing([](int i, double x) { return i == 0 ? 0.0 : x; })), std::vector<long>{2});
  EXPECT_EQ(outlier_lines(swing([](int i, double x) { return i == 1 ? 0.0 : x; })), std::vector<long>{3});
  EXPECT_EQ(outlier_lines(swing([](int i, double x) { return i == samples - 1 ? 0.0 : x; })),
            std::vector<long>{samples + 1});
  EXPECT_EQ(outlier_lines(swing([](int i, double x) { return i == 2 ? 0.0 : x; })), std::vector<long>{4});
}

TEST(DropOuts, MotionsHaveNone) {
  EXPECT_THAT(swing([](int, double x) { return x; }).outliers, IsEmpty());
  EXPECT_THAT(swing([](int, double x) { return x; }, "Position (m)", 0).outliers, IsEmpty());
  EXPECT_THAT(swing([](int, double x) { return x; }, "Position (m)", 0.02).outliers, IsEmpty());
  // Held, then released; moved to another place; steps of a staircase; rounding to 1 cm.
  EXPECT_THAT(swing([](int i, double x) { return i < 900 ? 0.7 : x; }).outliers, IsEmpty());
  EXPECT_THAT(swing([](int i, double x) { return i < 900 ? x : x + 0.8; }).outliers, IsEmpty());
  EXPECT_THAT(swing([](int i, double) { return i % 1000 < 200 ? 0.1 : 0.3; }).outliers, IsEmpty());
  EXPECT_THAT(swing([](int, double x) { return std::nearbyint(100 * x) / 100; }).outliers, IsEmpty());
}

/// A swing of 1 Hz that dies down, at these times.
Series swing_at(const std::vector<double>& times, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> bell(0, noise);
  std::uniform_real_distribution<double> turn(0, 6.283185307179586);
  const double phase = turn(random);
  std::string text = "Time (s),Position (m)\n";
  for (const double t : times)
    text += concat({shortest(t), ",",
                    shortest(std::exp(-0.12 * t) * std::cos(6.283185307179586 * t + phase) + bell(random)),
                    "\n"});
  return *take_series(*read_recording(text, "lab.csv", {}), "", 1, {});
}

TEST(DropOuts, AFewSamplesInAPeriodAreNone) {
  for (const double in_a_period : {4.05, 4.3, 4.7, 5.0})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::vector<double> times;
      for (int i = 0; i < 200; ++i) times.push_back(i / in_a_period);
      EXPECT_THAT(swing_at(times, 0.02, seed).outliers, IsEmpty()) << in_a_period << ' ' << seed;
    }
}

TEST(DropOuts, UnevenTimesHaveNone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution kept(0.5);
    std::vector<double> times;
    for (int i = 0; i < 800; ++i)
      if (kept(random)) times.push_back(i / 25.0);
    EXPECT_THAT(swing_at(times, 0.01, seed).outliers, IsEmpty()) << seed;
  }
}

TEST(DropOuts, PulsesOfAForceAreNone) {
  EXPECT_THAT(swing([](int i, double x) { return i >= 700 && i < 705 ? 5 : x; }, "Force (N)").outliers,
              IsEmpty());
}

}  // namespace
}  // namespace cromer::dialects
