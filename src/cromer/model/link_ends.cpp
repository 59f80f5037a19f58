#include "cromer/model/link_ends.h"

namespace cromer::core {

LinkEnds::LinkEnds(const Network& network) : entries_(network.masses.size()) {
  const std::size_t count = network.masses.size();
  std::vector<std::vector<LinkEnd>> at(count);
  std::vector<MatrixPlace> places(count);
  for (std::size_t i = 0; i < count; ++i) places[i] = {i, i};

  for (const NetworkLink& link : network.links) {
    const Law present = law_of(link.law).without(law_with<Friction>);
    resists_ = resists_ || present.shares(terms_of_velocity);
    const auto add = [&](std::size_t mass, std::size_t other, double sign) {
      if (mass == ground) return;
      Oscillator<double> law = link.law;
      law.mass = network.masses[mass].mass;
      law = divided_by_mass(law);
      LinkEnd end{.other = other, .sign = sign, .linear = Coefficients<linear_terms, double>(law)};
      if (!is_linear(present)) {
        end.general = general_.size();
        general_.emplace_back(law, present);
        end.resists_last = smallest_containing(compiled_laws, present).value_or(any_terms).has<Drag>();
      }
      if (other != ground) {
        end.entry = entries_++;
        places.push_back({mass, other});
      }
      at[mass].push_back(end);
    };
    add(link.from, link.to, -1);
    add(link.to, link.from, 1);
  }
  for (const std::vector<LinkEnd>& ends : at) {
    first_.push_back(ends_.size());
    ends_.insert(ends_.end(), ends.begin(), ends.end());
  }
  first_.push_back(ends_.size());
  solver_ = std::make_unique<SparseSolver>(count, std::move(places));
}

}  // namespace cromer::core
