// A place inside a plot from which a name is read without doubt.
#pragma once

#include <cstddef>
#include <vector>

#include "cromer/report/labels.h"

namespace cromer::core {

/// What a name inside must keep clear of.
struct Drawn {
  Occupancy all;                          ///< curves, words, leader lines, and lines to read by
  Occupancy inked;                        ///< the same without lines to read by
  std::vector<std::vector<Spot>> curves;  ///< of the panel, each; empty where it is a line to read by
};

/// A place for the name of curve `own`: on nothing, its leader line short and crossing nothing, and without a
/// leader line closer to its own curve than to any other. First at one of `wanted`, then where the curve
/// stands apart from the others. Covers lines to read by only where nothing else is left. `covered` > 0 or
/// `clear` false: there is none, and this is the least bad one.
struct ClearPlace {
  FreePlace place;
  bool clear = false;
};
ClearPlace clear_place(const Drawn& drawn, const Box& frame, double width, double height, std::size_t own,
                       std::span<const Spot> wanted, std::span<const Spot> anywhere);

}  // namespace cromer::core
