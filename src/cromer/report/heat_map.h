// A map: the place of its cells and of its colour bar, and its colours as a small PNG of 8 bits a px with a
// palette.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/report/axis.h"
#include "cromer/report/layout.h"

namespace cromer::core {

/// What the axes of a map show: from the first middle to the last, half a cell more on either side.
AxisRange map_x_range(const Panel& panel);
AxisRange map_y_range(const Panel& panel);

/// The ticks of the bar; the colours span the range.
struct MapScale {
  AxisRange range;
  std::vector<Tick> ticks;  ///< without a label: a minor one

  /// The place of z in the range: 0 darkest to 1 lightest.
  double share(double z) const;
};
MapScale map_scale(const HeatMap& map);

/// The map at every px of the frame, by the nearest cell.
PlacedMap place_map(const HeatMap& map, const AxisRange& x, const AxisRange& y, const Box& frame);

/// `values`, 0 darkest to 1 lightest, run along the columns, the lowest row first; as many as columns (>= 1)
/// times rows (>= 1). NaN is transparent.
std::string map_png(const std::vector<double>& values, int columns, int rows);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace cromer::core
