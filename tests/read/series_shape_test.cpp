// What the values of a series are like: their rounding, spikes, tops that are cut off.
#include "cromer/read/series_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

using Values = std::vector<double>;

Values made(std::size_t count, const std::function<double(int)>& value) {
  Values values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(value(static_cast<int>(i)));
  return values;
}

TEST(Median, UnseenSizesDoNotCount) {
  EXPECT_EQ(median_seen(Values{unseen, 9, unseen, 1, 5}), 5);
  EXPECT_EQ(median_seen(Values{unseen}), 0);
}

TEST(Rounding, NeedsThreeValues) {
  EXPECT_EQ(rounding_step(Values{0.1, 0.4}), 0);
  EXPECT_EQ(rounding_step(Values{0.1, 0.1, 0.1}), 0);
  EXPECT_DOUBLE_EQ(rounding_step(Values{0.1, 0.1, 0.45}), 0.35);
  EXPECT_DOUBLE_EQ(rounding_step(Values{0.1, 0.4, 0.2}), 0.1);
}

/// No two alike: 17 i modulo 1009.
int scattered(int i) { return 17 * i % 1009; }

TEST(Rounding, IsTheLastOfSixDecimals) {
  const auto of = [](double unit, double offset = 0) {
    return rounding_step(made(500, [=](int i) { return offset + scattered(i) * unit; }));
  };
  EXPECT_EQ(of(1), 1);
  EXPECT_DOUBLE_EQ(of(0.01), 0.01);
  EXPECT_DOUBLE_EQ(of(1e-6, 5), 1e-6);
  EXPECT_DOUBLE_EQ(of(0.01, 1234567), 0.01);
  EXPECT_EQ(of(1e-7, 5), 0);
  // Behind the first digit of the largest, where that is below one.
  EXPECT_DOUBLE_EQ(of(1e-8), 1e-8);
  EXPECT_DOUBLE_EQ(of(1e-9), 1e-9);
  EXPECT_EQ(of(1e-9, 0.0099), 0);
  EXPECT_DOUBLE_EQ(of(1e-8, 0.0099), 1e-8);
  EXPECT_DOUBLE_EQ(of(1e-6, 0.5), 1e-6);
  EXPECT_EQ(of(1e-7, 0.5), 0);
}

TEST(Rounding, NineOfTenValuesShowIt) {
  const auto with_rare = [](int rare) {
    return rounding_step(made(100, [=](int i) { return scattered(i) * 0.01 + (i < rare ? 0.0012345 : 0); }));
  };
  EXPECT_DOUBLE_EQ(with_rare(10), 0.01);
  EXPECT_EQ(with_rare(11), 0);
  // What is next to nothing is not written by whole units.
  EXPECT_EQ(rounding_step(made(100, [](int i) { return i < 11 ? 1e-12 * (i + 1) : i; })), 0);
  EXPECT_EQ(rounding_step(made(100, [](int i) { return i < 10 ? 1e-12 * (i + 1) : i; })), 1);
}

TEST(Rounding, AHundredThousandValuesAreLookedAt) {
  const auto of = [](std::size_t count) {
    return rounding_step(made(count, [](int i) { return i * 0.1 + (i % 2 == 1 ? 0.001 : 0); }));
  };
  EXPECT_DOUBLE_EQ(of(100000), 0.001);
  EXPECT_DOUBLE_EQ(of(100001), 0.1);
}

TEST(Rounding, WildValuesTellNothing) {
  const auto with_wild = [](double wild) {
    return rounding_step(made(400, [=](int i) { return i == 7 ? wild : scattered(i) * 0.01; }));
  };
  EXPECT_DOUBLE_EQ(with_wild(1e30), 0.01);
  EXPECT_DOUBLE_EQ(with_wild(-1e30), 0.01);
  EXPECT_EQ(rounding_step(Values{0.1, 0.2, 1e30}), 0);
}

TEST(Rounding, IsSeenFarFromZeroToo) {
  EXPECT_NEAR(rounding_step(made(400, [](int i) { return 1e8 + i * 7 % 5 * 0.01; })), 0.01, 1e-7);
}

TEST(Rounding, ValuesAsFarApartAsNumbersCanBeDoNoHarm) {
  const double step =
      rounding_step(made(400, [](int i) { return i % 2 == 0 ? 1.7e308 / (1 + i) : -1.7e308 + i * 1e300; }));
  EXPECT_TRUE(step >= 0) << step;
}

