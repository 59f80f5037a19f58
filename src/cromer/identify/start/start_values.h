// Where the least-squares iteration of a free decay begins; nothing is asked of the user.
#pragma once

#include <cstddef>
#include <optional>

#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/record.h"

namespace cromer::core {

/// What a part of the record shows, and from where the fit grows.
struct StartValues {
  Parameters phasor{};         ///< of DampedPhasor over the part
  std::size_t first = 0;       ///< sample of the record at which the part begins
  std::size_t samples = 0;     ///< in the part
  double frequency_error = 0;  // [rad/s] standard error, had the part white noise
  double rival = 0;            // [rad/s] the line that leaves least but for this one; 0 without another
  double rival_excess = 0;     ///< what it leaves more, of what this one leaves
};

/// The lines of the spectrum, each fitted with its decay to the samples at their own times: the one that
/// leaves least begins the fit. A motion of few periods is searched for on a grid instead. Times may be
/// uneven and have gaps. Empty where nothing moves. `record` has at least 8 samples.
std::optional<StartValues> find_start_values(const Record& record);

/// Start values of the part grown about eightfold, or to the whole record: the frequency is searched for
/// between as many cycles as its error leaves open. `start` is not the whole record.
StartValues grown(const Record& record, const StartValues& start);

/// Standard error of the angular frequency [rad/s] at a phasor's minimum, had the samples white noise.
double frequency_error(const LeastSquaresSummary& minimum, std::size_t samples);

}  // namespace cromer::core
