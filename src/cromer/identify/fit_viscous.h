// The viscous law by its closed form.
#pragma once

#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// One decaying sinusoid over the whole record, or a refusal.
LawFit fit_sinusoid(const Record& record, const LawFitOptions& options, const Watch& watch);

/// The first periods alone, of a swing whose frequency changes: the most of them that are clearly one
/// sinusoid, or the most that converge where noise leaves none clear. Empty where that is the whole record.
struct FirstPeriods {
  LawFit fit;
  std::size_t samples = 0;
  bool clear() const { return fit.explained > 0.95; }
};
std::optional<FirstPeriods> fit_first_periods(const Record& record, double angular_frequency,
                                              const LawFitOptions& options, const Watch& watch);

/// fit_sinusoid; where the first periods alone are a clear oscillation, a record that is out of step with
/// every sinusoid is none to refuse, and a notice says so.
LawFit fit_viscous(const Record& record, const LawFitOptions& options, const Watch& watch);

}  // namespace cromer::core