TEST(Rounding, ValuesFarFromZeroAreNotWild) {
  EXPECT_NEAR(rounding_step(made(400, [](int i) { return 2e6 + scattered(i) * 1e-4; })), 1e-4, 1e-9);
}

TEST(Rounding, AQuantumIsTheSmallestDifference) {
  const auto of = [](std::size_t distinct, double quantum) {
    return rounding_step(
        made(100, [=](int i) { return quantum * std::min<int>(i, static_cast<int>(distinct) - 1); }));
  };
  EXPECT_NEAR(of(80, 0.052), 0.052, 1e-12);
  EXPECT_DOUBLE_EQ(of(81, 0.052), 0.001);
  EXPECT_DOUBLE_EQ(of(50, 0.1), 0.1);
  EXPECT_NEAR(of(50, 0.0429123456), 0.0429123456, 1e-12);
  // Printed rounded.
  const Values printed = made(400, [](int i) { return std::nearbyint(i % 60 * 0.0429123456 * 1e4) / 1e4; });
  EXPECT_NEAR(rounding_step(printed), 0.0429123456, 1e-5);
  const Values noisy = made(400, [](int i) { return i % 60 * 0.0429123456 * (1 + 1e-15 * (i % 3)); });
  EXPECT_NEAR(rounding_step(noisy), 0.0429123456, 1e-12);
  // Exceptions that are closer than a decimal place.
  const Values exceptions = made(400, [](int i) { return i == 5 ? 0.0012 : i % 60 * 0.01; });
  EXPECT_DOUBLE_EQ(rounding_step(exceptions), 0.01);
}

// A sonar shifts its own steps now and then.
TEST(Rounding, OfGroupsOfValuesIsTheStepBetweenThem) {
  const auto step = [](int count, double shift) {
    return rounding_step(made(count, [=](int i) {
      return scattered(i) % 5 * 0.172 + (i % 7 == 0 ? shift : 0) - (i % 11 == 0 ? shift : 0);
    }));
  };
  EXPECT_NEAR(step(1000, 0.0208), 0.172, 1e-12);
  EXPECT_NEAR(step(1000, 0.0148), 0.172, 1e-12);
  EXPECT_DOUBLE_EQ(step(1000, 0.0608), 0.0001);  // no groups: they are as far apart as their values
  EXPECT_DOUBLE_EQ(step(100, 0.0208), 0.0001);   // groups by chance
  // Groups that are not evenly spaced, near or far.
  for (const std::vector<double>& middles :
       {std::vector{0.0, 1.0, 2.5, 3.5}, {0.0, 1.0, 6.47, 11.9, 17.35}}) {
    const auto values = made(1000, [&](int i) {
      return middles[static_cast<std::size_t>(scattered(i)) % middles.size()] + (i % 7 == 0 ? 0.0603 : 0);
    });
    EXPECT_DOUBLE_EQ(rounding_step(values), 0.0001);
  }
}

TEST(Rounding, OfWhatIsNoMultipleOfAQuantum) {
  // Differences of 1, 2, 3, ... steps are multiples, others are none; 19 of 20 suffice.
  const auto with_odd = [](int odd) {
    Values values;
    double at = 0;
    for (int i = 0; i <= 40; ++i) {
      for (int k = 0; k < 3; ++k) values.push_back(at);
      at += 0.0312345678 * (i < odd ? 1.5 : 1 + i % 3);
    }
    return rounding_step(values);
  };
  const auto of_differences = [](const std::vector<double>& steps) {
    Values values(3, 0);
    double at = 0;
    for (const double step : steps) values.insert(values.end(), 3, at += 0.0312345678 * step);
    return rounding_step(values);
  };
  std::vector<double> last_odd(20, 2);
  last_odd.front() = 1, last_odd.back() = 1.5;
  EXPECT_NEAR(of_differences(last_odd), 0.0312345678, 1e-12);
  last_odd.back() = 2, last_odd.insert(last_odd.end(), 1, 1.5), last_odd[9] = 1.5;
  EXPECT_EQ(of_differences(last_odd), 0);  // 19 of 21
  EXPECT_NEAR(with_odd(0), 0.0312345678, 1e-12);
  EXPECT_NEAR(with_odd(2), 0.0312345678, 1e-12);
  EXPECT_EQ(with_odd(3), 0);
}

