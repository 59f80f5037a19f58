// Stretches that a motion sensor did not see, told from what motions do.
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/read/recording.h"
#include "cromer/read/series_shape.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

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
  EXPECT_THAT(in_words(s.notices), Contains("7 samples in 2 drop-outs of the sensor, the first in line 702"));
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

/// What is found in y, every 0.01 s; the first and the end of each.
std::vector<std::pair<std::size_t, std::size_t>> found_in(const std::vector<double>& y, double resolution = 0,
                                                          std::size_t late = 0) {
  std::vector<double> t;
  for (std::size_t i = 0; i < y.size(); ++i)
    t.push_back(0.01 * static_cast<double>(i) + (late && i >= late ? 1 : 0));
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (const DropOut& each : drop_outs(t, y, 0.01, resolution)) all.emplace_back(each.first, each.end);
  return all;
}

/// Zigzag of steps of one; `more` is added to some of them.
std::vector<double> zigzag(std::size_t count, std::size_t from, std::vector<double> more) {
  std::vector<double> y;
  for (std::size_t i = 0; i < count; ++i) y.push_back(i % 2 == 0 ? 0 : 1);
  for (std::size_t k = 0; k < more.size(); ++k) y[from + k] += more[k];
  return y;
}

using Found = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(DropOuts, NeedFortySamples) {
  EXPECT_EQ(found_in(zigzag(40, 20, {90, 90})), (Found{{20, 22}}));
  EXPECT_EQ(found_in(zigzag(39, 20, {90, 90})), Found{});
}

TEST(DropOuts, HaveTwoToTenSamples) {
  EXPECT_EQ(found_in(zigzag(200, 100, {90})), Found{});
  for (std::size_t length = 2; length <= 10; ++length)
    EXPECT_EQ(found_in(zigzag(200, 100, std::vector<double>(length, 90))), (Found{{100, 100 + length}}))
        << length;
  EXPECT_EQ(found_in(zigzag(200, 100, std::vector<double>(11, 90))), Found{});
  EXPECT_EQ(found_in(zigzag(200, 100, {-90, -90, -90})), (Found{{100, 103}}));
  EXPECT_EQ(found_in(zigzag(200, 100, {90, -90})), Found{});
}

TEST(DropOuts, JumpByTwelveRobustDeviations) {
  // 12 * 1.4826 are 17.79; the jumps are one more and one less than what is added.
  EXPECT_EQ(found_in(zigzag(200, 100, {18.9, 18.9})), (Found{{100, 102}}));
  EXPECT_EQ(found_in(zigzag(200, 100, {18.7, 18.7})), Found{});
  EXPECT_EQ(found_in(zigzag(200, 100, {18.9, 18.9}), 3), Found{});
  EXPECT_EQ(found_in(zigzag(200, 100, {19.1, 19.1}), 3), (Found{{100, 102}}));
}

TEST(DropOuts, OfATenthOfTheSamplesAreNone) {
  std::vector<double> y = zigzag(200, 100, std::vector<double>(10, 90));
  for (std::size_t i = 40; i < 50; ++i) y[i] += 90;
  EXPECT_EQ(found_in(y), (Found{{40, 50}, {100, 110}}));
  y[160] += 90, y[161] += 90;
  EXPECT_EQ(found_in(y), Found{});
}

TEST(DropOuts, FlatOnesMayBeLong) {
  const auto flat = [](std::size_t first, std::size_t end) {
    std::vector<double> y = zigzag(400, 0, {});
    for (std::size_t i = first; i < end; ++i) y[i] = 90;
    return found_in(y);
  };
  EXPECT_EQ(flat(100, 103), (Found{{100, 103}}));
  EXPECT_EQ(flat(100, 130), (Found{{100, 130}}));
  EXPECT_EQ(flat(1, 4), (Found{{1, 4}}));
  EXPECT_EQ(flat(396, 399), (Found{{396, 399}}));
  EXPECT_EQ(flat(397, 400), Found{});
  EXPECT_EQ(flat(0, 3), Found{});
}

TEST(DropOuts, FlatOnesMayEndWhereTheMotionHasGone) {
  const auto moving = [](std::size_t length) {
    std::vector<double> y = zigzag(400, 0, {});
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += 2 * static_cast<double>(i);
    for (std::size_t i = 40; i < 40 + length; ++i) y[i] = 1;
    return found_in(y);
  };
  EXPECT_EQ(moving(3), (Found{{40, 43}}));
  EXPECT_EQ(moving(20), (Found{{40, 60}}));
  // From 79 to 160, above 1: farther than half the jump.
  EXPECT_EQ(moving(40), (Found{{40, 80}}));
}

