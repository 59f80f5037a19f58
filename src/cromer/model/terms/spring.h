#pragma once

#include "cromer/model/oscillator.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {

/// The linear spring: part of every law but those of a body without one.
struct Spring {
  static constexpr TermInfo info{.name = "spring",
                                 .formula = "k x",
                                 .meaning = "a spring that pulls back in proportion to the displacement",
                                 .source = "R. Hooke, De potentia restitutiva, 1678"};
  static constexpr std::array coefficients{
      CoefficientInfo{.option = "stiffness",
                      .parameter = "angular_frequency",
                      .in_si = "stiffness",
                      .symbol = "k",
                      .meaning = "spring constant k; negative with a cubic is a "
                                 "double well",
                      .length = -1,
                      .fitted = FittedAs::square_root}};
  template <class Real>
  static constexpr std::array members{&Oscillator<Real>::stiffness};

  template <class T, class V, class P>
  static constexpr auto force(const T& x, const V&, const P& k) {
    return k * x;
  }
  template <class T, class P>
  static constexpr auto energy(const T& x, const P& k) {
    return 0.5 * (k * x) * x;
  }
};

}  // namespace cromer::core
