// From an axis and the data to the range it shows, the place of a value on it, and its ticks.
#pragma once

#include <string>
#include <vector>

#include "cromer/report/figure.h"

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

/// The range of values that an axis shows, mapped to px.
struct AxisRange {
  double low = 0, high = 1;
  bool logarithmic = false;
  double from = 0, to = 1;  ///< px of low and high
  double step = 0;          ///< of the ticks the range was rounded to; 0: none

  /// NaN if a logarithmic axis cannot show the value.
  double px(double value) const;
};

/// The ranges of a panel: as asked for, else from the data. x ends with the data, a little beyond error bars.
/// y gets room around them and begins at 0 if they come near it. A phase portrait is centred if its data lie
/// on both sides of 0.
AxisRange x_range(const Panel& panel);
AxisRange y_range(const Panel& panel, const AxisRange& x);

std::vector<Tick> ticks_of(const Axis& axis, const AxisRange& range, int most);

}  // namespace cromer::core
