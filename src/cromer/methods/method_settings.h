// What a run may set of its method.
#pragma once

#include "cromer/methods/generalized_alpha.h"
#include "cromer/methods/newmark.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

/// Each method takes those it uses.
struct MethodSettings {
  NewtonOptions newton;
  double beta = Newmark{}.beta;                 ///< of newmark, 0 to 1
  double gamma = Newmark{}.gamma;               ///< of newmark, 0 to 1
  double rho_inf = GeneralizedAlpha{}.rho_inf;  ///< of generalized-alpha, 0 to 1

  friend bool operator==(const MethodSettings&, const MethodSettings&) = default;
};

}  // namespace cromer::core
