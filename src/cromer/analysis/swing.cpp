#include "cromer/analysis/swing.h"

#include <algorithm>

#include "cromer/base/state.h"
#include "cromer/methods/rk4.h"
#include "cromer/model/law_force.h"

namespace cromer::core {
namespace {

struct FreeSystem {
  Oscillator<double> per_mass;
  Law present;

  double acceleration(double /*t*/, double x, double v) const {
    return -restoring_force<any_terms>(per_mass, present, x) -
           resisting_force<any_terms>(per_mass, present, x, v) - per_mass.friction * sgn(v);
  }
};

// The next turning point on the same side, within ten periods, of a motion that starts at rest at A > 0.
std::optional<double> next_turning_point(const FreeSystem& system, double A, double period) {
  constexpr int steps = 1000;  // of a period
  const double h = period / steps;
  State<double> y{A, 0};
  NoMemory memory;
  bool returns = false;
  for (int i = 0; i < 10 * steps; ++i) {
    y = Rk4{}.step(system, 0.0, h, y, memory).y;
    if (!std::isfinite(y.x)) return std::nullopt;
    returns = returns || y.v > 0;
    // A step past it: the parabola of position, velocity and acceleration.
    if (returns && y.v <= 0) return y.x - y.v * y.v / (2 * system.acceleration(0, y.x, y.v));
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> limit_cycle_amplitude(const Oscillator<double>& per_mass, double near, double period) {
  const FreeSystem system{per_mass, law_of(per_mass)};
  const auto growth = [&](double A) -> std::optional<double> {
    const auto next = next_turning_point(system, A, period);
    if (!next || !(*next > 0)) return std::nullopt;
    return std::log(*next / A);
  };
  double before = near, now = 1.02 * near;
  std::optional<double> then = growth(before);
  for (int i = 0; i < 30 && then; ++i) {
    const std::optional<double> here = growth(now);
    if (!here) return std::nullopt;
    if (*here == *then) return std::abs(*here) < 1e-9 ? std::optional(now) : std::nullopt;
    // A step of the logarithm, by a factor of two at most.
    const double step = std::clamp(-*here * std::log(now / before) / (*here - *then), -0.7, 0.7);
    before = now;
    then = here;
    now *= std::exp(step);
    if (std::abs(step) < 1e-10) return now;
  }
  return std::nullopt;
}

}  // namespace cromer::core
