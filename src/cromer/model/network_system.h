// A network as a system that methods integrate: its scalar is a MassVector.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "cromer/base/dual.h"
#include "cromer/base/vector.h"
#include "cromer/base/vector_unknown.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/link_ends.h"
#include "cromer/model/network.h"

namespace cromer::core {

/// Accelerations by the smooth terms of the links and the drives of the masses; friction is left out. Of one
/// mass with one link to the ground they are those of the DrivenOscillator, to the bit (of a zero the sign
/// may differ). Force as there. A run in one thread at a time: the solver of its equations remembers.
template <class Force = HarmonicForce<double>>
class NetworkSystem {
 public:
  explicit NetworkSystem(const Network& network) : links_(std::make_shared<LinkEnds>(network)) {
    for (std::size_t i = 0; i < network.masses.size(); ++i) {
      const NetworkMass& mass = network.masses[i];
      if (mass.drive.amplitude != 0) drives_.emplace_back(i, force_of(mass.drive, mass.mass));
    }
  }
  template <class Other, class Make>
  NetworkSystem(const NetworkSystem<Other>& system, const Make& make) : links_(system.links_) {
    drives_.reserve(system.drives_.size());
    for (const auto& [mass, force] : system.drives_) drives_.emplace_back(mass, make(force));
  }

  /// True of the form that on_nodes gives.
  static constexpr bool at_nodes = requires(Force & force) { force.move_to(0.0, 1.0); };

  bool resists() const { return links_->resists(); }

  /// [m/s^2]
  template <class Time>
  MassVector acceleration(const Time& t, const MassVector& x, const MassVector& v) const {
    Vector a = driven(value_of(t));
    const double *at = x.first.data(), *speed = v.first.data();
    for (std::size_t i = 0; i < links_->masses(); ++i) {
      double sum = a[i];
      links_->for_each_at(
          i,
          [&](const LinkEnd& end, double sign) {
            if (end.other == ground) return State<double>{sign * at[i], sign * speed[i]};
            return State<double>{sign * (at[i] - at[end.other]), sign * (speed[i] - speed[end.other])};
          },
          [&](const LinkEnd& end, double sign, double resistance, double restoring) {
            const bool resists_last = at_nodes && end.resists_last;
            sum = sum - sign * (resists_last ? restoring : resistance);
            sum = sum - sign * (resists_last ? resistance : restoring);
          });
      a[i] = sum;
    }
    return {std::move(a), 0};
  }

  /// The same with derivatives by the unknowns of an implicit step.
  template <class Time, std::size_t count>
  Coupled<VectorUnknown<count>> acceleration(const Time& t, const Coupled<VectorUnknown<count>>& x,
                                             const Coupled<VectorUnknown<count>>& v) const {
    using D = Dual<double, count>;
    VectorUnknown<count> a(driven(value_of(t)));
    a.solver = &links_->solver();
    for (Vector& entries : a.entries) {
      entries = Vector::of_size(links_->entries());
      for (std::size_t e = 0; e < links_->entries(); ++e) entries[e] = 0;
    }
    const double *at = x.first.value.data(), *speed = v.first.value.data();
    for (std::size_t i = 0; i < links_->masses(); ++i) {
      D sum(a.value[i]);
      // The derivative by the link's own motion is the same at both ends, but for its sign.
      links_->for_each_at(
          i,
          [&](const LinkEnd& end, double sign) {
            const bool grounded = end.other == ground;
            return State<D>{{sign * (grounded ? at[i] : at[i] - at[end.other]), x.first.slope},
                            {sign * (grounded ? speed[i] : speed[i] - speed[end.other]), v.first.slope}};
          },
          [&](const LinkEnd& end, double sign, const D& resistance, const D& restoring) {
            sum.value = sum.value - sign * resistance.value;
            sum.value = sum.value - sign * restoring.value;
            for (std::size_t j = 0; j < count; ++j) {
              sum.derivative[j] = sum.derivative[j] - resistance.derivative[j];
              sum.derivative[j] = sum.derivative[j] - restoring.derivative[j];
              if (end.entry != LinkEnd::none)
                a.entries[j][end.entry] = resistance.derivative[j] + restoring.derivative[j];
            }
          });
      a.value[i] = sum.value;
      for (std::size_t j = 0; j < count; ++j) a.entries[j][i] = sum.derivative[j];
    }
    return {std::move(a), VectorUnknown<count>()};
  }

  /// Of inner states: there are none.
  Vector rate(const Vector&, const Vector&) const { return 0; }

  /// Its drives from tables, as those of a DrivenOscillator.
  auto on_grid(double spacing) const requires(std::same_as<Force, HarmonicForce<double>>) {
    return NetworkSystem<TabulatedForce<double>>(
        *this, [&](const Force& force) { return TabulatedForce<double>(force, spacing); });
  }
  template <class Nodes>
  auto on_nodes() const requires(std::same_as<Force, HarmonicForce<double>>) {
    return NetworkSystem<NodeForce<double, Nodes>>(
        *this, [](const Force& force) { return NodeForce<double, Nodes>(force); });
  }
  static constexpr int block = TabulatedForce<double>::block;
  template <class... Where>
  requires requires(Force& force, Where... where) { force.move_to(where...); }
  void move_to(Where... where) {
    for (auto& [mass, force] : drives_) force.move_to(where...);
  }

 private:
  template <class Other>
  friend class NetworkSystem;

  Vector driven(double t) const {
    Vector a = Vector::of_size(links_->masses());
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = 0;
    for (const auto& [mass, force] : drives_) a[mass] = force(t);
    return a;
  }

  std::shared_ptr<const LinkEnds> links_;
  std::vector<std::pair<std::size_t, Force>> drives_;  // per unit mass
};

}  // namespace cromer::core
