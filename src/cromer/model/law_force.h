// The forces of a law's terms, summed: written here alone, whoever chooses among the terms, and when. And
// which laws have code of their own.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/model/law.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// A law whose terms are told at run time: one type for all of them, where one for each set costs more than
/// it saves.
inline constexpr Law any_terms{std::uint32_t{1} << 31};

/// Terms whose force depends on the position alone; and the other smooth ones, whose force depends on the
/// velocity too.
inline constexpr Law terms_of_position =
    law_where([](const TermInfo& info) { return info.acts_at_rest; }).without(law_with<Hysteresis>);
inline constexpr Law terms_of_velocity = smooth_terms.without(terms_of_position);
/// Terms that take energy away, or give it where their coefficient is negative.
inline constexpr Law dissipative_terms = terms_of_velocity.with(law_with<Friction, Hysteresis>);

/// Whether the force of a law may depend on the velocity.
constexpr bool has_resistance(Law law) { return law == any_terms || law.shares(terms_of_velocity); }

/// The coefficients of a law's smooth terms alone, since what a loop carries must fit into registers. With
/// any_terms those of all smooth terms.
template <Law law, class Real>
class Coefficients {
 public:
  static constexpr Law terms = law == any_terms ? smooth_terms : Law{law.terms & smooth_terms.terms};

  Coefficients() = default;
  explicit Coefficients(const Oscillator<Real>& oscillator) {
    for_each_term([&]<class T>() {
      if constexpr (terms.has<T>()) numbers_[place<T>] = oscillator.*T::template members<Real>[0];
    });
  }

  template <class T>
  Real& of() {
    return numbers_[place<T>];
  }
  /// 0 for a term that is not among them.
  template <class T>
  decltype(auto) of() const {
    if constexpr (terms.has<T>())
      return (numbers_[place<T>]);
    else
      return Real(0);
  }

 private:
  template <class T>
  static constexpr std::size_t place =
      static_cast<std::size_t>(Law{terms.terms & (law_with<T>.terms - 1)}.size());

  std::array<Real, static_cast<std::size_t>(terms.size())> numbers_{};
};

/// The places of the law's terms in the registry.
template <Law law>
inline constexpr auto places_of = [] {
  std::array<std::size_t, static_cast<std::size_t>(law.size())> places{};
  std::size_t found = 0;
  for (std::size_t i = 0; i < term_count; ++i)
    if (law.has(i)) places[found++] = i;
  return places;
}();

template <class T, class Real>
const Real& coefficient_of(const Oscillator<Real>& oscillator) {
  return oscillator.*T::template members<Real>[0];
}
template <class T, Law law, class Real>
decltype(auto) coefficient_of(const Coefficients<law, Real>& coefficients) {
  return coefficients.template of<T>();
}

/// The sum over those of the law's terms that are among `which` [m/s^2] with coefficients per unit mass, in
/// the order of the registry. With any_terms those that are `present`: absent terms are stepped over, so that
/// the sum is the same to the bit (of a zero the sign may differ).
/// per_mass: an Oscillator or Coefficients.
template <Law law, Law which, class Source, class T>
T sum_of_forces(const Source& per_mass, [[maybe_unused]] Law present, const T& x, const T& v) {
  const auto force_of = [&]<class Term>() -> T { return Term::force(x, v, coefficient_of<Term>(per_mass)); };
  if constexpr (law == any_terms) {
    T sum(0);
    bool first = true;
    for_each_term([&]<class Term>() {
      if constexpr (which.has<Term>()) {
        if (!present.has<Term>()) return;
        const T force = force_of.template operator()<Term>();
        sum = first ? force : T(sum + force);
        first = false;
      }
    });
    return sum;
  } else {
    // One expression: a sum that is added to costs implicit methods a fourth of their speed.
    return [&]<std::size_t... i>(std::index_sequence<i...>)->T {
      constexpr auto places = places_of<Law{law.terms & which.terms}>;
      if constexpr (sizeof...(i) == 0)
        return T(0);
      else
        return (... + force_of.template operator()<std::tuple_element_t<places[i], AllTerms>>());
    }
    (std::make_index_sequence<places_of<Law{law.terms & which.terms}>.size()>{});
  }
}

/// The force of the terms of the position.
template <Law law, class Source, class T>
T restoring_force(const Source& per_mass, Law present, const T& x) {
  return sum_of_forces<law, terms_of_position>(per_mass, present, x, x);
}

/// The force of the terms of the velocity.
template <Law law, class Source, class T>
T resisting_force(const Source& per_mass, Law present, const T& x, const T& v) {
  return sum_of_forces<law, terms_of_velocity>(per_mass, present, x, v);
}

/// The restoring force of an oscillator [N].
template <class T>
T restoring_force(const Oscillator<double>& oscillator, const T& x) {
  return restoring_force<any_terms>(oscillator, law_of(oscillator), x);
}

/// The stiffness that small motions about x feel [N/m]: the slope of the restoring force, and that of a
/// hysteretic one where it begins.
inline double stiffness_at(const Oscillator<double>& oscillator, double x) {
  return restoring_force(oscillator, Dual<double, 1>::variable(x, 0)).derivative[0] +
         oscillator.hysteresis_stiffness;
}

/// Whether sets of terms have code of their own. A term that is absent then costs nothing; the page, which
/// must be small, has one code for all.
#ifdef CROMER_PAGE
inline constexpr bool each_set_of_terms = false;
#else
inline constexpr bool each_set_of_terms = true;
#endif

/// What a system has: a drive, and the terms of its law.
struct Terms {
  bool drive = false;
  Law law = law_with<Spring>;

  friend constexpr bool operator==(const Terms&, const Terms&) = default;
};

/// The drive and the terms that are present.
template <class Real>
constexpr Terms terms_of(const Oscillator<Real>& oscillator, const HarmonicDrive<Real>& drive) {
  return {.drive = drive.amplitude != Real(0), .law = law_of(oscillator)};
}

/// The smooth laws with code of their own: a measured choice. Every other one shares the code of any_terms,
/// which asks for each term whether it is there.
inline constexpr Law compiled_laws[] = {law_of("spring"),        law_of("viscous"),
                                        law_of("viscous+drag"),  law_of("cubic"),
                                        law_of("viscous+cubic"), law_of("viscous+drag+cubic")};

}  // namespace cromer::core
