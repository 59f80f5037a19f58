// The values that an option takes one after another: a list, or a range with both ends.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"

namespace cromer::core {

/// Values in the order asked for, computed one by one: a range costs no memory however long it is.
class Grid {
 public:
  /// At least one value, all finite.
  explicit Grid(std::vector<double> values) : list_(std::move(values)), size_(list_.size()) {}
  /// `points` >= 1 from low to high, both included, in either direction; logarithmic only where both are > 0.
  Grid(double low, double high, std::uint64_t points, bool logarithmic)
      : low_(low), high_(high), size_(points), logarithmic_(logarithmic) {}

  std::uint64_t size() const { return size_; }

  /// The i-th value, i < size(). The ends are exact. Between them the error is a few roundings of low and
  /// high; whole decades of a logarithmic range are as exact as the machine's powers of ten.
  double operator[](std::uint64_t i) const;

  /// The ends by value, whichever way the grid runs and wherever in a list they stand.
  double lowest() const;
  double highest() const;

 private:
  std::vector<double> list_;
  double low_ = 0, high_ = 0;
  std::uint64_t size_ = 0;
  bool logarithmic_ = false;
};

/// Reads "0.05,0.2,1" (a list), "0.1:10:1000" (so many points, even steps, either direction),
/// "0.01:10:200:log" (even ratios, either direction). A unit at the end holds for every number that has none
/// of its own: "0.1:10:1000 Hz", "20 ms,0.5,1 s". Values are SI, as parse_quantity reads them with `si_unit`.
/// An Error says what is wrong with which piece and how a grid is written.
Result<Grid> parse_grid(std::string_view text, std::string_view si_unit);

/// A unit as it was typed, and what it is in SI.
struct GridUnit {
  std::string name{};
  double factor = 1;
};

/// The unit at the end of a text that parse_grid reads; the SI unit if there is none.
GridUnit unit_of_grid(std::string_view text, std::string_view si_unit);

/// All values of the grid. bytes_per_point counts a value and all that is made of it. An Error, which says
/// how much is needed, if the whole exceeds `memory` [bytes]; 0 means no limit but the largest vector.
Result<std::vector<double>> values_of(const Grid& grid, double bytes_per_point, double memory);

/// Checks that so many points of bytes_per_point each fit into `memory`, with the errors of values_of. For
/// products of grids.
Result<void> fits_in_memory(double points, double bytes_per_point, double memory);

}  // namespace cromer::core
