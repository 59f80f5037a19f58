// From an axis and the data to the range it shows and the place of a value on it.
#pragma once

#include <vector>

#include "cromer/report/figure.h"
#include "cromer/report/ticks.h"

namespace cromer::core {

/// What an axis shows, mapped to px.
struct AxisRange {
  double low = 0, high = 1;
  bool logarithmic = false;
  double from = 0, to = 1;  ///< px of low and high
  double step = 0;          ///< of the ticks the range was rounded to; 0: none

  /// NaN where a logarithmic axis cannot show the value.
  double px(double value) const;
};

/// The ranges of a panel: as asked for, else from the data. x ends with the data; y gets room, and begins at
/// 0 when the data come near it; a phase portrait is centred where the data lie on both sides of 0.
AxisRange x_range(const Panel& panel);
AxisRange y_range(const Panel& panel, const AxisRange& x);

std::vector<Tick> ticks_of(const Axis& axis, const AxisRange& range, int most);

}  // namespace cromer::core
