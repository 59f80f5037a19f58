// How long to record until a quantity is known well enough.
//
// The fitted law itself (the normal equations of its motion) says how much a record of any length tells: in
// the long run the Cramér-Rao bounds, with all correlations. The present record's errors exceed this by
// some factor (noise that is correlated or rounded), which is assumed to stay.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {

/// A quantity and the standard uncertainty it should have.
struct Goal {
  std::string quantity;   ///< a name of the fit's parameters or derived quantities
  bool relative = false;  ///< a part of the value, not an amount
  std::string text;       ///< "0.5 %", "0.0001 1/s"
};

/// Reads "decay_rate 0.5 %" and "stiffness 0.02 N/m". An unknown name is an Error that suggests the nearest.
Result<Goal> parse_goal(std::string_view text);

struct RecordingPlan {
  std::string quantity, unit;
  double value = 0;
  double goal = 0;  ///< standard uncertainty wanted, in the quantity's unit
  double now = 0;   ///< standard uncertainty of this record
  bool met = false;
  bool possible = true;    ///< by a longer record from such a start
  double duration = 0;     // [s] that reaches the goal; if none does, beyond which nothing is gained
  double best = 0;         ///< if not possible: what the longest record gives
  double noise_ratio = 1;  ///< if not possible: how many times less noise it takes; 0: no less is enough
  double rate_ratio = 1;   ///< or how many times the samples per second, if the noise is white
  Notice text;             ///< all this in a sentence
};

/// The named quantities of a fit, with the errors that its covariance gives them.
using QuantitiesOf = std::function<std::vector<Parameter>(const LawFit& fit)>;

/// `fit` must have values and come from `record`. A goal for what this law does not have, or in a wrong unit,
/// is an Error.
Result<RecordingPlan> plan_recording(const Goal& goal, const LawFit& fit, const Record& record,
                                     const QuantitiesOf& quantities_of);

}  // namespace cromer::core