/// Every 0.01 s; none where y is shorter.
std::vector<std::size_t> spikes_of(const Values& y, double resolution = 0) {
  const Values t = made(y.size(), [](int i) { return 0.01 * i; });
  const auto found = spikes(t, y, 0.01, resolution);
  // The same backwards.
  Values back = y;
  std::reverse(back.begin(), back.end());
  std::vector<std::size_t> mirrored;
  for (const std::size_t i : spikes(t, back, 0.01, resolution))
    mirrored.insert(mirrored.begin(), y.size() - 1 - i);
  EXPECT_EQ(mirrored, found);
  return found;
}

Values ramp(std::size_t count, std::size_t spike, double height) {
  return made(count, [=](int i) { return 0.001 * i + (static_cast<std::size_t>(i) == spike ? height : 0); });
}

TEST(Spikes, NeedFortySamples) {
  EXPECT_THAT(spikes_of(ramp(40, 20, 1)), ElementsAre(20));
  EXPECT_THAT(spikes_of(ramp(39, 20, 1)), IsEmpty());
}

TEST(Spikes, StandAmongFiveTimesThatAreEven) {
  const auto found = [](std::size_t behind, double interval, std::size_t spike = 50) {
    Values t;
    for (std::size_t i = 0; i < 100; ++i)
      t.push_back(i == 0 ? 0 : t.back() + (i == behind + 1 ? interval : 1));
    return spikes(t, ramp(100, spike, 1), 1, 0).size();
  };
  for (const std::size_t behind : {48u, 49u, 50u, 51u}) {
    EXPECT_EQ(found(behind, 0.55), 1u) << behind;
    EXPECT_EQ(found(behind, 1.45), 1u) << behind;
    EXPECT_EQ(found(behind, 0.45), 0u) << behind;
    EXPECT_EQ(found(behind, 1.55), 0u) << behind;
  }
  EXPECT_EQ(found(47, 1.55), 1u);
  EXPECT_EQ(found(52, 1.55), 1u);
  for (const std::size_t spike : {2u, 97u}) {
    EXPECT_EQ(found(50, 1.55, spike), 1u) << spike;
    EXPECT_EQ(found(spike - 2, 1.55, spike), 0u) << spike;
    EXPECT_EQ(found(spike + 1, 1.55, spike), 0u) << spike;
  }
}

TEST(Spikes, AreSixSmallChangesOrRoundingSteps) {
  EXPECT_THAT(spikes_of(ramp(100, 50, 0.0061)), ElementsAre(50));
  EXPECT_THAT(spikes_of(ramp(100, 50, -0.0061)), ElementsAre(50));
  EXPECT_THAT(spikes_of(ramp(100, 50, 0.0059)), IsEmpty());
  EXPECT_THAT(spikes_of(ramp(100, 50, 0.0121), 0.002), ElementsAre(50));
  EXPECT_THAT(spikes_of(ramp(100, 50, 0.0119), 0.002), IsEmpty());
  EXPECT_THAT(spikes_of(Values(100, 0.5)), IsEmpty());
}

/// Alternates by one, from a sample on by four; one sample more by `height`.
Values flicker(int count, int livelier_from, int spike, double height) {
  return made(static_cast<std::size_t>(count), [=](int i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    return sign * ((i >= livelier_from ? 4 : 1) + (i == spike ? height : 0));
  });
}

TEST(Spikes, AreTwelveRobustDeviations) {
  // Each sample is 8/3 off the cubic: 12 * 1.4826 * 8/3 are 47.44.
  EXPECT_THAT(spikes_of(flicker(400, 400, 200, 44.9)), ElementsAre(200));
  EXPECT_THAT(spikes_of(flicker(400, 400, 200, 44.6)), IsEmpty());
}

TEST(Spikes, TheLivelierSideSaysWhatIsUsual) {
  const auto found = [](int spike) { return !spikes_of(flicker(400, 260, spike, 60)).empty(); };
  int last = 0;
  for (int i = 100; i < 258; ++i)
    if (found(i)) last = i;
  EXPECT_EQ(last, 245);  // then half of the twenty behind the next two are lively
  EXPECT_TRUE(found(200));
}

TEST(Spikes, ThreeSamplesOnASideSayWhatIsUsual) {
  const auto found = [](int lively, int spike) {
    Values y = flicker(400, 400, spike, 60);
    for (int i = 0; i < lively; ++i) y[static_cast<std::size_t>(i)] *= 4;
    return spikes_of(y);
  };
  EXPECT_THAT(found(4, 6), ElementsAre(6));
  EXPECT_THAT(found(5, 7), IsEmpty());
  EXPECT_THAT(found(2, 7), ElementsAre(7));
}

