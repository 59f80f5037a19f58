// Where words go: names at the right are moved apart; names inside look for a place that shows which curve
// they name.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/report/thinning.h"

namespace cromer::core {

/// A word this far from its point gets a leader line [px].
inline constexpr double leader_from = 14;

/// Moves intervals of the given `heights` apart with the smallest sum of squared shifts from `centres`,
/// keeping order, at least `gaps[i]` free after the i-th. Returns the new centres. They stay between `top`
/// and `bottom` while they fit there.
std::vector<double> spread(std::span<const double> centres, std::span<const double> heights,
                           std::span<const double> gaps, double top, double bottom);

/// The squares of 2 px in a panel that are drawn on already.
class Occupancy {
 public:
  explicit Occupancy(Box frame);
  void add_line(std::span<const Spot> points, double width);
  void add_box(const Box& box);
  /// How many squares inside `box` are taken.
  int taken(const Box& box) const;
  /// How many taken squares the straight line crosses.
  int crossed(Spot from, Spot to) const;

 private:
  void mark(double x, double y);
  bool is_taken(double x, double y) const;
  Box frame_;
  int columns_, rows_;
  std::vector<char> cells_;
};

/// A place for a box of the given size inside `frame`, on nothing that is drawn and as near as possible to
/// one of `targets`; and that target.
struct FreePlace {
  Box box;
  Spot target;
  double distance = 0;
  int covered = 0;  ///< squares that are covered nevertheless; 0 if there is room
};
FreePlace free_place(const Occupancy& drawn, const Box& frame, double width, double height,
                     std::span<const Spot> targets);

/// What is drawn, and what a name inside must keep clear of.
struct Drawn {
  Occupancy all;                          ///< curves, words, leader lines and guide lines
  Occupancy inked;                        ///< the same without guide lines
  std::vector<std::vector<Spot>> curves;  ///< of each curve of the panel; empty for a guide line
};

/// A place for the name of curve `own`. It covers nothing; its leader line is short and crosses nothing;
/// without a leader line it is closer to its own curve than to any other. Tried first at one of `wanted`,
/// then where the curve stands apart from the others. Guide lines are covered only if nothing else is left.
/// If `covered` > 0 or `clear` is false, there is no such place, and this is the least bad one.
struct ClearPlace {
  FreePlace place;
  bool clear = false;
};
ClearPlace clear_place(const Drawn& drawn, const Box& frame, double width, double height, std::size_t own,
                       std::span<const Spot> wanted, std::span<const Spot> anywhere);

}  // namespace cromer::core
