// The names of a panel as a list beside the plot, each with a piece of its line.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/report/layout.h"
#include "cromer/report/place_names.h"

namespace cromer::core {

/// Whether the curve's name stands in the list.
bool stands_in_list(const Curve& curve, const Panel& panel);

/// The right margin the list needs [px]; 0 without names.
double list_margin(const Panel& panel, const TextSizes& sizes, Typeface typeface, double room);

/// The curves `which` from top to bottom, where they lie furthest apart; as given where they are nowhere all
/// drawn. `spots` holds the points of every curve [px].
std::vector<std::size_t> order_from_top(const std::vector<std::vector<Spot>>& spots,
                                        const std::vector<std::size_t>& which, const Box& frame);

/// Adds the list to `placed`. What the names do is left out where it does not fit; of more names than fit,
/// evenly chosen ones stand there.
void place_list(PlacedPanel& placed, const Panel& panel, const std::vector<std::vector<Spot>>& spots,
                const std::vector<PlacedCurve>& drawn, const TextSizes& sizes, Typeface typeface,
                double room);

}  // namespace cromer::core
