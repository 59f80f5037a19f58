// A number with its derivatives by N parameters, for equations whose slope is known.
//
// The variational equation of a law needs sums and multiples only: the products are in the law's own slopes
// (forced_system.h). A Dual would carry each constant's zero derivatives through them, at ten times the cost.
#pragma once

#include <array>

namespace cromer {

template <int N>
struct Tangent {
  double value = 0;
  std::array<double, N> derivative{};

  friend Tangent operator+(Tangent a, const Tangent& b) {
    a.value += b.value;
    for (int i = 0; i < N; ++i) a.derivative[i] += b.derivative[i];
    return a;
  }
  friend Tangent operator*(double c, Tangent a) {
    a.value *= c;
    for (int i = 0; i < N; ++i) a.derivative[i] *= c;
    return a;
  }
};

/// Values alone.
template <>
struct Tangent<0> {
  double value = 0;

  friend Tangent operator+(Tangent a, const Tangent& b) { return {a.value + b.value}; }
  friend Tangent operator*(double c, Tangent a) { return {c * a.value}; }
};

/// The number without its derivatives, as of other scalars.
template <int N>
constexpr double value_of(const Tangent<N>& x) {
  return x.value;
}

}  // namespace cromer
