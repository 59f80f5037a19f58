// How long to record until a quantity is known as well as wanted.
//
// The information that a record of any length would hold is computed from the fitted law itself (the normal
// equations of its motion): in the long run the bounds of theory.md, with all correlations. What the present
// record's errors exceed it by (noise that is correlated or rounded) is taken to stay as it is.
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
  bool relative = false;  ///< `uncertainty` is a part of the value
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
  bool possible = true;  ///< by a longer record from such a start
  double duration = 0;   // [s] that reaches the goal; where none does, beyond which nothing is gained
  double best = 0;       ///< where it is not possible: what the longest record gives
  double noise_ratio =
      1;  ///< where it is not possible: how many times less noise it takes; 0: no less would do
  double rate_ratio = 1;  ///< or how many times the samples per second, if their noise is white
  Notice text;            ///< all this in a sentence
};

/// The named quantities of a fit, with the errors that its covariance gives them.
using QuantitiesOf = std::function<std::vector<Parameter>(const LawFit& fit)>;

/// `fit` has values; `record` is the one it came from. A goal for what this law does not have, or in a wrong
/// unit, is an Error.
Result<RecordingPlan> plan_recording(const Goal& goal, const LawFit& fit, const Record& record,
                                     const QuantitiesOf& quantities_of);

}  // namespace cromer::core
