#include "cromer/read/drop_outs.h"

#include <algorithm>
#include <cmath>

#include "cromer/read/series_shape.h"

namespace cromer::core::dialects {
namespace {

/// The signal with its changes from sample to sample; those across a gap in the times are unseen.
struct Signal {
  std::span<const double> y;
  std::vector<double> changes;
  double limit;  ///< a jump is larger than this many usual changes
  double floor;  ///< and than this

  double usual(std::size_t first, std::size_t end) const {
    const std::span all(changes);
    double livelier = 0;
    if (first > 5) {
      const std::size_t from = first - 1 - std::min(first - 1, reach);
      livelier = median_seen(all.subspan(from, first - 1 - from));
    }
    if (end + 5 < y.size())
      livelier = std::max(livelier, median_seen(all.subspan(end, std::min(reach, changes.size() - end))));
    return livelier;
  }
};

/// Left for and come back from on the same side, with every sample in between well away.
bool is_drop_out(const Signal& signal, std::size_t first, std::size_t end, bool flat) {
  const auto& y = signal.y;
  const double in = y[first] - y[first - 1], out = y[end - 1] - y[end];
  if (in * out <= 0) return false;
  const double size = std::min(std::fabs(in), std::fabs(out)), usual = signal.usual(first, end);
  if (usual == 0 || size <= std::max(signal.floor, signal.limit * usual)) return false;
  // Where what lies beyond both neighbours is like the stretch, the neighbours are two spikes.
  const auto like_the_stretch = [&](double beyond, double inside) {
    return std::fabs(beyond - inside) < 0.5 * size;
  };
  if (first >= 2 && end + 1 < y.size() && like_the_stretch(y[first - 2], y[first]) &&
      like_the_stretch(y[end + 1], y[end - 1]))
    return false;
  if (flat) return true;
  if (std::fabs(y[end] - y[first - 1]) > 0.5 * size) return false;
  const double sign = in > 0 ? 1 : -1,
               base = sign > 0 ? std::max(y[first - 1], y[end]) : std::min(y[first - 1], y[end]);
  return std::all_of(y.begin() + static_cast<std::ptrdiff_t>(first),
                     y.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](double value) { return sign * (value - base) > 0.5 * size; });
}

}  // namespace

std::vector<DropOut> drop_outs(std::span<const double> t, std::span<const double> y, double step,
                               double resolution) {
  constexpr std::size_t longest = 10;
  std::vector<DropOut> found;
  const std::size_t n = y.size();
  if (n < 2 * reach) return found;
  Signal signal{y, std::vector<double>(n - 1), deviations * robust, 0};
  for (std::size_t i = 0; i + 1 < n; ++i)
    signal.changes[i] = t[i + 1] - t[i] < 1.5 * step ? std::fabs(y[i + 1] - y[i]) : unseen;
  signal.floor = std::max(6 * resolution, signal.limit * median_seen(signal.changes));
  std::size_t lost = 0;
  for (std::size_t i = 1; i + 1 < n;) {
    if (signal.changes[i - 1] <= signal.floor) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < n && y[end] == y[i]) ++end;
    const bool flat = end >= i + 3;
    bool is = flat && end < n && is_drop_out(signal, i, end, true);
    for (end = is ? end : i + 2; !is && end < n && end <= i + longest;) {
      is = signal.changes[end - 1] > signal.floor && is_drop_out(signal, i, end, false);
      if (!is) ++end;
    }
    if (is) {
      found.push_back({i, end});
      lost += end - i;
    }
    i = is ? end + 1 : i + 1;
  }
  if (10 * lost > n) found.clear();
  return found;
}

}  // namespace cromer::core::dialects
