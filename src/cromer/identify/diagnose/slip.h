// Times that slip: samples that a recorder lost, or told twice, while its times went on evenly.
#pragma once

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// The page, which must be small, looks for no slips.
#ifdef CROMER_PAGE
inline constexpr bool looks_for_slips = false;
#else
inline constexpr bool looks_for_slips = true;
#endif

/// When, by how much and which way times slip: a viscous law whose times slip once then leaves no more than
/// the fit with its nonlinear spring, or a tenth less than the fit without one and than a cubic spring. Slips
/// from half a step between samples to ten are found, of less than a tenth of a period. A phase that jumps
/// once looks like a frequency that changes as the swing dies down. Empty where nothing slips, and of more
/// than 20,000 samples.
Notice slipped_times(const Record& record, const LawFit& fit, const Watch& watch = {});

inline bool is_of_slips(const Notice& notice) { return notice.code == "times_slip"; }

}  // namespace cromer::core
