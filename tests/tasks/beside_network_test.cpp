// The modes of a recording beside those of a network.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_run/network_run.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Three carts in a row, each with a spring and a damper before it, the first tied to the wall.
Network carts(double first_spring = 60) {
  Network network;
  const double springs[] = {first_spring, 45, 20}, dampers[] = {0.05, 0.03, 0.02};
  for (std::size_t i = 0; i < 3; ++i) {
    network.masses.push_back({.name = "cart " + std::to_string(i + 1), .mass = 0.5});
    network.links.push_back({i == 0 ? ground : i - 1, i, {.stiffness = springs[i], .damping = dampers[i]}});
  }
  network.masses[0].start.x = 0.02;
  network.masses[2].start.x = -0.03;
  return network;
}

/// How the three carts swing after they were let go: what a logger writes, its channels in an order and with
/// signs of their own.
Recording recorded(const std::vector<std::size_t>& order = {0, 1, 2},
                   const std::vector<double>& signs = {1, 1, 1}) {
  const auto run = run_network(carts(), "", {.method = {"exact"}, .step = 0.02, .until = 40});
  EXPECT_TRUE(run);
  std::string bytes = "t (s)";
  for (const std::size_t i : order) bytes += fmt::format(",x{} (m)", i + 1);
  for (std::size_t n = 0; n < run->states.t.size(); ++n) {
    bytes += fmt::format("\n{:.17g}", run->states.t[n]);
    for (std::size_t c = 0; c < order.size(); ++c)
      bytes += fmt::format(",{:.17g}", signs[c] * run->states.x[order[c]][n]);
  }
  auto recording = read_recording(bytes, "carts.csv", {});
  EXPECT_TRUE(recording);
  return *std::move(recording);
}

ModesResult beside(const Recording& recording, const Network& network, ModesOptions options = {}) {
  options.network = network;
  auto result = recording_modes(recording, options);
  EXPECT_TRUE(result) << (result ? "" : result.error().message());
  return result ? *std::move(result) : ModesResult{};
}

std::vector<std::string> codes(const ModesResult& result) {
  std::vector<std::string> all;
  for (const Notice& notice : result.notices) all.push_back(notice.code);
  return all;
}

TEST(BesideNetwork, EachModeIsTheOneOfItsShape) {
  const ModesResult result = beside(recorded(), carts());
  const auto known = network_modes(carts(), "");
  ASSERT_EQ(result.modes.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& of = result.modes[j].of_network;
    ASSERT_TRUE(of);
    EXPECT_EQ(of->mode, j + 1);
    EXPECT_EQ(of->frequency, known->modes[j].frequency.value);
    EXPECT_EQ(of->damping_ratio, known->modes[j].damping_ratio.value);
    EXPECT_NEAR(of->mac, 1, 1e-9);
    EXPECT_NEAR(result.modes[j].frequency.value / of->frequency, 1, 1e-7);
  }
  EXPECT_THAT(codes(result), testing::IsEmpty());
}

TEST(BesideNetwork, AStifferSpringIsSeenInTheFrequencies) {
  const ModesResult result = beside(recorded(), carts(75));
  ASSERT_EQ(result.modes.size(), 3u);
  for (const NaturalMode& mode : result.modes) {
    ASSERT_TRUE(mode.of_network);
    EXPECT_GT(mode.of_network->frequency, mode.frequency.value);
    EXPECT_GT(mode.of_network->mac, 0.9);
    EXPECT_LT(mode.of_network->mac, 0.99999);
  }
  EXPECT_THAT(codes(result), testing::IsEmpty());
}

TEST(BesideNetwork, SwappedChannelsAreNamed) {
  const std::vector<std::vector<std::size_t>> orders{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}};
  for (const auto& order : orders) {
    const ModesResult result = beside(recorded(order), carts());
    ASSERT_THAT(codes(result), testing::ElementsAre("channels_look_swapped"));
    const auto name = [&](std::size_t c) { return fmt::format("x{} (m)", order[c] + 1); };
    std::vector<std::string> wrong;
    for (std::size_t c = 0; c < 3; ++c)
      if (order[c] != c) wrong.push_back(name(c));
    EXPECT_THAT(in_words(result.notices[0]),
                testing::StartsWith(fmt::format("\"{}\" and \"{}\" look swapped", wrong[0], wrong[1])));
  }
}

TEST(BesideNetwork, ASensorThatPointsBackIsNamed) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<double> signs{1, 1, 1};
    signs[c] = -1;
    const ModesResult result = beside(recorded({0, 1, 2}, signs), carts());
    ASSERT_THAT(codes(result), testing::ElementsAre("channel_looks_reversed"));
    EXPECT_THAT(in_words(result.notices[0]), testing::StartsWith(fmt::format("\"x{} (m)\" ", c + 1)));
  }
  // All three point the same other way: shapes have no sign.
  EXPECT_THAT(codes(beside(recorded({0, 1, 2}, {-1, -1, -1}), carts())), testing::IsEmpty());
}

/// One oscillation of 1 Hz that dies away, its shape the sum of these of the network's, all as large.
Recording one_mode(const std::vector<std::size_t>& of_network) {
  const auto known = network_modes(carts(), "");
  std::string bytes = "t (s),a (m),b (m),c (m)";
  for (int n = 0; n < 1500; ++n) {
    const double t = 0.02 * n;
    bytes += fmt::format("\n{:.17g}", t);
    for (std::size_t i = 0; i < 3; ++i) {
      double shape = 0;
      for (const std::size_t k : of_network) {
        double square = 0;
        for (const auto& each : known->modes[k].shape) square += std::norm(each);
        shape += known->modes[k].shape[i].real() / std::sqrt(square);
      }
      bytes += fmt::format(",{:.17g}", shape * std::exp(-0.05 * t) * std::cos(2 * std::numbers::pi * t));
    }
  }
  return *read_recording(bytes, "carts.csv", {});
}

TEST(BesideNetwork, WhatIsMissingIsNamed) {
  const Recording first_alone = one_mode({0});
  const ModesResult result = beside(first_alone, carts());
  ASSERT_EQ(result.modes.size(), 1u);
  EXPECT_EQ(result.modes[0].of_network->mode, 1u);
  EXPECT_THAT(codes(result), testing::ElementsAre("fewer_modes_than_channels", "network_mode_not_found",
                                                  "network_mode_not_found"));
  // Who asks for some only misses none.
  EXPECT_THAT(codes(beside(first_alone, carts(), {.modes = 1})), testing::IsEmpty());
}

TEST(BesideNetwork, WhatIsLikeNoneIsNamed) {
  const ModesResult result = beside(one_mode({0, 1, 2}), carts());
  ASSERT_EQ(result.modes.size(), 1u);
  EXPECT_FALSE(result.modes[0].of_network);
  EXPECT_THAT(codes(result), testing::Contains("mode_unlike_network"));
}

TEST(BesideNetwork, EachMassNeedsItsChannel) {
  const auto refused = recording_modes(recorded({0, 2}), {.network = carts()});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().notice.code, "columns_for_masses");
}

TEST(BesideNetwork, AnotherNetworkHasNoneBesideIt) {
  const auto refused = network_modes(carts(), "carts.toml", {.network = carts()});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "carts.toml: network is for recordings, and this is a network");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
