// Runs of networks: what the task makes of its options, and where the energy goes.
#include "cromer/tasks/network_run/network_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "cromer/documents/words/words.h"
#include "cromer/methods/all.h"

namespace cromer::core {
namespace CROMER_FILE {

Network chain(std::size_t masses, double damping = 0) {
  Network network;
  for (std::size_t i = 0; i < masses; ++i)
    network.masses.push_back({.name = "m" + std::to_string(i + 1), .mass = 0.5});
  for (std::size_t i = 0; i <= masses; ++i)
    network.links.push_back(
        {i == 0 ? ground : i - 1, i == masses ? ground : i, {.stiffness = 8, .damping = damping}});
  network.masses[0].start.x = 1;
  return network;
}

NetworkRun run_of(const Network& network, const SimulateOptions& options) {
  auto run = run_network(network, "n.toml", options);
  if (!run) ADD_FAILURE() << in_words(run.error().notice);
  return run ? *run : NetworkRun{};
}

TEST(NetworkRun, HasDefaultsByItsPeriods) {
  const NetworkRun run = run_of(chain(3), {});
  const double fast = 8 * std::sin(3 * std::numbers::pi / 8), slow = 8 * std::sin(std::numbers::pi / 8);
  EXPECT_EQ(run.method, "euler-cromer");
  EXPECT_NEAR(run.step, 2 * std::numbers::pi / fast / 200, 1e-12);
  EXPECT_NEAR(run.until, 20 * 2 * std::numbers::pi / slow, 1e-9);
  EXPECT_EQ(run.outcome.status, Status::reached_end);
  EXPECT_EQ(run.states.t.size(), static_cast<std::size_t>(run.outcome.counts.accepted) + 1);
  EXPECT_EQ(run.last[1].x, run.states.x[1].back());
}

TEST(NetworkRun, HasDefaultsByItsDrivesToo) {
  const auto defaults = [](const Network& network, const SimulateOptions& options = {}) {
    const NetworkRun run = run_of(network, options);
    return std::array{run.step, run.until};
  };
  const double natural = 2 * std::numbers::pi / std::sqrt(32.0);  // of one mass between two springs
  Network driven = chain(1);
  driven.masses[0].start.x = 0;
  driven.masses[0].drive = {1, 2, 0};
  EXPECT_NEAR(defaults(driven)[0], natural / 200, 1e-15);
  EXPECT_NEAR(defaults(driven)[1], 20 * natural, 1e-12);
  driven.masses[0].drive.frequency = 10;
  EXPECT_NEAR(defaults(driven)[0], std::numbers::pi / 5 / 200, 1e-15);
  EXPECT_NEAR(defaults(driven)[1], 20 * natural, 1e-12);
  // A constant force has no period.
  driven.masses[0].drive.frequency = 0;
  EXPECT_NEAR(defaults(driven)[0], natural / 200, 1e-15);
  // Where nothing swings by itself, the first drive says how long, and the fastest how fine.
  Network free;
  for (const double frequency : {4.0, 8.0}) free.masses.push_back({"m", 1, {}, {1, frequency, 0}});
  free.links.push_back({0, 1, {.stiffness = 0, .damping = 0.1}});
  EXPECT_NEAR(defaults(free)[0], std::numbers::pi / 4 / 200, 1e-15);
  EXPECT_NEAR(defaults(free)[1], 20 * std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(defaults(free, {.step = 0.01})[0], 0.01);
  EXPECT_NEAR(defaults(free, {.step = 0.01})[1], 20 * std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(defaults(free, {.until = 3.0})[0], std::numbers::pi / 4 / 200, 1e-15);
  EXPECT_EQ(defaults(free, {.until = 3.0})[1], 3);
  free.masses[0].drive.amplitude = free.masses[1].drive.amplitude = 0;
  free.masses[0].start.v = 1;
  const auto none = run_network(free, "n.toml", {.step = 0.01});
  ASSERT_FALSE(none);
  EXPECT_EQ(in_words(none.error().notice), "n.toml: nothing swings: give --step and --until");
  EXPECT_EQ(defaults(free, {.step = 0.01, .until = 2.0})[1], 2);
}

TEST(NetworkRun, TheForceOfALinkWithMemoryIsThatFromEitherEnd) {
  const auto inner = [](bool turned) {
    Network network;
    network.masses.push_back({"m", 0.5, {1, 0}});
    network.links.push_back({turned ? 0 : ground, turned ? ground : 0, {.stiffness = 8}});
    network.links[0].law.hysteresis_stiffness = 2;
    network.links[0].law.hysteresis_beta = 3;
    return run_of(network, {.method = {"rk4"}, .step = 0.01, .until = 1}).states.inner;
  };
  const auto one = inner(false), other = inner(true);
  ASSERT_EQ(one.size(), 1u);
  ASSERT_EQ(other.size(), 1u);
  ASSERT_EQ(one[0].force.size(), 101u);
  EXPECT_LT(one[0].force[20], -0.1);
  for (std::size_t n = 0; n <= 100; ++n) EXPECT_EQ(one[0].force[n], -other[0].force[n]);
}

TEST(NetworkRun, SlowModesThatAreLostAreSaid) {
  Network network;
  for (int i = 0; i < 2; ++i) network.masses.push_back({"m", 1, {1, 0}});
  network.links.push_back({ground, 0, {.stiffness = 1}});
  network.links.push_back({0, 1, {.stiffness = 1e17}});
  const NetworkRun run = run_of(network, {.method = {"newmark"}, .step = 0.1, .until = 0.2});
  ASSERT_EQ(run.notices.size(), 1u);
  EXPECT_EQ(
      in_words(run.notices[0]),
      "1 slow mode is lost in rounding, at the frequency 0: the stiffnesses are too far apart; join what "
      "is stiff to one mass");
}

TEST(NetworkRun, KeepsEveryNthStateAndTheLast) {
  const NetworkRun whole = run_of(chain(2), {.method = {"rk4"}, .step = 0.01, .until = 1.005});
  const NetworkRun every = run_of(chain(2), {.method = {"rk4"}, .step = 0.01, .until = 1.005, .every = 7});
  ASSERT_EQ(every.states.t.size(), 15u);
  EXPECT_EQ(every.states.x[1][3], whole.states.x[1][21]);
  EXPECT_EQ(every.last[0].v, whole.last[0].v);
  EXPECT_EQ(every.outcome.t, 1.005);
}

TEST(NetworkRun, EnergyIsAccountedFor) {
  Network network = chain(3, 0.2);
  network.links[1].law.cubic = 3;
  network.links[2].law.drag = 0.4;
  network.masses[2].drive = {2, 3, 0.5};
  for (const std::string method : {"rk4", "gauss-legendre4", "dormand-prince"}) {
    const NetworkRun run = run_of(network, {.method = {method}, .step = 0.005, .until = 5});
    ASSERT_TRUE(run.energy);
    const NetworkEnergy& energy = *run.energy;
    EXPECT_NEAR(energy.start, run.states.energy.front(), 1e-12);
    EXPECT_NEAR(energy.end, run.states.energy.back(), 1e-12);
    EXPECT_GT(energy.taken, 1);
    EXPECT_GT(std::abs(energy.drive), 0.1);
    EXPECT_LT(std::abs(energy.method()), 1e-6 * energy.start) << method;
    ASSERT_EQ(energy.of_links.size(), 4u);
    double taken = 0;
    for (const LinkEnergy& link : energy.of_links) taken += link.taken;
    EXPECT_NEAR(taken, energy.taken, 1e-12);
  }
  // What a method makes itself shows: forward Euler's gain.
  const NetworkRun gains = run_of(network, {.method = {"forward-euler"}, .step = 0.005, .until = 5});
  EXPECT_GT(gains.energy->method(), 0.01);
}

TEST(NetworkRun, TheExactSolutionMakesNoEnergy) {
  SimulateOptions options{.method = {"exact"}, .step = 0.05, .until = 20};
  const NetworkRun run = run_of(chain(2, 0.2), options);
  ASSERT_TRUE(run.energy);
  EXPECT_NEAR(run.energy->method(), 0, 1e-15 * run.energy->start);
  EXPECT_GT(run.energy->taken, 0);
  options.until = 0.35;  // of eight states nothing is summed up
  EXPECT_FALSE(run_of(chain(2, 0.2), options).energy);
  options.until = 0.4;
  EXPECT_TRUE(run_of(chain(2, 0.2), options).energy);
}

TEST(NetworkRun, EnergyOfFrictionAndHysteresisIsAccountedFor) {
  Network network = chain(3);
  network.links[1].law.friction = 0.2;
  network.links[2].law.hysteresis_stiffness = 2;
  network.links[2].law.hysteresis_beta = 3;
  network.masses[2].drive = {2, 3, 0.5};
  const NetworkRun run = run_of(network, {.method = {"rk4"}, .step = 0.002, .until = 8});
  ASSERT_TRUE(run.ok());
  ASSERT_TRUE(run.energy);
  const NetworkEnergy& energy = *run.energy;
  EXPECT_GT(energy.of_links[1].taken, 0.1);
  EXPECT_GT(energy.of_links[2].taken, 0.1);
  EXPECT_EQ(energy.of_links[0].taken, 0);
  EXPECT_LT(std::abs(energy.method()), 1e-4 * energy.start);
  ASSERT_EQ(run.states.inner.size(), 1u);
  EXPECT_EQ(run.states.inner[0].link, 2u);
  EXPECT_EQ(run.states.inner[0].force.size(), run.states.t.size());
}

TEST(NetworkRun, RunsByEachMethod) {
  const auto runs =
      run_network_by_each(chain(2), "n.toml", {.method = {"rk4", "exact"}, .step = 0.01, .until = 1});
  ASSERT_TRUE(runs);
  ASSERT_EQ(runs->size(), 2u);
  EXPECT_EQ((*runs)[1].method, "exact");
  EXPECT_NEAR((*runs)[0].last[1].x, (*runs)[1].last[1].x, 1e-6);
  // The energy of the links and of the masses is that of the whole.
  const NetworkRun& run = runs->front();
  double sum = 0;
  for (std::size_t l = 0; l < 3; ++l) sum += stored_by(run, l)[40];
  for (std::size_t i = 0; i < 2; ++i) sum += 0.5 * run.states.v[i][40] * run.states.v[i][40] / 2;
  EXPECT_NEAR(sum, run.states.energy[40], 1e-12);
  EXPECT_FALSE(run_network_by_each(chain(2), "n.toml", {.method = {"rk4", "rk5"}}));
}

TEST(NetworkRun, ExactWithDampingThatTiesModesTogether) {
  Network network = chain(4, 0.1);
  network.links[2].law.damping = 1.5;
  network.masses[1].drive = {2, 3, 0.5};
  network.masses[3].drive = {1, 7, 0};
  const NetworkRun exact = run_of(network, {.method = {"exact"}, .step = 0.05, .until = 10});
  const NetworkRun near =
      run_of(network, {.method = {"dormand-prince"}, .step = 0.05, .until = 10, .tolerance = 1e-13});
  ASSERT_EQ(exact.states.t.size(), near.states.t.size());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t n = 0; n < exact.states.t.size(); ++n)
      ASSERT_NEAR(exact.states.x[i][n], near.states.x[i][n], 1e-9) << i << " " << n;
}

TEST(NetworkRun, TakesTenThousandMasses) {
  constexpr std::size_t masses = 10000;
  const auto end = [&](const char* method, double step, double until) {
    const NetworkRun run =
        run_of(chain(masses), {.method = {method}, .step = step, .until = until, .every = 1000});
    EXPECT_TRUE(run.ok());
    return run.last;
  };
  // The wave has not come to the far end: its state there is that of an infinite chain.
  const auto by_rk4 = end("rk4", 0.02, 1), by_newmark = end("newmark", 0.002, 1);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(by_rk4[i].x, by_newmark[i].x, 1e-4);
  EXPECT_GT(std::abs(by_rk4[2].x), 0.1);
  EXPECT_LT(std::abs(by_rk4[100].x), 1e-12);
}

TEST(NetworkRun, EndsEarlyWithAMessage) {
  Network network = chain(2);
  network.links[0].law.cubic = -50;
  const NetworkRun run = run_of(network, {.method = {"rk4"}, .step = 0.01, .until = 100});
  EXPECT_EQ(run.outcome.status, Status::not_finite);
  EXPECT_FALSE(run.ok());
  EXPECT_FALSE(run.message.empty());
  for (const double x : run.states.x[0]) EXPECT_TRUE(std::isfinite(x));
  const NetworkRun unstable = run_of(chain(2), {.method = {"euler-cromer"}, .step = 0.4, .until = 4});
  ASSERT_EQ(unstable.notices.size(), 1u);
  EXPECT_EQ(in_words(unstable.notices[0]), "euler-cromer with a step of 0.4 s is unstable on this network");
}

TEST(NetworkRun, EndsWhereItsEnergyOverflows) {
  Network network = chain(2);
  network.links[0].law.cubic = 50;
  const NetworkRun run = run_of(network, {.method = {"forward-euler"}, .step = 0.3, .until = 100});
  EXPECT_EQ(run.outcome.status, Status::not_finite);
  for (const double energy : run.states.energy) EXPECT_TRUE(std::isfinite(energy));
  ASSERT_FALSE(run.states.t.empty());
  EXPECT_EQ(run.outcome.t, run.states.t.back());
  ASSERT_EQ(run.states.x[1].size(), run.states.t.size());
  EXPECT_EQ(run.last[1].x, run.states.x[1].back());
}

TEST(NetworkRun, RefusesWhatItCannotDo) {
  const auto refusal = [](const Network& network, const SimulateOptions& options) {
    const auto run = run_network(network, "n.toml", options);
    return run ? "" : in_words(run.error().notice);
  };
  Network network = chain(2);
  network.links[1].law.friction = 0.1;
  EXPECT_EQ(refusal(network, {.method = {"exact"}}),
            "n.toml: exact takes linear networks, and a link has the term friction; take another --method");
  network = chain(2);
  network.links[1].law.cubic = 2;
  EXPECT_EQ(refusal(network, {.method = {"exact"}}),
            "n.toml: exact takes linear networks, and a link has the term cubic; take another --method");
  network = chain(2);
  EXPECT_EQ(refusal(network, {.method = {"rk4", "exact"}}),
            "--method is given 2 times; here a network runs with one method");
  EXPECT_NE(refusal(network, {.step = -1.0}).find("positive"), std::string::npos);
  EXPECT_NE(refusal(network, {.method = {"rk5"}}).find("rk4"), std::string::npos);
  EXPECT_NE(refusal(network, {.step = 1e-9, .until = 1e6, .memory = 1e6}).find("memory"), std::string::npos);
  EXPECT_EQ(refusal(network, {.step = 1e-16, .until = 1}),
            "--step: 1e-16 s up to 1 s are 1e+16 steps, too many to be told apart; take a longer step");
  network.masses[0].start.x = 0;
  EXPECT_EQ(refusal(network, {}), "n.toml: nothing moves: give a mass a position, a velocity or a drive");
  EXPECT_EQ(refusal(chain(501), {}),
            "the periods of 501 masses are not sought (of at most 500 they are): give --step and --until");
  EXPECT_EQ(refusal(chain(501), {.method = {"exact"}, .step = 0.1, .until = 1}),
            "--method: exact takes networks of at most 500 masses, and there are 501");
}

TEST(NetworkRun, TakesTheMemoryOfItsStates) {
  // Eleven states of two masses: time, energy, and two numbers of each mass, 8 bytes each.
  SimulateOptions options{.method = {"rk4"}, .step = 0.125, .until = 1.25, .memory = 11 * 8 * 6};
  EXPECT_TRUE(run_network(chain(2), "n.toml", options));
  options.memory -= 1;
  EXPECT_FALSE(run_network(chain(2), "n.toml", options));
  options.every = 5;
  options.memory = 3 * 8 * 6;
  EXPECT_EQ(run_of(chain(2), options).states.t, (std::vector{0.0, 0.625, 1.25}));
  options.memory -= 1;
  EXPECT_FALSE(run_network(chain(2), "n.toml", options));
  options.method = {"rk4", "verlet"};
  options.memory = 2 * 3 * 8 * 6;
  const auto both = run_network_by_each(chain(2), "n.toml", options);
  ASSERT_TRUE(both);
  ASSERT_EQ(both->size(), 2u);
  EXPECT_EQ(both->front().method + " " + both->back().method, "rk4 verlet");
  options.memory -= 1;
  EXPECT_FALSE(run_network_by_each(chain(2), "n.toml", options));
}

TEST(NetworkRun, EnergyIsToldOfNineStatesAndTwelveAPeriod) {
  const auto tells = [](std::size_t masses, double step, double until, long long every = 1) {
    return run_of(chain(masses), {.method = {"rk4"}, .step = step, .until = until, .every = every})
        .energy.has_value();
  };
  EXPECT_FALSE(tells(1, 0.015625, 7 * 0.015625));
  EXPECT_TRUE(tells(1, 0.015625, 8 * 0.015625));
  EXPECT_FALSE(tells(1, 0.015625, 14 * 0.015625, 2));
  EXPECT_TRUE(tells(1, 0.015625, 16 * 0.015625, 2));
  // Half a radian of the fastest that Gershgorin's circles allow: sums of stiffnesses over the mass of 32, 48
  // and 64 1/s^2, links between masses twice.
  EXPECT_TRUE(tells(1, 0.4999 / std::sqrt(32.0), 4));
  EXPECT_FALSE(tells(1, 0.5001 / std::sqrt(32.0), 4));
  EXPECT_TRUE(tells(2, 0.4999 / std::sqrt(48.0), 4));
  EXPECT_FALSE(tells(2, 0.5001 / std::sqrt(48.0), 4));
  EXPECT_TRUE(tells(3, 0.4999 / 8, 4));
  EXPECT_FALSE(tells(3, 0.5001 / 8, 4));
  EXPECT_TRUE(tells(3, 0.2499 / 8, 4, 2));
  EXPECT_FALSE(tells(3, 0.2501 / 8, 4, 2));
}

TEST(NetworkRun, StabilityIsToldOfSixtyMasses) {
  const SimulateOptions unstable{.method = {"verlet"}, .step = 0.4, .until = 0.8};
  ASSERT_EQ(run_of(chain(60), unstable).notices.size(), 1u);
  EXPECT_EQ(run_of(chain(60), unstable).notices[0].code, "method_unstable_on_network");
  EXPECT_TRUE(run_of(chain(61), unstable).notices.empty());
}

TEST(NetworkRuns, SayWhichOptionTheirMethodHasNoUseFor) {
  SimulateOptions options;
  options.method = {"newmark"};
  options.step = 0.01;
  options.until = 1;
  options.rho_inf = 0.5;
  const auto run = run_network(chain(2), "n.toml", options);
  ASSERT_TRUE(run.ok()) << in_words(run.error());
  EXPECT_THAT(in_words(run->notices), testing::ElementsAre("--rho-inf has no effect on newmark"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
