// The size of a number, as methods ask for it. Where the scalar is a pack of numbers (ensemble/pack.h) each
// lane has its own.
#pragma once

#include <cmath>

#include "cromer/base/dual.h"

namespace cromer::core {

/// |x| without its derivatives.
template <class Real>
constexpr auto magnitude(const Real& x) -> decltype(value_of(x)) {
  using std::abs;
  return abs(value_of(x));
}

/// The type of sizes: double, or a pack of doubles.
template <class Real>
using Magnitude = decltype(magnitude(Real{}));

/// The type of answers about sizes: bool, or one for each lane.
template <class Real>
using Truth = decltype(Magnitude<Real>{} < Magnitude<Real>{});

constexpr double larger(double a, double b) { return a < b ? b : a; }

/// True in every lane.
constexpr bool all(bool truth) { return truth; }

/// `yes` if it is true, else `no`.
template <class Number>
constexpr Number choose(bool truth, const Number& yes, const Number& no) {
  return truth ? yes : no;
}

}  // namespace cromer::core
