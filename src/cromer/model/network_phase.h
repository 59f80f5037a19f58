// One phase of a network's motion with dry friction: which contacts slide, and which masses stick together.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "cromer/base/vector.h"
#include "cromer/model/link_ends.h"
#include "cromer/model/network.h"
#include "cromer/model/sparse_solver.h"

namespace cromer::core {

/// Where two masses, or a mass and the ground, rub against each other: all links with dry friction between
/// them, taken together.
struct Contact {
  std::size_t from = ground, to = ground;
  double kinetic = 0;  // [N] or [N m] while it slides
  double holding = 0;  // [N] or [N m] the most at rest, >= kinetic
};

/// In a phase the friction of each sliding contact is a constant force, and masses that stick together move
/// as one: by the mean of their accelerations, weighted by mass. What friction must hold them together never
/// enters. Masses that stick to the ground, directly or through others, rest.
class NetworkPhase {
 public:
  /// directions: of each contact 1 or -1 while it slides that way, 0 while it sticks.
  NetworkPhase(const Network& network, const std::vector<Contact>& contacts,
               const std::vector<int>& directions);

  /// Adds friction to the accelerations by all other forces, and lets those that stick share.
  void apply(Vector& acceleration) const;

  /// Gives masses that stick together one velocity, keeping their momentum.
  void join(Vector& velocity) const { share(velocity); }

  /// Every mass sticks to the ground.
  bool all_at_rest() const { return groups_.size() == 1 && groups_.front().grounded && !free_masses_; }

  /// [m/s^2] Rounding error of the friction's accelerations.
  double rounding() const { return rounding_; }

  /// For implicit steps of this phase.
  SparseSolver& solver(const LinkEnds& links) const;

 private:
  /// Two masses or more, or those that stick to the ground.
  struct Group {
    std::vector<std::size_t> masses{};
    double mass = 0;
    bool grounded = false;
  };

  void share(Vector& of_masses) const;

  std::vector<double> mass_;
  std::vector<double> friction_;  // [m/s^2] of each mass; empty where nothing slides
  std::vector<Group> groups_;
  bool free_masses_ = false;  ///< some mass is in no group
  double rounding_ = 0;
  mutable std::unique_ptr<SparseSolver> solver_;
};

}  // namespace cromer::core
