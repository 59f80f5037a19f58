#pragma once

#include <cmath>

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// A spring whose stiffness changes with the displacement itself, the same to both sides.
struct OddQuadratic {
  static constexpr TermInfo info{.name = "odd-quadratic",
                                 .formula = "ka x|x|",
                                 .meaning =
                                     "micro-slip where a spring is clamped: the frequency changes in "
                                     "proportion to the amplitude",
                                 .source = "L. E. Goodman & J. H. Klumpp, J. Appl. Mech. 23, 421 (1956)"};
  static constexpr std::array coefficients{CoefficientInfo{.option = "odd-quadratic",
                                                           .parameter = "odd_quadratic",
                                                           .in_si = "odd_quadratic_stiffness",
                                                           .symbol = "ka",
                                                           .meaning = "odd quadratic stiffness ka, of x|x|",
                                                           .length = -2}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::odd_quadratic};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& ka) {
    using std::abs;
    return (ka * x) * abs(x);
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& ka) {
    using std::abs;
    return (ka * (x * x)) * abs(x) * (1.0 / 3);
  }
};

}  // namespace cromer::core
