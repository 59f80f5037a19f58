// Where the ticks of an axis stand and what is written at them.
#pragma once

#include <string>
#include <vector>

namespace cromer::core {

struct Tick {
  double value = 0;
  std::string
      label;  ///< true minus sign; enhanced text ("10^{3}"); empty: a minor tick of a logarithmic axis
};

/// The smallest step of 1, 2, 2.5 or 5 times a power of ten that puts at most `most` (>= 2) ticks on [low,
/// high], low < high.
double tick_step(double low, double high, int most);

/// The multiples of `step` (> 0) on [low, high], both ends included to a millionth of a step. At most 1000.
std::vector<Tick> linear_ticks(double low, double high, double step);

/// Decades where there are at least two, thinned to at most `most` labels, minor ticks between; 1, 2, 5
/// within a shorter range. 0 < low < high.
std::vector<Tick> logarithmic_ticks(double low, double high, int most);

/// `value` as written at a tick: at most four digits, else as "2×10^{5}".
std::string tick_label(double value);

}  // namespace cromer::core
