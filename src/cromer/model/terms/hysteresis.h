#pragma once

#include <cmath>

#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// A force z that depends on the way by which the motion came where it is: z' = A x' - beta |x'| |z|^(n-1) z
/// - gamma x' |z|^n.
struct Hysteresis {
  static constexpr TermInfo info{
      .name = "hysteresis",
      .formula = "z, z' = A x' - beta |x'| z - gamma x'|z|",
      .meaning = "slip in joints and structures: loops of force against displacement",
      .source =
          "R. Bouc, Proc. 4th Conf. Nonlinear Oscill. Prague, 315 (1967); Y.-K. "
          "Wen, J. Eng. Mech. Div. ASCE 102, 249 (1976)",
      .acts_at_rest = false};
  static constexpr std::array coefficients{
      CoefficientInfo{.option = "hysteresis-stiffness",
                      .parameter = "hysteresis_stiffness",
                      .in_si = "hysteresis_force_stiffness",
                      .symbol = "A",
                      .meaning = "stiffness A of the hysteretic force where it begins",
                      .length = -1},
      CoefficientInfo{
          .option = "hysteresis-beta",
          .parameter = "hysteresis_beta",
          .in_si = "",
          .symbol = "beta",
          .meaning = "how soon the hysteretic force gives way, beta (N^(1-n)/m with an exponent n)",
          .length = -1,
          .fitted = FittedAs::not_a_force},
      CoefficientInfo{.option = "hysteresis-gamma",
                      .parameter = "hysteresis_gamma",
                      .in_si = "",
                      .symbol = "gamma",
                      .meaning = "what sets the shape of its loops, gamma (N^(1-n)/m)",
                      .length = -1,
                      .fitted = FittedAs::not_a_force}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::hysteresis_stiffness,
                                      &Oscillator<Real>::hysteresis_beta,
                                      &Oscillator<Real>::hysteresis_gamma};
  static constexpr bool has_inner_state = true;

  /// What beta and gamma are multiplied by where z becomes a force per unit mass.
  template <class Real>
  static Real shape_per_mass(const Real& mass, double exponent) {
    using std::pow;
    return exponent == 1 ? Real(1) : Real(pow(mass, exponent - 1));
  }

  /// z' [N/s] at a velocity v and a force z. Duals may stand in one of the places v, z and the coefficients.
  template <class V, class Z, class A, class B, class G>
  static auto rate(const V& v, const Z& z, const A& stiffness, const B& beta, const G& gamma,
                   double exponent) {
    using std::abs, std::pow;
    if (exponent == 1) return stiffness * v - (beta * abs(v)) * z - (gamma * v) * abs(z);
    const auto power = pow(abs(z), exponent);
    return stiffness * v - (beta * abs(v)) * (sgn(z) * power) - (gamma * v) * power;
  }
};

}  // namespace cromer::core
