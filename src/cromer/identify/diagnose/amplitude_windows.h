// How large a swing is, window by window, whatever its frequency does.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/identify/describe_fit.h"

namespace cromer::core {

struct AmplitudeWindow {
  double from, to;   // [s]
  double amplitude;  ///< root two times the standard deviation within, in the record's unit
};

/// Windows of `length` [s] one after the other from the first sample; the rest that does not fill one, and
/// those of fewer than `at_least` samples, are left out.
inline std::vector<AmplitudeWindow> amplitude_windows(const Record& record, double length,
                                                      std::size_t at_least) {
  std::vector<AmplitudeWindow> windows;
  for (std::size_t first = 0; first < record.t.size();) {
    const double end = record.t[first] + length;
    if (end > record.t.back() || !(end > record.t[first])) break;  // the latter: shorter than rounding
    std::size_t last = first;
    while (record.t[last] < end) ++last;
    if (last - first >= at_least)
      windows.push_back({record.t[first], end, sinusoid_amplitude(record.y.subspan(first, last - first))});
    first = last;
  }
  return windows;
}

}  // namespace cromer::core
