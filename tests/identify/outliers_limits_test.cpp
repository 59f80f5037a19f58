// Samples that stand out, on residuals whose median and scale are known: at each limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/identify/diagnose/outliers.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double deviation = 1.4826;  // of what repeats -1, 0 and 1: the median absolute deviation is 1

std::vector<double> thirds(std::size_t n) {
  std::vector<double> r;
  for (std::size_t i = 0; i < n; ++i) r.push_back(static_cast<double>(i % 3) - 1);
  return r;
}

/// The motion is none: the values are the residuals, about a level.
std::vector<std::size_t> found(const std::vector<double>& r, double resolution = 0, double level = 0) {
  std::vector<double> y = r;
  for (double& each : y) each += level;
  return outliers({even_times(r.size(), 0.01), y, resolution}, r);
}

std::vector<double> with(std::vector<double> r, std::size_t at, double value) {
  r[at] = value;
  return r;
}

TEST(OutliersLimits, FourDeviationsAndMoreOfLongRecords) {
  for (const std::size_t n : {32u, 400u, 600u, 3000u, 4096u, 4097u, 8000u})
    for (const double sign : {1.0, -1.0})
      for (const std::size_t at : {std::size_t{0}, std::size_t{1}, n / 2, n - 1}) {
        const double many = std::max(4.0, std::sqrt(2 * std::log(5.0 * static_cast<double>(n))));
        EXPECT_THAT(found(with(thirds(n), at, sign * (many * deviation - 1e-6))), IsEmpty())
            << n << ' ' << at;
        EXPECT_THAT(found(with(thirds(n), at, sign * (many * deviation + 1e-6))), ElementsAre(at))
            << n << ' ' << at;
      }
}

TEST(OutliersLimits, ThirtyTwoSamples) {
  EXPECT_THAT(found(with(thirds(32), 7, 100)), ElementsAre(7));
  EXPECT_THAT(found(with(thirds(31), 7, 100)), IsEmpty());
}

// By one and a half steps of the values, or a millionth of the largest of them on either side of zero.
TEST(OutliersLimits, RoundingIsNone) {
  EXPECT_THAT(found(with(thirds(400), 7, 14.99), 10), IsEmpty());
  EXPECT_THAT(found(with(thirds(400), 7, 15.01), 10), ElementsAre(7));
  for (const double level : {1e7, -1e7}) {
    EXPECT_THAT(found(with(thirds(400), 7, 9.99), 0, level), IsEmpty()) << level;
    EXPECT_THAT(found(with(thirds(400), 7, 10.01), 0, level), ElementsAre(7)) << level;
  }
}

// Ten neighbours on either side, all of them near five.
TEST(OutliersLimits, StandOutFromTheirNeighboursToo) {
  std::vector<double> r = thirds(400);
  for (std::size_t i = 90; i < 111; ++i) r[i] += 5;
  EXPECT_THAT(found(with(r, 100, 5 + 4 * deviation - 1e-6)), IsEmpty());
  EXPECT_THAT(found(with(r, 100, 5 + 4 * deviation + 1e-6)), ElementsAre(100));
  EXPECT_THAT(found(with(r, 100, 5 - 4 * deviation - 1e-6)), IsEmpty());  // among all others it does not
}

// Of ten about 50 to the left and ten zeros to the right the upper median is the lowest of the first; half of
// them are then no further off than the zeros.
TEST(OutliersLimits, TenNeighboursOnEitherSide) {
  const auto edge = [](double value, std::size_t left, std::size_t right) {
    std::vector<double> r(400);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = static_cast<double>(i % 3) - 1;
    for (std::size_t i = 200 - left; i < 200; ++i) r[i] = 50 + static_cast<double>(i - 200 + left);
    for (std::size_t i = 201; i < 201 + right; ++i) r[i] = 0;
    return found(with(r, 200, value));
  };
  const double limit = 50 + 4 * deviation * 50;
  EXPECT_THAT(edge(limit - 1e-6, 10, 10), IsEmpty());
  EXPECT_THAT(edge(limit + 1e-6, 10, 10), ElementsAre(200));
}

TEST(OutliersLimits, MoreThanATenthAreNone) {
  const auto spikes = [](std::size_t n, std::size_t count) {
    std::vector<double> r = thirds(n);
    for (std::size_t k = 0; k < count; ++k) r[4 + 9 * k] = 1000 + static_cast<double>(k);
    return found(r).size();
  };
  EXPECT_EQ(spikes(110, 11), 11u);
  EXPECT_EQ(spikes(109, 11), 0u);
}

// What is far off together is no outlier, and where it is more than a fifth nothing is.
TEST(OutliersLimits, MoreThanAFifthFarOffIsAnotherLaw) {
  const auto beside_a_plateau = [](std::size_t plateau) {
    std::vector<double> r = thirds(105);
    for (std::size_t i = 60; i < 60 + plateau; ++i) r[i] = 30;
    return found(with(r, 10, 100));
  };
  EXPECT_THAT(beside_a_plateau(20), ElementsAre(10));
  EXPECT_THAT(beside_a_plateau(21), IsEmpty());
}

// What is independent from sample to sample is the least scale: in a calm stretch much stands out.
TEST(OutliersLimits, ACalmStretchIsMeasuredByTheNoiseOfAll) {
  std::vector<double> r;
  double value = 0;
  for (std::size_t i = 0; i < 1200; ++i) {
    r.push_back(value);
    value += (i / 6 % 2 == 0 ? 1 : -1) * static_cast<double>(1 + i % 3);
  }
  for (std::size_t i = 600; i < 624; ++i) r[i] = 0;
  EXPECT_THAT(found(with(r, 612, 1e3)), ElementsAre(612));
  EXPECT_THAT(found(r), IsEmpty());
}

TEST(KeptSamples, LackOnlyThoseSetAside) {
  const std::vector<double> t = even_times(7, 0.5), y{0, 10, 20, 30, 40, 50, 60}, r{1, 2, 3, 4, 5, 6, 7};
  const Record record{t, y, 0.25, 2};
  const KeptSamples kept(record, {2, 3, 6}, r);
  EXPECT_THAT(kept.t, ElementsAre(0, 0.5, 2, 2.5));
  EXPECT_THAT(kept.y, ElementsAre(0, 10, 40, 50));
  EXPECT_EQ(kept.record().resolution, 0.25);
  EXPECT_EQ(kept.record().derivative, 2);
  EXPECT_EQ(kept.record().t.size(), 4u);
  // The first keeps its place, by the value of the fit.
  const KeptSamples moved(record, {0, 1, 5}, r);
  EXPECT_THAT(moved.t, ElementsAre(0, 1, 1.5, 2, 3));
  EXPECT_THAT(moved.y, ElementsAre(-1, 20, 30, 40, 60));
  EXPECT_THAT(KeptSamples(record, {}, {}).y, testing::ElementsAreArray(y));
  // Of a fit that failed there is nothing to move it to.
  EXPECT_EQ(KeptSamples(record, {0}, {}).y.front(), y.front());
}

TEST(Outliers, AreSoughtFiveTimesAtMost) {
  const std::vector<double> y = thirds(300);
  int fits = 0;
  const auto settled = settle_outliers(
      Record{even_times(300, 0.01), y}, 0, {}, [&](const Record&) { return ++fits; },
      [&](int made, const Record&) { return with(y, 10 + 10 * static_cast<std::size_t>(made), 100); });
  EXPECT_EQ(fits, 5);
  EXPECT_THAT(settled.aside, ElementsAre(50));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
