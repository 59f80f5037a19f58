#include "cromer/model/link_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cromer::core {
namespace CROMER_FILE {

/// A chain, further links of `reach` masses, and some to the ground with long stretches between them.
Network chain_of(std::size_t masses, std::ptrdiff_t reach, bool damped, unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() - random.min()) /
                      static_cast<double>(random.max() - random.min());
  };
  Network network;
  for (std::size_t i = 0; i < masses; ++i) network.masses.push_back({"m", between(0.5, 2)});
  const auto link = [&](std::size_t from, std::size_t to) {
    network.links.push_back({from, to, {.stiffness = between(1, 9), .damping = damped ? between(0, 1) : 0}});
  };
  link(ground, 0);
  for (std::size_t i = 1; i < masses; ++i) {
    link(i - 1, i);
    if (i % 150 < 3) link(i, ground);
    if (i % 100 < 20 && i + static_cast<std::size_t>(reach) < masses)
      link(i, i + static_cast<std::size_t>(reach));
  }
  link(masses - 1, ground);
  return network;
}

/// What each link says, one after another.
std::vector<double> accelerations(const Network& network, const std::vector<double>& x,
                                  const std::vector<double>& v) {
  std::vector<double> a(x.size(), 0.0);
  const auto of = [](const std::vector<double>& all, std::size_t i) { return i == ground ? 0.0 : all[i]; };
  for (const NetworkLink& link : network.links) {
    const double force = link.law.stiffness * (of(x, link.to) - of(x, link.from)) +
                         link.law.damping * (of(v, link.to) - of(v, link.from));
    if (link.to != ground) a[link.to] -= force / network.masses[link.to].mass;
    if (link.from != ground) a[link.from] += force / network.masses[link.from].mass;
  }
  return a;
}

TEST(LinkBands, PullAsTheLinksDo) {
  for (const bool damped : {false, true})
    for (const std::size_t masses : {2u, 3u, 5u, 64u, 65u, 66u, 67u, 200u, 500u})
      for (const std::ptrdiff_t reach : {1, 2, 70}) {
        const Network network = chain_of(masses, reach, damped, static_cast<unsigned>(masses));
        const LinkEnds links(network);
        ASSERT_TRUE(links.has_bands());
        std::vector<double> x(masses), v(masses), a(masses, 0.0);
        for (std::size_t i = 0; i < masses; ++i) {
          x[i] = std::sin(1.7 * static_cast<double>(i * i));
          v[i] = std::cos(0.3 * static_cast<double>(i * i));
        }
        links.pull_by_bands(a.data(), x.data(), v.data());
        const std::vector<double> expected = accelerations(network, x, v);
        for (std::size_t i = 0; i < masses; ++i)
          ASSERT_NEAR(a[i], expected[i], 1e-13) << "mass " << i << " of " << masses << ", " << reach;
      }
}

TEST(LinkBands, ASpringOfNoStiffnessPullsNothing) {
  Network network;
  for (int i = 0; i < 3; ++i) network.masses.push_back({"m", 1});
  network.links = {{ground, 0, {.stiffness = 0}}, {0, 1, {.stiffness = 0}}, {1, 2, {.stiffness = 4}}};
  const LinkEnds links(network);
  ASSERT_TRUE(links.has_bands());
  const std::vector<double> x{1, 2, 4}, v(3, 0.0);
  std::vector<double> a(3, 0.0);
  links.pull_by_bands(a.data(), x.data(), v.data());
  EXPECT_EQ(a, (std::vector<double>{0, 8, -8}));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
