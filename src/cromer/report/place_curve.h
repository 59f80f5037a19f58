// From a curve's numbers to what is drawn of it.
#pragma once

#include <vector>

#include "cromer/report/axis.h"
#include "cromer/report/layout.h"

namespace cromer::core {

/// The curve's points in px, NaN where nothing can be drawn; points with x far outside the panel are left
/// out.
std::vector<Spot> spots_of(const Curve& curve, const AxisRange& x, const AxisRange& y);

/// Thinned and styled; `alone`: the panel's only curve, drawn a little wider; `phase`: exact is drawn
/// narrower.
PlacedCurve place_curve(const Curve& curve, const std::vector<Spot>& spots, bool alone, bool phase);

/// The height [px] of the name at the right: that of the curve's last peak if it still oscillates in the last
/// third, else of its end.
double height_at_end(const std::vector<Spot>& spots, const Box& frame);

}  // namespace cromer::core
