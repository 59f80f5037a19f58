// When a record is no oscillation that can be fitted, and how that is said.
#pragma once

#include <optional>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct Refusal {
  FitStatus status;
  Notice message;
};

/// A fit that was not made.
LawFit refused(const Refusal& refusal, const LawFitOptions& options);

/// A fit that was made and is not to be believed: what its parameters would have warned of is not said.
void refuse(LawFit& fit, const Refusal& refusal);

/// Before any fit of the law: too few samples for its parameters, nothing moves, no spring and no force.
std::optional<Refusal> refuse_record(const Record& record, const LawFitOptions& options);

/// What the viscous fit shows: a record without a line, too short, overdamped, too noisy, or with its tops
/// cut off.
std::optional<Refusal> refuse_fit(const Record& record, const LawFit& fit);

/// Says that a driven law accounts for too little of the motion.
Notice explains_too_little(const LawFit& fit);

/// A harmonic drive whose body would swing at a multiple of its frequency, undamped: that is a harmonic of
/// the steady motion, as rounding makes it, and no body.
std::optional<Refusal> refuse_harmonic(const LawFit& fit);

/// A frequency that is known to no more than a twentieth, by whatever law.
std::optional<Refusal> refuse_frequency(const LawFit& fit);

}  // namespace cromer::core
