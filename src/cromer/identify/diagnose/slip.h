// Times that slip: samples that a recorder lost, or told twice, while its times went on evenly.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
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

  /// That times slip, when and by how much.
  Notice told() const;
  /// That the slip was taken out, and what `as_recorded` found of the times with it.
  Notice taken_out(const LawFit& as_recorded) const;
};

/// Whether it tells of a slip that is still in the times.
inline bool is_of_slips(const Notice& notice) { return notice.code == "times_slip"; }

/// A law with a straight spring, the viscous one or that of `fit` without its nonlinear spring where it is
/// among `others`, whose times slip once: it leaves no more than `fit` with its nonlinear spring, or clearly
/// less than `fit` without one and than a cubic spring. Slips from half a step between samples to ten are
/// found, of less than a tenth of a period, not in the first or the last twentieth of the record. A phase
/// that jumps once looks like a frequency that changes as the swing dies down. Empty where nothing slips, and
/// of more than 20,000 samples.
std::optional<TimeSlip> find_slip(const Record& record, const LawFit& fit,
                                  std::span<const LawFit> others = {}, const Watch& watch = {});

/// The same slip where a law shows it, which is fitted to the times without it; `record` still has it.
TimeSlip slip_under(const Law& law, TimeSlip slip, const Record& record, const Watch& watch = {});

/// Whether a fit of the times without the slip is as good beside it, within half a period, as elsewhere: what
/// slides for a while leaves more there. `record` has those times.
bool is_sharp(double slips_at, const Record& record, const LawFit& fit);

struct SamplesToldTwice {
  std::size_t from = 0, to = 0;  ///< the numbers of the samples before the slip that were told again after it
};

/// Takes the slip out of the times. What was told twice lies behind the first sample after the slip, and is
/// to be left out.
SamplesToldTwice take_out(const TimeSlip& slip, std::vector<double>& t);

}  // namespace cromer::core
