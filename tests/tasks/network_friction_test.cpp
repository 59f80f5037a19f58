// Networks with dry friction and with forces that have memory, by every method.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cromer/methods/all.h"
#include "cromer/methods/vector_newton.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/hysteretic_oscillator.h"
#include "cromer/run/solve.h"
#include "cromer/tasks/network_run/network_stick_slip.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

struct KeptState {
  double t;
  std::vector<double> x, v;
};

std::vector<KeptState> states_of(const Network& network, std::string_view name, double until, double step,
                                 double tolerance = 1e-12) {
  std::vector<KeptState> kept;
  const auto keep = [&](double t, const State<MassVector>& y) {
    KeptState& state = kept.emplace_back(KeptState{t, {}, {}});
    for (std::size_t i = 0; i < network.masses.size(); ++i) {
      state.x.push_back(y.x.first[i]);
      state.v.push_back(y.v.first[i]);
    }
  };
  const Outcome outcome =
      visit_method(name, MethodSettings{.newton = {.tolerance = 1e-14}}, [&]<class M>(const M& method) {
        const StepControl control(step, tolerance);
        const State<MassVector> start = start_of(network);
        if constexpr (M::info.is_exact()) {
          return Outcome{};
        } else {
          if (law_of(network).has<Friction>())
            return solve_with_contacts(network, method, {0, until}, start, control, keep, {});
          return solve(NetworkSystem<>(network), method, {0, until}, start, control, keep);
        }
      });
  EXPECT_EQ(outcome.status, Status::reached_end) << name;
  return kept;
}

Network one_mass(const Oscillator<double>& law, const State<double>& start,
                 const HarmonicDrive<double>& drive = {}, bool turned = false) {
  Network network;
  network.masses.push_back({"one", law.mass, start, drive});
  network.links.push_back({turned ? 0 : ground, turned ? ground : 0, law});
  return network;
}

class NetworkFrictionRuns : public EveryMethod {};

INSTANTIATE_TEST_SUITE_P(Registry, NetworkFrictionRuns, testing::ValuesIn(method_names), name_of_test);

TEST_P(NetworkFrictionRuns, OneMassIsTheOscillator) {
  if (info().is_exact()) return;
  const HarmonicDrive<double> slow{1, 0.25, -1.5}, fast{2, 2.9, 0.4};
  const Oscillator<double> rubbing{.mass = 1.3, .stiffness = 9, .damping = 0.1, .friction = 0.5},
      sticking{.mass = 0.7, .stiffness = 1, .damping = 0.2, .friction = 0.5, .static_friction = 0.7},
      bent{.mass = 0.7, .stiffness = 3, .drag = 0.2, .friction = 0.2, .cubic = 0.8};
  for (const Oscillator<double>& law : {rubbing, sticking, bent})
    for (const HarmonicDrive<double>& drive : {HarmonicDrive<double>{}, slow, fast})
      for (const bool turned : {false, true}) {
        const State<double> start{1, -0.3};
        std::vector<State<double>> single;
        with_dry_friction(law, drive, [&](const auto& system) {
          with_method([&](const auto& method) {
            return solve(system, method, {0, 30}, start, StepControl(0.02, 1e-12),
                         [&](double, const State<double>& y) { single.push_back(y); });
          });
        });
        const auto kept = states_of(one_mass(law, start, drive, turned), GetParam(), 30, 0.02);
        ASSERT_EQ(kept.size(), single.size());
        // Smooth stretches agree to the bit. Where a mass breaks loose, both find the moment to rounding, but
        // not to the same bit; Newton's iteration and the adaptive steps see its rounding.
        const double near = info().is_adaptive() ? 1e-9 : info().implicit ? 1e-10 : 1e-12;
        for (std::size_t n = 0; n < kept.size(); ++n) {
          ASSERT_NEAR(kept[n].x[0], single[n].x, near) << law_of(law).terms << ' ' << n;
          ASSERT_NEAR(kept[n].v[0], single[n].v, 10 * near) << law_of(law).terms << ' ' << n;
        }
        const std::size_t equal = drive.amplitude == 0 ? 30 : 0;
        for (std::size_t n = 0; n < equal; ++n) ASSERT_EQ(kept[n].x[0], single[n].x) << n;
      }
}

