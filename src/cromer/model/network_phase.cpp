#include "cromer/model/network_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/disjoint_sets.h"

namespace cromer::core {

NetworkPhase::NetworkPhase(const Network& network, const std::vector<Contact>& contacts,
                           const std::vector<int>& directions) {
  const std::size_t count = network.masses.size();
  for (const NetworkMass& mass : network.masses) mass_.push_back(mass.mass);

  DisjointSets sticking(count + 1);  // the last one is the ground
  const auto place = [&](std::size_t mass) { return mass == ground ? count : mass; };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (directions[c] == 0) {
      // The last of them leads, so that the ground does.
      const auto [first, last] =
          std::minmax({sticking.leader(place(contact.from)), sticking.leader(place(contact.to))});
      sticking.join(first, last);
      continue;
    }
    if (friction_.empty()) friction_.assign(count, 0);
    const double force = directions[c] > 0 ? contact.kinetic : -contact.kinetic;
    if (contact.to != ground) friction_[contact.to] += force / mass_[contact.to];
    if (contact.from != ground) friction_[contact.from] -= force / mass_[contact.from];
  }
  for (const double each : friction_)
    rounding_ = std::max(rounding_, std::numeric_limits<double>::epsilon() * std::abs(each));

  std::vector<Group> groups(count + 1);  // each at the place of its leader
  for (std::size_t i = 0; i < count; ++i) {
    Group& group = groups[sticking.leader(i)];
    group.masses.push_back(i);
    group.mass += mass_[i];
  }
  groups[count].grounded = true;
  for (Group& group : groups) {
    if (group.masses.size() > 1 || (group.grounded && !group.masses.empty()))
      groups_.push_back(std::move(group));
    else if (!group.masses.empty())
      free_masses_ = true;
  }
}

void NetworkPhase::apply(Vector& acceleration) const {
  for (std::size_t i = 0; i < friction_.size(); ++i) acceleration[i] -= friction_[i];
  share(acceleration);
}

void NetworkPhase::share(Vector& of_masses) const {
  for (const Group& group : groups_) {
    double sum = 0;
    if (!group.grounded) {
      for (const std::size_t i : group.masses) sum += mass_[i] * of_masses[i];
      sum /= group.mass;
    }
    for (const std::size_t i : group.masses) of_masses[i] = sum;
  }
}

SparseSolver& NetworkPhase::solver(const LinkEnds& links) const {
  if (groups_.empty()) return links.solver();
  if (solver_) return *solver_;
  MatrixPattern pattern = links.solver().pattern();
  pattern.group.assign(mass_.size(), LinkEnd::none);
  pattern.share.assign(mass_.size(), 1);
  for (const Group& group : groups_) {
    for (const std::size_t i : group.masses) {
      pattern.group[i] = pattern.groups;
      pattern.share[i] = group.grounded ? 0 : mass_[i] / group.mass;
    }
    ++pattern.groups;
  }
  for (std::size_t& group : pattern.group)
    if (group == LinkEnd::none) group = pattern.groups++;
  solver_ = std::make_unique<SparseSolver>(std::move(pattern));
  return *solver_;
}

}  // namespace cromer::core
