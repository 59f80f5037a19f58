// The registry: the only list of the law's terms. A new one is an include and an entry.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "cromer/model/terms/cubic.h"
#include "cromer/model/terms/drag.h"
#include "cromer/model/terms/friction.h"
#include "cromer/model/terms/hysteresis.h"
#include "cromer/model/terms/odd_quadratic.h"
#include "cromer/model/terms/pendulum.h"
#include "cromer/model/terms/quadratic.h"
#include "cromer/model/terms/quintic.h"
#include "cromer/model/terms/spring.h"
#include "cromer/model/terms/van_der_pol.h"
#include "cromer/model/terms/viscous.h"

namespace cromer::core {

/// In the order in which laws are written and parameters listed.
using AllTerms = std::tuple<Spring, Viscous, Drag, Friction, Cubic, Quadratic, OddQuadratic, Quintic,
                            VanDerPol, Hysteresis, Pendulum>;

inline constexpr std::size_t term_count = std::tuple_size_v<AllTerms>;

/// Calls f.operator()<T>() for every term, in the order of the list.
template <class F>
constexpr void for_each_term(F&& f) {
  [&]<class... T>(std::type_identity<std::tuple<T...>>) {
    (f.template operator()<T>(), ...);
  }(std::type_identity<AllTerms>{});
}

/// What is known of each term, in the order of the list.
inline constexpr auto term_infos = []<class... T>(std::type_identity<std::tuple<T...>>) {
  return std::array<TermInfo, sizeof...(T)>{T::info...};
}(std::type_identity<AllTerms>{});

/// Place of a term in the list.
template <class T>
inline constexpr std::size_t place_of_term = []<class... Each>(std::type_identity<std::tuple<Each...>>) {
  std::size_t place = 0, i = 0;
  ((std::is_same_v<T, Each> ? void(place = i) : void(), ++i), ...);
  return place;
}(std::type_identity<AllTerms>{});

}  // namespace cromer::core
