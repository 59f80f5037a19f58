// What a device has sent so far: rows of a time and one or more values, and what went wrong on the way.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cromer {

/// Rows with equally many values each, one after the other.
struct Rows {
  std::size_t width = 0;       ///< values of a row, the time not counted
  std::vector<double> t;       // [s]
  std::vector<double> values;  ///< width * t.size(), row by row; NaN where missing

  std::size_t size() const { return t.size(); }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * width, width}; }
  void add(double time, std::span<const double> row) {
    t.push_back(time);
    values.insert(values.end(), row.begin(), row.end());
  }
  void add(const Rows& more) {
    width = more.width;
    t.insert(t.end(), more.t.begin(), more.t.end());
    values.insert(values.end(), more.values.begin(), more.values.end());
  }
  /// Drops the first ones where there are more than `most`.
  void keep_last(std::size_t most) {
    if (size() <= most) return;
    values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(most * width));
    t.erase(t.begin(), t.end() - static_cast<std::ptrdiff_t>(most));
  }
  void clear() { t.clear(), values.clear(); }
};

/// The columns' names with their units: "Time (s)", then one for each value.
using Headings = std::vector<std::string>;

enum class NoticeKind { garbage, clock, gap, connection, device, option };

/// Something a person should know of, in a sentence.
struct Notice {
  NoticeKind kind;
  std::string text;
};

}  // namespace cromer
