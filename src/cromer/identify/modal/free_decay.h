// Modes of a structure that was let go: each channel is a sum of the same damped oscillations, with
// amplitudes and phases of its own.
#pragma once

#include <complex>
#include <vector>

#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

/// The most modes of a fit.
inline constexpr std::size_t most_decaying_modes = 10;

struct FreeDecay {
  std::vector<MeasuredMode> modes;  ///< by rising frequency
  bool converged = false;
  double share = 0;                  ///< decaying_share() of these modes
  std::vector<double> residual_rms;  ///< by channel, in its unit
};

/// How much of the channels' power about these eigenvalues [1/s] is a decay that began at the first sample:
/// near 1 of a free decay, whatever noise is elsewhere, near 0 of random forces that act for many decay
/// times.
double decaying_share(const ModalRecord& record, const std::vector<std::complex<double>>& eigenvalues);

/// Least squares over all channels at once, each weighted by what is left of it, from these start values; at
/// most most_decaying_modes of them. The amplitudes are solved for at each step (G. H. Golub & V. Pereyra,
/// SIAM J. Numer. Anal. 10, 413 (1973); L. Kaufman, BIT 15, 49 (1975)). Intervals are those of the residuals'
/// own correlation. A mode is left out whose frequency is
/// not known to 1 %, whose amplitude is less than six standard errors in each channel, or that has the shape
/// of a surer one within the mean of their widths: that is one swing which is not linear.
FreeDecay fit_free_decay(const ModalRecord& record, std::vector<std::complex<double>> eigenvalues);

}  // namespace cromer::core