TEST_P(NetworkFrictionRuns, OneMassWithMemoryIsTheOscillator) {
  if (info().is_exact()) return;
  Oscillator<double> law{.mass = 0.7, .stiffness = 3, .damping = 0.1};
  law.hysteresis_stiffness = 5, law.hysteresis_beta = 2, law.hysteresis_gamma = -0.5;
  for (const double exponent : {1.0, 1.7})
    for (const HarmonicDrive<double>& drive : {HarmonicDrive<double>{}, HarmonicDrive<double>{2, 2.9, 0.4}}) {
      law.hysteresis_exponent = exponent;
      const State<double> start{1, -0.3};
      std::vector<double> single, of_network;
      with_method([&](const auto& method) {
        return solve(HystereticOscillator(divided_by_mass(law), force_of(drive, law.mass)), method, {0, 10},
                     State<Coupled<double>>{{start.x, 0}, {start.v, 0}}, StepControl(0.02, 1e-10),
                     [&](double, const State<Coupled<double>>& y) {
                       single.push_back(y.x.first);
                       single.push_back(y.v.first);
                     });
      });
      for (const KeptState& state : states_of(one_mass(law, start, drive), GetParam(), 10, 0.02, 1e-10)) {
        of_network.push_back(state.x[0]);
        of_network.push_back(state.v[0]);
      }
      ASSERT_EQ(single.size(), of_network.size());
      // The drive of networks comes from tables.
      if (drive.amplitude == 0) {
        EXPECT_EQ(single, of_network);
      }
      for (std::size_t n = 0; n < single.size(); ++n) ASSERT_NEAR(single[n], of_network[n], 1e-8);
    }
}

TEST_P(NetworkFrictionRuns, TwoFreeMassesEndWithOneVelocity) {
  if (info().is_exact()) return;
  Network network;
  network.masses.push_back({"a", 2, {0, 3}});
  network.masses.push_back({"b", 0.5, {0, -1}});
  network.links.push_back({0, 1, {.stiffness = 0, .friction = 0.7}});
  const double momentum = 2 * 3 - 0.5, common = momentum / 2.5, rate = 0.7 * (1 / 2.0 + 1 / 0.5),
               rest = 4 / rate;
  for (const KeptState& state : states_of(network, GetParam(), 4, 0.03)) {
    EXPECT_NEAR(2 * state.v[0] + 0.5 * state.v[1], momentum, 1e-12);
    EXPECT_NEAR(state.v[0] - state.v[1], std::max(0.0, 4 - rate * state.t), 1e-11) << state.t;
    if (state.t > rest) {
      EXPECT_NEAR(state.v[0], common, 1e-12);
      EXPECT_EQ(state.v[0], state.v[1]);
    }
  }
}

/// Pulled by a force that rises and falls slowly.
Network pulled_blocks(double between) {
  Network network;
  network.masses.push_back({"a", 2, {}, {10, 0.5, -std::numbers::pi / 2}});
  network.masses.push_back({"b", 3});
  network.links.push_back({ground, 0, {.stiffness = 0, .friction = 1.5}});
  network.links.push_back({1, ground, {.stiffness = 0, .friction = 2.5}});
  network.links.push_back({1, 0, {.stiffness = 0, .friction = between}});
  return network;
}

