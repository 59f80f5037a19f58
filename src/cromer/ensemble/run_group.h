// A group of points, run until their motion has settled, or to an end.
#pragma once

#include <optional>
#include <span>

#include "cromer/base/interrupt.h"
#include "cromer/ensemble/dispatch.h"
#include "cromer/ensemble/group.h"
#include "cromer/ensemble/point.h"

namespace cromer::core {

/// Fills the group with the points at their starts; spare places repeat the last point.
void fill_group(std::span<const Point> points, cromer_group::Group& group);

/// An order for the unit: the number of steps, and weights (one for each step) for the sums, or nullptr.
cromer_group::Order order_of(const Stepping& stepping, long long steps, const double* weights = nullptr);

/// When a driven motion counts as settled, and how long that may take.
struct Settling {
  /// Cycles of the drive that are dropped, at least; then one window is measured, settled or not. Empty:
  /// runs until the motion has settled.
  std::optional<double> dropped{};
  double tolerance = 1e-6;   ///< relative error that amplitude and energy may still have
  double most_cycles = 2e4;  ///< of the drive, after which it gives up
  double window = 8;         ///< cycles over which amplitude, phase, peak and energy are measured, >= 4
};

/// Runs up to cromer_group::size driven points (drive amplitude and frequency > 0) until they have settled.
///
/// Amplitude and phase are those of a least-squares sinusoid over a window of cycles with smooth weights, so
/// that overtones and what is left of the free motion do not leak in. From window to window their change
/// falls as the free motion does; a motion has settled when the changes still to come, a geometric series,
/// sum up to less than the tolerance. False: interrupted.
bool settle_group(const KernelUnit& unit, std::span<const Point> points, const Stepping& stepping,
                  const Settling& settling, std::span<PointResult> results, const Watch& watch = {});

/// Runs up to cromer_group::size points each from 0 to its own end [s] > 0; one that is not a whole number
/// of steps is reached by a shorter one. Amplitude and phase of driven points are left out. False:
/// interrupted.
bool run_group(const KernelUnit& unit, std::span<const Point> points, const Stepping& stepping,
               std::span<const double> until, std::span<PointResult> results, const Watch& watch = {});

}  // namespace cromer::core
