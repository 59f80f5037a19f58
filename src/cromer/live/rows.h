// What a device has sent so far: rows of a time and one or more values, and what went wrong on the way.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// Rows with equally many values each, one after the other.
struct Rows {
  std::size_t width = 0;       ///< values of a row, the time not counted
  std::vector<double> t;       // [s]
  std::vector<double> values;  ///< width * t.size(), row by row; NaN where missing

  std::size_t size() const { return t.size(); }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * width, width}; }
  /// Where memory runs out nothing is added: times and values stay in step.
  void add(double time, std::span<const double> row) { add(std::span(&time, 1), row); }
  void add(const Rows& more) {
    width = more.width;
    add(more.t, more.values);
  }
  /// Drops the first ones where there are more than `most`.
  void keep_last(std::size_t most) {
    if (size() <= most) return;
    values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(most * width));
    t.erase(t.begin(), t.end() - static_cast<std::ptrdiff_t>(most));
  }
  void clear() { t.clear(), values.clear(); }

 private:
  void add(std::span<const double> times, std::span<const double> more) {
    const std::size_t before = values.size();
    values.insert(values.end(), more.begin(), more.end());
    try {
      t.insert(t.end(), times.begin(), times.end());
    } catch (...) {
      values.resize(before);
      throw;
    }
  }
};

/// The columns' names with their units: "Time (s)", then one for each value.
using Headings = std::vector<std::string>;

enum class RemarkKind { garbage, clock, gap, connection, device, option };

/// Something a person should know of.
struct Remark {
  RemarkKind kind;
  Notice what;
};

}  // namespace cromer::core