TEST_P(NetworkFrictionRuns, PulledBlocksPartWhereTheyMust) {
  if (info().is_exact()) return;
  // 10 N sin(t/2). Loosely joined, a goes alone from 1.5 N + 1 N on; b never does: it holds 2.5 N.
  const double alone = 2 * std::asin(0.25);
  for (const KeptState& state : states_of(pulled_blocks(1), GetParam(), 3, 0.01)) {
    if (state.t < alone - 1e-9) {
      EXPECT_EQ(state.v[0], 0);
    }
    if (state.t > alone + 0.011) {
      EXPECT_GT(state.v[0], 0);
    }
    EXPECT_EQ(state.x[1], 0);
  }
  // Tightly, both go from 1.5 N + 2.5 N on, as one: m v = 20 N s (cos t0/2 - cos t/2) - 4 N (t - t0).
  const double both = 2 * std::asin(0.4);
  for (const KeptState& state : states_of(pulled_blocks(50), GetParam(), 3, 0.01)) {
    EXPECT_EQ(state.v[0], state.v[1]);
    const double t = std::max(both, state.t);
    const double v = (20 * (std::cos(both / 2) - std::cos(t / 2)) - 4 * (t - both)) / 5;
    EXPECT_NEAR(state.v[0], v, info().order == 1 ? 0.02 : 1e-5) << state.t;
    if (state.t < both - 1e-9) {
      EXPECT_EQ(state.v[0], 0);
    }
  }
}

Network rubbing_chain() {
  Network network;
  for (std::size_t i = 0; i < 4; ++i) network.masses.push_back({"m", 0.5 + 0.2 * static_cast<double>(i)});
  network.masses[0].start.x = 1;
  network.masses[2].drive = {1.2, 2.2, 0.3};
  for (std::size_t i = 0; i < 4; ++i)
    network.links.push_back({i == 0 ? ground : i - 1, i, {.stiffness = 8, .damping = 0.05, .friction = 0.3}});
  network.links[2].law.static_friction = 0.5;
  network.links.push_back({ground, 3, {.stiffness = 2, .friction = 0.2}});
  return network;
}

TEST_P(NetworkFrictionRuns, KeepsItsOrderThroughTheStops) {
  if (info().is_exact()) return;
  const double until = 4;
  static const KeptState truth = states_of(rubbing_chain(), "dormand-prince", until, until, 1e-14).back();
  const auto error = [&](int steps) {
    const KeptState end = states_of(rubbing_chain(), GetParam(), until, until / steps).back();
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += std::pow(end.x[i] - truth.x[i], 2) + std::pow(end.v[i] - truth.v[i], 2) / 16;
    return std::sqrt(sum);
  };
  if (info().is_adaptive()) {
    EXPECT_LT(error(10), 1e-9);
    return;
  }
  const int steps = info().order >= 4 ? 200 : 4000;
  EXPECT_NEAR(std::log2(error(steps) / error(4 * steps)) / 2, info().order, 0.25);
}

TEST_P(NetworkFrictionRuns, AContactStopsWithOthersThatCloseALoop) {
  if (info().is_exact()) return;
  // b rests on the ground. Where a stops on b, it stops on the ground too; then its spring pulls it back at
  // once: nothing waits for the next step.
  Network network;
  network.masses.push_back({"a", 1, {0, 1}});
  network.masses.push_back({"b", 1});
  network.links.push_back({ground, 0, {.stiffness = 16, .static_friction = 0.5}});
  network.links.push_back({ground, 1, {.stiffness = 0, .friction = 5}});
  network.links.push_back({1, 0, {.stiffness = 0, .friction = 0.5}});
  const Network alone = one_mass({.mass = 1, .stiffness = 16, .friction = 0.5, .static_friction = 1}, {0, 1});
  const auto both = states_of(network, GetParam(), 4, 0.05), one = states_of(alone, GetParam(), 4, 0.05);
  ASSERT_EQ(both.size(), one.size());
  for (std::size_t n = 0; n < one.size(); ++n) {
    ASSERT_NEAR(both[n].x[0], one[n].x[0], 1e-9) << n;
    ASSERT_EQ(both[n].x[1], 0);
  }
}