TEST(Spikes, StandAlone) {
  const auto with = [](Values bumps) {
    Values y = ramp(100, 0, 0);
    for (std::size_t k = 0; k < bumps.size(); ++k) y[50 + k] += bumps[k];
    return spikes_of(y);
  };
  EXPECT_THAT(with({1}), ElementsAre(50));
  EXPECT_THAT(with({1, 1}), IsEmpty());
  EXPECT_THAT(with({1, 0.5}), IsEmpty());
  EXPECT_THAT(with({1, 0, 0, 0, 0, 0, 1}), ElementsAre(50, 56));
  EXPECT_THAT(with({0.5, 1, 0.5}), IsEmpty());
}

TEST(Spikes, AreSeenAmongEvenTimesOnly) {
  const Values y = ramp(100, 50, 1);
  const auto with = [&](std::size_t late, double by) {
    Values t = made(100, [](int i) { return 0.01 * i; });
    for (std::size_t i = late; i < 100; ++i) t[i] += by;
    return spikes(t, y, 0.01, 0);
  };
  EXPECT_THAT(with(50, 0.004), ElementsAre(50));
  EXPECT_THAT(with(50, 0.006), IsEmpty());
  EXPECT_THAT(with(50, -0.004), ElementsAre(50));
  EXPECT_THAT(with(50, -0.006), IsEmpty());
  for (const std::size_t hidden : {49u, 50u, 51u}) EXPECT_THAT(with(hidden, 0.1), IsEmpty()) << hidden;
  EXPECT_THAT(with(52, 0.1), IsEmpty());
  EXPECT_THAT(with(53, 0.1), ElementsAre(50));
  EXPECT_THAT(with(48, 0.1), ElementsAre(50));
  // Steps that are all longer, but not by a half.
  Values slow = made(100, [](int i) { return 0.0124 * i; }),
         slower = made(100, [](int i) { return 0.0126 * i; });
  EXPECT_THAT(spikes(slow, y, 0.01, 0), ElementsAre(50));
  EXPECT_THAT(spikes(slower, y, 0.01, 0), IsEmpty());
}

TEST(Spikes, TheFirstTwoAndLastTwoSamplesMayBeSome) {
  // Missed by six times what sticks out elsewhere, 36 small changes.
  for (const std::size_t at : {0u, 1u, 98u, 99u}) {
    EXPECT_THAT(spikes_of(ramp(100, at, 0.037)), ElementsAre(at)) << at;
    EXPECT_THAT(spikes_of(ramp(100, at, 0.035)), IsEmpty()) << at;
  }
  for (const std::size_t at : {2u, 3u, 4u, 95u, 96u, 97u})
    for (const double height : {0.0061, 0.01, 0.02, 0.04, 0.2})
      EXPECT_THAT(spikes_of(ramp(100, at, height)), ElementsAre(at)) << at << ' ' << height;
  EXPECT_THAT(spikes_of(made(100, [](int i) { return 0.001 * i + (i == 0 || i == 99 ? 1 : 0); })),
              ElementsAre(0, 99));
  EXPECT_THAT(spikes_of(made(100, [](int i) { return 0.001 * i + (i == 0 || i == 3 ? 1 : 0); })),
              ElementsAre(3));
}

bool are_cut_off(const Values& y, double step, double resolution) {
  return !tops_cut_off(y, step, resolution).empty();
}

/// Says so for a swing with `per_period` samples, whose top is cut at a height.
bool cut_off(std::size_t count, double per_period, double height, double resolution = 0) {
  return are_cut_off(made(count,
                          [=](int i) {
                            const double x = std::sin(6.283185307179586 * (i + 0.3) / per_period);
                            return std::clamp(x, -2.0, height) + 5;
                          }),
                     0.01, resolution);
}

