// A structure that is at rest, or held, where its recording begins.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/modal/modal_record.h"
#include "cromer/notice.h"

namespace cromer::core {

/// The samples before the motion begins: before the place at which the channels' variances most likely change
/// (D. V. Hinkley, Biometrika 57, 1 (1970)), before the last tenth and the last fewest_modal_samples, where
/// one channel has less than a quarter of what follows and every other, too, or noise alone, and on to the
/// first sample that leaves the noise before it by five standard deviations. 0 where there is no such place,
/// fewer than eight samples, or a mean that moves on in them as at a turning point.
std::size_t still_samples(const ModalRecord& record);

/// Whether the samples before `first` are no part of the free motion after it, in these modes: fitted
/// together with the motion, they leave a residual rms above three times the motion's own, and above half of
/// what they vary by: a small swing whose frequency depends on its amplitude leaves less.
bool is_still_before(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& modes);

/// Whether the modes of a whole record describe what comes after its sample `first` worse than that part's
/// own modes: by half as large a residual again (rms) in one channel.
bool is_spoilt_by(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& of_the_whole,
                  const std::vector<MeasuredMode>& of_the_part);

/// How many of a free decay's first samples, at most six periods of its slowest mode, belong to a release
/// that took its time: the motion after them, followed back, departs from them by more than noise, and
/// somewhere by thirty times its deviation. 0 where it departs by less.
std::size_t samples_of_release(const ModalRecord& record, const std::vector<MeasuredMode>& modes);

/// How many of the first samples are of another motion than the free one after sample `free`, in these modes,
/// as where a hand moves it: followed back a period and a half of the slowest, or a hundredth of the record,
/// at a time, the free motion departs there by more than ten deviations of its noise and half of what the
/// samples vary by. 0 where it does not.
std::size_t samples_of_hold(const ModalRecord& record, std::size_t free,
                            const std::vector<MeasuredMode>& modes);

/// Says when the motion begins, after `still` samples, and what is before it: nothing moves, or, where the
/// last `released` of them are of a release, it is held and let go.
Notice still_before_motion(const ModalRecord& record, std::size_t still, std::size_t released);

/// What the record holds from this sample on.
ModalRecord from_sample(const ModalRecord& record, std::size_t first);

}  // namespace cromer::core