TEST(NetworkFrictionRun, MassesThatStickMoveAsOne) {
  // A train whose couplings hold is one mass.
  Network train;
  for (int i = 0; i < 3; ++i) train.masses.push_back({"m", 1.0 + i, {0.5, 1}});
  train.links.push_back({ground, 0, {.stiffness = 12, .damping = 0.3}});
  train.links.push_back({0, 1, {.stiffness = 5, .friction = 100}});
  train.links.push_back({1, 2, {.stiffness = 0, .friction = 100}});
  const Network whole = one_mass({.mass = 6, .stiffness = 12, .damping = 0.3}, {0.5, 1});
  for (const std::string_view method : {"rk4", "newmark", "gauss-legendre4", "verlet", "dormand-prince"}) {
    const auto parts = states_of(train, method, 5, 0.01), one = states_of(whole, method, 5, 0.01);
    ASSERT_EQ(parts.size(), one.size());
    for (std::size_t n = 0; n < one.size(); ++n)
      for (const double x : parts[n].x) ASSERT_NEAR(x, one[n].x[0], 1e-10) << method;
  }
}

/// Accelerations of least distance from free ones, by sweeps over the friction of each contact.
std::vector<double> by_sweeps(const std::vector<double>& mass, const std::vector<Contact>& contacts,
                              std::vector<double> a) {
  std::vector<double> force(contacts.size());
  for (int sweep = 0; sweep < 200000; ++sweep) {
    double change = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto& [from, to, kinetic, holding] = contacts[c];
      const double apart = (to == ground ? 0 : a[to]) - (from == ground ? 0 : a[from]);
      const double ease = (to == ground ? 0 : 1 / mass[to]) + (from == ground ? 0 : 1 / mass[from]);
      const double next = std::clamp(force[c] + apart / ease, -holding, holding), more = next - force[c];
      force[c] = next;
      if (to != ground) a[to] -= more / mass[to];
      if (from != ground) a[from] += more / mass[from];
      change = std::max(change, std::abs(more));
    }
    if (change < 1e-15) break;
  }
  return a;
}

TEST(NetworkFrictionRun, DecidesManyContactsTogether) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(0, 1);
  int slid = 0, stuck = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Network network;
    const std::size_t masses = 1 + random() % 6;
    for (std::size_t i = 0; i < masses; ++i) network.masses.push_back({"m", 0.2 + number(random)});
    const std::size_t links = 1 + random() % 9;
    for (std::size_t l = 0; l < links; ++l) {
      const std::size_t from = random() % masses, other = random() % (masses + 1);
      const std::size_t to = other == masses ? ground : other;
      if (from != to) network.links.push_back({from, to, {.stiffness = 0, .friction = number(random)}});
    }
    std::vector<double> mass, free;
    Vector a = Vector::of_size(masses);
    for (std::size_t i = 0; i < masses; ++i) {
      mass.push_back(network.masses[i].mass);
      free.push_back(a[i] = 4 * number(random) - 2);
    }
    const NetworkFriction friction(network);
    std::vector<int> directions(friction.contacts().size());
    friction.decide(a, directions);
    NetworkPhase(network, friction.contacts(), directions).apply(a);
    const std::vector<double> wanted = by_sweeps(mass, friction.contacts(), free);
    for (std::size_t i = 0; i < masses; ++i) ASSERT_NEAR(a[i], wanted[i], 1e-9) << trial;
    for (std::size_t c = 0; c < directions.size(); ++c) {
      const double speed = friction.speed(c, a);
      if (directions[c] == 0) {
        ASSERT_EQ(speed, 0);
      }
      if (directions[c] != 0) {
        ASSERT_GT(speed * directions[c], 0) << trial;
      }
      ++(directions[c] == 0 ? stuck : slid);
    }
  }
  EXPECT_GT(slid, 200);
  EXPECT_GT(stuck, 200);
}

