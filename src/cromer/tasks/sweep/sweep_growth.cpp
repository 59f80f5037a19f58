#include "cromer/tasks/sweep/sweep_growth.h"

#include <cmath>
#include "cromer/model/linear_quantities.h"

#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"

namespace cromer::core {

LinearLaw<double> linear_law(const Point& point) { return linear_law(point.oscillator, point.drive); }

std::optional<double> own_decay_rate(const SweepWork& work, const MethodSettings& settings,
                                     const Point& point) {
  LinearLaw<double> law = linear_law(point);
  law.drive_amplitude = 0;
  return visit_method(work.method, settings, [&]<class M>(const M& method) -> std::optional<double> {
    if constexpr (M::info.order > 0 && M::info.error_order == 0)
      return effective_oscillator(method, law, point.step).decay_rate;
    else
      return 0.0;
  });
}

void name_status(const SweepWork& work, const MethodSettings& settings, const Point& point,
                 PointResult& result) {
  if (work.runs_to_end()) return;
  const Oscillator<double>& o = point.oscillator;
  if (o.friction != 0 || result.status == PointStatus::no_convergence) return;
  if (is_linear(law_of(o)) &&
      visit_method(work.method, settings, [&](const auto& method) { return grows(method, point); })) {
    result.status = PointStatus::unstable;
    return;
  }
  if (law_of(o).shares(terms_of_velocity) || work.settling.dropped || !has_numbers(result.status)) return;
  // Of a law that is not linear the decay of small motions.
  const double rate = o.stiffness > 0 ? own_decay_rate(work, settings, point).value_or(0) : 0;
  const bool decayed = rate * result.end_time > -std::log(work.settling.tolerance);
  result.status = decayed ? PointStatus::own_damping : PointStatus::not_settled;
}

}  // namespace cromer::core
