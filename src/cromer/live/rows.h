// What a device has sent so far: rows of a time and one or more values, their headings, where their times
// came from, and what went wrong on the way.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/notice.h"

namespace cromer::core {

/// Rows of samples, with equally many values each, one after the other.
struct SampleRows {
  std::size_t width = 0;       ///< values of a row, the time not counted
  std::vector<double> t;       // [s]
  std::vector<double> values;  ///< width * t.size(), row by row; NaN where missing

  std::size_t size() const { return t.size(); }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * width, width}; }
  /// If memory runs out, nothing is added: times and values stay in step.
  void add(double time, std::span<const double> row) { add(std::span(&time, 1), row); }
  void add(const SampleRows& more) {
    width = more.width;
    add(more.t, more.values);
  }
  /// Keeps the last `most` rows.
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

/// Something that a person should know.
struct Remark {
  RemarkKind kind;
  Notice what;
};

/// A heading that can stand in a CSV file without quotes, without blanks at its ends.
std::string plain_heading(std::string text);

/// Whether `name` is the heading, with its unit or without: "Position (mm)" or "Position".
bool is_named(std::string_view heading, std::string_view name);

/// Adds "t,value,...\n", each number with the fewest digits that read back as the same; a number that is not
/// finite is left empty.
void append_row(std::string& text, double t, std::span<const double> values);

/// The times of a file: to the microsecond, each at least one above that before.
inline constexpr double least_step = 1e-6;  // [s]
double to_microseconds(double t);

enum class TimesBy { nothing, device, count, rate, arrival };

/// `by` is where most times came from. The counts are of samples without a time of their own.
struct SampleTimes {
  TimesBy by = TimesBy::nothing;  ///< while nothing came
  std::size_t by_rate = 0, by_arrival = 0;
  double rate = 0;           ///< [1/s] that was found, last; 0 where none was
  double longest_delay = 0;  // [s] from the time by the rate to the arrival
};

/// "device", "count", "rate" or "arrival"; "" for nothing.
std::string_view name(TimesBy by);

/// Says: "times: rate found, 100.02/s; delays up to 0.21 s; 12 of 6000 by arrival"; empty if the times are
/// the device's own or nothing came.
Notice sentence(const SampleTimes& times);

}  // namespace cromer::core
