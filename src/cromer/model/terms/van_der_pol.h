#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// Damping that grows with the displacement; with a negative viscous term, a swing that keeps itself going.
struct VanDerPol {
  static constexpr TermInfo info{.name = "van-der-pol",
                                 .formula = "e x^2 x'",
                                 .meaning = "damping that grows with the square of the displacement",
                                 .source = "B. van der Pol, Phil. Mag. 2, 978 (1926)",
                                 .acts_at_rest = false,
                                 .bounds = true};
  static constexpr std::array coefficients{CoefficientInfo{.option = "van-der-pol",
                                                           .parameter = "van_der_pol",
                                                           .in_si = "van_der_pol_constant",
                                                           .symbol = "e",
                                                           .meaning = "damping e of x^2 x'",
                                                           .length = -3,
                                                           .time = 1}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::van_der_pol};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V& v, const P& e) {
    return (e * (x * x)) * v;
  }
};

}  // namespace cromer::core
