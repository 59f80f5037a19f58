#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// A spring that is not the same to both sides.
struct Quadratic {
  static constexpr TermInfo info{
      .name = "quadratic",
      .formula = "k2 x^2",
      .meaning =
          "a spring that is not the same to both sides: a second harmonic, and a "
          "mean that moves with the amplitude",
      .source = "H. von Helmholtz, Die Lehre von den Tonempfindungen, Vieweg 1863"};
  static constexpr std::array coefficients{CoefficientInfo{.option = "quadratic",
                                                           .parameter = "quadratic",
                                                           .in_si = "quadratic_stiffness",
                                                           .symbol = "k2",
                                                           .meaning = "quadratic stiffness k2",
                                                           .length = -2}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::quadratic};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& k2) {
    return k2 * (x * x);
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& k2) {
    return (k2 * (x * x)) * x * (1.0 / 3);
  }
};

}  // namespace cromer::core
