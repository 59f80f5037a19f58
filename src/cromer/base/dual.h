// Forward-mode differentiation: a number that carries its derivatives along.
//
// Griewank & Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, chapter 3. Every operation is exact to
// rounding; there is no step to choose. Duals nest: Dual<Dual<double, 5>, 1> is what Newton's iteration sees
// inside a fit.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace cromer::core {

/// A value and its N partial derivatives. Comparisons look at the value alone.
template <class Real, std::size_t N>
struct Dual {
  Real value{};
  std::array<Real, N> derivative{};

  constexpr Dual() = default;
  constexpr Dual(const Real& constant) : value(constant) {}  // NOLINT: a constant has no derivatives
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::same_as<Number, Real>) constexpr Dual(Number constant)
      : value(static_cast<Real>(constant)) {}  // NOLINT: likewise
  constexpr Dual(const Real& v, const std::array<Real, N>& d) : value(v), derivative(d) {}

  /// The i-th independent variable: its own derivative is 1.
  static constexpr Dual variable(const Real& value, std::size_t i) {
    Dual x(value);
    x.derivative[i] = Real(1);
    return x;
  }

  [[gnu::always_inline]] constexpr Dual operator-() const { return chain(-value, Real(-1)); }

  [[gnu::always_inline]] constexpr Dual& operator+=(const Dual& b) {
    value += b.value;
    for (std::size_t i = 0; i < N; ++i) derivative[i] += b.derivative[i];
    return *this;
  }
  [[gnu::always_inline]] constexpr Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (std::size_t i = 0; i < N; ++i) derivative[i] -= b.derivative[i];
    return *this;
  }
  [[gnu::always_inline]] constexpr Dual& operator*=(const Dual& b) {
    for (std::size_t i = 0; i < N; ++i) derivative[i] = derivative[i] * b.value + value * b.derivative[i];
    value *= b.value;
    return *this;
  }
  [[gnu::always_inline]] constexpr Dual& operator/=(const Dual& b) {
    const Real divisor = b.value;  // b may be this number itself
    value /= divisor;
    for (std::size_t i = 0; i < N; ++i) derivative[i] = (derivative[i] - value * b.derivative[i]) / divisor;
    return *this;
  }

  [[gnu::always_inline]] friend constexpr Dual operator+(Dual a, const Dual& b) { return a += b; }
  [[gnu::always_inline]] friend constexpr Dual operator-(Dual a, const Dual& b) { return a -= b; }
  [[gnu::always_inline]] friend constexpr Dual operator*(Dual a, const Dual& b) { return a *= b; }
  // A constant's zero derivatives need no products.
  [[gnu::always_inline]] friend constexpr Dual operator*(const Real& c, const Dual& b) {
    return b.chain(c * b.value, c);
  }
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::same_as<Number, Real>)  //
      friend constexpr Dual
      operator*(Number c, const Dual& b) {
    return Real(c) * b;
  }
  [[gnu::always_inline]] friend constexpr Dual operator/(Dual a, const Dual& b) { return a /= b; }

  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr bool operator>(const Dual& a, const Dual& b) { return b < a; }
  friend constexpr bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend constexpr bool operator>=(const Dual& a, const Dual& b) { return b <= a; }

  /// f(*this), given f and f' at the value.
  [[gnu::always_inline]] constexpr Dual chain(const Real& f, const Real& slope) const {
    Dual y(f);
    for (std::size_t i = 0; i < N; ++i) y.derivative[i] = slope * derivative[i];
    return y;
  }
};

/// The number without its derivatives, whatever the scalar.
constexpr double value_of(double x) { return x; }
constexpr double value_of(long double x) { return static_cast<double>(x); }
template <class Real, std::size_t N>
constexpr double value_of(const Dual<Real, N>& x) {
  return value_of(x.value);
}

/// Whether a number is 0 and stays so, whatever it is a function of.
constexpr bool vanishes(double x) { return x == 0; }
template <class Real, std::size_t N>
constexpr bool vanishes(const Dual<Real, N>& x) {
  for (const Real& each : x.derivative)
    if (!vanishes(each)) return false;
  return vanishes(x.value);
}

/// -1, 0 or 1; its derivative is 0 everywhere, also at the jump.
constexpr double sgn(double x) { return (x > 0) - (x < 0); }
template <class Real, std::size_t N>
constexpr Dual<Real, N> sgn(const Dual<Real, N>& x) {
  return Dual<Real, N>(sgn(x.value));
}

/// The derivative at 0 is taken as 0. That is right for v|v|. The hysteretic rate has a corner where v or z
/// is 0; 0 lies between its two slopes.
template <class Real, std::size_t N>
Dual<Real, N> abs(const Dual<Real, N>& x) {
  using std::abs;
  return x.chain(abs(x.value), sgn(x.value));
}

template <class Real, std::size_t N>
Dual<Real, N> sqrt(const Dual<Real, N>& x) {
  using std::sqrt;
  const Real root = sqrt(x.value);
  return x.chain(root, Real(0.5) / root);
}

template <class Real, std::size_t N>
Dual<Real, N> sin(const Dual<Real, N>& x) {
  using std::cos, std::sin;
  return x.chain(sin(x.value), cos(x.value));
}

template <class Real, std::size_t N>
Dual<Real, N> cos(const Dual<Real, N>& x) {
  using std::cos, std::sin;
  return x.chain(cos(x.value), -sin(x.value));
}

template <class Real, std::size_t N>
Dual<Real, N> exp(const Dual<Real, N>& x) {
  using std::exp;
  const Real y = exp(x.value);
  return x.chain(y, y);
}

template <class Real, std::size_t N>
Dual<Real, N> expm1(const Dual<Real, N>& x) {
  using std::exp, std::expm1;
  return x.chain(expm1(x.value), exp(x.value));
}

/// With a constant exponent, which must be at least 1 at a base of 0.
template <class Real, std::size_t N>
Dual<Real, N> pow(const Dual<Real, N>& x, double exponent) {
  using std::pow;
  return x.chain(pow(x.value, exponent), exponent * pow(x.value, exponent - 1));
}

template <class Real, std::size_t N>
Dual<Real, N> log(const Dual<Real, N>& x) {
  using std::log;
  return x.chain(log(x.value), Real(1) / x.value);
}

template <class Real, std::size_t N>
Dual<Real, N> hypot(const Dual<Real, N>& x, const Dual<Real, N>& y) {
  using std::hypot;
  Dual<Real, N> r(hypot(x.value, y.value));
  for (std::size_t i = 0; i < N; ++i)
    r.derivative[i] = (x.value * x.derivative[i] + y.value * y.derivative[i]) / r.value;
  return r;
}

template <class Real, std::size_t N>
Dual<Real, N> atan2(const Dual<Real, N>& y, const Dual<Real, N>& x) {
  using std::atan2;
  const Real r2 = x.value * x.value + y.value * y.value;
  Dual<Real, N> angle(atan2(y.value, x.value));
  for (std::size_t i = 0; i < N; ++i)
    angle.derivative[i] = (x.value * y.derivative[i] - y.value * x.derivative[i]) / r2;
  return angle;
}

}  // namespace cromer::core
