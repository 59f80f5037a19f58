#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// What a cubic spring leaves at large swings.
struct Quintic {
  static constexpr TermInfo info{.name = "quintic",
                                 .formula = "k5 x^5",
                                 .meaning =
                                     "a spring whose stiffness changes with the fourth power of the "
                                     "displacement: what a cubic one leaves at large swings",
                                 .source = "A. H. Nayfeh & D. T. Mook, Nonlinear Oscillations, Wiley 1979"};
  static constexpr std::array coefficients{CoefficientInfo{.option = "quintic",
                                                           .parameter = "quintic",
                                                           .in_si = "quintic_stiffness",
                                                           .symbol = "k5",
                                                           .meaning = "quintic stiffness k5",
                                                           .length = -5}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::quintic};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& k5) {
    const auto square = x * x;
    return (k5 * x) * (square * square);
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& k5) {
    const auto square = x * x;
    return (k5 * square) * (square * square) * (1.0 / 6);
  }
};

}  // namespace cromer::core
