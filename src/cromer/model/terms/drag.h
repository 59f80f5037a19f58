#pragma once

#include <cmath>

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// Drag of a body in fast flow, in proportion to the square of the velocity.
struct Drag {
  static constexpr TermInfo info{.name = "drag",
                                 .formula = "d x'|x'|",
                                 .meaning = "a body in fast flow: the decay rate grows with the amplitude",
                                 .source = "I. Newton, Principia, book II (1687)",
                                 .damps = true,
                                 .acts_at_rest = false};
  static constexpr std::array coefficients{CoefficientInfo{.option = "drag",
                                                           .parameter = "drag",
                                                           .in_si = "drag_constant",
                                                           .symbol = "d",
                                                           .meaning = "quadratic drag d",
                                                           .length = -2,
                                                           .time = 2,
                                                           .sign = Sign::not_negative}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::drag};

  template <class T, class V, class P>
  static constexpr auto force(const T&, const V& v, const P& d) {
    using std::abs;
    return (d * abs(v)) * v;
  }
};

}  // namespace cromer::core
