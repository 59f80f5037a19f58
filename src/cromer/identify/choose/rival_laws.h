// Laws that a record speaks against no more than against the one chosen, and that would change its numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// What to say of them; empty where no rival is left. A rival lies within 6 of the chosen candidate's BIC
/// (see criterion.h), has as many terms or one more (of a driven motion one more only with a lower
/// criterion), and puts a coefficient that both share, or the frequency, further off than three of the
/// standard errors that the chosen one claims; or it has another damping in the place of its own.
Notice rival_laws(const Record& record, const std::vector<LawFit>& candidates, std::size_t chosen);

}  // namespace cromer::core
