#pragma once

#include "cromer/base/dual.h"
#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// Dry friction while it slides; what it does at rest is in model/friction.h.
struct Friction {
  static constexpr TermInfo info{.name = "friction",
                                 .formula = "f sgn(x')",
                                 .meaning = "dry friction: the amplitude falls by the same length each cycle",
                                 .source = "C. A. de Coulomb, Theorie des machines simples, 1785",
                                 .damps = true,
                                 .acts_at_rest = false};
  static constexpr std::array coefficients{CoefficientInfo{.option = "friction",
                                                           .parameter = "friction",
                                                           .in_si = "friction_force",
                                                           .symbol = "f",
                                                           .meaning = "dry friction f while it slides",
                                                           .sign = Sign::not_negative}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::friction};

  template <class T, class V, class P>
  static constexpr auto force(const T&, const V& v, const P& f) {
    return f * sgn(v);
  }
};

}  // namespace cromer::core
