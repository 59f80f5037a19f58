// Which terms a law of motion has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/all.h"

namespace cromer::core {

/// A set of the registry's terms.
struct Law {
  std::uint32_t terms = 0;  ///< bit i: the i-th term of the registry

  template <class T>
  constexpr bool has() const {
    return (terms >> place_of_term<T> & 1) != 0;
  }
  constexpr bool has(std::size_t place) const { return (terms >> place & 1) != 0; }

  /// Every term of the other.
  constexpr bool contains(Law other) const { return (terms & other.terms) == other.terms; }
  constexpr bool shares(Law other) const { return (terms & other.terms) != 0; }

  constexpr Law with(Law other) const { return {terms | other.terms}; }
  constexpr Law without(Law other) const { return {terms & ~other.terms}; }

  constexpr int size() const {
    int count = 0;
    for (std::uint32_t rest = terms; rest != 0; rest &= rest - 1) ++count;
    return count;
  }

  friend constexpr bool operator==(const Law&, const Law&) = default;
};

/// The law of these terms alone.
template <class... T>
inline constexpr Law law_with{((std::uint32_t{1} << place_of_term<T>) | ... | 0U)};

/// The law of all terms for whose info says(info) is true.
template <class Says>
constexpr Law law_where(Says says) {
  Law law;
  for (std::size_t i = 0; i < term_count; ++i)
    if (says(term_infos[i])) law.terms |= std::uint32_t{1} << i;
  return law;
}

/// The smallest law that contains all terms of the given one; the first of equals; nothing if none does.
constexpr std::optional<Law> smallest_containing(std::span<const Law> laws, Law law) {
  std::optional<Law> best;
  for (const Law each : laws)
    if (each.contains(law) && (!best || each.size() < best->size())) best = each;
  return best;
}

/// Terms that pull a body back to rest. Every law has one of them.
inline constexpr Law springs = law_with<Spring, Pendulum>;
/// Terms that take energy away where their coefficients are positive.
inline constexpr Law dampings = law_where([](const TermInfo& info) { return info.damps; });
/// Terms that bound a swing which negative damping feeds.
inline constexpr Law bounding_terms = law_where([](const TermInfo& info) { return info.bounds; });
/// Whether a coefficient may be negative in this law. One that feeds the swing may where another term bounds
/// it, and in `growing`, a part of a motion that is not bounded while it is seen (see may_grow()).
constexpr bool may_be_negative(const CoefficientInfo& info, Law law, bool growing = false) {
  return info.sign == Sign::any ||
         (info.sign == Sign::not_negative_unless_fed && (growing || law.shares(bounding_terms)));
}
/// Whether a swing of this law may grow without a bound: viscous damping is its only one. Beside another, a
/// negative one would only stand in for a shape that neither has.
constexpr bool may_grow(Law law) {
  return Law{law.terms & dampings.terms} == law_with<Viscous> && !law.shares(bounding_terms) &&
         !law.has<Hysteresis>();
}
/// The linear law: the one with a closed form.
inline constexpr Law linear_terms = law_with<Spring, Viscous>;
constexpr bool is_linear(Law law) { return linear_terms.contains(law); }
/// Whether the restoring force is not proportional to the displacement.
constexpr bool has_bent_spring(Law law) {
  return !is_linear(law.without(dampings).without(law_with<Friction, Hysteresis>));
}
/// Terms whose force is a smooth function of position and velocity.
inline constexpr Law smooth_terms =
    law_where([](const TermInfo&) { return true; }).without(law_with<Friction, Hysteresis>);

/// The law of these names, "viscous+drag", with a linear spring, or with a pendulum in its place. For laws
/// written in code: a name that is no term's is passed over (identify/law.h reads what a person typed).
constexpr Law law_of(std::string_view names) {
  Law law;
  while (!names.empty()) {
    const std::size_t end = names.find('+');
    const std::string_view name = names.substr(0, end);
    law = law.with(law_where([&](const TermInfo& info) { return info.name == name; }));
    names = end == std::string_view::npos ? std::string_view{} : names.substr(end + 1);
  }
  return law.shares(springs) ? law : law.with(law_with<Spring>);
}

/// The terms whose first coefficient is not zero (of hysteresis its stiffness); the spring is always among
/// them unless a pendulum is. With static friction there is friction.
template <class Real>
constexpr Law law_of(const Oscillator<Real>& oscillator) {
  Law law;
  for_each_term([&]<class T>() {
    if (oscillator.*T::template members<Real>[0] != Real(0)) law = law.with(law_with<T>);
  });
  if (oscillator.static_friction != Real(0)) law = law.with(law_with<Friction>);
  return law.shares(springs) ? law : law.with(law_with<Spring>);
}

/// Empty if the oscillator has a closed form in one piece (with friction it is made of arcs); otherwise the
/// option of the term that prevents it.
template <class Real>
constexpr std::string_view why_not_exact(const Oscillator<Real>& oscillator) {
  std::string_view option;
  const Law law = law_of(oscillator).without(linear_terms);
  for_each_term([&]<class T>() {
    if (option.empty() && law.has<T>()) option = T::coefficients[0].option;
  });
  return option;
}

/// The oscillator per unit mass.
template <class Real>
constexpr Oscillator<Real> divided_by_mass(const Oscillator<Real>& oscillator) {
  Oscillator<Real> per_mass = oscillator;
  per_mass.mass = Real(1);
  per_mass.static_friction = oscillator.static_friction / oscillator.mass;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const auto member = T::template members<Real>[i];
      if (T::coefficients[i].fitted != FittedAs::not_a_force)
        per_mass.*member = oscillator.*member / oscillator.mass;
      else if constexpr (HasInnerState<T>)
        per_mass.*member =
            oscillator.*member * T::shape_per_mass(oscillator.mass, value_of(oscillator.hysteresis_exponent));
    }
  });
  return per_mass;
}

/// The oscillator of that mass from its coefficients per unit mass: the inverse of divided_by_mass.
template <class Real>
constexpr Oscillator<Real> multiplied_by_mass(const Oscillator<Real>& per_mass, const Real& mass) {
  Oscillator<Real> oscillator = per_mass;
  oscillator.mass = mass;
  oscillator.static_friction = mass * per_mass.static_friction;
  for_each_term([&]<class T>() {
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      Real factor = mass;
      if constexpr (HasInnerState<T>)
        if (T::coefficients[i].fitted == FittedAs::not_a_force)
          factor = Real(1) / T::shape_per_mass(mass, value_of(per_mass.hysteresis_exponent));
      const auto member = T::template members<Real>[i];
      oscillator.*member = factor * per_mass.*member;
    }
  });
  return oscillator;
}

}  // namespace cromer::core
