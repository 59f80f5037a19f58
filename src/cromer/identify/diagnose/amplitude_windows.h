// How large a swing is, window by window, whatever its frequency does.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer {

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
    double mean = 0, squares = 0;
    std::size_t last = first;
    for (; record.t[last] < end; ++last) {
      const double change = record.y[last] - mean;
      mean += change / static_cast<double>(last - first + 1);
      squares += change * (record.y[last] - mean);
    }
    const std::size_t count = last - first;
    if (count >= at_least)
      windows.push_back({record.t[first], end, std::sqrt(2 * squares / static_cast<double>(count))});
    first = last;
  }
  return windows;
}

}  // namespace cromer
