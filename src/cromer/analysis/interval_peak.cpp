#include "cromer/analysis/interval_peak.h"

#include <numbers>
#include <utility>

namespace cromer::core {
namespace {

/// q and its first three derivatives.
struct Derivatives {
  double q, slope, bend, twist;
};

/// The quantity of a motion inside an interval.
struct ResponseInside {
  const LinearLaw<double>& law;
  const ResponseQuantity<double>& quantity;
  const IntervalMotion& motion;

  Derivatives at(double t) const {
    const IntervalMotion here(law, propagate_ramp(law, motion.f, motion.slope, t, motion.y),
                              motion.f + motion.slope * t, motion.slope);
    return of(here);
  }
  Derivatives of(const IntervalMotion& m) const {
    const double snap = -2 * law.decay_rate * m.jerk - law.stiffness * m.acceleration;
    return {quantity.x * m.y.x + quantity.v * m.y.v, quantity.x * m.y.v + quantity.v * m.acceleration,
            quantity.x * m.acceleration + quantity.v * m.jerk, quantity.x * m.jerk + quantity.v * snap};
  }
};

/// The root between a and b of a function whose values there, fa and fb, differ in sign: by Newton's steps,
/// or bisection where they leave the bracket. `function(t)` returns value and derivative.
template <class Function>
double root_between(double a, double fa, double b, double fb, double to_within, const Function& function) {
  double t = a + (b - a) * (fa / (fa - fb));
  for (int i = 0; i < 60; ++i) {
    const auto [value, derivative] = function(t);
    if (value == 0) return t;
    ((value < 0) == (fa < 0) ? a : b) = t;
    const double next = t - value / derivative;
    const bool inside = next > a && next < b;
    const double before = t;
    t = inside ? next : a + (b - a) / 2;
    if (std::abs(t - before) <= to_within || b - a <= to_within) return t;
  }
  return t;
}

/// The extreme on a stretch where q' is monotone.
void include_turn(const ResponseInside& response, double a, const Derivatives& at_a, double b,
                  const Derivatives& at_b, double to_within, Extremes& range) {
  if (!((at_a.slope < 0 && at_b.slope > 0) || (at_a.slope > 0 && at_b.slope < 0))) return;
  root_between(a, at_a.slope, b, at_b.slope, to_within, [&](double u) {
    const Derivatives here = response.at(u);
    range.include(here.q);
    return std::pair{here.slope, here.bend};
  });
}

}  // namespace

void include_inside(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity,
                    const IntervalMotion& motion, const State<double>& y_end, double h, Extremes& range) {
  const ResponseInside response{law, quantity, motion};
  const Derivatives begin = response.of(motion);
  const Derivatives end = response.of(IntervalMotion(law, y_end, motion.f + motion.slope * h, motion.slope));
  const double to_within = 1e-7 * h;  // q is flat where it turns: good to 1e-14
  if ((begin.bend < 0) == (end.bend < 0)) {
    include_turn(response, 0, begin, h, end, to_within, range);
    return;
  }
  // q'' swings freely and vanishes at most once in half a period: q' turns there.
  const double bend = root_between(0, begin.bend, h, end.bend, to_within, [&](double u) {
    const Derivatives here = response.at(u);
    return std::pair{here.bend, here.twist};
  });
  const Derivatives middle = response.at(bend);
  include_turn(response, 0, begin, bend, middle, to_within, range);
  include_turn(response, bend, middle, h, end, to_within, range);
}

void include_free(const LinearLaw<double>& law, const ResponseQuantity<double>& quantity,
                  const State<double>& y, Extremes& range) {
  const ResponseInside response{law, quantity, IntervalMotion(law, y, 0, 0)};
  const Derivatives begin = response.of(response.motion);
  range.include(begin.q);
  range.include(0);
  // q' moves as the law does, from q'(0) with the slope q''(0): it vanishes where
  // tan(w t) = -w q'(0)/(q''(0) + b q'(0)), w the damped frequency, or tanh beyond critical damping.
  const double b = law.decay_rate, discriminant = law.stiffness - b * b;
  const double w = std::sqrt(std::abs(discriminant));
  const double across = -begin.slope, along = begin.bend + b * begin.slope;
  if (across == 0 && along == 0) return;
  if (discriminant > 0) {
    double angle = std::atan2(w * across, along);
    if (angle < 0) angle += std::numbers::pi;
    range.include(response.at(angle / w).q);
    range.include(response.at((angle + std::numbers::pi) / w).q);
    return;
  }
  const double ratio = across / along;
  if (discriminant == 0) {
    if (ratio > 0 && std::isfinite(ratio)) range.include(response.at(ratio).q);
  } else if (w * ratio > 0 && w * ratio < 1) {
    range.include(response.at(std::atanh(w * ratio) / w).q);
  }
}

}  // namespace cromer::core
