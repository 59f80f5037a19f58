// Networks of masses through every method.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cromer/methods/vector_newton.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/linear_network.h"
#include "cromer/model/network_system.h"
#include "cromer/run/solve.h"
#include "tests/support/every_method.h"

namespace cromer::core {
namespace CROMER_FILE {

using EveryMethodOnNetworks = EveryMethod;

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethodOnNetworks, testing::ValuesIn(method_names), name_of_test);

constexpr double mass = 0.5, stiffness = 8;

/// Equal masses between two walls, joined by equal springs and dampers.
Network chain(std::size_t masses, double damping = 0) {
  Network network;
  for (std::size_t i = 0; i < masses; ++i)
    network.masses.push_back({.name = "m" + std::to_string(i + 1), .mass = mass});
  const Oscillator<double> law{.stiffness = stiffness, .damping = damping};
  for (std::size_t i = 0; i <= masses; ++i)
    network.links.push_back({i == 0 ? ground : i - 1, i == masses ? ground : i, law});
  return network;
}

/// w_j = 2 sqrt(k/m) sin(j pi/(2 (n + 1))), j from 1.
double chain_frequency(std::size_t masses, std::size_t j) {
  return 2 * std::sqrt(stiffness / mass) *
         std::sin(static_cast<double>(j) * std::numbers::pi / (2 * static_cast<double>(masses + 1)));
}

/// The motion of the chain from rest with each mode's coordinate at 1/j: a sum of sine waves. Damped, each
/// mode is an oscillator with 2 b = w^2 c/k.
State<MassVector> chain_motion(std::size_t masses, double damping, double t) {
  Vector x = Vector::of_size(masses);
  for (std::size_t i = 0; i < masses; ++i) x[i] = 0;
  Vector v = x;
  for (std::size_t j = 1; j <= masses; ++j) {
    const double w = chain_frequency(masses, j), b = w * w * damping / stiffness / 2;
    const double swing = std::sqrt(w * w - b * b), a = 1 / static_cast<double>(j);
    const double decay = a * std::exp(-b * t);
    const double q = decay * (std::cos(swing * t) + b / swing * std::sin(swing * t));
    const double rate = -decay * (swing + b * b / swing) * std::sin(swing * t);
    for (std::size_t i = 0; i < masses; ++i) {
      const double shape =
          std::sin(static_cast<double>((i + 1) * j) * std::numbers::pi / static_cast<double>(masses + 1));
      x[i] += q * shape;
      v[i] += rate * shape;
    }
  }
  return {{x, 0}, {v, 0}};
}

double distance(const State<MassVector>& a, const State<MassVector>& b) {
  return std::max(value_of(a.x - b.x), value_of(a.v - b.v) / 4);
}

/// Calls f with the network as `exact` has it, or as the other methods do.
template <class M, class F>
auto with_system(const M&, const Network& network, const F& f) {
  if constexpr (M::info.is_exact()) {
    const LinearNetwork linear = linearised(network);
    const UndampedModes modes = undamped_modes(linear);
    const std::vector<double> damping = modal_damping(linear, modes);
    if (damping.empty()) return f(NetworkByExponential(network));
    return f(NetworkByModes(network, modes, damping));
  } else {
    return f(NetworkSystem<>(network));
  }
}

TEST_P(EveryMethodOnNetworks, HasTheDeclaredOrderOnChains) {
  for (const std::size_t masses : {2u, 3u, 10u})
    for (const double damping : {0.0, 0.2}) {
      const Network network = chain(masses, damping);
      const State<MassVector> start = chain_motion(masses, damping, 0);
      const double until = 1;
      const State<MassVector> truth = chain_motion(masses, damping, until);
      const auto error = [&](int steps) {
        return with_method([&](const auto& method) {
          return with_system(method, network, [&](const auto& system) {
            return distance(
                end<std::decay_t<decltype(system)>, MassVector>(system, start, until, until / steps), truth);
          });
        });
      };
      if (info().order == 0) {
        EXPECT_LT(error(7), 1e-13) << masses;
        continue;
      }
      const int steps = info().order >= 4 ? 100 : 2000;
      EXPECT_NEAR(std::log2(error(steps) / error(4 * steps)) / 2, info().order, 0.1) << masses;
    }
}

TEST_P(EveryMethodOnNetworks, OneMassIsTheOscillatorToTheBit) {
  const HarmonicDrive<double> drive{1.5, 2, 0.3};
  std::vector<Oscillator<double>> laws{
      {0.7, 9, 0, 0, 0, 0}, {0.7, 9, 0.4, 0, 0, 0}, {0.7, 9, 0.4, 0.3, 0, 0.8}};
  Oscillator<double>& all = laws.emplace_back(Oscillator<double>{0.7, 9, 0.4, 0.3, 0, 0.8});
  all.quadratic = 0.2, all.quintic = 0.1, all.van_der_pol = 0.3, all.pendulum = 0.5, all.odd_quadratic = 0.7;
  for (const Oscillator<double>& law : laws)
    for (const bool driven : {false, true}) {
      const State<double> start{0.9, -0.3};
      Network network;
      network.masses.push_back({"one", law.mass, start, driven ? drive : HarmonicDrive<double>{}});
      network.links.push_back({ground, 0, law});
      if (info().is_exact() && !is_linear(law_of(law))) continue;
      std::vector<double> states, of_network;
      with_method([&](const auto& method) {
        with_terms(law, network.masses[0].drive, [&](const auto& system) {
          solve(system, method, {0, 2}, start, 0.013, [&](double, const State<double>& y) {
            states.insert(states.end(), {y.x, y.v});
          });
        });
        return with_system(method, network, [&](const auto& system) {
          solve(system, method, {0, 2}, start_of(network), 0.013, [&](double, const State<MassVector>& y) {
            of_network.insert(of_network.end(), {y.x.first[0], y.v.first[0]});
          });
          return 0;
        });
      });
      EXPECT_GT(states.size(), 300u);
      EXPECT_EQ(states, of_network) << law_of(law).terms << driven;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
