// What a term of the law is: a struct with its `info`, the `force` it pulls back with, and its `energy` where
// it stores any.
//
//   m x'' = F(t) - the sum over the terms of force(x, v, coefficient)
//
// A term is written over three scalars, T of the position, V of the velocity and P of the coefficient: where
// a derivative is wanted, a dual number of one derivative stands in one of the three places and plain
// numbers in the others. That costs no more than a slope written by hand.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace cromer::core {

/// What a fit reports for a coefficient.
enum class FittedAs {
  itself,       ///< the coefficient over the mass
  half,         ///< half of it: the decay rate c/2m
  square_root,  ///< its root: the angular frequency of small swings
  not_a_force   ///< the coefficient itself, whatever the mass
};

/// What a fit reports of a coefficient per unit mass; the root of a negative one is reported as 0.
template <class T>
T as_fitted(FittedAs as, const T& coefficient) {
  using std::sqrt;
  if (as == FittedAs::half) return coefficient / T(2);
  if (as == FittedAs::square_root) return coefficient > T(0) ? T(sqrt(coefficient)) : T(0);
  return coefficient;
}

/// The coefficient per unit mass of what a fit reports.
template <class T>
T from_fitted(FittedAs as, const T& fitted) {
  if (as == FittedAs::half) return T(2) * fitted;
  if (as == FittedAs::square_root) return fitted * fitted;
  return fitted;
}

/// Which signs a coefficient may have.
enum class Sign {
  any,
  not_negative,
  not_negative_unless_fed,  ///< below 0 it feeds the swing: law.h says where it may
};

/// One coefficient of a term.
struct CoefficientInfo {
  std::string_view option;     ///< of `simulate`, "odd-quadratic"
  std::string_view parameter;  ///< of a fit, per unit mass: "odd_quadratic"
  std::string_view in_si;      ///< of a fit with a mass: "odd_quadratic_stiffness"; "" where there is none
  std::string_view symbol;     ///< in formulas, "ka"
  std::string_view meaning;    ///< in help
  int length = 0;              ///< powers of metres in its unit, beside that of a force
  int time = 0;                ///< powers of seconds, likewise
  Sign sign = Sign::any;
  FittedAs fitted = FittedAs::itself;
};

/// A term as the registry (all.h) shows it.
struct TermInfo {
  std::string_view name;     ///< as typed in a law: "odd-quadratic"
  std::string_view formula;  ///< "ka x|x|"
  std::string_view meaning;  ///< what makes such a force
  std::string_view source;
  bool damps = false;        ///< takes energy, at a positive coefficient, and never gives any
  bool acts_at_rest = true;  ///< its force depends on the position alone
  bool bounds = false;       ///< bounds the swing that a negative viscous damping feeds
};

/// All terms have the coefficients in an array of their own: `coefficients`, of CoefficientInfo, and
/// `members<Real>`, the places in an Oscillator<Real>.
template <class T>
inline constexpr std::size_t coefficients_of = T::coefficients.size();

/// A term whose force has memory: its inner state has a `rate` of its own.
template <class T>
concept HasInnerState = requires {
  T::has_inner_state;
};

/// How powers are written: "m^2", as typed, or "m²".
enum class Powers { caret, superscript };

/// "m/s²" and "1/(m² s)" from powers of units, up to the fifth; units without a name are left out.
inline std::string unit_of_powers(std::initializer_list<std::pair<std::string_view, int>> factors,
                                  Powers powers = Powers::superscript) {
  constexpr std::string_view superscripts[] = {"", "", "²", "³", "⁴", "⁵"};
  std::string above, below;
  int count_below = 0;
  for (const auto& [name, exponent] : factors) {
    if (name.empty() || exponent == 0) continue;
    const int power = exponent > 0 ? exponent : -exponent;
    std::string& side = exponent > 0 ? above : below;
    side += (side.empty() ? "" : " ") + std::string(name);
    if (power > 1)
      side += powers == Powers::caret ? "^" + std::to_string(power) : std::string(superscripts[power]);
    count_below += exponent < 0;
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (count_below > 1 ? "(" + below + ")" : below);
}

/// The SI unit of a coefficient: "N/m^3", "kg/(m^2 s)"; "1/m" of one that is not a force's.
inline std::string unit_of(const CoefficientInfo& info, Powers powers = Powers::caret) {
  if (info.fitted == FittedAs::not_a_force)
    return unit_of_powers({{"m", info.length}, {"s", info.time}}, powers);
  if (info.time == 0) return unit_of_powers({{"N", 1}, {"m", info.length}}, powers);
  // With times in it, in kilograms: N = kg m/s^2.
  return unit_of_powers({{"kg", 1}, {"m", 1 + info.length}, {"s", info.time - 2}}, powers);
}

}  // namespace cromer::core
