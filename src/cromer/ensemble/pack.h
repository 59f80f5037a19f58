// A pack: as many doubles as a vector register of one instruction set holds, as a scalar for laws and
// methods.
//
// Only units compiled for that instruction set may include this (units/unit.h).
#pragma once

#include <cstddef>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "cromer/base/dual.h"
#include "cromer/base/magnitude.h"

namespace cromer::core {

/// A yes or no for each lane.
template <class Arch>
struct Mask {
  xsimd::batch_bool<double, Arch> lanes;

  Mask(bool truth = false) : lanes(truth) {}  // NOLINT: the same in every lane
  explicit Mask(const xsimd::batch_bool<double, Arch>& truths) : lanes(truths) {}

  /// Both sides are evaluated.
  friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.lanes & b.lanes); }
  friend Mask operator||(const Mask& a, const Mask& b) { return Mask(a.lanes | b.lanes); }
  friend bool all(const Mask& m) { return xsimd::all(m.lanes); }
};

/// Operations act on each lane by itself.
template <class Arch>
struct Pack {
  using Batch = xsimd::batch<double, Arch>;
  static constexpr std::size_t size = Batch::size;

  Batch lanes;

  Pack() = default;
  Pack(double number) : lanes(number) {}  // NOLINT: the same in every lane
  explicit Pack(const Batch& batch) : lanes(batch) {}

  /// From and to `size` doubles.
  static Pack load(const double* from) { return Pack(Batch::load_unaligned(from)); }
  void store(double* to) const { lanes.store_unaligned(to); }

  Pack operator-() const { return Pack(-lanes); }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes + b.lanes); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes - b.lanes); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes * b.lanes); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes / b.lanes); }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  Pack& operator/=(const Pack& b) { return *this = *this / b; }

  /// Cosine and sine of each lane. Out of line: asked for once in many steps, it would crowd their loop.
  [[gnu::noinline]] friend std::pair<Pack, Pack> cosine_and_sine(const Pack& a) {
    const auto both = xsimd::sincos(a.lanes);
    return {Pack(both.second), Pack(both.first)};
  }

  friend Mask<Arch> operator<(const Pack& a, const Pack& b) { return Mask<Arch>(a.lanes < b.lanes); }
  friend Mask<Arch> operator>(const Pack& a, const Pack& b) { return Mask<Arch>(a.lanes > b.lanes); }
  friend Mask<Arch> operator<=(const Pack& a, const Pack& b) { return Mask<Arch>(a.lanes <= b.lanes); }
  friend Mask<Arch> operator>=(const Pack& a, const Pack& b) { return Mask<Arch>(a.lanes >= b.lanes); }

  friend Pack value_of(const Pack& a) { return a; }
  friend Pack abs(const Pack& a) { return Pack(xsimd::abs(a.lanes)); }
  friend Pack larger(const Pack& a, const Pack& b) { return Pack(xsimd::max(a.lanes, b.lanes)); }
  friend Pack smaller(const Pack& a, const Pack& b) { return Pack(xsimd::min(a.lanes, b.lanes)); }
  friend Pack cos(const Pack& a) { return Pack(xsimd::cos(a.lanes)); }
  friend Pack sin(const Pack& a) { return Pack(xsimd::sin(a.lanes)); }
  friend Pack choose(const Mask<Arch>& truth, const Pack& yes, const Pack& no) {
    return Pack(xsimd::select(truth.lanes, yes.lanes, no.lanes));
  }
  /// -1, 0 or 1.
  friend Pack sgn(const Pack& a) {
    return choose(a > 0.0, Pack(1), Pack(0)) - choose(a < 0.0, Pack(1), Pack(0));
  }
};

}  // namespace cromer::core
