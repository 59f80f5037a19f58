// The numbers that every law has, where a record cannot tell which law is right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct AmplitudeRate;
struct FittedRecording;

/// What a standard error lacks, in quadrature, because other laws fit as well: how far their numbers are from
/// the chosen law's, or how much less they know them if that is more, each law with a weight of exp(-AIC/2)
/// (K. P. Burnham, D. R. Anderson, Sociol. Methods Res. 33, 261 (2004)) that fades where BIC is between 4 and
/// 8 higher than the chosen law's. Of a law whose spring has three bends or more also what the last one
/// changed.
struct LawDoubt {
  std::string name;
  double by = 0;
};

/// Of angular_frequency and stiffness (with a mass; not where only one of two laws is hysteretic), a drive's
/// amplitude and force, derived_quantities(), decay_rate_ends() and, of the viscous law, decay_rate and
/// damping, by the alternatives_to() the chosen law. The result has its law, its samples and, if
/// driven, its motion. `force_unit` as in derived_quantities().
std::vector<LawDoubt> law_doubts(const FittedRecording& result, const std::vector<LawFit>& candidates,
                                 std::string_view force_unit = {});

/// Adds what the first and the last stretch, each fitted by itself, speak against the law's rates at the
/// ends, where these differ: how far they are from it beyond two of their standard errors, in quadrature.
void add_doubts_of_stretches(std::vector<LawDoubt>& doubts, const std::vector<AmplitudeRate>& stretches);

/// The number with the doubt of its name in standard error and interval, if there is one.
Parameter with_doubt(Parameter number, const std::vector<LawDoubt>& doubts);

/// with_doubt() for each number.
void add_doubts(std::vector<Parameter>& numbers, const std::vector<LawDoubt>& doubts);

/// The covariance of the fitted parameters, row by row: correlated as by the chosen law, with the standard
/// errors of `result`, in which the doubts are.
std::vector<double> covariance_with_doubts(const FittedRecording& result);

}  // namespace cromer::core
