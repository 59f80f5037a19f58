// Dry friction with every method: truths for the arcs, orders, rest that is rest.
#include "cromer/run/stick_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/general_drive.h"
#include "cromer/run/solve.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

struct Run {
  Outcome outcome;
  Trajectory trajectory;
};

Run run(const Oscillator<double>& oscillator, const HarmonicDrive<double>& drive, std::string_view name,
        double until, StepControl control, State<double> start, EventLog* events = nullptr) {
  KeepEvery keep(1, count_steps({0, until}, control.step));
  const Outcome outcome = with_dry_friction(oscillator, drive, [&](const auto& system) {
    return visit_method(name, {}, [&](const auto& method) {
      return solve(system, method, {0, until}, start, control, keep, {}, {}, events);
    });
  });
  return {outcome, keep.take()};
}

double energy(const Oscillator<double>& o, double x, double v) {
  return (o.mass * v * v + o.stiffness * x * x) / 2;
}

const Oscillator<double> rubbing{.mass = 1, .stiffness = 9, .damping = 0.1, .friction = 0.5};

/// Slides, sticks twice a cycle, and goes on doing so.
const Oscillator<double> sticking{
    .mass = 1, .stiffness = 1, .damping = 0.2, .friction = 0.5, .static_friction = 0.7};
const HarmonicDrive<double> slow{.amplitude = 1, .frequency = 0.25, .phase = -1.5};

