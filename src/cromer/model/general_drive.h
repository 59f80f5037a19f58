// Drives other than the harmonic one, as one type; with_terms tells them apart once, outside every loop.
#pragma once

#include <utility>
#include <variant>

#include "cromer/model/chirp.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/friction.h"
#include "cromer/model/pulse.h"
#include "cromer/model/sampled_drive.h"

namespace cromer::core {

template <class Real>
using GeneralDrive = std::variant<PulseDrive<Real>, ChirpDrive<Real>, SampledDrive>;

template <class Real>
PulseForce<Real> force_of(const PulseDrive<Real>& drive, const Real& mass) {
  return {drive, mass};
}
template <class Real>
ChirpForce<Real> force_of(const ChirpDrive<Real>& drive, const Real& mass) {
  return {drive, mass};
}
template <class Real>
SampledForce<Real> force_of(const SampledDrive& drive, const Real& mass) {
  return {drive, mass};
}

/// As with_terms, of one of these drives, with three sets of terms only (linear, any but friction, any): each
/// force would multiply the instantiations.
template <class Real, class Drive, class F>
decltype(auto) with_terms_under(const Oscillator<Real>& oscillator, const Drive& drive, F&& f) {
  const Law present = law_of(oscillator);
  const Oscillator<Real> per_mass = divided_by_mass(oscillator);
  const auto force = force_of(drive, oscillator.mass);
  using Force = std::remove_const_t<decltype(force)>;
  const DrivenOscillator<Real, Terms{.drive = true, .law = any_terms}, Force> system(per_mass, force);
  if (present.has<Friction>())
    return std::forward<F>(f)(DryFriction(system, per_mass.friction, per_mass.static_friction));
  if (!is_linear(present)) return std::forward<F>(f)(system);
  return std::forward<F>(f)(
      DrivenOscillator<Real, Terms{.drive = true, .law = linear_terms}, Force>(per_mass, force));
}

/// The same, whichever it is.
template <class Real, class F>
decltype(auto) with_terms(const Oscillator<Real>& oscillator, const GeneralDrive<Real>& drive, F&& f) {
  return std::visit([&](const auto& one) -> decltype(auto) { return with_terms_under(oscillator, one, f); },
                    drive);
}

}  // namespace cromer::core
