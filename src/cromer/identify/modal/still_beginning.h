// A structure that is at rest, or held, where its recording begins.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/modal/modal_record.h"
#include "cromer/notice.h"

namespace cromer::core {

/// The samples before the one at which the channels' variances most likely change (D. V. Hinkley, Biometrika
/// 57, 1 (1970)), in the first half: fewer than a twenty-fifth of what follows. 0 where there is no such
/// place, or fewer than four. Free motion that begins at a turning point may look so, too.
std::size_t still_samples(const ModalRecord& record);

/// Whether the samples before `first` are no part of the free motion after it, in these modes: fitted
/// together with the motion, they leave a residual rms above three times the motion's own.
bool is_still_before(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& modes);

/// Says how long nothing moves, and when the motion begins.
Notice still_before_motion(const ModalRecord& record, std::size_t still);

/// What the record holds from this sample on.
ModalRecord from_sample(const ModalRecord& record, std::size_t first);

}  // namespace cromer::core
