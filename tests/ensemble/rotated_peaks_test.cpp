// Peaks of two components in every direction, against each direction by itself.
#include "cromer/ensemble/rotated_peaks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/ensemble/dispatch.h"

namespace cromer::core {
namespace CROMER_FILE {

using Samples = std::vector<double>;

constexpr double spacing = 0.01;

Samples shaking(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Samples samples(n);
  double smooth = 0;
  for (std::size_t i = 0; i < n; ++i) {
    smooth = 0.8 * smooth + normal(random);
    samples[i] = smooth * std::exp(-std::pow(4 * static_cast<double>(i) / static_cast<double>(n) - 1, 2));
  }
  return samples;
}

Samples sum(double a, const Samples& x, double b, const Samples& y) {
  Samples result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = a * x[i] + b * y[i];
  return result;
}

LinearLaw<double> law_of(double period, double damping_ratio) {
  const double w = 2 * pi / period;
  return {.decay_rate = damping_ratio * w, .stiffness = w * w};
}

std::vector<LinearLaw<double>> many_laws() {
  std::vector<LinearLaw<double>> laws;
  for (const double period : {0.004, 0.0101, 0.02, 0.05, 0.0999, 0.1, 0.31, 1.3, 7.0, 60.0})
    for (const double zeta : {0.0, 0.02, 0.05, 0.3, 1.0, 2.5}) laws.push_back(law_of(period, zeta));
  return laws;
}

/// Two components of a ground: unlike each other, nearly alike, one a multiple of the other, one at rest.
struct Ground {
  const char* name;
  Samples first, second;
};
std::vector<Ground> grounds(std::size_t n) {
  const Samples a = shaking(n, 1), b = shaking(n, 2), rest(n, 0.0);
  return {{"unlike", a, b},
          {"nearly alike", a, sum(0.6, a, 0.05, b)},
          {"in one direction", a, sum(-0.75, a, 0, b)},
          {"first at rest", rest, b},
          {"second at rest", a, rest}};
}

RotatedPeaks of_directions(Samples reach) {
  std::sort(reach.begin(), reach.end());
  return {(reach[89] + reach[90]) / 2, reach[179]};
}

class RotatedPeaksBy : public ::testing::TestWithParam<KernelUnit> {};
INSTANTIATE_TEST_SUITE_P(Units, RotatedPeaksBy, ::testing::ValuesIn(units_here()),
                         [](const auto& unit) { return std::string(unit.param.name); });

/// The displacements at the samples, or every `refinement` of them, by the model's own closed form.
Samples displacements(const Samples& a, bool hold, std::size_t refinement, const LinearLaw<double>& law) {
  Samples x;
  State<double> y{0, 0};
  for (std::size_t i = 0; i + (hold ? 0 : 1) < a.size(); ++i) {
    y = propagate_ramp(law, a[i], hold ? 0 : (a[i + 1] - a[i]) / spacing, spacing, y);
    if ((i + 1) % refinement == 0) x.push_back(y.x);
  }
  return x;
}

double largest(const Samples& x) {
  double most = 0;
  for (const double each : x) most = std::max(most, std::abs(each));
  return most;
}

TEST_P(RotatedPeaksBy, AtTheSamplesOfEachDirection) {
  const auto laws = many_laws();
  for (const Ground& ground : grounds(200))
    for (const bool hold : {false, true})
      for (const std::size_t refinement : {1, 3}) {
        const BetweenSamples between = hold ? BetweenSamples::hold : BetweenSamples::linear;
        const auto found = rotated_peaks({ground.first, spacing, between, refinement},
                                         {ground.second, spacing, between, refinement}, laws, Peaks::samples,
                                         GetParam().walk);
        ASSERT_EQ(found.size(), laws.size());
        for (std::size_t i = 0; i < laws.size(); ++i) {
          const Samples x = displacements(ground.first, hold, refinement, laws[i]),
                        y = displacements(ground.second, hold, refinement, laws[i]);
          Samples reach;
          for (int degree = 0; degree < 180; ++degree)
            reach.push_back(largest(sum(std::cos(degree * pi / 180), x, std::sin(degree * pi / 180), y)));
          const RotatedPeaks exact = of_directions(reach);
          // A held force leaves an undamped motion of whole turns per sample at 0.
          const double size = std::max(exact.largest, 1 / laws[i].stiffness);
          EXPECT_NEAR(found[i].largest, exact.largest, 1e-11 * size) << ground.name << " " << i;
          EXPECT_NEAR(found[i].median, exact.median, 1e-11 * size) << ground.name << " " << i;
        }
      }
}

TEST_P(RotatedPeaksBy, ContinuousAndOfPartsAsEachDirectionAlone) {
  const auto laws = many_laws();
  for (const Ground& ground : grounds(150))
    for (const bool hold : {false, true})
      for (const Peaks peaks : {Peaks::continuous, Peaks::peer}) {
        const BetweenSamples between = hold ? BetweenSamples::hold : BetweenSamples::linear;
        std::vector<Samples> reach(laws.size());
        for (int degree = 0; degree < 180; ++degree) {
          const Samples rotated =
              sum(std::cos(degree * pi / 180), ground.first, std::sin(degree * pi / 180), ground.second);
          const auto alone = response_peaks({rotated, spacing, between}, laws,
                                            {.peaks = peaks, .after_the_end = peaks == Peaks::continuous});
          for (std::size_t i = 0; i < laws.size(); ++i) reach[i].push_back(alone[i].overall());
        }
        const auto found = rotated_peaks({ground.first, spacing, between}, {ground.second, spacing, between},
                                         laws, peaks, GetParam().walk);
        for (std::size_t i = 0; i < laws.size(); ++i) {
          const RotatedPeaks exact = of_directions(reach[i]);
          EXPECT_NEAR(found[i].largest, exact.largest, 1e-11 * exact.largest) << ground.name << " " << i;
          EXPECT_NEAR(found[i].median, exact.median, 1e-11 * exact.largest) << ground.name << " " << i;
        }
      }
}

TEST_P(RotatedPeaksBy, OfAGroundAtRestAreNone) {
  const Samples rest(100, 0.0);
  for (const Peaks peaks : {Peaks::continuous, Peaks::samples})
    for (const RotatedPeaks& found :
         rotated_peaks({rest, spacing}, {rest, spacing}, many_laws(), peaks, GetParam().walk)) {
      EXPECT_EQ(found.median, 0);
      EXPECT_EQ(found.largest, 0);
    }
}

// Over 8192 samples blocks grow, and a long period needs all its digits.
TEST_P(RotatedPeaksBy, OfManySamples) {
  const std::size_t n = 40000;
  const Samples first = shaking(n, 5), second = shaking(n, 6);
  const std::vector<LinearLaw<double>> laws{law_of(0.03, 0.05), law_of(0.7, 0.05), law_of(90, 0.01)};
  const auto found =
      rotated_peaks({first, spacing}, {second, spacing}, laws, Peaks::samples, GetParam().walk);
  for (std::size_t i = 0; i < laws.size(); ++i) {
    Samples reach;
    for (int degree = 0; degree < 180; ++degree)
      reach.push_back(
          response_peaks(
              {sum(std::cos(degree * pi / 180), first, std::sin(degree * pi / 180), second), spacing},
              std::vector{laws[i]}, {.peaks = Peaks::samples, .after_the_end = false})[0]
              .overall());
    const RotatedPeaks exact = of_directions(reach);
    EXPECT_NEAR(found[i].largest, exact.largest, 1e-11 * exact.largest) << i;
    EXPECT_NEAR(found[i].median, exact.median, 1e-11 * exact.largest) << i;
  }
}

TEST(RotatedPeaks, ByDefaultTheFastestUnitWalks) {
  const Samples first = shaking(300, 5), second = shaking(300, 6);
  const std::vector<LinearLaw<double>> laws{law_of(0.03, 0.05), law_of(0.7, 0.05)};
  const auto found = rotated_peaks({first, spacing}, {second, spacing}, laws, Peaks::continuous);
  const auto fastest =
      rotated_peaks({first, spacing}, {second, spacing}, laws, Peaks::continuous, choose_unit()->walk);
  for (std::size_t i = 0; i < laws.size(); ++i) EXPECT_EQ(found[i].median, fastest[i].median);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
