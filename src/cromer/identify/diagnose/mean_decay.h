// The decay rate that all damping terms of a law make together, where a record knows it best.
#pragma once

#include <optional>
#include <string>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct MeanDecay {
  double amplitude = 0;  ///< of a lasting sinusoid as strong as the law's motion, in the displacement's unit
  Estimate rate;         // [1/s] of the amplitude there, averaged over a cycle
  std::string unit{};    ///< of the amplitude, for sentences; "" if it is not known
};

/// The rate and, by the covariance of its terms, its uncertainty; a fit with values, and its record. Empty
/// for a hysteretic law, whose loops depend on the motion's history.
std::optional<MeanDecay> mean_decay(const LawFit& fit, const Record& record);

/// True if two damping terms are traded for each other: their estimates' correlation is below -0.9.
bool dampings_are_collinear(const LawFit& fit);

/// True if negative damping surely feeds the swing.
bool is_fed(const LawFit& fit);

/// A clause: "decay rate 0.0123 ± 0.0004 1/s at the swing's rms amplitude, 0.038 m".
Notice as_clause(const MeanDecay& decay);

}  // namespace cromer::core
