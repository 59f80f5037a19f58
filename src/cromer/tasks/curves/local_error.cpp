#include "cromer/tasks/curves/local_error.h"

#include <cmath>
#include <numbers>

#include "cromer/analysis/local_error.h"
#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr int halvings = 10;
constexpr double longest_in_periods = 1.0 / 20;

/// The acceleration and its rate of change along the exact motion.
struct Force {
  double per_mass;  // [m/s^2]
  double rate;      // [m/s^3]
};

/// The rate is a difference over a length where neither rounding nor curvature shows: 1e-5 of a period, good
/// to some 1e-9.
template <class S>
Force force_at(const S& system, double t, const State<double>& y, double period) {
  const double h = 1e-5 * period;
  const State<double> before = system.propagate(t, t - h, y), after = system.propagate(t, t + h, y);
  return {system.acceleration(t, y.x, y.v),
          (system.acceleration(t + h, after.x, after.v) - system.acceleration(t - h, before.x, before.v)) /
              (2 * h)};
}

LocalErrorCurve with_predictions(const std::string& method, const LocalError& measured, const Force& force) {
  LocalErrorCurve curve;
  curve.method = method;
  curve.h = measured.step;
  for (const double error : measured.position) curve.x_error.push_back(std::abs(error));
  for (const double error : measured.velocity) curve.v_error.push_back(std::abs(error));
  curve.x_slope = measured.position_slope;
  curve.v_slope = measured.velocity_slope;
  const double h = curve.h.front(), half = h * h / 2;
  curve.x_over_predicted = curve.x_error.front() / (half * std::abs(force.per_mass));
  curve.v_over_predicted = curve.v_error.front() / (half * std::abs(force.rate));
  return curve;
}

}  // namespace

Result<LocalErrorResult> local_errors(const LocalErrorOptions& options) {
  auto runs = set_up_runs(options.simulate);
  if (!runs) return runs.error();
  LocalErrorResult result;
  for (const SimulatedRun& run : *runs) {
    if (run.general) return Error{"local_error_under_drive"};
    if (const std::string_view term = why_not_exact(run.oscillator); !term.empty())
      return Error{"local_error_without_closed_form", {{"option", term}}};
    const double period = natural_period(run.oscillator);
    if (!(period > 0)) return Error{"local_error_without_period"};
    std::vector<double> steps;
    for (int i = halvings; i >= 0; --i) steps.push_back(period * longest_in_periods * std::ldexp(1.0, -i));
    const double t = options.phase * period;
    result.curves.push_back(with_terms(run.oscillator, run.drive, [&](const auto& system) {
      if constexpr (ExactSystem<decltype(system), double>) {
        const State<double> y = system.propagate(0.0, t, run.start);
        const Force force = force_at(system, t, y, period);
        return visit_method(run.method, {}, [&](const auto& method) {
          return with_predictions(run.method, local_error(system, method, t, y, steps), force);
        });
      } else {
        return LocalErrorCurve{};
      }
    }));
  }
  return result;
}

}  // namespace cromer::core
