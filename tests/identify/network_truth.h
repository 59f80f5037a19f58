// Free and driven swings of networks whose law is known.
#pragma once

#include <cstdint>
#include <vector>

#include "cromer/identify/network/fit_network.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/network_system.h"
#include "cromer/model/sensor.h"
#include "cromer/run/solve.h"

namespace cromer::core {

struct NetworkSwings {
  std::vector<double> t;
  std::vector<std::vector<double>> y;

  NetworkRecord record() const {
    NetworkRecord record{t, {}};
    for (const auto& column : y) record.y.emplace_back(column);
    return record;
  }
};

/// The network's motion by a fine Runge-Kutta, seen by sensors with an offset and noise.
inline NetworkSwings swings_of(const Network& network, std::size_t samples, double step, double noise,
                               std::uint64_t seed) {
  NetworkSwings swings;
  swings.y.resize(network.masses.size());
  const NetworkSystem<> system(network);
  const Rk4 method;
  NoMemory none;
  NormalDeviates normal(seed);
  State<MassVector> y = start_of(network);
  constexpr int parts = 10;
  for (std::size_t n = 0; n < samples; ++n) {
    const double t = static_cast<double>(n) * step;
    swings.t.push_back(t);
    for (std::size_t i = 0; i < swings.y.size(); ++i)
      swings.y[i].push_back(y.x.first[i] + 0.01 * static_cast<double>(i + 1) + noise * normal.next());
    for (int k = 0; k < parts; ++k) y = method.step(system, t + k * step / parts, step / parts, y, none).y;
  }
  return swings;
}

}  // namespace cromer::core
