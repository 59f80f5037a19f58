// What else oscillates in a recording, once the fitted motion is taken off.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer {

struct ResidualLine {
  double angular_frequency = 0;  // [rad/s]
  double frequency_error = 0;    // [rad/s] its standard error
  double amplitude = 0;          ///< at the first sample, in the unit of the record
  double decay_rate = 0;         // [1/s] roughly
  int harmonic = 0;              ///< 2 to 15 where it is that multiple of the swing's own frequency, to three
                                 ///< standard errors of both; else 0
};

/// Lines of the residuals' spectrum, the strongest first, at most three: each stands six times above its
/// surroundings, carries a twentieth of the residuals' power and is no skirt of the swing's own line. What
/// lies closer to that than four over the record's length (in cycles) is not told from it.
std::vector<ResidualLine> residual_lines(const Record& record, const LawFit& fit);

/// The same as sentences for the user; `unit` is the record's.
std::vector<std::string> second_modes(const Record& record, const LawFit& fit, std::string_view unit);

}  // namespace cromer
