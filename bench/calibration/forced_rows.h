// Motions under a force: one that was recorded with them, at several spacings, or a harmonic one.
#pragma once

#include "bench/calibration/in_parallel.h"
#include "bench/calibration/tally.h"

namespace cromer::core::bench {

struct ForcedRow {
  const char* law;
  const char* condition;
  double spacing = 0.02;         // [s] of the samples
  double motion_to_noise = 100;  ///< root mean squares
  double correlation = 0;        ///< of the noise from sample to sample
  bool recorded = true;  ///< the force, which is then smooth: lines up to 12 rad/s; harmonic otherwise
  double friction = 0;   // [m/s^2] per unit mass
};

inline constexpr ForcedRow forced_rows[] = {
    {.law = "recorded force", .condition = "every 0.05 s", .spacing = 0.05},
    {.law = "recorded force", .condition = "every 0.02 s", .spacing = 0.02},
    {.law = "recorded force", .condition = "every 0.01 s", .spacing = 0.01},
    {.law = "driven", .condition = "base", .recorded = false},
    {.law = "driven", .condition = "correlated noise, 0.99", .correlation = 0.99, .recorded = false},
    {.law = "driven", .condition = "friction", .recorded = false, .friction = 0.05},
};

/// Fits `records` records with the viscous law, and friction where that acts and a fit takes it. There is no
/// bound at hand: scatter is over the root mean square of the standard errors.
Tally calibrate(const ForcedRow& row, std::size_t records, const Progress& progress);

}  // namespace cromer::core::bench
