#include "cromer/read/series_shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <utility>

#include "cromer/base/even_steps.h"
#include "cromer/base/extent.h"
#include "cromer/base/quantile.h"

namespace cromer::core::dialects {
namespace {

// The neighbours on either side that show what is usual, and how many robust standard deviations are unusual.
constexpr std::size_t reach = 20;
constexpr double robust = 1.4826, deviations = 12;

/// Units in the last decimal place, if six decimals behind the largest value's first digit, or behind the
/// point, write nearly all values (a logger may print 0.00 as -3.75e-5 now and then); else 0.
double decimal_step(std::span<const double> values) {
  const std::size_t most_others = values.size() / 10;
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  if (!(largest > 1e-290)) return 0;
  const int first = largest < 1 ? static_cast<int>(-std::floor(std::log10(largest))) - 1 : 0;
  double scale = std::pow(10.0, first);
  for (int decimals = 0; decimals <= 6; ++decimals, scale *= 10) {
    const auto is_exact = [scale](double value) {
      const double scaled = value * scale, whole = std::nearbyint(scaled);
      // A value far below one unit is not a multiple of it.
      if (whole == 0 && value != 0) return false;
      return std::fabs(scaled - whole) <= std::min(0.01, 1e-9 * std::max(1.0, std::fabs(scaled)));
    };
    std::size_t others = 0;
    for (std::size_t i = 0; i < values.size() && others <= most_others; ++i) others += !is_exact(values[i]);
    if (others <= most_others) return 1 / scale;
  }
  return 0;
}

/// All values of a short series; every n-th of a long one, enough to show its rounding.
std::vector<double> even_choice(std::span<const double> values) {
  constexpr std::size_t enough = 100'000;
  const std::size_t stride = (values.size() + enough - 1) / enough;
  std::vector<double> chosen;
  chosen.reserve(values.size() / stride + 1);
  for (std::size_t i = 0; i < values.size(); i += stride) chosen.push_back(values[i]);
  return chosen;
}

/// The values sorted, in a time that grows with their number where they are spread out: each into one of as
/// many bins as there are values, and then within its bin.
std::vector<double> sorted(std::vector<double> values) {
  if (values.empty()) return values;
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto [lowest, highest] = extent_of(values);
  const double low = lowest, width = highest - low, scale = static_cast<double>(n - 1) / width;
  if (!std::isfinite(scale) || !std::isfinite(width)) {  // all alike, or as far apart as numbers can be
    std::sort(values.begin(), values.end());
    return values;
  }
  const auto bin = [=](double value) { return static_cast<std::size_t>((value - low) * scale); };
  std::vector<std::ptrdiff_t> begin(values.size() + 2, 0);
  for (const double value : values) ++begin[bin(value) + 2];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<double> result(values.size());
  for (const double value : values) result[static_cast<std::size_t>(begin[bin(value) + 1]++)] = value;
  // Each bin's begin now stands in its own place.
  for (std::size_t k = 0; k < values.size(); ++k)
    if (begin[k + 1] - begin[k] > 1) std::sort(result.begin() + begin[k], result.begin() + begin[k + 1]);
  return result;
}

/// The median distance of sorted values from one of them. The nearest half are neighbours; the nearest of the
/// others has that distance.
double usual_distance(const std::vector<double>& ordered, double middle) {
  const std::size_t half = ordered.size() / 2;
  std::size_t first = 0, end = ordered.size() - half;
  while (first < end) {
    const std::size_t i = (first + end) / 2;
    if (ordered[i + half] - middle < middle - ordered[i])
      first = i + 1;
    else
      end = i;
  }
  const double above = first + half < ordered.size() ? ordered[first + half] - middle : HUGE_VAL;
  return first > 0 ? std::min(above, middle - ordered[first - 1]) : above;
}

/// The lower quartile of the changes from sample to sample, zeros left out: the flicker of a signal at rest.
double usual_small_change(std::span<const double> y) {
  std::vector<double> changes;
  changes.reserve(y.size());
  for (std::size_t i = 1; i < y.size(); ++i)
    if (y[i] != y[i - 1]) changes.push_back(std::fabs(y[i] - y[i - 1]));
  return changes.empty() ? 0 : quantile(changes, 0.25);
}

/// Whether times are about a step apart, as the cubic takes them to be.
bool are_even(std::span<const double> t, double step) {
  for (std::size_t i = 1; i < t.size(); ++i)
    if (const double h = t[i] - t[i - 1]; h < 0.5 * step || h > 1.5 * step) return false;
  return t.back() - t.front() < static_cast<double>(t.size() - 1) * 1.25 * step;
}

/// Distance of y[i] from the cubic through its four neighbours, evenly spaced.
double distance_from_cubic(std::span<const double> y, std::size_t i) {
  return y[i] - (4 * (y[i - 1] + y[i + 1]) - (y[i - 2] + y[i + 2])) / 6;
}

/// The first and last two samples have no neighbours on one side: they stick out if the cubic through the
/// next four samples misses them by far but fits the sample behind these. `least` is the distance that sticks
/// out anywhere; the cubic misses a decaying swing by more where it is large.
std::vector<std::size_t> spikes_at_the_ends(std::span<const double> t, std::span<const double> y, double step,
                                            std::span<const double> size, double least) {
  std::vector<std::size_t> found;
  const std::size_t n = y.size();
  for (const bool front : {true, false}) {
    const auto near = front ? size.subspan(4, reach) : size.subspan(n - 4 - reach, reach);
    const double floor = std::max(least, deviations * robust * median_seen(near));
    for (const std::size_t from_end : {std::size_t{1}, std::size_t{0}}) {
      const auto at = [&](std::size_t k) { return front ? from_end + k : n - 1 - from_end - k; };
      const auto missed = [&](std::size_t k) {
        return std::fabs(y[at(k)] - 4 * y[at(k + 1)] + 6 * y[at(k + 2)] - 4 * y[at(k + 3)] + y[at(k + 4)]);
      };
      const bool even = are_even(t.subspan(std::min(at(0), at(4)), 5), step);
      // If the next sample is a spike, the cubic misses this one by four times its size.
      if (!even || size[at(3)] > floor || missed(0) <= 6 * floor || missed(0) < 5 * missed(1)) continue;
      found.push_back(at(0));
      break;
    }
  }
  return found;
}

/// The step between groups of values that lie close together, as a sensor makes them that shifts its own
/// coarse steps by a little now and then. 0 where the groups are not far from each other or not evenly
/// spaced.
double step_between_groups(const std::vector<double>& distinct) {
  constexpr double apart = 5, even = 0.12;  // a gap between groups over one within; of a step
  constexpr std::size_t fewest = 3;         // groups
  std::vector<double> gaps;
  for (std::size_t i = 1; i < distinct.size(); ++i) gaps.push_back(distinct[i] - distinct[i - 1]);
  const std::vector<double> ordered = sorted(gaps);
  std::size_t split = 0;
  for (std::size_t i = 1; i < ordered.size(); ++i)
    if (split == 0 || ordered[i] / ordered[i - 1] > ordered[split] / ordered[split - 1]) split = i;
  if (split == 0 || ordered[split] < apart * ordered[split - 1]) return 0;
  const double between = ordered[split];
  std::vector<double> middles;
  for (std::size_t first = 0, i = 1; i <= distinct.size(); ++i) {
    if (i < distinct.size() && gaps[i - 1] < between) continue;
    if (distinct[i - 1] - distinct[first] > between / 2) return 0;
    middles.push_back((distinct[first] + distinct[i - 1]) / 2);
    first = i;
  }
  if (middles.size() < fewest) return 0;
  double step = middles.back() - middles.front();
  for (std::size_t i = 1; i < middles.size(); ++i) step = std::min(step, middles[i] - middles[i - 1]);
  double steps = 0;
  for (std::size_t i = 1; i < middles.size(); ++i) {
    const double count = (middles[i] - middles[i - 1]) / step;
    if (std::fabs(count - std::nearbyint(count)) > even * std::min(std::nearbyint(count), 3.0)) return 0;
    steps += std::nearbyint(count);
  }
  return (middles.back() - middles.front()) / steps;
}

}  // namespace

double median_seen(std::span<const double> sizes) {
  std::vector<double> seen;
  seen.reserve(sizes.size());
  std::copy_if(sizes.begin(), sizes.end(), std::back_inserter(seen), [](double s) { return s != unseen; });
  return seen.empty() ? 0 : median(std::move(seen));
}

double rounding_step(std::span<const double> all) {
  std::vector<double> values = even_choice(all), distinct = sorted(values);
  // A stray value of 1e30 says nothing about the decimals of the others.
  constexpr double wild = 1e9;  // times the usual distance from the middle
  if (values.size() < 3) return 0;
  const double middle = distinct[distinct.size() / 2];
  if (const double usual = usual_distance(distinct, middle); usual > 0)
    for (auto* some : {&values, &distinct})
      std::erase_if(*some, [&](double value) { return std::fabs(value - middle) > wild * usual; });
  if (values.size() < 3) return 0;
  const double range = distinct.back() - distinct.front();
  // The binary rounding of decimals, at any distance from zero.
  const double noise =
      std::max(1e-9 * range, 1e-15 * std::max(std::fabs(distinct.front()), std::fabs(distinct.back())));
  distinct.erase(
      std::unique(distinct.begin(), distinct.end(), [&](double a, double b) { return b - a <= noise; }),
      distinct.end());
  if (distinct.size() < 2) return 0;
  if (distinct.size() == 2) return range;  // two levels are one step
  const double decimal = decimal_step(values);
  if (static_cast<double>(distinct.size()) > 0.8 * static_cast<double>(values.size())) return decimal;

  double smallest = range;
  for (std::size_t i = 1; i < distinct.size(); ++i)
    smallest = std::min(smallest, distinct[i] - distinct[i - 1]);
  if (decimal > 0 && smallest < 0.75 * decimal) return decimal;  // only the rare exceptions are closer
  // A quantum may be printed rounded: 0.0429 and 0.0430 are the same step.
  const double tolerance = std::max(0.05 * smallest, std::min(1.01 * decimal, 0.25 * smallest));
  std::size_t multiples = 0;
  double sum = 0, counts = 0;
  for (std::size_t i = 1; i < distinct.size(); ++i) {
    const double difference = distinct[i] - distinct[i - 1];
    const double count = std::nearbyint(difference / smallest);
    if (std::fabs(difference - count * smallest) > tolerance * std::min(count, 3.0)) continue;
    ++multiples;
    if (count > 3) continue;
    sum += difference;
    counts += count;
  }
  const bool even = static_cast<double>(multiples) >= 0.95 * static_cast<double>(distinct.size() - 1);
  if (!even || counts == 0) {
    constexpr double repeated = 20;  // times each value, so that groups are none of chance
    const bool few = repeated * static_cast<double>(distinct.size()) < static_cast<double>(values.size());
    return few ? std::max(decimal, step_between_groups(distinct)) : decimal;
  }
  // A step of one decimal place is exactly that, not a mean with binary noise.
  const double mean = sum / counts;
  return decimal > 0 && std::fabs(mean - decimal) < 0.01 * decimal ? decimal : mean;
}

std::vector<std::size_t> spikes(std::span<const double> t, std::span<const double> y, double step,
                                double resolution) {
  std::vector<std::size_t> found;
  const std::size_t n = y.size();
  if (n < 2 * reach) return found;
  std::vector<double> size(n, unseen);
  for (std::size_t i = 2; i + 2 < n; ++i) size[i] = std::fabs(distance_from_cubic(y, i));
  // Only where some step may be too short or too long is each looked at.
  const EvenSteps all_steps = even_steps(t);
  if (all_steps.mean - all_steps.farthest < 0.5 * step || all_steps.mean + all_steps.farthest > 1.2 * step)
    for (std::size_t i = 2; i + 2 < n; ++i)
      if (!are_even(t.subspan(i - 2, 5), step)) size[i] = unseen;
  const auto [low, high] = extent_of(y);
  const double everywhere = robust * median_seen(size);
  if (low == high) return found;
  const double floor = std::max(
      {deviations * everywhere, 6 * std::max(resolution, usual_small_change(y)), 1e-6 * (high - low)});
  // A spike at an end spoils the distances next to it.
  found = spikes_at_the_ends(t, y, step, size, floor);
  const auto spoilt = [&, at_ends = found](std::size_t i) {
    return std::any_of(at_ends.begin(), at_ends.end(),
                       [&](std::size_t end) { return (end > i ? end - i : i - end) <= 2; });
  };
  for (std::size_t i = 2; i + 2 < n; ++i) {
    if (size[i] <= floor || spoilt(i)) continue;
    const bool alone = (y[i] - y[i - 1]) * (y[i + 1] - y[i]) < 0 &&
                       size[i] > 1.2 * std::max(size[i - 1], size[i + 1]) &&
                       size[i] > 2 * std::max(size[i - 2], size[i + 2]);
    if (!alone) continue;
    // Beside a gap, a spike of the neighbour whose size is unknown looks like one here; but then the other
    // neighbour hardly shows it.
    const auto marked = [&](std::size_t hidden, std::size_t other) {
      return size[hidden] != unseen || 2 * size[other] > size[i];
    };
    if (!marked(i - 1, i + 1) || !marked(i + 1, i - 1)) continue;
    // Motion may begin on one side only: the livelier side shows what is usual.
    const std::size_t from = i > reach + 2 ? i - reach - 2 : 2, to = std::min(i + reach + 3, n - 2);
    const std::span all(size);
    double usual = 0;
    if (i - from > 4) usual = std::max(usual, median_seen(all.subspan(from, i - 2 - from)));
    if (to - i > 5) usual = std::max(usual, median_seen(all.subspan(i + 3, to - i - 3)));
    if (size[i] > deviations * robust * usual) found.push_back(i);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<double> tops_cut_off(std::span<const double> y, double step, double resolution) {
  constexpr std::size_t fewest = 32, fewest_crossings = 4;
  if (y.size() < fewest) return {};
  const auto [low, high] = extent_of(y);
  const double amplitude = 0.5 * (high - low), middle = 0.5 * (high + low);
  if (!(amplitude > 0) || resolution >= amplitude) return {};
  // Crossings from well below to well above the middle, which noise does not make.
  std::size_t crossings = 0;
  int side = 0;
  for (const double value : y) {
    if (std::fabs(value - middle) < 0.2 * amplitude) continue;
    const int now = value > middle ? 1 : -1;
    crossings += side != 0 && now != side;
    side = now;
  }
  if (crossings < fewest_crossings) return {};
  const double half_period = static_cast<double>(y.size()) * step / static_cast<double>(crossings);
  const double dwell = 2 * std::acos(1 - resolution / amplitude) * half_period / std::numbers::pi;
  std::vector<double> levels;
  for (const double top : {low, high}) {
    std::size_t run = 0, longest = 0, plateaus = 0;
    for (std::size_t i = 0; i <= y.size(); ++i) {
      if (i < y.size() && y[i] == top) {
        ++run;
        continue;
      }
      plateaus += run >= 3;
      longest = std::max(longest, run);
      run = 0;
    }
    // A top as long as the half period belongs to a square wave.
    const double length = static_cast<double>(longest) * step;
    if (plateaus >= 2 && length > 1.5 * dwell + 3 * step && length < 0.9 * half_period) levels.push_back(top);
  }
  return levels;
}

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

/// Whether the jumps away and back are on the same side, and every sample between them is well away.
bool is_drop_out(const Signal& signal, std::size_t first, std::size_t end, bool flat) {
  const auto& y = signal.y;
  const double in = y[first] - y[first - 1], out = y[end - 1] - y[end];
  if (in * out <= 0) return false;
  const double size = std::min(std::fabs(in), std::fabs(out)), usual = signal.usual(first, end);
  if (usual == 0 || size <= std::max(signal.floor, signal.limit * usual)) return false;
  // If the samples beyond both neighbours are like the stretch, the neighbours are two spikes.
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