TEST(NetworkFrictionRun, ManyBlocksComeToRest) {
  Network network;
  constexpr std::size_t blocks = 200;
  for (std::size_t i = 0; i < blocks; ++i) {
    network.masses.push_back({"m", 1});
    network.links.push_back({ground, i, {.stiffness = 0, .friction = 0.2}});
    if (i > 0) network.links.push_back({i - 1, i, {.stiffness = 10}});
  }
  network.masses[0].start.v = 8;
  const auto kept = states_of(network, "rk4", 30, 0.02);
  for (const double v : kept.back().v) EXPECT_EQ(v, 0);
  double spring = 0, farthest = 0;
  for (std::size_t i = 1; i < blocks; ++i)
    spring = std::max(spring, 10 * std::abs(kept.back().x[i] - kept.back().x[i - 1]));
  for (std::size_t i = 0; i < blocks; ++i)
    if (kept.back().x[i] != 0) farthest = static_cast<double>(i);
  EXPECT_GT(farthest, 5);
  EXPECT_LT(farthest, 100);
  EXPECT_GT(spring, 0.1);
}

/// A state of a network at rest but for one velocity.
State<MassVector> moving(const Network& network, double v, std::size_t mass = 0) {
  State<MassVector> state = start_of(network);
  state.v.first[mass] = v;
  return state;
}

TEST(ContactPhase, AContactThatIsNotSeenToMoveSticksForAStep) {
  const Network network = one_mass({.mass = 1, .stiffness = 0, .friction = 1}, {0, 1});
  ContactPhases phases(network);
  ASSERT_EQ(phases.directions(), std::vector{1});
  std::vector<double> asked;
  const State<MassVector> begin = moving(network, 0);
  const auto cut = look_inside(
      {phases}, 0, 0.1, begin, moving(network, -1), 2, [&](double) { return moving(network, -1); },
      [&](double theta) {
        asked.push_back(theta);
        return moving(network, 0);
      });
  EXPECT_EQ(cut.theta, 0);
  EXPECT_EQ(cut.y.v.first[0], 0);
  EXPECT_TRUE(cut.at_rest);
  ASSERT_EQ(asked.size(), 15u);  // of the first half, down to a thousand-millionth of it
  for (std::size_t n = 0; n < asked.size(); ++n) EXPECT_EQ(asked[n], 0.25 * std::pow(0.25, n));
  EXPECT_FALSE(phases.any_held());
  State<MassVector> y = cut.y;
  phases.begin(0, y);
  EXPECT_TRUE(phases.any_held());
  EXPECT_EQ(phases.directions(), std::vector{0});
  phases.begin(0.1, y);
  EXPECT_FALSE(phases.any_held());
}

TEST(ContactPhase, AContactStopsWhereItsSpeedPassesZero) {
  const Network network = one_mass({.mass = 1, .stiffness = 0, .friction = 1}, {0, 1});
  const auto at = [&](double theta) { return moving(network, 0.3 - theta); };
  for (const double first : {0.0, 0.3}) {  // seen to move at an eighth of the step, or from its beginning
    ContactPhases phases(network);
    const auto cut = look_inside({phases}, 0, 0.1, moving(network, first), at(1), 1, at, at);
    EXPECT_NEAR(cut.theta, 0.3, 1e-15);
    EXPECT_NEAR(cut.y.v.first[0], 0, 1e-15);
    EXPECT_TRUE(cut.at_rest);
    EXPECT_EQ(phases.directions(), std::vector{0});
  }
  ContactPhases phases(network);
  const auto whole = look_inside({phases}, 0, 0.1, at(0), at(0.2), 1, at, at);
  EXPECT_EQ(whole.theta, 1);
  EXPECT_FALSE(whole.at_rest);
  EXPECT_EQ(phases.directions(), std::vector{1});
}

