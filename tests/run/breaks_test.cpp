// Drives that jump or bend: every method keeps its order, and the tolerance is kept, across the breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/model/general_drive.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

const Oscillator<double> law{.mass = 0.7, .stiffness = 20, .damping = 0.4};
const State<double> start{0.03, -0.2};
constexpr double end = 7.3;

/// The end of a run under the drive.
template <class Drive>
Outcome run(const Drive& drive, std::string_view method, StepControl control, State<double> from = start) {
  KeepNone keep;
  return with_terms_under(law, drive, [&](const auto& system) {
    return visit_method(method, {}, [&](const auto& m) {
      return solve(system, m, {0, end}, from, control, keep);
    });
  });
}

double distance(const State<double>& a, const State<double>& b) {
  return std::hypot(a.x - b.x, (a.v - b.v) / 5);
}

template <class Drive>
void expect_orders(const Drive& drive, const State<double>& truth) {
  for (const MethodInfo& info : method_infos) {
    if (!info.takes_fixed_steps()) continue;
    const int steps = info.order >= 4 ? 600 : 4800;
    const auto error = [&](int n) { return distance(run(drive, info.name, end / n).y, truth); };
    EXPECT_NEAR(std::log2(error(steps) / error(4 * steps)) / 2, info.order, 0.15) << info.name;
  }
}

TEST(Breaks, EveryMethodKeepsItsOrderAcrossJumpsBetweenSteps) {
  const PulseDrive<double> jump{PulseShape::rectangular, 2.3, 0.77123, 1.10456};
  expect_orders(jump, run(jump, "exact", end).y);
}

TEST(Breaks, EveryMethodKeepsItsOrderUnderAHeldRecording) {
  auto samples = std::make_shared<std::vector<double>>(101);
  for (std::size_t i = 0; i < samples->size(); ++i)
    (*samples)[i] = std::sin(1.7 * static_cast<double>(i * i));
  // The steps divide the spacing, so that the jumps are at their ends.
  const SampledDrive held{samples, end / 100, BetweenSamples::hold};
  expect_orders(held, run(held, "exact", end).y);
}

TEST(Breaks, EveryMethodKeepsItsOrderUnderAChirpThatEnds) {
  const ChirpDrive<double> chirp{2.3, 1, 8, 0.3, 0.512345, 5.0};
  expect_orders(chirp, run(chirp, "dormand-prince", {end, 1e-14}).y);
}

TEST(Breaks, TheToleranceIsKept) {
  const PulseDrive<double> jump{PulseShape::rectangular, 2.3, 0.77123, 1.10456};
  const State<double> truth = run(jump, "exact", end).y;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12})
    EXPECT_LT(distance(run(jump, "dormand-prince", {0.001, tolerance}).y, truth), 10 * tolerance)
        << tolerance;
}

TEST(Breaks, AForceThatJumpsWhileTheMassRestsSetsItGoing) {
  for (const PulseShape shape :
       {PulseShape::step, PulseShape::rectangular, PulseShape::half_sine, PulseShape::triangular}) {
    const PulseDrive<double> late{shape, 100, 3.0, 0.01};
    const State<double> truth = run(late, "exact", end, {0, 0}).y;
    for (const double tolerance : {1e-6, 1e-10, 1e-12, 1e-13, 1e-14})
      for (const double row : {end, 0.05, 0.001}) {
        const Outcome outcome = run(late, "dormand-prince", {row, tolerance}, {0, 0});
        EXPECT_EQ(outcome.status, Status::reached_end) << tolerance << ' ' << row;
        EXPECT_LT(distance(outcome.y, truth), std::max(10 * tolerance, 1e-12)) << tolerance << ' ' << row;
      }
    EXPECT_GT(std::abs(truth.x), 1e-3);
  }
}

TEST(Breaks, APulseBetweenTwoStepsIsNotLost) {
  const PulseDrive<double> brief{PulseShape::rectangular, 100, 5.003, 0.001};
  const State<double> truth = run(brief, "exact", 0.01, {0, 0}).y;
  EXPECT_GT(std::abs(truth.x), 1e-3);
  EXPECT_LT(distance(run(brief, "rk4", 0.01, {0, 0}).y, truth), 1e-6);
}

TEST(Breaks, RowsDoNotChangeAdaptiveSteps) {
  const PulseDrive<double> jump{PulseShape::step, 1, 0.5, 0};
  EXPECT_EQ(run(jump, "dormand-prince", {0.1, 1e-6}).counts,
            run(jump, "dormand-prince", {0.001, 1e-6}).counts);
}

TEST(Breaks, APulseOfAnInstantIsNotLostWhateverTheStep) {
  // An impulse of 1 N s within 0.1 us.
  const PulseDrive<double> instant{PulseShape::rectangular, 1e7, 5.003, 1e-7};
  const State<double> truth = run(instant, "exact", 0.01, {0, 0}).y;
  EXPECT_GT(std::abs(truth.x), 0.01);
  for (const std::string_view method : {"rk4", "dormand-prince"})
    EXPECT_LT(distance(run(instant, method, 0.01, {0, 0}).y, truth), 1e-6) << method;
}

TEST(Breaks, ASlideGoesOnFromPulseToPulse) {
  // 10 m/s less 1 m/s in a second, and 1 N s in 0.1 us on the way.
  const Oscillator<double> sledge{.mass = 1, .stiffness = 0, .friction = 1};
  const GeneralDrive<double> instant(PulseDrive<double>{PulseShape::rectangular, 1e7, 5.003, 1e-7});
  for (const std::string_view method : {"rk4", "dormand-prince"}) {
    const Outcome outcome = with_terms(sledge, instant, [&](const auto& system) {
      return visit_method(method, {}, [&](const auto& m) {
        return solve(system, m, {0, end}, State<double>{0, 10}, StepControl{0.01, 1e-10}, KeepNone{});
      });
    });
    EXPECT_NEAR(outcome.y.v, 10 - end + 1, 1e-7) << method;
    EXPECT_NEAR(outcome.y.x, 10 * end - end * end / 2 + (end - 5.003), 1e-6) << method;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
