// Complex numbers over any scalar (std::complex is defined for the floating types only).
#pragma once

namespace cromer::core {

template <class Real>
struct Complex {
  Real re{}, im{};

  friend constexpr Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend constexpr Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend constexpr Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend constexpr Complex operator*(const Real& a, const Complex& b) { return {a * b.re, a * b.im}; }

  /// Without scaling: |b|^2 must neither overflow nor underflow.
  friend constexpr Complex operator/(const Complex& a, const Complex& b) {
    const Real d = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / d, (a.im * b.re - a.re * b.im) / d};
  }
};

}  // namespace cromer::core
