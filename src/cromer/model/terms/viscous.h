#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// Damping in proportion to the velocity: the amplitude falls exponentially.
struct Viscous {
  static constexpr TermInfo info{
      .name = "viscous",
      .formula = "c x'",
      .meaning = "slow flow, eddy currents, a dashpot: the amplitude falls exponentially",
      .source = "G. G. Stokes, Trans. Camb. Phil. Soc. 9, 8 (1851)",
      .damps = true,
      .acts_at_rest = false};
  static constexpr std::array coefficients{CoefficientInfo{.option = "damping",
                                                           .parameter = "decay_rate",
                                                           .in_si = "damping",
                                                           .symbol = "c",
                                                           .meaning = "viscous damping c",
                                                           .length = -1,
                                                           .time = 1,
                                                           .sign = Sign::not_negative_unless_fed,
                                                           .fitted = FittedAs::half}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::damping};

  template <class T, class V, class P>
  static constexpr auto force(const T&, const V& v, const P& c) {
    return c * v;
  }
};

}  // namespace cromer::core
