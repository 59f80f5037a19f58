// A network as a system that methods integrate: its scalar is a MassVector.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
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
#include "cromer/model/network_phase.h"

namespace cromer::core {

/// Accelerations by the links and the drives of the masses: of a network with dry friction those of one phase
/// of its motion, else without friction. Of one mass with one link to the ground they are those of the
/// DrivenOscillator or the HystereticOscillator, to the bit (of a zero the sign may differ). Force as there.
/// A run in one thread at a time: the solver of its equations remembers.
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
  NetworkSystem(const NetworkSystem<Other>& system, const Make& make)
      : links_(system.links_), phase_(system.phase_) {
    drives_.reserve(system.drives_.size());
    for (const auto& [mass, force] : system.drives_) drives_.emplace_back(mass, make(force));
  }

  /// The same while masses slide on and stick to each other as the phase says.
  NetworkSystem in(std::shared_ptr<const NetworkPhase> phase) const {
    NetworkSystem same = *this;
    same.phase_ = std::move(phase);
    return same;
  }

  /// True of the form that on_nodes gives.
  static constexpr bool at_nodes = requires(Force & force) { force.move_to(0.0, 1.0); };

  const LinkEnds& links() const { return *links_; }
  bool resists() const { return links_->resists(); }

  /// [m/s^2], and of inner states [m/s^3].
  template <class Time>
  MassVector acceleration(const Time& t, const MassVector& x, const MassVector& v) const {
    Vector a = driven(value_of(t));
    const double *at = x.first.data(), *speed = v.first.data(), *inner = v.second.data();
    const std::size_t looked_up = links_->has_bands() ? 0 : links_->masses();
    if (links_->has_bands()) links_->pull_by_bands(a.data(), at, speed);
    for (std::size_t i = 0; i < looked_up; ++i) {
      double sum = a[i];
      links_->for_each_at(
          i,
          [&](const LinkEnd& end, double sign) {
            if (end.other == ground) return State<double>{sign * at[i], sign * speed[i]};
            return State<double>{sign * (at[i] - at[end.other]), sign * (speed[i] - speed[end.other])};
          },
          [&](const LinkEnd& end, double sign, double resistance, double restoring) {
            if (end.inner != LinkEnd::none) {
              sum = sum - sign * (end.inner_share * inner[end.inner]);
              sum = sum - sign * (resistance + restoring);
              return;
            }
            const bool resists_last = at_nodes && end.resists_last;
            sum = sum - sign * (resists_last ? restoring : resistance);
            sum = sum - sign * (resists_last ? resistance : restoring);
          });
      a[i] = sum;
    }
    if (phase_) phase_->apply(a);
    return {std::move(a), rate(v.first, v.second)};
  }

  /// The same with derivatives by the unknowns of an implicit step.
  template <class Time, std::size_t count>
  Coupled<VectorUnknown<count>> acceleration(const Time& t, const Coupled<VectorUnknown<count>>& x,
                                             const Coupled<VectorUnknown<count>>& v) const {
    using D = Dual<double, count>;
    VectorUnknown<count> a(driven(value_of(t)));
    a.solver = phase_ ? &phase_->solver(*links_) : &links_->solver();
    for (Vector& entries : a.entries) entries = Vector::zeros(links_->entries());
    const double *at = x.first.value.data(), *speed = v.first.value.data(), *inner = v.second.value.data();
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
            if (end.inner != LinkEnd::none) {
              sum.value = sum.value - sign * (end.inner_share * inner[end.inner]);
              sum.value = sum.value - sign * (resistance.value + restoring.value);
            } else {
              sum.value = sum.value - sign * resistance.value;
              sum.value = sum.value - sign * restoring.value;
            }
            for (std::size_t j = 0; j < count; ++j) {
              const double slope = resistance.derivative[j] + restoring.derivative[j];
              if (end.inner != LinkEnd::none) {
                sum.derivative[j] = sum.derivative[j] - slope;
                a.entries[j][end.inner_entry] = -sign * (end.inner_share * v.second.slope[j]);
              } else {
                sum.derivative[j] = sum.derivative[j] - resistance.derivative[j];
                sum.derivative[j] = sum.derivative[j] - restoring.derivative[j];
              }
              if (end.entry != LinkEnd::none) a.entries[j][end.entry] = slope;
            }
          });
      a.value[i] = sum.value;
      for (std::size_t j = 0; j < count; ++j) a.entries[j][i] = sum.derivative[j];
    }
    if (phase_) phase_->apply(a.value);
    return {std::move(a), rate(v)};
  }

  /// Of inner states [m/s^3].
  Vector rate(const Vector& v, const Vector& inner) const {
    if (links_->inner().empty()) return 0;
    Vector rates = Vector::of_size(links_->inner().size());
    for (std::size_t l = 0; l < rates.size(); ++l)
      rates[l] = rate_of(links_->inner()[l], link_speed(links_->inner()[l], v), inner[l]);
    return rates;
  }

  /// [m/s^2] Rounding error of the acceleration. Where masses break loose, pull and friction cancel to it.
  double acceleration_rounding(double) const { return phase_ ? phase_->rounding() : 0; }

  /// The first time after t [s] at which the drive of some mass turns; infinite without one.
  double next_turn(double t) const requires(std::same_as<Force, HarmonicForce<double>>) {
    double next = std::numeric_limits<double>::infinity();
    for (const auto& [mass, force] : drives_) next = std::fmin(next, force.next_turn(t));
    return next;
  }

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
    Vector a = Vector::zeros(links_->masses());
    for (const auto& [mass, force] : drives_) a[mass] = force(t);
    return a;
  }

  /// u' of a link.
  static double link_speed(const InnerLink& link, const Vector& v) {
    return stretch(link.from, link.to, [&](std::size_t i) { return v[i]; });
  }

  template <class T>
  static T rate_of(const InnerLink& link, const T& v, const T& z) {
    return Hysteresis::rate(v, z, link.law.hysteresis_stiffness, link.law.hysteresis_beta,
                            link.law.hysteresis_gamma, link.law.hysteresis_exponent);
  }

  template <std::size_t count>
  VectorUnknown<count> rate(const Coupled<VectorUnknown<count>>& v) const {
    if (links_->inner().empty()) return {};
    // In pairs as the unknowns of a single mass are: by its velocity, by its inner state.
    using D = Dual<double, 2 * count>;
    const std::size_t size = links_->inner().size();
    VectorUnknown<count> rates(Vector::of_size(size));
    for (Vector& entries : rates.entries) entries = Vector::of_size(links_->inner_entries());
    std::size_t entry = 0;
    for (std::size_t l = 0; l < size; ++l) {
      const InnerLink& link = links_->inner()[l];
      D speed(link_speed(link, v.first.value)), z(v.second.value[l]);
      for (std::size_t j = 0; j < count; ++j) {
        speed.derivative[2 * j] = v.first.slope[j];
        z.derivative[2 * j + 1] = v.second.slope[j];
      }
      const D found = rate_of(link, speed, z);
      rates.value[l] = found.value;
      const auto add = [&](double sign, std::size_t offset) {
        for (std::size_t j = 0; j < count; ++j)
          rates.entries[j][entry] = sign * found.derivative[2 * j + offset];
        ++entry;
      };
      if (link.from != ground) add(-1, 0);
      if (link.to != ground) add(1, 0);
      add(1, 1);
    }
    return rates;
  }

  std::shared_ptr<const LinkEnds> links_;
  std::shared_ptr<const NetworkPhase> phase_{};
  std::vector<std::pair<std::size_t, Force>> drives_;  // per unit mass
};

}  // namespace cromer::core
