#include "cromer/ensemble/response_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/ensemble/dispatch.h"

namespace cromer::core {
namespace CROMER_FILE {

std::vector<double> shaking(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> samples(n);
  double smooth = 0;
  for (double& sample : samples) sample = smooth = 0.7 * smooth + normal(random);
  return samples;
}

LinearLaw<double> law_of(double period, double damping_ratio) {
  const double w = 2 * pi / period;
  return {.decay_rate = damping_ratio * w, .stiffness = w * w};
}

/// The extremes at `parts` points of each interval, by the model's own closed form.
Extremes looked_at(const std::vector<double>& a, double h, bool hold, const LinearLaw<double>& law,
                   ResponseOf of, int parts) {
  Extremes range{0, 0};
  State<double> y{0, 0};
  const std::size_t intervals = a.size() - (hold ? 0 : 1);
  for (std::size_t i = 0; i < intervals; ++i) {
    const double slope = hold ? 0 : (a[i + 1] - a[i]) / h;
    for (int j = 1; j <= parts; ++j) {
      const State<double> at = propagate_ramp(law, a[i], slope, h * j / parts, y);
      range.include(of == ResponseOf::displacement ? at.x : law.stiffness * at.x + 2 * law.decay_rate * at.v);
    }
    y = propagate_ramp(law, a[i], slope, h, y);
  }
  return range;
}

class ResponsePeaksBy : public ::testing::TestWithParam<KernelUnit> {
 protected:
  PeakSearch search(ResponseOf quantity, Peaks peaks, bool largest_alone) const {
    return {.peaks = peaks, .quantity = quantity, .largest_alone = largest_alone, .unit = GetParam().walk};
  }
};
INSTANTIATE_TEST_SUITE_P(Units, ResponsePeaksBy, ::testing::ValuesIn(units_here()),
                         [](const auto& unit) { return std::string(unit.param.name); });

constexpr double damping_ratios[] = {0.0, 0.02, 0.05, 0.3, 1.0, 2.5};

TEST_P(ResponsePeaksBy, AtTheSamples) {
  const auto a = shaking(500, 1);
  const double h = 0.01;
  std::vector<LinearLaw<double>> laws;
  for (const double period : {0.004, 0.01, 0.02, 0.033, 0.1, 0.7, 5.0, 60.0})
    for (const double zeta : damping_ratios) laws.push_back(law_of(period, zeta));
  for (const bool hold : {false, true}) {
    const GroundMotion ground{a, h, hold ? BetweenSamples::hold : BetweenSamples::linear};
    for (const ResponseOf of : {ResponseOf::displacement, ResponseOf::absolute_acceleration}) {
      const auto peaks = response_peaks(ground, laws, search(of, Peaks::samples, true));
      for (std::size_t i = 0; i < laws.size(); ++i) {
        const Extremes exact = looked_at(a, h, hold, laws[i], of, 1);
        // A held force leaves an undamped motion of whole turns per sample at 0: beside what would be static.
        const double still = of == ResponseOf::displacement ? 1 / laws[i].stiffness : 1;
        const double size = std::max(exact.magnitude(), still);
        EXPECT_NEAR(peaks[i].during.low, exact.low, 1e-11 * size) << i;
        EXPECT_NEAR(peaks[i].during.high, exact.high, 1e-11 * size) << i;
      }
    }
  }
}

TEST_P(ResponsePeaksBy, AtPartsOfTheirPeriod) {
  const auto a = shaking(300, 2);
  const double h = 0.01;
  EXPECT_EQ(substeps(0.01, 0.1), 1u);
  EXPECT_EQ(substeps(0.01, 0.0999), 2u);
  EXPECT_EQ(substeps(0.005, 0.01), 5u);
  EXPECT_EQ(substeps(0.01, 5), 1u);
  std::vector<LinearLaw<double>> laws;
  for (const double period : {0.011, 0.02, 0.05, 0.0999, 0.1, 1.0, 0.012, 0.019, 0.03})
    laws.push_back(law_of(period, 0.05));
  const auto peaks = response_peaks({a, h, BetweenSamples::linear}, laws,
                                    search(ResponseOf::displacement, Peaks::peer, true));
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double period = 2 * pi / std::sqrt(laws[i].stiffness);
    const Extremes exact =
        looked_at(a, h, false, laws[i], ResponseOf::displacement, static_cast<int>(substeps(h, period)));
    EXPECT_NEAR(peaks[i].during.magnitude(), exact.magnitude(), 1e-12 * exact.magnitude()) << period;
  }
}

// Never less than what a dense look finds, and no more than its blur over: both extremes, and the larger
// alone.
TEST_P(ResponsePeaksBy, ContinuousMissNothing) {
  const double h = 0.01;
  constexpr int parts = 200;
  std::vector<LinearLaw<double>> laws;
  for (const double period : {0.003, 0.013, 0.02, 0.05, 0.11, 0.4, 3.0, 40.0})
    for (const double zeta : damping_ratios) laws.push_back(law_of(period, zeta));
  for (unsigned seed = 3; seed < 6; ++seed) {
    const auto a = shaking(seed % 2 ? 70 : 130, seed);
    for (const bool hold : {false, true}) {
      const GroundMotion ground{a, h, hold ? BetweenSamples::hold : BetweenSamples::linear};
      for (const ResponseOf of : {ResponseOf::displacement, ResponseOf::absolute_acceleration}) {
        const auto both = response_peaks(ground, laws, search(of, Peaks::continuous, false));
        const auto larger = response_peaks(ground, laws, search(of, Peaks::continuous, true));
        for (std::size_t i = 0; i < laws.size(); ++i) {
          const Extremes dense = looked_at(a, h, hold, laws[i], of, parts);
          // The motion bends with its own frequency and with that of the samples.
          const double blur = (laws[i].stiffness + 1 / (h * h)) * std::pow(h / parts, 2);
          EXPECT_GE(both[i].during.high, dense.high - 1e-12 * dense.magnitude()) << i;
          EXPECT_LE(both[i].during.low, dense.low + 1e-12 * dense.magnitude()) << i;
          EXPECT_LE(both[i].during.high, dense.high + blur * dense.magnitude()) << i;
          EXPECT_GE(both[i].during.low, dense.low - blur * dense.magnitude()) << i;
          EXPECT_NEAR(larger[i].during.magnitude(), both[i].during.magnitude(), 1e-12 * dense.magnitude())
              << i;
        }
      }
    }
  }
}

TEST_P(ResponsePeaksBy, AfterTheEndTheMotionIsFree) {
  const auto a = shaking(60, 9);
  const double h = 0.01;
  for (const double zeta : damping_ratios)
    for (const double period : {0.05, 0.6, 9.0}) {
      const LinearLaw<double> law = law_of(period, zeta);
      State<double> y{0, 0};
      for (std::size_t i = 0; i + 1 < a.size(); ++i)
        y = propagate_ramp(law, a[i], (a[i + 1] - a[i]) / h, h, y);
      Extremes dense{std::min(y.x, 0.0), std::max(y.x, 0.0)};
      for (int j = 0; j <= 4000; ++j) {
        const auto free = impulse_response(law, 2 * period * j / 4000);
        dense.include(free.position * y.x + free.g * y.v);
      }
      const auto found = response_peaks({a, h, BetweenSamples::linear}, std::vector{law},
                                        search(ResponseOf::displacement, Peaks::continuous, false))[0]
                             .after;
      EXPECT_GE(found.high, dense.high - 1e-12 * dense.magnitude()) << zeta << " " << period;
      EXPECT_LE(found.low, dense.low + 1e-12 * dense.magnitude()) << zeta << " " << period;
      EXPECT_NEAR(found.high, dense.high, 1e-5 * dense.magnitude()) << zeta << " " << period;
      EXPECT_NEAR(found.low, dense.low, 1e-5 * dense.magnitude()) << zeta << " " << period;
    }
}

TEST_P(ResponsePeaksBy, TheLargestAloneIsThatOfAll) {
  std::vector<LinearLaw<double>> laws;
  for (const double period : {0.02, 0.3, 2.0, 9.0, 60.0})
    for (const double zeta : damping_ratios) laws.push_back(law_of(period, zeta));
  for (unsigned seed = 20; seed < 40; ++seed) {
    const auto a = shaking(100, seed);
    const GroundMotion ground{a, 0.01, BetweenSamples::linear};
    const auto all = response_peaks(ground, laws, search(ResponseOf::displacement, Peaks::continuous, false));
    const auto alone =
        response_peaks(ground, laws, search(ResponseOf::displacement, Peaks::continuous, true));
    for (std::size_t i = 0; i < laws.size(); ++i)
      EXPECT_NEAR(alone[i].overall() / all[i].overall(), 1, 1e-12) << i << " " << seed;
  }
}

TEST_P(ResponsePeaksBy, OfOneDoNotDependOnItsNeighbours) {
  const auto a = shaking(2000, 11);
  std::vector<LinearLaw<double>> laws;
  for (int i = 0; i < 101; ++i) laws.push_back(law_of(0.02 * std::pow(1.07, i), 0.05));
  const GroundMotion ground{a, 0.01, BetweenSamples::linear};
  const auto together =
      response_peaks(ground, laws, search(ResponseOf::displacement, Peaks::continuous, true));
  for (std::size_t i = 0; i < laws.size(); i += 9) {
    const auto alone = response_peaks(ground, std::vector{laws[i]},
                                      search(ResponseOf::displacement, Peaks::continuous, true))[0];
    EXPECT_NEAR(alone.overall() / together[i].overall(), 1, 1e-12) << i;
  }
}

TEST(ResponsePeaks, ByDefaultTheFastestUnitWalks) {
  const auto a = shaking(300, 9);
  const std::vector<LinearLaw<double>> laws{law_of(0.1, 0.05), law_of(0.7, 0.02), law_of(3, 0)};
  const GroundMotion ground{a, 0.01};
  const auto found = response_peaks(ground, laws, {});
  const auto fastest = response_peaks(ground, laws, {.unit = choose_unit()->walk});
  ASSERT_EQ(found.size(), laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) EXPECT_EQ(found[i].overall(), fastest[i].overall()) << i;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
