#pragma once

#include <cmath>

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// Gravity on a pendulum in place of a spring; x is an angle [rad].
struct Pendulum {
  static constexpr TermInfo info{.name = "pendulum",
                                 .formula = "p sin x",
                                 .meaning =
                                     "gravity on a pendulum, x an angle: the frequency falls with the "
                                     "amplitude",
                                 .source = "C. Huygens, Horologium oscillatorium, 1673"};
  static constexpr std::array coefficients{CoefficientInfo{.option = "pendulum",
                                                           .parameter = "angular_frequency",
                                                           .in_si = "",
                                                           .symbol = "p",
                                                           .meaning = "force p of p sin x, x an angle",
                                                           .fitted = FittedAs::square_root}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::pendulum};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& p) {
    using std::sin;
    return p * sin(x);
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& p) {
    using std::sin;
    const auto half = sin(0.5 * x);
    return 2.0 * p * (half * half);
  }
};

}  // namespace cromer::core
