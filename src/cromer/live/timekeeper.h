// Times for what arrives: the device's own, watched by the computer's clock, or counted. Pure: the clock is
// read elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "cromer/live/rows.h"

namespace cromer::core {

/// The time of a sample, and a notice if it had to be changed.
struct Stamp {
  double t;  // [s] strictly above the one before
  std::optional<Remark> notice{};
};

/// Arrivals are seconds of a clock that never jumps.
class Timekeeper {
 public:
  /// `rate` [1/s]: of samples without a time of their own; 0 where there are none.
  explicit Timekeeper(double rate = 0) : rate_(rate) {}

  /// A sample with the device's own time, which is kept. If the device's clock jumps back, or forward by 0.5
  /// s more than the computer's clock while both had kept pace, the times continue by the computer's clock. A
  /// step on both clocks of more than 0.1 s and five usual steps is a gap. A repeated time counts as a jump
  /// back. A time of 1e15 s or more is garbled: the last time and a usual step replace it, or after a silence
  /// the computer's clock; then the device's clock goes on.
  Stamp of_device(double device, double arrival);

  /// A sample without a time, at the known rate: 0 for the first, then by counting. The count begins anew at
  /// an arrival that is more than half a second away from it.
  Stamp of_count(double arrival);

  /// Seconds of the device over those of the computer since the first sample; 0 during the first two seconds.
  double pace() const;

 private:
  static constexpr std::size_t window = 64;
  double usual_step() const;
  bool keeps_pace() const;
  double rising(double t) const;  ///< above the last time, whatever the rounding
  Stamp instead_of(double device, double arrival);
  void remember(double device, double arrival, double t);
  void remember(double arrival, double t);  ///< a sample without a time of the device's

  double rate_;
  std::size_t samples_ = 0;
  double first_arrival_ = 0, first_device_ = 0;
  double last_arrival_ = 0, last_t_ = 0;
  double last_device_ = 0, device_arrival_ = 0;           // [s] the device's last time, and when it came
  double held_up_ = 0;                                    // [s] the longest that a sample came late by
  double offset_ = 0;                                     // [s] what the file's time is ahead of the device's
  double counted_from_ = 0;                               // [s] file time of the first sample of this count
  std::size_t counted_ = 0;                               // samples of this count
  std::array<double, window> steps_{}, arrival_steps_{};  // [s] the last ones
};

}  // namespace cromer::core
