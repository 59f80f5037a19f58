// Dry friction between masses: which contacts stick, and which start to slide.
//
// Contacts that are at rest together are decided together. Of all accelerations the masses can have, with no
// contact holding more than it can, the motion takes those closest to free motion (C. F. Gauss, J. reine
// angew. Math. 4, 232 (1829)). Masses joined by contacts that hold share their mean acceleration, and they do
// hold exactly if the contacts can carry what each mass has too much to where there is too little: a flow
// through a network whose capacities are the holding forces. Where the largest flow is too small, its
// bottleneck (L. R. Ford & D. R. Fulkerson, Can. J. Math. 8, 399 (1956)) is where they part. So loops of
// contacts, whose forces the equations of motion leave open, need no special care.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/base/vector.h"
#include "cromer/model/network.h"
#include "cromer/model/network_phase.h"

namespace cromer::core {

/// The contacts of a network.
class NetworkFriction {
 public:
  explicit NetworkFriction(const Network& network);

  const std::vector<Contact>& contacts() const { return contacts_; }

  /// u' of a contact.
  double speed(std::size_t contact, const Vector& v) const {
    return stretch(contacts_[contact].from, contacts_[contact].to, [&](std::size_t i) { return v[i]; });
  }

  /// Sets the direction of each contact that is 0, at rest, to 1 or -1 if it starts to slide. acceleration:
  /// of each mass by all forces but friction [m/s^2]. Of contacts that are held, by their places, 0 stays.
  /// Time grows with the contacts at rest, and where they form loops faster.
  void decide(const Vector& acceleration, std::vector<int>& directions,
              const std::vector<bool>& held = {}) const;

 private:
  std::vector<double> mass_;
  std::vector<Contact> contacts_;
};

}  // namespace cromer::core
