// The modes in a recording of several channels, whether random forces keep it moving or it was let go.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/modal/modal_record.h"
#include "cromer/identify/modal/spectral_matrix.h"

namespace cromer::core {

enum class ModalMotion { ambient, free_decay };

struct ModalAnalysis {
  ModalMotion motion = ModalMotion::ambient;
  std::size_t still = 0;  ///< samples left out at the beginning: at rest or held until a free motion begins
  std::size_t released = 0;         ///< the last of these: a release that took its time
  std::size_t resting = 0;          ///< samples left out at the end: a free motion has died down before them
  std::vector<MeasuredMode> modes;  ///< by rising frequency
  double decaying_share =
      0;  ///< of the power about the modes: what free motion from the first sample accounts for
  std::vector<double> lines;  // [Hz] steady oscillations among random forces: no modes
  SpectralMatrix spectrum;
  std::vector<SpectralPeak> peaks;
  std::vector<StabilityPole> poles;  ///< the stabilisation diagram
  int highest_order = 0;             ///< 0 where the record is too short to look for modes
  int lags = 0;
  double lag_step = 0;  // [s]
};

/// A free decay (or growth) is what nine tenths of the power about the modes follow, and, where a mode lasts
/// for more than a third of the record, all but 1.5 % of what is no noise; all else is ambient vibration. Its
/// modes are sought in what steady oscillations leave. No channel may be constant.
ModalAnalysis find_modes(const ModalRecord& record, const ModalSettings& settings = {});

}  // namespace cromer::core
