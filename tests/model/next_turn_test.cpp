#include "cromer/model/next_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "cromer/model/chirp.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/pulse.h"
#include "cromer/model/sampled_drive.h"

namespace cromer::core {
namespace {

constexpr double pi = std::numbers::pi;

/// The turns of a force up to `until`; in between it must be monotonic.
template <class Force>
std::vector<double> turns(const Force& force, double until) {
  std::vector<double> found;
  double last = 0;
  while (true) {
    const double next = force.next_turn(last);
    if (!(next > last)) {
      ADD_FAILURE() << "stands still at " << last;
      return found;
    }
    const double end = std::min(next, until);
    bool rises = false, falls = false;
    double before = force(last + 1e-9 * (end - last));
    for (int i = 1; i < 1000; ++i) {
      const double now = force(last + i / 1000.0 * (end - last));
      rises = rises || now > before + 1e-12;
      falls = falls || now < before - 1e-12;
      before = now;
    }
    EXPECT_FALSE(rises && falls) << "between " << last << " and " << next;
    if (next >= until) return found;
    found.push_back(next);
    last = next;
  }
}

TEST(NextTurn, OfAHarmonicForceIsItsExtrema) {
  const auto found = turns(HarmonicForce<double>{2, 5, 0.4}, 100);
  ASSERT_EQ(found.size(), 159u);  // 500.4/pi
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_DOUBLE_EQ(found[i], ((static_cast<double>(i) + 1) * pi - 0.4) / 5);
  EXPECT_EQ(HarmonicForce<double>({2, 0, 0.4}).next_turn(3), std::numeric_limits<double>::infinity());
}

TEST(NextTurn, OfAPulseIsWhereItsPiecesBegin) {
  const auto of = [](PulseShape shape) { return turns(PulseForce<double>({shape, -3, 0.5, 0.25}, 1.0), 10); };
  EXPECT_EQ(of(PulseShape::step), (std::vector<double>{0.5}));
  EXPECT_EQ(of(PulseShape::rectangular), (std::vector<double>{0.5, 0.75}));
  EXPECT_EQ(of(PulseShape::triangular), (std::vector<double>{0.5, 0.625, 0.75}));
  const auto half_sine = of(PulseShape::half_sine);
  ASSERT_EQ(half_sine.size(), 3u);
  EXPECT_DOUBLE_EQ(half_sine[1], 0.625);
}

TEST(NextTurn, OfARecordingIsEverySample) {
  const auto samples = std::make_shared<const std::vector<double>>(std::vector<double>{0, 1, -2, 2, 2, 0});
  for (const auto between : {BetweenSamples::linear, BetweenSamples::hold}) {
    const auto found = turns(SampledForce<double>({samples, 0.1, between}, 1.0), 10);
    ASSERT_EQ(found.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(found[i], 0.1 * (static_cast<double>(i) + 1));
  }
}

TEST(NextTurn, OfAChirpIsItsExtrema) {
  struct Case {
    double from, to, phase;
    bool logarithmic;
  };
  for (const Case& c :
       {Case{0, 40, 0, false}, Case{40, 0, 1, false}, Case{10, 10, -2, false}, Case{3, 30, 0.3, false},
        Case{1, 100, -pi, true}, Case{100, 1, 0.5, true}, Case{7, 7, 0.5, true}, Case{0, 0, 0.2, false}}) {
    const ChirpDrive<double> drive{2, c.from, c.to, c.phase, 0.5, 4, c.logarithmic};
    const auto found = turns(ChirpForce<double>(drive, 1.0), 10);
    // The angle runs over this much; beside the turns there are start and end.
    const double mean =
        c.logarithmic && c.from != c.to ? (c.to - c.from) / std::log(c.to / c.from) : (c.from + c.to) / 2;
    const double half_turns = std::floor((c.phase + 4 * mean) / pi) - std::floor(c.phase / pi);
    EXPECT_NEAR(static_cast<double>(found.size()), 2 + half_turns, 1) << c.from << ' ' << c.to;
    EXPECT_EQ(found.front(), 0.5);
    EXPECT_EQ(found.back(), 4.5);
    for (std::size_t i = 1; i + 1 < found.size(); ++i)
      EXPECT_NEAR(std::abs(ChirpForce<double>(drive, 1.0)(found[i])), 2, 1e-12) << found[i];
  }
}

}  // namespace
}  // namespace cromer::core
