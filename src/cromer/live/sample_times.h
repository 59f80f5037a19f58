// Where the times of a recording came from.
#pragma once

#include <cstddef>
#include <string_view>

#include "cromer/notice.h"

namespace cromer::core {

enum class TimesBy { nothing, device, count, rate, arrival };

/// `by` is that of most samples. The numbers are of samples without a time of their own.
struct SampleTimes {
  TimesBy by = TimesBy::nothing;  ///< while nothing came
  std::size_t by_rate = 0, by_arrival = 0;
  double rate = 0;           ///< [1/s] that was found, last; 0 where none was
  double longest_delay = 0;  // [s] from what the rate says to the arrival
};

/// "device", "count", "rate" or "arrival"; "" for nothing.
std::string_view name(TimesBy by);

/// Says: "times: rate found, 100.02/s; delays up to 0.21 s; 12 of 6000 by arrival"; "" where the times are
/// the device's own, or nothing came.
Notice sentence(const SampleTimes& times);

}  // namespace cromer::core
