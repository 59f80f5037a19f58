// Many records fitted, and the fits held against the truth.
#pragma once

#include "bench/calibration/in_parallel.h"
#include "bench/calibration/simulated_record.h"
#include "bench/calibration/tally.h"

namespace cromer::core::bench {

/// Fits `records` records with the true law, on all processors. The tally does not depend on their number.
Tally calibrate(const TrueLaw& law, const Condition& condition, std::size_t records,
                const Progress& progress);

/// How often `auto` chose what is there.
struct Choices {
  const char* law = "";
  const char* condition = "";
  std::size_t records = 0;
  double strength = 0;  ///< standard errors that the weakest of the law's terms is worth, on average
  double right = 0;     ///< share that chose exactly the true law
  double needless = 0;  ///< share with a term that is not there
  double missed = 0;    ///< share without a term that is there
};

/// The same for the choice of the law; the terms besides viscous damping weakened to `strength` standard
/// errors each, where that is not 0.
Choices choose(const TrueLaw& law, const Condition& condition, double strength, std::size_t records,
               const Progress& progress);

}  // namespace cromer::core::bench
