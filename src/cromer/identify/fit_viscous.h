// The viscous law by its closed form.
#pragma once

#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// One decaying sinusoid over the whole record, or a refusal.
LawFit fit_sinusoid(const Record& record, const LawFitOptions& options, const Watch& watch);

/// A fit of the first periods alone, of a swing whose frequency changes: of as many as are clearly one
/// sinusoid or, where noise leaves none clear, as many as converge. Empty where that is the whole record.
struct FirstPeriods {
  LawFit fit;
  std::size_t samples = 0;
  bool clear() const { return fit.explained > 0.95; }
};
std::optional<FirstPeriods> fit_first_periods(const Record& record, double angular_frequency,
                                              const LawFitOptions& options, const Watch& watch);

/// As fit_sinusoid, but a record that is out of step with every sinusoid is not refused where its first
/// periods are a clear oscillation: a notice says so.
LawFit fit_viscous(const Record& record, const LawFitOptions& options, const Watch& watch);

}  // namespace cromer::core
