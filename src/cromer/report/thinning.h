// Places and boxes in a picture, and what is drawn of a curve: fewer points that look the same at the
// figure's size, cut at the frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cromer::core {

/// A place in a picture, in px; y grows downwards unless said otherwise.
struct Spot {
  double x = 0, y = 0;

  friend bool operator==(const Spot&, const Spot&) = default;
};

/// A rectangle in px, y downwards.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Spot nearest(Spot p) const { return {std::clamp(p.x, x, right()), std::clamp(p.y, y, bottom())}; }
};

/// The unbroken pieces of a curve in px; points that are not finite break it.
std::vector<std::vector<Spot>> unbroken(std::span<const Spot> points);

/// Leaves out points until the line through the rest would be off by more than `tolerance` [px]. Where x
/// never goes back, first, lowest, highest and last point of each half pixel column are kept before that, so
/// that the dense curve keeps every peak.
std::vector<Spot> thin_line(std::span<const Spot> piece, double tolerance = 0.08);

/// One dot per quarter pixel: dots under another are left out, and those less than `apart` [px] from the one
/// before.
std::vector<Spot> thin_dots(std::span<const Spot> dots, double apart = 0);

/// Indices of the samples that a picture of so many columns needs: the first, lowest, highest and last of
/// each column, in order; all of them if there are at most four a column. `x` does not go back. Samples that
/// are not finite are kept, since they break the line.
std::vector<std::size_t> extremes(std::span<const double> x, std::span<const double> y, std::size_t columns);

/// A filled band: lowest and highest y at each x.
struct Band {
  std::vector<double> x, low, high;
};

/// Lowest and highest point of each pixel column, taken over `columns` neighbouring ones (>= 1) and joined to
/// the next column.
Band min_max_band(std::span<const Spot> points, int columns);

/// How many pixel columns one period of the signal takes, from the crossings of its middle, gaps left out;
/// infinite if there are none.
double columns_per_period(std::span<const Spot> points);

/// A point up to a hundredth of a px outside counts as inside.
bool inside(Spot p, const Box& frame);

/// The pieces of an unbroken line inside the frame, cut at the edge, each of two spots or more.
std::vector<std::vector<Spot>> pieces_inside(const std::vector<Spot>& line, const Box& frame);

/// The columns in the frame, cut at its upper and lower edge; NaN still parts the pieces.
Band band_inside(const Band& band, const Box& frame);

}  // namespace cromer::core
