// Times that slip: samples that a recorder lost, or told twice, while its times went on evenly.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// The page, which must be small, looks for no slips.
#ifdef CROMER_PAGE
inline constexpr bool looks_for_slips = false;
#else
inline constexpr bool looks_for_slips = true;
#endif

struct TimeSlip {
  double at = 0;  // [s] the first sample that is late
  double by = 0;  // [s] by so much; negative where it is early, for samples that were lost

  /// When and by how much, with a clause for why.
  Notice notice(const char* code) const;
};

/// A viscous law whose times slip once leaves no more than `fit` with its nonlinear spring, a tenth less than
/// `fit` of a pendulum, or a tenth less than `fit` without either and than a cubic spring. Slips from half a
/// step between samples to ten are found, of less than a tenth of a period. A phase that jumps once looks
/// like a frequency that changes as the swing dies down. Empty where nothing slips, and of more than 20,000
/// samples.
std::optional<TimeSlip> find_slip(const Record& record, const LawFit& fit, const Watch& watch = {});

struct SamplesToldTwice {
  std::size_t from = 0, to = 0;  ///< the numbers of the samples before the slip that were told again after it
};

/// Takes the slip out of the times. What was told twice lies behind the first sample after the slip, and is
/// to be left out.
SamplesToldTwice take_out(const TimeSlip& slip, std::vector<double>& t);

}  // namespace cromer::core
