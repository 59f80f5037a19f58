// Texts of a study with results in them: "k = {two.stiffness}".
#pragma once

#include <string>
#include <string_view>

#include "cromer/result.h"
#include "cromer/study/results.h"

namespace cromer::core {

/// Replaces each {name, modifier, ...} by its result. Modifiers: a whole number (significant digits), a unit
/// ("cm", "%", "mJ": converted to), "bare" (without unit), "no ±" (without uncertainty), "concise" (the
/// uncertainty in brackets behind the last digit), "signed" (a leading
/// + or minus), "si" (the value alone, exact, for options), "abs". A name that begins with a point is taken
/// relative to `scope`: {.label}. A brace is written {{; one behind _ or ^ is markup and stays. An unknown
/// name or modifier is an Error.
Result<std::string> fill(std::string_view text, const Results& results, std::string_view scope = "");

}  // namespace cromer::core
