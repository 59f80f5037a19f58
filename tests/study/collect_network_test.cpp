// The named results of networks: their runs, and their modes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

Network two_masses() {
  Network network;
  network.masses = {{"left", 2, {1, 0}}, {"floor 1", 2}};
  network.links = {{ground, 0, {.stiffness = 8}}, {ground, 1, {.stiffness = 8}}, {0, 1, {.stiffness = 1}}};
  return network;
}

TEST(CollectNetwork, NamesMassesAndLinks) {
  const auto runs =
      run_network_by_each(two_masses(), "n.toml", {.method = {"rk4", "exact"}, .step = 0.01, .until = 2});
  ASSERT_TRUE(runs);
  Results results;
  collect("beats", *runs, results);
  EXPECT_EQ(fact(results, "beats.2.label"), "exact");
  EXPECT_EQ(fact(results, "beats.1.left.peak"), "1 m");
  EXPECT_EQ(fact(results, "beats.1.left.peak_t"), "0 s");
  EXPECT_EQ(column(results, "beats.1.left.energy").values.front(), 4);
  EXPECT_EQ(value(results, "beats.1.floor_1.x_end"), runs->front().last[1].x);
  EXPECT_EQ(value(results, "beats.1.links.3.energy_peak"), 0.5);
  const ResultColumn x = column(results, "beats.1.left.x");
  EXPECT_EQ(x.values.size(), 201u);
  EXPECT_EQ(x.unit, "m");
  EXPECT_EQ(column(results, "beats.1.links.1.energy").values.front(), 4);
  EXPECT_EQ(column(results, "beats.1.energy").values.front(), 4.5);
}

TEST(CollectNetwork, NamesModesAndTheirBeat) {
  const auto found = network_modes(two_masses(), "n.toml", {.method = {"newmark"}, .step = 0.1});
  ASSERT_TRUE(found);
  Results results;
  collect("modes", *found, results);
  const double slow = 2 / (2 * std::numbers::pi), fast = std::sqrt(5.0) / (2 * std::numbers::pi);
  EXPECT_NEAR(value(results, "modes.1.frequency"), slow, 1e-12);
  EXPECT_NEAR(value(results, "modes.beat_period"), 1 / (fast - slow), 1e-9);
  EXPECT_NEAR(value(results, "modes.coupling"), 1.0 / 9, 1e-12);
  EXPECT_NEAR(value(results, "modes.1.left") * value(results, "modes.1.floor_1"), 1, 1e-12);
  EXPECT_NEAR(value(results, "modes.2.left") * value(results, "modes.2.floor_1"), -1, 1e-12);
  EXPECT_EQ(fact(results, "modes.1.methods.1.label"), "newmark");
  EXPECT_LT(value(results, "modes.1.methods.1.frequency_error"), 0);
  EXPECT_EQ(column(results, "modes.frequency").values.size(), 2u);
}

TEST(CollectNetwork, EveryNumberOfTheModesOfTwoMassesIsByHand) {
  const double h = 0.1, pi = std::numbers::pi;
  const auto found =
      network_modes(two_masses(), "n.toml", {.method = {"implicit-midpoint", "exact"}, .step = h});
  ASSERT_TRUE(found);
  Results results;
  collect("m", *found, results);
  EXPECT_EQ(fact(results, "m.modes"), "2");
  const double w[] = {2, std::sqrt(5.0)};
  EXPECT_NEAR(value(results, "m.beat_frequency"), (w[1] - w[0]) / (2 * pi), 1e-13);
  for (int j = 0; j < 2; ++j) {
    const std::string mode = "m." + std::to_string(j + 1);
    EXPECT_NEAR(value(results, mode + ".period"), 2 * pi / w[j], 1e-12);
    EXPECT_NEAR(value(results, mode + ".damping_ratio"), 0, 1e-15);
    EXPECT_NEAR(value(results, mode + ".participation"), j == 0 ? 1 : 0, 1e-14);
    EXPECT_NEAR(value(results, mode + ".left"), 1, 1e-14);
    EXPECT_NEAR(value(results, mode + ".left.phase"), 0, 1e-14);
    EXPECT_NEAR(value(results, mode + ".floor_1"), j == 0 ? 1 : -1, 1e-14);
    EXPECT_NEAR(std::abs(value(results, mode + ".floor_1.phase")), j == 0 ? 0 : pi, 1e-14);
    // The midpoint's: tan(w' h/2) = w h/2.
    const double by_midpoint = 2 / h * std::atan(w[j] * h / 2);
    EXPECT_NEAR(value(results, mode + ".methods.1.frequency"), by_midpoint / (2 * pi), 1e-12);
    EXPECT_NEAR(value(results, mode + ".methods.1.frequency_error"), by_midpoint / w[j] - 1, 1e-11);
    EXPECT_NEAR(value(results, mode + ".methods.1.damping_ratio"), 0, 1e-12);
    EXPECT_NEAR(value(results, mode + ".methods.2.frequency_error"), 0, 1e-11);
    EXPECT_EQ(fact(results, mode + ".methods.2.label"), "exact");
    EXPECT_EQ(fact(results, mode + ".methods.3.label"), "none");
    EXPECT_EQ(column(results, "m.mode").values[static_cast<std::size_t>(j)], j + 1);
  }
}

