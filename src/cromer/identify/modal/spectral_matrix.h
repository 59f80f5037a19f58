// Frequency domain decomposition: the singular values of the channels' spectral matrix, whose peaks are the
// modes (R. Brincker, L. Zhang, P. Andersen, Smart Mater. Struct. 10, 441 (2001)).
#pragma once

#include <vector>

#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

struct SpectralMatrix {
  double step = 0;                            // [Hz] between neighbouring values
  std::vector<std::vector<double>> singular;  ///< of each frequency from 0, the largest first; [unit²/Hz]
  int averages = 0;                           ///< segments, half overlapping

  double frequency(std::size_t k) const { return static_cast<double>(k) * step; }
};

/// By Welch's method with a Hann window: half-overlapping segments, none across a gap; stretches shorter than
/// a segment are left out. Each is a power of two of samples, at most the record over `segments`.
SpectralMatrix spectral_matrix(const ModalRecord& record, std::size_t segments = 16);

struct SpectralPeak {
  double frequency = 0;   // [Hz] by a parabola through the logarithms
  double prominence = 0;  ///< over the median around
};

/// The peaks of the largest singular value that stand out of what is around: by more than noise with this
/// many averages does in one record of a hundred.
std::vector<SpectralPeak> spectral_peaks(const SpectralMatrix& matrix);

}  // namespace cromer::core
