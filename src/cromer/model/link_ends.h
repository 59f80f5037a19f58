// The links of a network as its masses feel them, mass by mass.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "cromer/model/law_force.h"
#include "cromer/model/network.h"
#include "cromer/model/sparse_solver.h"

namespace cromer::core {

/// One end of a link. Coefficients are per unit mass of the one at this end.
struct LinkEnd {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::size_t other = ground;  ///< the mass at the other end
  std::size_t entry = none;    ///< of the derivative by that mass, among those of all ends
  double sign = 1;             ///< 1 where the link ends, -1 where it begins
  Coefficients<linear_terms, double> linear{};
  std::size_t general = none;  ///< the place of its law, if that has other terms
  bool resists_last = false;   ///< as DrivenOscillator adds drag, at the nodes of methods with many stages
  std::size_t inner = none;    ///< the place of its inner state, if it has one
  std::size_t inner_entry = none;  ///< of the derivative by that, among those of all ends
  double inner_share = 1;          ///< inner state to force per unit mass
};

/// A link with a force that has memory. Its inner state is that force over the mass at one of its ends, so
/// that a network of one mass has the numbers of the HystereticOscillator.
struct InnerLink {
  std::size_t link = 0;  ///< its place in the network
  std::size_t from = ground, to = ground;
  Oscillator<double> law{};  ///< per unit mass
  double mass = 1;           // [kg] or [kg m^2]
};

/// Ends of linear links at masses in a row, all to the ground or to the mass so many places on: loops over
/// them need no lookup. Coefficients are per unit mass, from the first mass on.
struct LinkBand {
  bool grounded = false;
  std::ptrdiff_t offset = 0;
  std::size_t first = 0;
  std::vector<double> damping{}, stiffness{};  ///< damping is empty where there is none

  std::size_t end() const { return first + stiffness.size(); }
  bool pulls_only_apart() const { return !grounded && damping.empty(); }
};

/// The smooth terms of all links, and those with an inner state.
class LinkEnds {
 public:
  explicit LinkEnds(const Network& network);

  std::size_t masses() const { return first_.size() - 1; }
  /// Some force depends on the velocity.
  bool resists() const { return resists_; }
  /// Of derivatives: one for each mass by itself, then one for each end of a link between two masses.
  std::size_t entries() const { return pattern_.places.size(); }
  /// One for each inner state, in their order.
  const std::vector<InnerLink>& inner() const { return inner_; }
  /// Of derivatives of inner states' rates: those by the masses at both ends (where the link has them), from
  /// and to, then that by itself.
  std::size_t inner_entries() const { return pattern_.inner_places.size(); }
  SparseSolver& solver() const { return *solver_; }

  /// All links are linear and lie in few bands, as those of chains do: then pull_by_bands takes their forces
  /// off the accelerations, at each mass in the order of the bands.
  bool has_bands() const { return !bands_.empty(); }
  void pull_by_bands(double* acceleration, const double* x, const double* v) const;

  /// For each end at mass i, in the order of the links: relative(end, sign) gives u and u' times sign, and
  /// pull(end, sign, resistance, restoring) gets the forces in that direction, without those of inner states.
  /// Of a linear law sign is 1, and u the mass' own position less the other one; of others they are the
  /// link's.
  template <class Relative, class Pull>
  void for_each_at(std::size_t i, const Relative& relative, const Pull& pull) const {
    for (std::size_t e = first_[i]; e < first_[i + 1]; ++e) {
      const LinkEnd& end = ends_[e];
      if (end.general == LinkEnd::none) {
        const auto u = relative(end, 1.0);
        pull(end, 1.0, resisting_force<linear_terms>(end.linear, Law{}, u.x, u.v),
             restoring_force<linear_terms>(end.linear, Law{}, u.x));
      } else {
        const auto& [law, present] = general_[end.general];
        const auto u = relative(end, end.sign);
        pull(end, end.sign, resisting_force<any_terms>(law, present, u.x, u.v),
             restoring_force<any_terms>(law, present, u.x));
      }
    }
  }

 private:
  void make_bands();

  std::vector<std::size_t> first_;  ///< of each mass' ends; one more than masses
  std::vector<LinkEnd> ends_;
  std::vector<std::pair<Oscillator<double>, Law>> general_;
  std::vector<InnerLink> inner_;
  std::vector<LinkBand> bands_;
  bool resists_ = false;
  MatrixPattern pattern_;
  std::unique_ptr<SparseSolver> solver_;
};

}  // namespace cromer::core