TEST(CollectNetwork, NamesWhatIsFound) {
  const auto run = run_network(two_masses(), "n.toml", {.method = {"exact"}, .step = 0.05, .until = 30});
  std::string bytes = "t (s),left (m),floor 1 (m)";
  for (std::size_t n = 0; n < run->states.t.size(); ++n)
    bytes += fmt::format("\n{:.17g},{:.17g},{:.17g}", run->states.t[n], run->states.x[0][n],
                         run->states.x[1][n] + 0.25);
  const auto recording = read_recording(bytes, "masses.csv", {});
  ASSERT_TRUE(recording);
  const auto open = read_network_file(
      "[[mass]]\nname = \"left\"\nmass = 2\n[[mass]]\nname = \"floor 1\"\nmass = 2\n"
      "[[link]]\nto = \"left\"\nstiffness = 8\n[[link]]\nto = \"floor 1\"\nstiffness = 8\n"
      "[[link]]\nfrom = \"left\"\nto = \"floor 1\"\nstiffness = \"?\"\n",
      "n.toml");
  ASSERT_TRUE(open);
  const auto fitted = fit_network(*recording, *open, "n.toml", {});
  ASSERT_TRUE(fitted);
  Results results;
  collect("joint", *fitted, results);
  EXPECT_NEAR(value(results, "joint.links.3.stiffness"), 1, 1e-9);
  EXPECT_LE(value(results, "joint.links.3.stiffness.low"), value(results, "joint.links.3.stiffness.high"));
  EXPECT_EQ(fact(results, "joint.links.3.to"), "floor 1");
  EXPECT_NEAR(value(results, "joint.left.position"), 1, 1e-9);
  EXPECT_NEAR(value(results, "joint.floor_1.equilibrium"), 0.25, 1e-9);
  const ResultColumn measured = column(results, "joint.left.measured");
  EXPECT_EQ(measured.unit, "m");
  ASSERT_EQ(measured.values.size(), 601u);
  EXPECT_EQ(column(results, "joint.t").values.size(), 601u);
  for (const std::size_t n : {std::size_t{0}, std::size_t{333}})
    EXPECT_EQ(column(results, "joint.left.fitted").values[n],
              measured.values[n] - column(results, "joint.left.residual").values[n]);
}

// A name's letters stay, whatever they are; a link may end at the ground.
TEST(CollectNetwork, AnglesHaveTheirUnits) {
  Network network = two_masses();
  network.angles = true;
  network.masses[1].name = "β-arm 1/2";
  network.links[0] = {0, ground, {.stiffness = 8}};
  const auto runs = run_network_by_each(network, "n.toml", {.method = {"exact"}, .step = 0.01, .until = 12});
  ASSERT_TRUE(runs);
  Results results;
  collect("beats", *runs, results);
  EXPECT_EQ(fact(results, "beats.1.left.peak"), "1 rad");
  EXPECT_EQ(column(results, "beats.1.left.x").unit, "rad");
  EXPECT_EQ(column(results, "beats.1.left.x").name, "angle *x*");
  EXPECT_EQ(column(results, "beats.1.left.v").unit, "rad/s");
  EXPECT_EQ(column(results, "beats.1.left.v").name, "angular velocity *v*");
  EXPECT_EQ(column(results, "beats.1.left.energy").values.front(), 4);
  EXPECT_EQ(column(results, "beats.1.β-arm_1_2.energy").values.front(), 0);
  EXPECT_EQ(value(results, "beats.1.β-arm_1_2.x_end"), runs->front().last[1].x);

  std::string bytes = "t (s),left (rad),right (rad)";
  const NetworkStates& states = runs->front().states;
  for (std::size_t n = 0; n < states.t.size(); n += 5)
    bytes += fmt::format("\n{:.17g},{:.17g},{:.17g}", states.t[n], states.x[0][n], states.x[1][n]);
  const auto recording = read_recording(bytes, "arms.csv", {});
  ASSERT_TRUE(recording);
  const auto open = read_network_file(
      "[[mass]]\nname = \"left\"\ninertia = \"2 kg m²\"\n[[mass]]\nname = \"right\"\ninertia = \"2 kg m²\"\n"
      "[[link]]\nto = \"left\"\nstiffness = \"8 N m\"\n[[link]]\nto = \"right\"\nstiffness = \"8 N m\"\n"
      "[[link]]\nfrom = \"left\"\nto = \"right\"\nstiffness = \"?\"\n",
      "n.toml");
  ASSERT_TRUE(open);
  const auto fitted = fit_network(*recording, *open, "n.toml", {});
  ASSERT_TRUE(fitted);
  Results found;
  collect("joint", *fitted, found);
  EXPECT_EQ(column(found, "joint.left.measured").unit, "rad");
  EXPECT_EQ(column(found, "joint.left.measured").name, "angle *x*");
  EXPECT_EQ(column(found, "joint.left.measured").values.size(), 241u);
  ASSERT_TRUE(fitted->succeeded());
  EXPECT_EQ(column(found, "joint.left.fitted").unit, "rad");
  EXPECT_EQ(column(found, "joint.left.fitted").name, "angle *x*");
  EXPECT_TRUE(fact(found, "joint.left.velocity").ends_with(" rad/s"));
  EXPECT_TRUE(fact(found, "joint.left.position").ends_with(" rad"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