TEST(DropOuts, NextToEachOtherAreFoundBoth) {
  std::vector<double> y = zigzag(200, 100, {90, 90});
  y[104] += 90, y[105] += 90;
  EXPECT_EQ(found_in(y), (Found{{100, 102}, {104, 106}}));
  EXPECT_EQ(found_in(zigzag(200, 1, {90, 90})), (Found{{1, 3}}));
  EXPECT_EQ(found_in(zigzag(200, 197, {90, 90})), (Found{{197, 199}}));
}

TEST(DropOuts, AcrossAGapInTheTimesAreNotSeen) {
  const std::vector<double> y = zigzag(200, 100, {90, 90});
  EXPECT_EQ(found_in(y, 0, 100), Found{});
  EXPECT_EQ(found_in(y, 0, 102), Found{});
  EXPECT_EQ(found_in(y, 0, 99), (Found{{100, 102}}));
  EXPECT_EQ(found_in(y, 0, 103), (Found{{100, 102}}));
}

TEST(DropOuts, TheLivelierSideSaysWhatIsUsualToThem) {
  const auto behind = [](std::size_t lively_from) {
    std::vector<double> y = zigzag(400, 100, {60, 60, 60});
    for (std::size_t i = lively_from; i < 150; ++i) y[i] *= 4;
    return !found_in(y).empty();
  };
  EXPECT_TRUE(behind(150));
  EXPECT_TRUE(behind(115));
  EXPECT_FALSE(behind(108));
  const auto before = [](std::size_t lively_to) {
    std::vector<double> y = zigzag(400, 100, {60, 60, 60});
    for (std::size_t i = 50; i < lively_to; ++i) y[i] *= 4;
    return !found_in(y).empty();
  };
  EXPECT_TRUE(before(50));
  EXPECT_TRUE(before(88));
  EXPECT_FALSE(before(95));
}

TEST(DropOuts, AllTheirSamplesAreWellAwayFromBothSides) {
  // From 1 to 90 and back from 91 to `after`, with `between` among them.
  const auto is = [](double after, double between, double sign) {
    std::vector<double> y = zigzag(400, 100, {90, 90, 90, 90});
    y[101] = between;
    for (std::size_t i = 104; i < y.size(); ++i) y[i] += after;
    for (double& value : y) value *= sign;
    return !found_in(y).empty();
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(is(20, 56, sign));  // 20 and half of 71
    EXPECT_FALSE(is(20, 55, sign));
    EXPECT_TRUE(is(-20, 46, sign));  // 1 and half of 89
    EXPECT_FALSE(is(-20, 45, sign));
  }
}

TEST(DropOuts, NearTheEndsFiveChangesSayWhatIsUsual) {
  const auto near_the_end = [](std::size_t first, double height, bool back) {
    std::vector<double> y = zigzag(400, 0, {});
    for (std::size_t i = 0; i < first + 3; ++i) y[i] = i < first ? 4 * y[i] : y[i] + height;
    if (back) std::reverse(y.begin(), y.end());
    return !found_in(y).empty();
  };
  for (const bool back : {false, true}) {
    EXPECT_TRUE(near_the_end(5, 60, back));
    for (const std::size_t first : {6u, 7u, 8u, 12u, 20u}) {
      EXPECT_FALSE(near_the_end(first, 60, back)) << first << back;
      EXPECT_TRUE(near_the_end(first, 90, back)) << first << back;
    }
  }
}

TEST(DropOuts, ComeBackToWhereTheyLeft) {
  const auto shifted = [](double by) {
    std::vector<double> y = zigzag(200, 100, {90, 90});
    for (std::size_t i = 102; i < 200; ++i) y[i] += by;
    return found_in(y);
  };
  EXPECT_EQ(shifted(31), (Found{{100, 102}}));
  EXPECT_EQ(shifted(31.1), Found{});
  EXPECT_EQ(shifted(-29), (Found{{100, 102}}));
  EXPECT_EQ(found_in(zigzag(200, 100, {90, 46, 90})), (Found{{100, 103}}));
  EXPECT_EQ(found_in(zigzag(200, 100, {90, 43, 90})), Found{});
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
