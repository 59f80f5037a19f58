#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// A spring that stiffens (or softens) with the square of the displacement.
struct Cubic {
  static constexpr TermInfo info{.name = "cubic",
                                 .formula = "k3 x^3",
                                 .meaning =
                                     "a spring that stiffens or softens: the frequency changes with the "
                                     "square of the amplitude",
                                 .source = "G. Duffing, Erzwungene Schwingungen, Vieweg 1918"};
  static constexpr std::array coefficients{CoefficientInfo{.option = "cubic",
                                                           .parameter = "cubic",
                                                           .in_si = "cubic_stiffness",
                                                           .symbol = "k3",
                                                           .meaning = "cubic stiffness k3",
                                                           .length = -3}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::cubic};

  // Two products deep, not three: from x to the next x is the longest way through a step.
  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& k3) {
    return (k3 * x) * (x * x);
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& k3) {
    return 0.25 * (k3 * (x * x)) * (x * x);
  }
};

}  // namespace cromer::core