TEST(StickSlip, ExactMeetsThePublishedStatesWhateverTheStep) {
  const auto truth = problems::read("coulomb.json");
  int compared = 0;
  for (const auto& entry : truth) {
    const Oscillator<double> o{.mass = problems::number(entry, "m"),
                               .stiffness = problems::number(entry, "k"),
                               .friction = problems::number(entry, "friction")};
    const double t = problems::number(entry, "t"), x0 = problems::number(entry, "x0");
    for (const double step : {t, t / 7, 0.01}) {
      const State<double> y = run(o, {}, "exact", t, step, {x0, 0}).outcome.y;
      EXPECT_NEAR(y.x, problems::number(entry, "x"), 1e-12 * x0) << t << ' ' << step;
      EXPECT_NEAR(y.v, problems::number(entry, "v"), 1e-12 * 9 * x0) << t << ' ' << step;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 21);
}

TEST(StickSlip, DampedArcsAgreeWithAFineIntegration) {
  const State<double> fine = run(rubbing, {}, "dormand-prince", 3, {0.1, 1e-13}, {1, 0.4}).outcome.y;
  const State<double> exact = run(rubbing, {}, "exact", 3, 3, {1, 0.4}).outcome.y;
  EXPECT_NEAR(exact.x, fine.x, 1e-11);
  EXPECT_NEAR(exact.v, fine.v, 1e-11);
  EXPECT_GT(std::abs(exact.v), 0.1) << "it still moves";
}

// Undamped it keeps the energy from cycle to cycle; friction alone takes it, 2 f / k of the amplitude a turn.
TEST(StickSlip, EulerCromerAddsNoEnergyAtTheTurns) {
  const double w = 6, friction = 0.01, start = 0.1;
  for (const double step : {0.005, 0.0171, 0.03, 0.0507}) {
    EventLog log{.events = {{.quantity = Event::Quantity::velocity}}};
    run({.mass = 1, .stiffness = w * w, .friction = friction}, {}, "euler-cromer", 20, {step}, {start, 0},
        &log);
    ASSERT_GE(log.found.size(), 37u) << step;
    const double left = start - 2 * friction / (w * w) * 37;
    EXPECT_NEAR(std::abs(log.found[36].y.x) / left, 1, w * w * step * step) << step;
  }
}

TEST(StickSlip, OneArcOfAFreeMassIsABrakingDistance) {
  // No spring: v0 = 2 m/s, 0.5 m/s^2: 4 s and 4 m.
  const Oscillator<double> sledge{.mass = 2, .stiffness = 0, .friction = 1};
  for (const std::string_view method : method_names) {
    EventLog log{.events = {{.quantity = Event::Quantity::velocity}}};
    const auto end = run(sledge, {}, method, 10, 0.7, {0, 2}, &log).outcome;
    const bool first_order = find_method(method)->order == 1;  // x is wrong by a tenth, v by nothing
    EXPECT_NEAR(end.y.x, 4, first_order ? 0.8 : 1e-12) << method;
    EXPECT_EQ(end.y.v, 0) << method;
    ASSERT_EQ(log.found.size(), 1u) << method;
    EXPECT_NEAR(log.found[0].t, 4, 1e-12) << method;
  }
}

class WithFriction : public testing::TestWithParam<std::string_view> {
 protected:
  const MethodInfo& info() const { return *find_method(GetParam()); }
  bool adaptive() const { return info().error_order > 0; }
  StepControl control(double step) const { return {step, 1e-11}; }
};

INSTANTIATE_TEST_SUITE_P(Registry, WithFriction, testing::ValuesIn(method_names), [](const auto& test) {
  std::string name(test.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(WithFriction, KeepsItsOrderThroughTheStops) {
  const double until = 2.9;  // two stops behind it, sliding
  const State<double> exact = run(rubbing, {}, "exact", until, until, {1, 0}).outcome.y;
  const auto error = [&](int steps) {
    const State<double> y = run(rubbing, {}, GetParam(), until, control(until / steps), {1, 0}).outcome.y;
    return std::hypot(y.x - exact.x, (y.v - exact.v) / 3);
  };
  if (info().order == 0 || adaptive()) {
    EXPECT_LT(error(10), 1e-10);
    return;
  }
  const int steps = info().order >= 4 ? 150 : 1500;
  EXPECT_NEAR(std::log2(error(steps) / error(8 * steps)) / 3, info().order, 0.2);
}

TEST_P(WithFriction, ComesToRestAndStaysThere) {
  const auto [outcome, kept] = run(rubbing, {}, GetParam(), 40, control(0.01), {1, 0});
  ASSERT_EQ(outcome.status, Status::reached_end);
  ASSERT_EQ(kept.size(), 4001u);
  EXPECT_EQ(kept.v.back(), 0);
  EXPECT_LE(std::abs(kept.x.back()) * 9, 0.5 * (1 + 1e-12));
  std::size_t first = 0;
  while (kept.v[first] != 0 || first == 0) ++first;
  EXPECT_LT(kept.t[first], 12) << "it does not creep";
  for (std::size_t i = first; i < kept.size(); ++i) {
    EXPECT_EQ(kept.v[i], 0) << kept.t[i];
    EXPECT_EQ(kept.x[i], kept.x[first]) << kept.t[i];
  }
  if (!adaptive()) {
    EXPECT_LT(outcome.counts.accepted, 1200) << "rest costs nothing";
  }
}

TEST_P(WithFriction, LosesEnergyAtEveryStop) {
  EventLog log{.events = {{.quantity = Event::Quantity::velocity}}};
  run(rubbing, {}, GetParam(), 40, control(0.01), {1, 0}, &log);
  double last = 1;
  ASSERT_GE(log.found.size(), 5u);
  for (const FoundEvent& stop : log.found) {
    EXPECT_EQ(stop.y.v, 0);
    // 4 f/k a cycle, and a little to the damping.
    EXPECT_LT(std::abs(stop.y.x), last - (last > 0.2 ? 0.08 : 0)) << stop.t;
    last = std::abs(stop.y.x);
  }
}

TEST_P(WithFriction, EnergyNeverRisesWhereTheMethodAddsNone) {
  if (GetParam() == "forward-euler" || GetParam() == "euler-cromer") GTEST_SKIP() << "its energy swings";
  const auto kept = run(rubbing, {}, GetParam(), 40, control(0.01), {1, 0}).trajectory;
  for (std::size_t i = 1; i < kept.size(); ++i)
    EXPECT_LE(energy(rubbing, kept.x[i], kept.v[i]),
              energy(rubbing, kept.x[i - 1], kept.v[i - 1]) * (1 + 1e-5) + 1e-15)
        << kept.t[i];
}

TEST_P(WithFriction, AWeakDriveMovesNothing) {
  if (GetParam() == "exact") GTEST_SKIP() << "takes no drive with friction";
  const auto [outcome, kept] = run(sticking, {0.59, 0.25, 0}, GetParam(), 60, control(0.05), {-0.1, 0});
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept.x[i], -0.1);
    EXPECT_EQ(kept.v[i], 0);
  }
  EXPECT_EQ(outcome.counts.accepted, 0);
  // And one that is just strong enough does: 0.7 N hold it.
  EXPECT_NE(run(sticking, {0.601, 0.25, 0}, GetParam(), 60, control(0.05), {-0.1, 0}).outcome.y.x, -0.1);
}

TEST_P(WithFriction, BreaksLooseWhenThePullExceedsTheStaticFriction) {
  if (GetParam() == "exact") GTEST_SKIP() << "takes no drive with friction";
  // At x = 0 and rest: cos(t/4 - 3/2) = 0.7.
  const double loose = (1.5 - std::acos(0.7)) / 0.25;
  const auto kept = run(sticking, slow, GetParam(), 4, control(0.01), {0, 0}).trajectory;
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_EQ(kept.v[i] != 0, kept.t[i] > loose) << kept.t[i] << ' ' << loose;
}

TEST_P(WithFriction, StickSlipUnderADriveAgreesWithAFineRun) {
  if (GetParam() == "exact") GTEST_SKIP() << "takes no drive with friction";
  const auto fine = run(sticking, slow, "dormand-prince", 100, {0.01, 1e-13}, {0, 0}).trajectory;
  const auto kept = run(sticking, slow, GetParam(), 100, control(0.01), {0, 0}).trajectory;
  ASSERT_EQ(kept.size(), fine.size());
  double worst = 0;
  long long at_rest = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    worst = std::max(worst, std::abs(kept.x[i] - fine.x[i]));
    at_rest += kept.v[i] == 0;
  }
  EXPECT_LT(worst, adaptive() ? 1e-9 : info().order == 1 ? 2e-2 : info().order == 2 ? 2e-5 : 1e-8);
  EXPECT_GT(at_rest, 1000) << "it does stick";
  EXPECT_LT(at_rest, 9000) << "it does slip";
}

TEST(StickSlip, ReleaseIsFoundBetweenRowsFarApart) {
  // A drive of 2.1 s period, rows 10 s apart.
  const Oscillator<double> o{.mass = 1, .stiffness = 4, .friction = 0.5};
  const HarmonicDrive<double> drive{.amplitude = 1, .frequency = 3, .phase = 1.4};
  const auto coarse = run(o, drive, "dormand-prince", 100, {10, 1e-12}, {0, 0});
  const auto fine = run(o, drive, "dormand-prince", 100, {0.01, 1e-12}, {0, 0});
  for (std::size_t i = 0; i < coarse.trajectory.size(); ++i)
    EXPECT_NEAR(coarse.trajectory.x[i], fine.trajectory.x[1000 * i], 1e-8) << i;
}

TEST(StickSlip, BreaksLooseAtAnyTolerance) {
  // Pull and friction all but cancel there: what moves at first is less than the rounding of both.
  const Oscillator<double> o{.mass = 1, .stiffness = 4, .friction = 0.5};
  const HarmonicDrive<double> drive{.amplitude = 1, .frequency = 3, .phase = 1.4};
  const double end = run(o, drive, "dormand-prince", 10, {0.01, 1e-15}, {0, 0}).outcome.y.x;
  for (const double step : {0.01, 0.3, 10.0})
    for (const double tolerance : {1e-6, 1e-9, 1e-12, 1e-13, 1e-14}) {
      const auto outcome = run(o, drive, "dormand-prince", 10, {step, tolerance}, {0, 0}).outcome;
      EXPECT_EQ(outcome.status, Status::reached_end) << tolerance;
      EXPECT_NEAR(outcome.y.x, end, std::max(30 * tolerance, 1e-13)) << tolerance;
    }
}

/// When a mass on 1 N/m that rests at x breaks loose, held by 1 N, with rows so far apart [s].
template <class Drive>
double breaks_loose(const Drive& drive, double x, double row) {
  const Oscillator<double> o{.mass = 2, .stiffness = 1, .friction = 0.8, .static_friction = 1};
  return with_terms(o, drive, [&](const auto& system) {
    if constexpr (requires { system.holding(); }) {
      const Rows rows{{0, 100}, row};
      Course<double> course{0, {x, 0}};
      KeepNone keep_none;
      if (direction_from_rest(system, 0, x) == 0 && stick(system, rows, course, keep_none, {}) != 0)
        return course.t;
    }
    return std::numeric_limits<double>::quiet_NaN();
  });
}

TEST(StickSlip, NoPullIsMissedHoweverBriefOrSlight) {
  using General = GeneralDrive<double>;
  const double pi = std::numbers::pi;
  for (const double row : {1.0, 0.37, 100.0}) {
    const auto pulse = [](PulseShape shape) { return General(PulseDrive<double>{shape, 2, 7.3, 1e-3}); };
    EXPECT_NEAR(breaks_loose(pulse(PulseShape::step), 0, row), 7.3, 1e-14);
    EXPECT_NEAR(breaks_loose(pulse(PulseShape::rectangular), 0, row), 7.3, 1e-14);
    EXPECT_NEAR(breaks_loose(pulse(PulseShape::half_sine), 0, row), 7.3 + 1e-3 / 6, 1e-14);
    EXPECT_NEAR(breaks_loose(pulse(PulseShape::triangular), 0, row), 7.3 + 1e-3 / 4, 1e-14);

    // One sample of 100,000 that pulls; the spring already pulls with 0.3 N.
    auto samples = std::make_shared<std::vector<double>>(100'001);
    (*samples)[54321] = -4;
    SampledDrive recorded{samples, 1e-3, BetweenSamples::linear};
    EXPECT_NEAR(breaks_loose(General(recorded), 0.3, row), 54.320 + 0.7 / 4 * 1e-3, 1e-13);
    recorded.between = BetweenSamples::hold;
    EXPECT_NEAR(breaks_loose(General(recorded), 0.3, row), 54.321, 1e-9) << "a jump";

    // A millionth more than friction holds, once in 0.02 s; nothing if it is a millionth less.
    const double fast = 100 * pi;
    const HarmonicDrive<double> drive{1 + 1e-6, fast, -1};
    EXPECT_NEAR(breaks_loose(drive, 0, row), (1 - std::acos(1 / (1 + 1e-6))) / fast, 1e-14);
    EXPECT_TRUE(std::isnan(breaks_loose(HarmonicDrive<double>{1 - 1e-6, fast, -1}, 0, row)));

    // A chirp that pushes first, but the spring helps it only when it pulls: its first pull at 2 pi.
    const ChirpDrive<double> linear{0.7 + 1e-6, 50, 5e4, pi, 2, 90, false};
    const double angle = pi - std::acos(0.7 / (0.7 + 1e-6)), bend = (5e4 - 50) / 180;
    const double since = 2 * angle / (50 + std::sqrt(2500 + 4 * bend * angle));
    EXPECT_NEAR(breaks_loose(General(linear), -0.3, row), 2 + since, 1e-13);
    // One that ends while it rises: the last value counts.
    const ChirpDrive<double> ending{2, 0.01, 0.01, -pi / 2, 2, 100 * pi / 6 + 1e-6, false};
    EXPECT_NEAR(breaks_loose(General(ending), 0, row), 2 + 100 * pi / 6, 1e-12);
  }
}

TEST(StickSlip, AShortPulseBetweenTwoRowsMovesTheMassWithEveryMethod) {
  const GeneralDrive<double> pulse(PulseDrive<double>{PulseShape::rectangular, 20, 0.3, 1e-3});
  const Oscillator<double> o{.mass = 1, .stiffness = 0, .friction = 1};
  for (const std::string_view method : method_names) {
    if (method == "exact") continue;
    KeepEvery keep(1, count_steps({0, 3}, 1));
    with_terms(o, pulse, [&](const auto& system) {
      return visit_method(method, {}, [&](const auto& m) {
        return solve(system, m, {0, 3}, State<double>{0, 0}, {1, 1e-11}, keep);
      });
    });
    const Trajectory kept = keep.take();
    ASSERT_EQ(kept.size(), 4u) << method;
    EXPECT_NE(kept.x.back(), 0) << method;
    // 19 m/s^2 for 1 ms, then 1 m/s^2 against it: 9.5 um, and 180.5 um to the stop.
    if (method == "dormand-prince") {
      EXPECT_NEAR(kept.x.back(), 190e-6, 1e-10);
      EXPECT_EQ(kept.v[1], 0);
    }
  }
}

TEST(StickSlip, APullThatJustBalancesIsRest) {
  // Turning points at 3 f/k, then f/k: there friction holds, or all but holds.
  for (const double k : {1.0, 3.0, 7.0, 0.3})
    for (const std::string_view method : method_names) {
      const Oscillator<double> o{.mass = 1, .stiffness = k, .friction = 0.1 * k};
      const auto outcome = run(o, {}, method, 100, {0.01, 1e-12}, {0.3, 0}).outcome;
      EXPECT_EQ(outcome.status, Status::reached_end) << method;
      EXPECT_NEAR(outcome.y.x, -0.1, find_method(method)->order == 1 ? 0.02 : 1e-4) << method;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
