// Where words go: names at the right are moved apart, names inside look for a place from which they are read
// without doubt.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cromer/report/thinning.h"

namespace cromer::core {

/// Moves intervals of the given `heights` apart with the smallest sum of squared shifts from `centres`,
/// keeping order, at least `gaps[i]` free after the i-th. Returns the new centres. They stay between `top`
/// and `bottom` while they fit there.
std::vector<double> spread(std::span<const double> centres, std::span<const double> heights,
                           std::span<const double> gaps, double top, double bottom);

/// What is drawn in a panel already, in squares of 2 px.
class Occupancy {
 public:
  explicit Occupancy(Box frame);
  void add_line(std::span<const Spot> points, double width);
  void add_box(const Box& box);
  /// Squares inside `box` that are taken.
  int taken(const Box& box) const;
  /// Squares that the straight line crosses and that are taken.
  int crossed(Spot from, Spot to) const;

 private:
  void mark(double x, double y);
  bool is_taken(double x, double y) const;
  Box frame_;
  int columns_, rows_;
  std::vector<char> cells_;
};

/// A place for a box of the given size inside `frame`, as near as can be to one of `targets`, on nothing that
/// is drawn; and the target it is nearest to.
struct FreePlace {
  Box box;
  Spot target;
  double distance = 0;
  int covered = 0;  ///< squares of 2 px that are covered all the same; 0 where there is room
};
FreePlace free_place(const Occupancy& drawn, const Box& frame, double width, double height,
                     std::span<const Spot> targets);

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
