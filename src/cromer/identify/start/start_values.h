// Where the least-squares iteration of a free decay begins; nothing is asked of the user.
#pragma once

#include <cstddef>
#include <optional>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/record.h"

namespace cromer {

struct StartValues {
  Parameters phasor{};      ///< of DampedPhasor over the whole record
  std::size_t samples = 0;  ///< of the record's first part, from which they come; the fit grows from there
};

/// The strongest spectral line gives the frequency; the decay rate is the best of a grid, with equilibrium
/// and amplitudes by linear least squares. Times may be uneven. Empty where the spectrum has no line.
/// `record` has at least 8 samples.
std::optional<StartValues> find_start_values(const Record& record);

}  // namespace cromer
