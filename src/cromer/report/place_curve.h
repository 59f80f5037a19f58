// From a curve's numbers to what is drawn of it.
#pragma once

#include <vector>

#include "cromer/report/axis.h"
#include "cromer/report/layout.h"

namespace cromer::core {

/// The curve's points in px, NaN where nothing can be drawn; points with x far outside the panel are left
/// out.
std::vector<Spot> spots_of(const Curve& curve, const AxisRange& x, const AxisRange& y);

/// A curve of the panel, thinned and styled. A panel's only curve is drawn a little wider and solid; a road
/// is narrower in a phase portrait; dots stand apart where a line is drawn, so that both are seen.
PlacedCurve place_curve(const Curve& curve, const std::vector<Spot>& spots, const Panel& panel);

/// The height [px] of the name at the right: that of the curve's last peak if it still oscillates in the last
/// third, else of its end.
double height_at_end(const std::vector<Spot>& spots, const Box& frame);

}  // namespace cromer::core
