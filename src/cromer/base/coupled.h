// A pair of numbers as one scalar, so that every method can carry a third state along.
//
// A force with memory has an inner state z with a rate of its own. State<Coupled<Real>> holds it beside the
// velocity: v is (velocity, z), x is (position, the unused integral of z), and the system's acceleration
// gives (acceleration, rate of z). A method that adds up accelerations to velocities then adds up rates to z
// by the same formula, with the same stages.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"

namespace cromer::core {

/// A pair. Sums, and products with numbers, go component by component; comparisons and value_of look at the
/// first component alone.
template <class Real>
struct Coupled {
  Real first{};
  Real second{};

  constexpr Coupled() = default;
  constexpr Coupled(Real a, Real b) : first(std::move(a)), second(std::move(b)) {}
  /// The same number in both components, most often 0.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr Coupled(Number both) : first(both), second(both) {}  // NOLINT: as numbers do
  /// Converts both components, for example numbers to duals.
  template <class Other>
  requires(!std::same_as<Other, Real> &&
           std::convertible_to<Other, Real>) constexpr explicit Coupled(const Coupled<Other>& other)
      : first(other.first), second(other.second) {}
  /// Evaluates a pair of products that are not multiplied yet.
  template <class Other>
  requires std::same_as<typename Other::Value, Real>
  constexpr Coupled(Coupled<Other>&& other)  // NOLINT: it is one
      : first(std::move(other.first)), second(std::move(other.second)) {}

  constexpr Coupled operator-() const { return {-first, -second}; }
  constexpr Coupled& operator+=(const Coupled& b) { return *this = *this + b; }
  constexpr Coupled& operator-=(const Coupled& b) { return *this = *this - b; }

  friend constexpr bool operator==(const Coupled&, const Coupled&) = default;
  friend constexpr bool operator<(const Coupled& a, const Coupled& b) { return a.first < b.first; }
};

template <class Real>
constexpr Coupled<Real> coupled(Real first, Real second) {
  return {std::move(first), std::move(second)};
}

template <class Number>
inline constexpr bool is_coupled = false;
template <class Real>
inline constexpr bool is_coupled<Coupled<Real>> = true;

template <class T>
concept IsCoupled = is_coupled<std::remove_cvref_t<T>>;

// What is about to go hands its parts on: vectors then take no new memory.
template <IsCoupled A, IsCoupled B>
[[gnu::always_inline]] constexpr auto operator+(A&& a, B&& b) {
  return coupled(std::forward<A>(a).first + std::forward<B>(b).first,
                 std::forward<A>(a).second + std::forward<B>(b).second);
}
template <IsCoupled A, IsCoupled B>
[[gnu::always_inline]] constexpr auto operator-(A&& a, B&& b) {
  return coupled(std::forward<A>(a).first - std::forward<B>(b).first,
                 std::forward<A>(a).second - std::forward<B>(b).second);
}
template <class Factor, IsCoupled A>
requires(!IsCoupled<Factor>) [[gnu::always_inline]] constexpr auto operator*(const Factor& c, A&& a) {
  return coupled(c * std::forward<A>(a).first, c * std::forward<A>(a).second);
}
template <IsCoupled A, class Factor>
requires(!IsCoupled<Factor>) [[gnu::always_inline]] constexpr auto operator*(A&& a, const Factor& c) {
  return coupled(std::forward<A>(a).first * c, std::forward<A>(a).second * c);
}
template <IsCoupled A, class Divisor>
requires(!IsCoupled<Divisor>) [[gnu::always_inline]] constexpr auto operator/(A&& a, const Divisor& c) {
  return coupled(std::forward<A>(a).first / c, std::forward<A>(a).second / c);
}

template <class Real>
constexpr double value_of(const Coupled<Real>& a) {
  return value_of(a.first);
}

/// The magnitude of each component.
template <class Real>
constexpr Coupled<Magnitude<Real>> magnitude(const Coupled<Real>& a) {
  return {magnitude(a.first), magnitude(a.second)};
}
constexpr Coupled<double> larger(const Coupled<double>& a, const Coupled<double>& b) {
  return {larger(a.first, b.first), larger(a.second, b.second)};
}

}  // namespace cromer::core
