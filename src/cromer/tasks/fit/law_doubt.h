// The numbers that every law has, where a record cannot tell which law is right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct FittedRecording;

/// By how much a number of the chosen law is off from those of all laws that may be right: root mean square,
/// in its unit. A law is as likely as exp(-BIC/2) says (A. E. Raftery, Sociol. Methodol. 25, 111 (1995)).
struct LawDoubt {
  std::string name;
  double by = 0;
};

/// Of angular_frequency, stiffness (with a mass), derived_quantities() and decay_rate_ends(), by the
/// rivals_of() the chosen law. The result has its law, its samples and, if driven, its motion. `force_unit`
/// as in derived_quantities().
std::vector<LawDoubt> law_doubts(const FittedRecording& result, const std::vector<LawFit>& candidates,
                                 std::string_view force_unit = {});

/// The number with the doubt of its name in standard error and interval, if there is one.
Parameter with_doubt(Parameter number, const std::vector<LawDoubt>& doubts);

/// All of them.
void add_doubts(std::vector<Parameter>& numbers, const std::vector<LawDoubt>& doubts);

}  // namespace cromer::core
