// When a record is no oscillation that can be fitted, and how that is said.
#pragma once

#include <optional>

#include "cromer/identify/free_decay.h"

namespace cromer {

struct Refusal {
  FitStatus status;
  std::string message;
};

/// Before any fit of the law: too few samples for its parameters, nothing moves.
std::optional<Refusal> refuse_record(const Record& record, const Law& law);

/// What the viscous fit shows: a record without a line, too short, overdamped, too noisy, or with its tops
/// cut off.
std::optional<Refusal> refuse_fit(const Record& record, const FreeDecay& fit);

/// A frequency that is known to no more than a twentieth, by whatever law.
std::optional<Refusal> refuse_frequency(const FreeDecay& fit);

}  // namespace cromer