TEST(Tops, AreCutOffWhereTheyAreFlatAgainAndAgain) {
  EXPECT_TRUE(cut_off(1000, 100, 0.7));
  EXPECT_FALSE(cut_off(1000, 100, 2));
  EXPECT_TRUE(are_cut_off(made(1000, [](int i) { return std::max(std::sin(0.0628 * i), -0.7); }), 0.01, 0));
  // Thirty-two samples and four crossings at least, and two flat tops.
  EXPECT_TRUE(cut_off(32, 12, 0.5));
  EXPECT_FALSE(cut_off(31, 12, 0.5));
  EXPECT_FALSE(cut_off(200, 100, 0.7));
  EXPECT_TRUE(cut_off(230, 100, 0.7));
  // Four samples long; three are not.
  EXPECT_FALSE(cut_off(1000, 20, 0.93));
  EXPECT_TRUE(cut_off(1000, 20, 0.7));
  // Rounding makes flat tops of its own.
  EXPECT_FALSE(cut_off(1000, 100, 0.9, 0.1));
  EXPECT_TRUE(cut_off(1000, 100, 0.6, 0.01));
  EXPECT_FALSE(cut_off(1000, 100, 0.6, 0.9));
  EXPECT_FALSE(are_cut_off(Values(100, 1), 0.01, 0));
  const Values both = made(1000, [](int i) { return std::clamp(std::sin(0.0628 * i), -0.7, 0.6); });
  EXPECT_THAT(tops_cut_off(both, 0.01, 0), ElementsAre(-0.7, 0.6));
}

// Of a sine, all within a resolution of the top look alike: 2 acos(1 - r / A) of its 2 pi.
TEST(Tops, AreCutOffWhereTheyLastHalfAsLongAgainAsRoundingMakesThem) {
  const double pi = 3.14159265358979323846;
  // Ten tops of 41 samples each, 200 samples a period; lowest at -1, highest at cos(20 * 2 pi / 200).
  const double top = std::cos(pi / 5 * 1.001), amplitude = 0.5 * (top + 1);
  const Values y = made(2000, [&](int i) { return std::min(std::cos(2 * pi * (i + 100) / 200), top); });
  const double half_period = 2000.0 / 20;  // between crossings, of which there are 20
  const double dwell = (41 - 3) / 1.5;
  const double resolution = amplitude * (1 - std::cos(pi * dwell / half_period / 2));
  EXPECT_TRUE(are_cut_off(y, 0.01, 0.98 * resolution));
  EXPECT_FALSE(are_cut_off(y, 0.01, 1.02 * resolution));
}

TEST(Tops, OfARectangleAreNotCutOff) {
  const auto rectangle = [](int high) {
    return are_cut_off(made(1000, [=](int i) { return i % 100 < high ? 1.0 : -0.01 * (i % 7); }), 0.01, 0);
  };
  EXPECT_TRUE(rectangle(20));
  EXPECT_FALSE(rectangle(50));
}

TEST(Rounding, IsLookedForAboutTheMiddle) {
  EXPECT_DOUBLE_EQ(rounding_step(made(400, [](int i) { return i == 7 ? 1e12 : 1e6 + scattered(i) * 0.01; })),
                   0.01);
}

TEST(Spikes, OnASlopeThatGoesOnAreNone) {
  const auto with = [](double height) {
    return spikes_of(made(200, [=](int i) {
      return 0.001 * i + (i < 90 ? 0 : std::min(i - 90, 20)) + (i == 100 ? height : 0);
    }));
  };
  EXPECT_THAT(with(0.9), IsEmpty());
  EXPECT_THAT(with(1.1), ElementsAre(100));
}

TEST(Spikes, AtALivelyEndAreNone) {
  const auto with = [](int lively) {
    return spikes_of(made(400, [=](int i) {
      const double sign = i % 2 == 0 ? 1 : -1;
      return sign * (i >= 400 - lively ? 4 : 1) + (i == 399 ? 400 : 0);
    }));
  };
  EXPECT_THAT(with(0), ElementsAre(399));
  EXPECT_THAT(with(12), ElementsAre(399));
  EXPECT_THAT(with(16), IsEmpty());
}

TEST(Tops, OneOfTwoFlatOnesMayHaveThreeSamples) {
  const auto with = [](int first, int second) {
    Values y;
    for (int k = 0; k < 8; ++k) {
      const int flat = k == 2 ? first : k == 5 ? second : 1;
      for (int i = -6; i <= 6; ++i) {
        y.push_back(i == 0 && k % 8 != 2 && k != 5 ? 5.5 : 6 - std::abs(i));
        for (int more = 1; i == 0 && more < flat; ++more) y.push_back(6);
      }
    }
    return are_cut_off(y, 0.01, 0);
  };
  EXPECT_TRUE(with(4, 3));
  EXPECT_TRUE(with(3, 4));
  EXPECT_FALSE(with(4, 2));
  EXPECT_FALSE(with(3, 3));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
