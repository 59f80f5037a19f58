// The coverage of every law under every condition against the band it must keep to.
#pragma once

#include <vector>

#include "bench/calibration/tally.h"
#include "cromer/report/figure.h"

namespace cromer::core::bench {

/// One row for each condition, in it one line for each law from its worst to its best parameter.
Figure coverage_figure(const std::vector<Tally>& tallies);

}  // namespace cromer::core::bench
