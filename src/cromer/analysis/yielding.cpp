#include "cromer/analysis/yielding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/pi.h"
#include "cromer/base/state.h"
#include "cromer/methods/rk4.h"
#include "cromer/run/root.h"

namespace cromer::core {
namespace {

/// Between two events: on the elastic line about `offset`, or at the force of yield.
struct Branch {
  double w2, damping;    ///< w^2 and 2 zeta w
  double ground, slope;  ///< its acceleration at the beginning of the step, and how that changes
  double offset = 0;     ///< plastic displacement
  double plastic = 0;    ///< the force of yield over the mass with its sign; 0 while elastic

  double acceleration(double t, double x, double v) const {
    return -(ground + slope * t) - damping * v - (plastic != 0 ? plastic : w2 * (x - offset));
  }
  State<double> after(double h, double from, const State<double>& y) const {
    Rk4::Memory<double> none;
    return Rk4{}.step(*this, from, h, y, none).y;
  }
};

/// A whole step by Branch: what is linear, by what it makes of each unit.
struct WholeStep {
  State<double> of_x, of_v, of_ground, of_slope;

  WholeStep(double w2, double damping, double h)
      : of_x(Branch{w2, damping, 0, 0}.after(h, 0, {1, 0})),
        of_v(Branch{w2, damping, 0, 0}.after(h, 0, {0, 1})),
        of_ground(Branch{w2, damping, 1, 0}.after(h, 0, {0, 0})),
        of_slope(Branch{w2, damping, 0, 1}.after(h, 0, {0, 0})) {}

  State<double> operator()(double x, double v, double ground, double slope) const {
    return {of_x.x * x + of_v.x * v + of_ground.x * ground + of_slope.x * slope,
            of_x.v * x + of_v.v * v + of_ground.v * ground + of_slope.v * slope};
  }
};

}  // namespace

double YieldingOscillator::peak(double yield_displacement) const {
  // A hundred steps a period leave 1e-5; damping must not be stiff either.
  const double longest =
      std::min(0.01 * two_pi / w, damping_ratio > 0 ? 0.1 / (2 * damping_ratio * w) : HUGE_VAL);
  const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(spacing / longest)));
  const double h = spacing / static_cast<double>(parts);
  const double yield = w * w * yield_displacement;
  Branch branch{.w2 = w * w, .damping = 2 * damping_ratio * w, .ground = 0, .slope = 0};
  const WholeStep elastic(branch.w2, branch.damping, h), yielding(0, branch.damping, h);
  State<double> y{0, 0};
  double largest = 0;
  for (std::size_t i = 0; i + 1 < acceleration.size(); ++i) {
    branch.slope = (acceleration[i + 1] - acceleration[i]) / spacing;
    for (std::size_t part = 0; part < parts; ++part) {
      branch.ground = acceleration[i] + branch.slope * h * static_cast<double>(part);
      double from = 0;
      constexpr int most_events = 8;  // in one of a hundred parts of a period
      for (int event = 0;; ++event) {
        const double left = h - from;
        State<double> end;
        if (from > 0) {
          end = branch.after(left, from, y);
        } else if (branch.plastic != 0) {
          end = yielding(y.x, y.v, branch.ground + branch.plastic, branch.slope);
        } else {
          end = elastic(y.x - branch.offset, y.v, branch.ground, branch.slope);
          end.x += branch.offset;
        }
        // Over the force of yield, or turning back from it.
        const auto excess = [&](const State<double>& at) {
          return branch.plastic != 0 ? (branch.plastic > 0 ? -at.v : at.v)
                                     : std::abs(at.x - branch.offset) - yield_displacement;
        };
        const double before = excess(y), over = excess(end);
        if (!(over > 0) || !(before < 0) || event == most_events) {
          y = end;
          break;
        }
        const double at = find_root([&](double step) { return excess(branch.after(step, from, y)); }, 0,
                                    before, left, over);
        y = branch.after(at, from, y);
        from += at;
        largest = std::max(largest, std::abs(y.x));
        if (branch.plastic != 0) {
          branch.offset = y.x - std::copysign(yield_displacement, branch.plastic);
          branch.plastic = 0;
        } else {
          branch.plastic = std::copysign(yield, y.x - branch.offset);
        }
      }
      largest = std::max(largest, std::abs(y.x));
    }
  }
  return largest;
}

double YieldingOscillator::yield_displacement(double ductility, double elastic_peak) const {
  constexpr double ratio = 0.95, weakest = 1e-4, wanted = 1e-6;
  const auto reaches = [&](double yield) { return peak(yield) >= ductility * yield; };
  double strong = elastic_peak, weak = ratio * strong;
  // Downwards, as the ductility does not always rise with a weaker spring: the strongest that reaches it.
  while (!reaches(weak)) {
    strong = weak;
    weak *= ratio;
    if (weak < weakest * elastic_peak) return std::numeric_limits<double>::quiet_NaN();
  }
  while (strong - weak > wanted * strong) {
    const double middle = 0.5 * (weak + strong);
    (reaches(middle) ? weak : strong) = middle;
  }
  return weak;
}

}  // namespace cromer::core