TEST(ContactPhase, AContactThatSticksBreaksLooseInsideAStep) {
  // The first one slides all the time, the second one holds up to 1 N.
  Network network;
  network.masses.push_back({"slides", 1, {0, 1}});
  network.masses.push_back({"sticks", 1});
  network.links.push_back({ground, 0, {.stiffness = 0, .friction = 1}});
  network.links.push_back({ground, 1, {.stiffness = 1, .friction = 1}});
  const auto stretched = [&](double x, double v = 1) {
    State<MassVector> state = moving(network, v);
    state.x.first[1] = x;
    return state;
  };
  ContactPhases phases(network);
  State<MassVector> begin = stretched(0);
  phases.begin(0, begin);
  ASSERT_EQ(phases.directions(), (std::vector{1, 0}));
  const auto cut = [&](const State<MassVector>& end, double slope) {
    const auto at = [=, &stretched](double theta) { return stretched(slope * theta); };
    return look_inside({phases}, 0, 0.1, begin, end, 1, at, at);
  };
  EXPECT_NEAR(cut(stretched(4), 4).theta, 0.25, 1e-14);
  EXPECT_NEAR(cut(stretched(4), 4).y.x.first[1], 1, 1e-14);
  EXPECT_TRUE(cut(stretched(4), 4).at_rest);
  // The end of the step is loose where a step of just its length is not.
  EXPECT_EQ(cut(stretched(4), 0).theta, 1);
  EXPECT_EQ(cut(stretched(4), 0).y.x.first[1], 4);
  EXPECT_TRUE(cut(stretched(4), 0).at_rest);
  EXPECT_EQ(phases.directions(), (std::vector{1, 0}));
  EXPECT_FALSE(cut(stretched(0.5), 0.5).at_rest);
  // Then the one that slides stops first.
  const auto slowing = [&](double theta) { return stretched(theta < 0.5 ? 0 : 4, 0.5 - theta); };
  const auto stopped = look_inside({phases}, 0, 0.1, begin, slowing(1), 1, slowing, slowing);
  EXPECT_EQ(stopped.theta, 0.5);
  EXPECT_EQ(phases.directions(), (std::vector{0, 0}));
}

TEST(ContactPhase, MomentsAtOneTimeComeToAnEnd) {
  // Pulled by more than it holds: it begins to slide, over and over.
  const Network network = one_mass({.mass = 1, .stiffness = 2, .friction = 1}, {1, 0});
  ContactPhases phases(network);
  State<MassVector> y = start_of(network);
  for (int n = 0; n < 5; ++n) {
    phases.begin(3, y);
    EXPECT_FALSE(phases.any_held()) << n;
    EXPECT_EQ(phases.directions(), std::vector{-1}) << n;
  }
  for (int n = 0; n < 2; ++n) {
    phases.begin(3, y);
    EXPECT_TRUE(phases.any_held()) << n;
    EXPECT_EQ(phases.directions(), std::vector{0}) << n;
  }
  phases.begin(3.5, y);
  EXPECT_FALSE(phases.any_held());
  EXPECT_EQ(phases.directions(), std::vector{-1});
  // One that moves is not held.
  y.v.first[0] = -1;
  for (int n = 0; n < 9; ++n) phases.begin(3.5, y);
  EXPECT_FALSE(phases.any_held());
  EXPECT_EQ(phases.directions(), std::vector{-1});
}

TEST(ContactPhase, RestsUntilItIsInterrupted) {
  // A phase of so many turns is not known to a turn.
  for (const double phase : {0.0, 1e17}) {
    const Network network = one_mass({.mass = 1, .stiffness = 0, .friction = 1}, {},
                                     {.amplitude = 0.5, .frequency = 9, .phase = phase});
    for (const bool asked : {false, true}) {
      std::atomic<bool> interrupt{asked};
      int rows = 0;
      const auto keep = [&](double, const State<MassVector>&) { ++rows; };
      const Outcome outcome = solve_with_contacts(network, Rk4{}, {0, 10}, start_of(network),
                                                  StepControl(0.1, 1), keep, {.interrupt = &interrupt});
      EXPECT_EQ(outcome.interrupted, asked);
      EXPECT_EQ(outcome.status, asked ? Status::stopped_by_event : Status::reached_end);
      EXPECT_EQ(outcome.t, asked ? 0 : 10);
      EXPECT_EQ(rows, asked ? 1 : 101);
    }
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
