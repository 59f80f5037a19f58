// The words of a panel: names at the right, inside or in a list beside the plot, notes and markers.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/report/axis.h"
#include "cromer/report/layout.h"

namespace cromer::core {

/// Whether the curve's name stands in the right margin.
bool stands_outside(const Curve& curve, const Panel& panel);

/// The curve's height at px `x`, by linear interpolation; NaN where it has none.
double height_at(const std::vector<Spot>& spots, double x);

/// The lines of a name and its remark, and how wide they are.
struct NameBlock {
  std::vector<PlacedText> lines;  ///< only text, size, colour, bold
  double width = 0, height = 0;
};
NameBlock name_block(const Curve& curve, const TextSizes& sizes, Typeface typeface, double room);

/// The right margin the names of a panel need [px]; 0 without names outside.
double names_margin(const Panel& panel, const TextSizes& sizes, Typeface typeface, double room);

/// Adds the key's curves to `placed`, each with its look before its name, in rows from the top of `room` on.
/// Gives their height.
double place_key(PlacedPanel& placed, const std::vector<Curve>& key, const Box& room, const TextSizes& sizes,
                 Typeface typeface);

/// Adds texts, leaders, rings and dots to `placed`, whose frame and curves are there already. `cell` is the
/// panel's whole place, `spots` the points of each curve. The words do not overlap each other while there is
/// room; `crowded` says whether the names inside found good places.
void place_words(PlacedPanel& placed, const Panel& panel, const std::vector<std::vector<Spot>>& spots,
                 const AxisRange& x, const AxisRange& y, const Box& cell, const TextSizes& sizes,
                 Typeface typeface);

/// Whether the curve's name stands in the list.
bool stands_in_list(const Curve& curve, const Panel& panel);

/// The curves `which` from top to bottom, in their order where they lie furthest apart. If there is no x at
/// which all are drawn, the order stays as given. `spots` holds the points of every curve [px].
std::vector<std::size_t> order_from_top(const std::vector<std::vector<Spot>>& spots,
                                        const std::vector<std::size_t>& which, const Box& frame);

}  // namespace cromer::core
