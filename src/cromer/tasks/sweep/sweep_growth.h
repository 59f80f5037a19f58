// Points whose motion has no end to settle at: a linear law's free motion grows by itself, or by the method.
#pragma once

#include <limits>
#include <optional>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/ensemble/point.h"
#include "cromer/model/law.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {

/// Per unit mass, with its drive.
LinearLaw<double> linear_law(const Point& point);

/// The free motion of a linear law, as the method has it, grows without end. A method that is exact, or
/// chooses its steps, has the law's own.
template <class M>
bool grows(const M& method, const Point& point) {
  if constexpr (M::info.order > 0 && M::info.error_order == 0) {
    LinearLaw<double> law = linear_law(point);
    law.drive_amplitude = 0;
    const EffectiveOscillator effective = effective_oscillator(method, law, point.step);
    // Of a free mass x grows with the time alone: both eigenvalues are 1, to the root of rounding.
    const double rounding = law.stiffness == 0 ? 1e-8 : 1e-12;
    return effective.spectral_radius > 1 + rounding;
  } else {
    return point.oscillator.stiffness < 0 || point.oscillator.damping < 0;
  }
}

/// The decay rate of the free motion [1/s] that the method has of an undamped linear law: its own damping.
/// Empty where nothing oscillates.
std::optional<double> own_decay_rate(const SweepWork& work, const MethodSettings& settings,
                                     const Point& point);

/// Tells of a stepped result what stepping alone cannot see. A linear law that grows is unstable: not just
/// unsettled, run away, or measured after --settle. Where the law takes no energy the free motion stays,
/// though the amplitude at the drive's frequency may not show it: that counts as settled only if the method's
/// own damping had the time for it.
void name_status(const SweepWork& work, const MethodSettings& settings, const Point& point,
                 PointResult& result);

}  // namespace cromer::core
