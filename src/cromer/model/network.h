// Masses and links: what a network is.
//
// A link joins a mass to another one or to the ground, with any terms of the law: of u, the position of its
// end less that of its beginning, and of u'. It pulls on both ends with the same force.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "cromer/base/coupled.h"
#include "cromer/base/state.h"
#include "cromer/base/vector.h"
#include "cromer/model/law.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// A number for each mass; the second vector of the pair holds the inner states of links, if there are any.
using MassVector = Coupled<Vector>;

/// True if all positions and velocities are numbers; the loops of run/ find it.
inline bool is_finite(const State<MassVector>& y) { return all_finite(y.x.first) && all_finite(y.v.first); }

/// Stands for the ground where a link names a mass.
inline constexpr std::size_t ground = std::numeric_limits<std::size_t>::max();

/// A mass or, in a network of angles, a moment of inertia.
struct NetworkMass {
  std::string name{};
  double mass = 1;                // [kg] or [kg m^2], > 0
  State<double> start{};          // [m], [m/s], or [rad], [rad/s]
  HarmonicDrive<double> drive{};  // [N] or [N m]
};

/// From one mass to another, or from or to the ground.
struct NetworkLink {
  std::size_t from = ground, to = ground;    ///< places in the list of masses; never the same
  Oscillator<double> law{.stiffness = 0.0};  ///< its mass is not used
};

/// At least one mass; every link holds at least one.
struct Network {
  bool angles = false;  ///< masses are moments of inertia, positions angles
  std::vector<NetworkMass> masses{};
  std::vector<NetworkLink> links{};
};

/// u between two masses, or a mass and the ground, or u': `of` gives each mass' part.
template <class Of>
double stretch(std::size_t from, std::size_t to, const Of& of) {
  const double end = to == ground ? 0 : of(to);
  return from == ground ? end : end - of(from);
}

/// "ground", or the mass' name.
inline std::string name_of(const Network& network, std::size_t end) {
  return end == ground ? "ground" : network.masses[end].name;
}

/// The terms of all links, and a spring.
inline Law law_of(const Network& network) {
  Law law = law_with<Spring>;
  for (const NetworkLink& link : network.links) law = law.with(law_of(link.law));
  return law;
}

/// Where the masses are at the start. Links with a force that has memory have not been stretched before.
inline State<MassVector> start_of(const Network& network) {
  Vector x = Vector::of_size(network.masses.size()), v = x;
  for (std::size_t i = 0; i < network.masses.size(); ++i) {
    x[i] = network.masses[i].start.x;
    v[i] = network.masses[i].start.v;
  }
  std::size_t inner = 0;
  for (const NetworkLink& link : network.links) inner += law_of(link.law).has<Hysteresis>();
  const Vector at_rest = Vector::zeros(inner);
  return {{x, at_rest}, {v, at_rest}};
}

}  // namespace cromer::core
