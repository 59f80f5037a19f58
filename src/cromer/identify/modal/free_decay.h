// Modes of a structure that was let go: each channel is a sum of the same damped oscillations, with
// amplitudes and phases of its own.
#pragma once

#include <vector>

#include "cromer/identify/modal/decay_fit.h"

namespace cromer::core {

/// The most modes of a fit.
inline constexpr std::size_t most_decaying_modes = 10;

struct FreeDecay {
  std::vector<MeasuredMode> modes;  ///< by rising frequency; damping ratios of modes that grow are negative
  bool converged = false;
  double share = 0;  ///< of the power about the modes (without steady ones where others are not): what the
                     ///< fit accounts for
  double unexplained = 0;  ///< of that power: what neither the fit nor noise accounts for
};

/// Least squares over all channels at once (fit_eigenvalues), each weighted by what is left of it, from these
/// start values and, while there are fewer oscillations than channels, from the peaks of what the fit leaves;
/// at most most_decaying_modes of them. Intervals are those of the residuals' own correlation.
/// An oscillation leaves the fit whose amplitude is less than four standard errors in each channel, or that
/// has the shape of a surer one within the mean of their widths: that is one swing which is not linear. Of
/// the others those are modes whose frequency is known to 1 % and whose amplitude to a sixth.
FreeDecay fit_free_decay(const ModalRecord& record, Eigenvalues eigenvalues);

}  // namespace cromer::core
