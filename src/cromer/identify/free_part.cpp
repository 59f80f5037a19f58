#include "cromer/identify/free_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cromer {
namespace {

struct Swing {
  double centre = 0;  // what it swings about
  double period = 0;  // [s]
};

// Period and centre without a spectrum: the median time between upward crossings of the last third's mean,
// told from noise by a band about it.
std::optional<Swing> swing_of(const Record& record) {
  const std::size_t n = record.t.size(), third = n - n / 3;
  Swing swing;
  for (std::size_t i = third; i < n; ++i) swing.centre += record.y[i] / static_cast<double>(n - third);
  double squares = 0;
  for (const double y : record.y) squares += (y - swing.centre) * (y - swing.centre);
  const double band = 0.25 * std::sqrt(squares / static_cast<double>(n));
  std::vector<double> intervals;
  double last = 0;
  bool below = false, any = false;
  for (std::size_t i = 0; i < n; ++i) {
    const double y = record.y[i] - swing.centre;
    if (y < -band) below = true;
    if (!(y > band) || !below) continue;
    below = false;
    if (any) intervals.push_back(record.t[i] - last);
    last = record.t[i];
    any = true;
  }
  if (intervals.size() < 4) return std::nullopt;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  swing.period = *middle;
  return swing;
}

struct Window {
  double from, to, amplitude;
};

// Root two times the standard deviation, over windows of two periods, each begun half a period after the
// last.
std::vector<Window> windows_of(const Record& record, double period) {
  std::vector<Window> windows;
  const double length = 2 * period;
  for (double from = record.t.front(); from + length <= record.t.back(); from += 0.5 * period) {
    const auto first = std::lower_bound(record.t.begin(), record.t.end(), from) - record.t.begin();
    const auto last = std::lower_bound(record.t.begin(), record.t.end(), from + length) - record.t.begin();
    if (last - first < 12) continue;
    double mean = 0, squares = 0;
    for (auto i = first; i < last; ++i) mean += record.y[i] / static_cast<double>(last - first);
    for (auto i = first; i < last; ++i) squares += (record.y[i] - mean) * (record.y[i] - mean);
    windows.push_back({from, from + length, std::sqrt(2 * squares / static_cast<double>(last - first))});
  }
  return windows;
}

// The mean rate at which the amplitude falls while it is between two shares of the top, from window k on; 0
// where it does not get there.
double fall(const std::vector<Window>& windows, std::size_t k, double top, double from, double to) {
  while (k < windows.size() && windows[k].amplitude > from * top) ++k;
  const std::size_t begin = k;
  while (k < windows.size() && windows[k].amplitude > to * top) ++k;
  if (k >= windows.size() || k == begin) return 0;
  return (windows[begin].amplitude - windows[k].amplitude) / (windows[k].from - windows[begin].from);
}

// A drive that stops.
std::optional<FreePart> after_the_drive(const std::vector<Window>& windows, double period) {
  double top = 0;
  std::size_t stop = 0, rises = 0;
  for (std::size_t k = 0; k < windows.size(); ++k) top = std::max(top, windows[k].amplitude);
  while (rises < windows.size() && windows[rises].amplitude < 0.9 * top) ++rises;
  // The last windows that the drive keeps at their level.
  for (std::size_t k = windows.size(); k-- > 0;)
    if (windows[k].amplitude >= 0.9 * top) {
      stop = k;
      break;
    }
  if (stop <= rises || windows[stop].from - windows[rises].from < 6 * period) return std::nullopt;
  while (stop > rises && windows[stop].amplitude < 0.98 * top) --stop;

  // Free from the start, it falls as fast before this moment as after it.
  const double before = (windows[rises].amplitude - windows[stop].amplitude) /
                        std::max(period, windows[stop].from - windows[rises].from);
  const double after = fall(windows, stop, top, 0.95, 0.7);
  if (!(after > 0) || before > 0.2 * after) return std::nullopt;
  // A beat begins to fall slowly, what is let go falls fastest at first.
  const double later = fall(windows, stop, top, 0.6, 0.4);
  if (!(later > 0) || after < 0.7 * later) return std::nullopt;
  // It must fall for good, and further than it ever did while it was driven.
  double lowest = top, lowest_driven = top;
  for (std::size_t k = stop; k < windows.size(); ++k) {
    if (windows[k].amplitude > lowest + 0.1 * top) return std::nullopt;
    lowest = std::min(lowest, windows[k].amplitude);
  }
  for (std::size_t k = rises; k <= stop; ++k) lowest_driven = std::min(lowest_driven, windows[k].amplitude);
  if (lowest > 0.7 * lowest_driven || windows.back().to - windows[stop].to < 5 * period) return std::nullopt;
  const double from = windows[stop].to;
  return FreePart{from, fmt::format("the amplitude {} until {:.4g} s and only falls from there, as where a "
                                    "drive stops",
                                    rises > 4 ? "rises and stays level" : "stays level", from)};
}

// Held still, displaced or at rest.
std::optional<FreePart> after_the_hold(const Record& record, const Swing& swing) {
  double amplitude = 0;
  for (const double y : record.y) amplitude = std::max(amplitude, std::abs(y - swing.centre));
  const double band = 0.05 * amplitude;
  // A first value alone may be off by noise: the mean of the first quarter period.
  double held = 0;
  std::size_t quarter = 0;
  while (quarter + 1 < record.t.size() && record.t[quarter] - record.t[0] < 0.25 * swing.period)
    held += record.y[quarter++];
  if (quarter < 3) return std::nullopt;
  held /= static_cast<double>(quarter);
  std::size_t last = 0;
  while (last < record.t.size() && std::abs(record.y[last] - held) <= band) ++last;
  // A swing stays so close to its turning point for a fifth of a period at most.
  if (last < 4 || last >= record.t.size() || record.t[last] - record.t[0] < 0.5 * swing.period)
    return std::nullopt;
  double from = record.t[last - 1];
  const double displaced = std::abs(held - swing.centre);
  // Where it was at rest, something has set it going: free it is when it comes back from its first large
  // swing.
  if (displaced < 0.5 * amplitude) {
    std::size_t i = last;
    while (i < record.t.size() && std::abs(record.y[i] - swing.centre) < 0.8 * amplitude) ++i;
    // A beat rises slowly.
    if (i >= record.t.size() || record.t[i] - record.t[last] > 2 * swing.period) return std::nullopt;
    const double side = record.y[i] - swing.centre;
    while (i < record.t.size() && (record.y[i] - swing.centre) * side > 0) ++i;
    if (i >= record.t.size()) return std::nullopt;
    from = record.t[i];
  }
  if (record.t.back() - from < 4 * swing.period) return std::nullopt;
  return FreePart{from, fmt::format("it is held still until {:.4g} s{}", record.t[last - 1],
                                    displaced < 0.5 * amplitude ? " and then set going" : "")};
}

}  // namespace

std::optional<FreePart> find_free_part(const Record& record) {
  if (record.t.size() < 64) return std::nullopt;
  const std::optional<Swing> swing = swing_of(record);
  if (!swing) return std::nullopt;
  if (auto part = after_the_drive(windows_of(record, swing->period), swing->period)) return part;
  return after_the_hold(record, *swing);
}

}  // namespace cromer
