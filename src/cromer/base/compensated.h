// Compensated summation as a number: sums keep what rounding would drop.
//
// A run of 1e8 steps adds 1e8 small increments to a position; each addition rounds, and the errors walk away.
// State<Compensated> carries the rounded-off rest along, in the same methods and laws (Kahan, Comm. ACM 8, 40
// (1965); the exact sum of two doubles: Knuth, The Art of Computer Programming 2, 4.2.2). Needs
// -ffp-contract=off and no -ffast-math.
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

namespace cromer::core {

/// value + rest, |rest| at most half a unit in the last place of value. Sums and differences are right to
/// 2^-105 of the larger operand; products, quotients and functions are rounded to doubles (they make the
/// increments, whose own last digits do not matter), but keep the rests of their operands to first order.
struct Compensated {
  double value = 0;
  double rest = 0;

  constexpr Compensated() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number>
  constexpr Compensated(Number number) : value(static_cast<double>(number)) {}  // NOLINT: a number as it is
  constexpr Compensated(double v, double r) : value(v), rest(r) {}

  constexpr Compensated operator-() const { return {-value, -rest}; }

  friend constexpr Compensated operator+(const Compensated& a, const Compensated& b) {
    const double sum = a.value + b.value, from_b = sum - a.value;
    const double error = (a.value - (sum - from_b)) + (b.value - from_b);
    const double lost = error + (a.rest + b.rest), rounded = sum + lost;
    return {rounded, lost - (rounded - sum)};
  }
  friend constexpr Compensated operator-(const Compensated& a, const Compensated& b) { return a + -b; }
  friend constexpr Compensated operator*(const Compensated& a, const Compensated& b) {
    return {a.value * b.value, a.value * b.rest + a.rest * b.value};
  }
  friend constexpr Compensated operator/(const Compensated& a, const Compensated& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.rest - quotient * b.rest) / b.value};
  }
  constexpr Compensated& operator+=(const Compensated& b) { return *this = *this + b; }
  constexpr Compensated& operator-=(const Compensated& b) { return *this = *this - b; }
  constexpr Compensated& operator*=(const Compensated& b) { return *this = *this * b; }
  constexpr Compensated& operator/=(const Compensated& b) { return *this = *this / b; }

  friend constexpr bool operator==(const Compensated& a, const Compensated& b) = default;
  friend constexpr bool operator<(const Compensated& a, const Compensated& b) {
    return a.value < b.value || (a.value == b.value && a.rest < b.rest);
  }
  friend constexpr bool operator>(const Compensated& a, const Compensated& b) { return b < a; }
  friend constexpr bool operator<=(const Compensated& a, const Compensated& b) { return !(b < a); }
  friend constexpr bool operator>=(const Compensated& a, const Compensated& b) { return !(a < b); }
};

constexpr double value_of(const Compensated& x) { return x.value; }

/// -1, 0 or 1.
constexpr Compensated sgn(const Compensated& x) { return Compensated((x.value > 0) - (x.value < 0)); }

inline Compensated abs(const Compensated& x) { return x.value < 0 ? -x : x; }

inline Compensated sin(const Compensated& x) { return {std::sin(x.value), std::cos(x.value) * x.rest}; }
inline Compensated cos(const Compensated& x) { return {std::cos(x.value), -std::sin(x.value) * x.rest}; }

}  // namespace cromer::core
