// A root between two signs.
#pragma once

#include "cromer/base/function_ref.h"

namespace cromer::core {

/// The place in [a, b] where f changes its sign, to rounding: the first known abscissa whose value has the
/// sign of f(b), or is zero. fa = f(a) and fb = f(b) must not have the same sign; if they do, the end with
/// the smaller |f|. Inverse quadratic interpolation where it is safe, else bisection: T. R. Chandrupatla,
/// Adv. Eng. Softw. 28, 145 (1997). About ten evaluations, never more than some sixty.
double find_root(FunctionRef<double(double)> f, double a, double fa, double b, double fb);

}  // namespace cromer::core
