#include "cromer/read/time.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cromer/base/even_steps.h"
#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/base/quantity.h"

namespace cromer::core::dialects {
namespace {

/// How many rows were left out for one reason, and the line of the first.
struct LeftOut {
  std::size_t count = 0;
  long line = 0;

  void add(long at) {
    if (count++ == 0) line = at;
  }
};

/// Whether the times from row i on rise towards `last` for some rows, or to their end. If so, it is a new
/// start; a single backward time is a glitch.
bool rises_from(const std::vector<double>& t, std::size_t i, double last) {
  constexpr std::size_t rows = 5;
  double before = t[i];
  std::size_t seen = 0;
  for (std::size_t k = i + 1; k < t.size() && seen < rows; ++k) {
    if (!std::isfinite(t[k])) continue;
    if (t[k] <= before || t[k] >= last) return false;
    before = t[k];
    ++seen;
  }
  return seen > 0;
}

/// Whether times that rose from `first` to `last` in `count` rows start again in row i.
bool starts_again(const std::vector<double>& t, std::size_t i, double first, double last, std::size_t count) {
  constexpr std::size_t fewest = 10;
  return count > fewest && t[i] < last && t[i] - first <= 0.1 * (last - first) && rises_from(t, i, last);
}

}  // namespace

std::vector<std::size_t> restarts(const std::vector<double>& t) {
  std::vector<std::size_t> found;
  std::size_t count = 0;
  double first = 0, last = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) continue;
    const bool again = count > 0 && starts_again(t, i, first, last, count);
    if (again) found.push_back(i);
    if (again || count == 0) {
      first = last = t[i];
      count = 1;
    } else if (t[i] > last) {
      last = t[i];
      ++count;
    }
  }
  return found;
}

std::optional<std::size_t> time_column_of(const Table& table, std::size_t j) {
  const auto& columns = table.columns;
  const auto is_time = [&](std::size_t k) { return k != j && columns[k].quantity == "time"; };
  for (std::size_t k = j; k-- > 0;)
    if (is_time(k) && columns[k].run == columns[j].run) return k;
  for (std::size_t k = j + 1; k < columns.size(); ++k)
    if (is_time(k) && columns[k].run == columns[j].run) return k;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (is_time(k)) return k;
  return std::nullopt;
}

std::vector<std::optional<std::size_t>> time_columns_of(const Table& table) {
  const auto& columns = table.columns;
  const auto is_time = [&](std::size_t k) { return columns[k].quantity == "time"; };
  std::vector<std::optional<std::size_t>> found(columns.size());
  std::map<int, std::size_t> last_of_run;
  std::size_t times = 0, first = 0, second = 0;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (const auto last = last_of_run.find(columns[j].run); last != last_of_run.end())
      found[j] = last->second;
    if (!is_time(j)) continue;
    last_of_run[columns[j].run] = j;
    if (times++ == 0) first = j;
    if (times == 2) second = j;
  }
  last_of_run.clear();
  for (std::size_t j = columns.size(); j-- > 0;) {
    if (const auto last = last_of_run.find(columns[j].run); !found[j] && last != last_of_run.end())
      found[j] = last->second;
    if (is_time(j)) last_of_run[columns[j].run] = j;
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (found[j] || times == 0) continue;
    if (j != first) found[j] = first;
    if (j == first && times > 1) found[j] = second;
  }
  return found;
}

Result<RisingTimes> keep_rising(const std::vector<double>& t, const std::vector<long>& lines) {
  std::size_t falling = 0, rising = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] < t[i - 1]) ++falling;
    if (t[i] > t[i - 1]) ++rising;
  }
  if (t.size() > 1 && rising == 0) return Error{falling > 0 ? "time_runs_backward" : "time_stands_still"};
  if (falling > rising) return Error{"time_mostly_backward"};

  RisingTimes result;
  result.kept.reserve(t.size());
  LeftOut repeated, backward;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (result.kept.empty()) {
      result.kept.push_back(i);
      continue;
    }
    const double first = t[result.kept.front()], last = t[result.kept.back()];
    if (t[i] > last) {
      result.kept.push_back(i);
    } else if (t[i] == last) {
      repeated.add(lines[i]);
    } else {
      if (starts_again(t, i, first, last, result.kept.size())) {
        result.notices.push_back(Notice{"time_starts_again", {{"line", lines[i]}, {"rows", t.size() - i}}});
        break;
      }
      backward.add(lines[i]);
    }
  }
  if (repeated.count > 0)
    result.notices.push_back(Notice{"repeated_times", {{"rows", repeated.count}, {"line", repeated.line}}});
  if (backward.count > 0)
    result.notices.push_back(Notice{"backward_times", {{"rows", backward.count}, {"line", backward.line}}});
  return result;
}

namespace {

/// `value` rounded to so many significant digits.
double to_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const int places = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  if (std::abs(places) > 300) return value;
  const double scale = std::pow(10.0, std::abs(places));  // a whole power of ten: dividing by it rounds once
  return places >= 0 ? std::nearbyint(value * scale) / scale : std::nearbyint(value / scale) * scale;
}

/// The number of fewest digits, 12 at most, within `relative` of the value.
double round_within(double value, double relative) {
  constexpr int most_digits = 12;
  for (int digits = 1; digits < most_digits; ++digits) {
    const double round = to_digits(value, digits);
    if (std::fabs(round - value) <= relative * value) return round;
  }
  return to_digits(value, most_digits);
}

std::vector<double> differences(std::span<const double> t, std::size_t apart) {
  std::vector<double> found(t.size() > apart ? t.size() - apart : 0);
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = t[i + apart] - t[i];
  return found;
}

/// Times that a logger summed up or a double rounded are off by a few units in the last place of the largest.
double noise_of(std::span<const double> t) {
  return 4 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(t.front()), std::fabs(t.back()));
}

/// The rounding of times, by which their steps differ, if it is at least a twentieth of a step; else 0.
/// Rounding gives even steps two lengths; other lengths come only from missing samples.
double rounding_of(std::span<const double> t, double step) {
  constexpr double coarse = 0.05;
  constexpr std::size_t most = 12;
  const double noise = std::max(1e-6 * step, noise_of(t));
  struct Length {
    double length;
    std::size_t count;
  };
  std::vector<Length> lengths;
  for (const double each : differences(t, 1)) {
    const auto known = std::find_if(lengths.begin(), lengths.end(), [&](const Length& other) {
      return std::fabs(other.length - each) <= noise;
    });
    if (known != lengths.end())
      ++known->count;
    else
      lengths.push_back({each, 1});
    if (lengths.size() > most) return 0;
  }
  if (lengths.size() < 2) return 0;
  std::sort(lengths.begin(), lengths.end(),
            [](const Length& a, const Length& b) { return a.length < b.length; });
  const double rounding = lengths[1].length - lengths[0].length;
  for (const Length& each : lengths)
    if (std::fabs(each.length - rounding * std::nearbyint(each.length / rounding)) > 2 * noise) return 0;
  // A simulation's last step may be a shorter one.
  const bool only_last =
      lengths.size() == 2 && lengths[0].count == 1 && t.back() - t[t.size() - 2] < lengths[1].length - noise;
  if (only_last) return 0;
  // A whole step more, now and then, is a missing sample.
  const bool whole = rounding > 0.9 * lengths[0].length;
  if (whole && 10 * lengths[1].count < t.size()) return 0;
  return rounding >= coarse * step ? rounding : 0;
}

/// The rounding of times written with a fixed number of digits, in their last power of ten, where it is
/// largest [s]; else 0.
double decimal_rounding_of(std::span<const double> t, double step) {
  constexpr std::size_t fewest = 16;
  if (!(t.back() > 0)) return 0;
  const double decade = std::pow(10.0, std::floor(std::log10(t.back())));
  const auto first = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), decade) - t.begin());
  if (t.size() - first < fewest) return 0;
  const double rounding = rounding_of(t.subspan(first), step);
  const double digit = std::pow(10.0, std::round(std::log10(rounding)));
  return std::fabs(rounding - digit) < 1e-6 * digit ? rounding : 0;
}

/// The usual time from sample to sample, also where rounding or jitter spoils the median step: from the
/// median of stretches of sixteen, unless gaps spoil those.
double pace_of(std::span<const double> t, double step) {
  constexpr std::size_t length = 16;
  if (t.size() < 4 * length) return step;
  const double pace = median(differences(t, length)) / static_cast<double>(length);
  return pace < 1.5 * step ? pace : step;
}

/// How much the times behind step i are late, compared with those before it, on an even clock: medians of ten
/// on either side, which a single late sample does not move.
double lateness(std::span<const double> t, std::size_t i, double step) {
  constexpr std::size_t reach = 10;
  const auto late = [&](std::size_t from, std::size_t to) {
    std::vector<double> offsets;
    for (std::size_t k = from; k < to; ++k)
      offsets.push_back(t[k] - t[i] - (static_cast<double>(k) - static_cast<double>(i)) * step);
    return median(std::move(offsets));
  };
  return late(i + 1, std::min(i + 1 + reach, t.size())) - late(i + 1 > reach ? i + 1 - reach : 0, i + 1);
}

/// The straight line through times over their sample numbers.
struct Line {
  double start = 0, step = 0;

  Line(std::span<const double> t, const std::vector<double>& number) {
    const auto n = static_cast<double>(t.size());
    double mean_t = 0, mean_k = 0, products = 0, squares = 0;
    for (std::size_t i = 0; i < t.size(); ++i) mean_t += t[i] / n, mean_k += number[i] / n;
    for (std::size_t i = 0; i < t.size(); ++i) {
      products += (t[i] - mean_t) * (number[i] - mean_k);
      squares += (number[i] - mean_k) * (number[i] - mean_k);
    }
    step = products / squares;
    start = mean_t - step * mean_k;
  }
};

/// The points (number, t) that no straight line from above, or from below, can pass by: its hull on that
/// side.
std::vector<std::size_t> hull(std::span<const double> t, const std::vector<double>& number, double side) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const auto turns_in = [&] {
      const std::size_t a = corners[corners.size() - 2], b = corners.back();
      return side * ((t[b] - t[a]) * (number[i] - number[a]) - (t[i] - t[a]) * (number[b] - number[a])) > 0;
    };
    while (corners.size() > 1 && !turns_in()) corners.pop_back();
    corners.push_back(i);
  }
  return corners;
}

struct Interval {
  double low, high;
};

/// All steps of an even clock whose times, rounded to `r`, may be `t`. Where there is none, as the times
/// jitter too, those that least squares leave possible. `near` is the step by least squares.
Interval possible_steps(std::span<const double> t, const std::vector<double>& number, double r, double near) {
  const std::vector<std::size_t> above = hull(t, number, 1), below = hull(t, number, -1);
  // How far the times differ from a clock of this step, from one side to the other: convex in the step.
  const auto spread = [&](double step) {
    double high = -HUGE_VAL, low = HUGE_VAL;
    for (const std::size_t i : above) high = std::max(high, t[i] - t[0] - step * number[i]);
    for (const std::size_t i : below) low = std::min(low, t[i] - t[0] - step * number[i]);
    return high - low;
  };
  const double reach = 4 * r / (number.back() - number.front()), enough = (1 + 1e-9) * r + noise_of(t);
  double low = near - reach, high = near + reach;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3;
    if (spread(low + third) < spread(high - third))
      high -= third;
    else
      low += third;
  }
  const double best = 0.5 * (low + high);
  if (spread(best) > enough) {
    const double half = std::sqrt(3) * r / std::pow(static_cast<double>(t.size()), 1.5);
    return {near - half, near + half};
  }
  const auto end = [&](double outside) {
    double inside = best;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inside + outside);
      (spread(middle) <= enough ? inside : outside) = middle;
    }
    return inside;
  };
  return {end(near - reach), end(near + reach)};
}

struct KnownStep {
  double step, error;  ///< relative, of a standard deviation
};

/// The step in an interval: one whose length or rate is so round a number that it is not there by chance,
/// else the middle.
KnownStep likely_step(const Interval& steps) {
  const double middle = 0.5 * (steps.low + steps.high), width = (steps.high - steps.low) / middle;
  const auto is_possible = [&](double step) { return step >= steps.low && step <= steps.high; };
  constexpr double chance = 0.05, of_video = 1.001;  // 29.97 pictures a second stand for 30
  double tenfold = 10;                               // numbers of so many digits, in a decade
  for (int digits = 1; tenfold * width < chance && digits < 12; ++digits, tenfold *= 10)
    for (const double round : {1 / to_digits(1 / middle, digits), to_digits(middle, digits)})
      if (is_possible(round) && !is_possible(round * of_video) && !is_possible(round / of_video))
        return {round, 0};
  return {middle, width / std::sqrt(12)};
}

// The even times, perhaps with samples missing, that agree with `t` to half its rounding. The rounding must
// be a twentieth of a step at least. Nothing if there are no such times, or if `t` is even already.
std::optional<EvenClock> even_clock(std::span<const double> t, double median_step) {
  constexpr std::size_t fewest = 16;
  const std::size_t n = t.size();
  if (n < fewest) return std::nullopt;
  const double same = rounding_of(t, median_step);
  const double r = same > 0 ? same : decimal_rounding_of(t, median_step);
  if (!(r > 0)) return std::nullopt;
  // The mean of the stretches without a missing sample, which differ by one rounding at most.
  const std::vector<double> stretches = differences(t, fewest - 1);
  const double usual = median(stretches);
  double sum = 0, count = 0;
  for (const double stretch : stretches)
    if (std::fabs(stretch - usual) <= 1.01 * r) sum += stretch, ++count;
  const double pace = sum / (count * static_cast<double>(fewest - 1));
  if (!(r < pace)) return std::nullopt;

  // The number of each sample, by a clock that follows the samples near by, then by the clock of all. The
  // first clock is the mean phase of the first times.
  double sine = 0, cosine = 0;
  for (std::size_t i = 0; i < fewest; ++i) {
    const double phase = two_pi * std::fmod((t[i] - t[0]) / pace, 1.0);
    sine += std::sin(phase);
    cosine += std::cos(phase);
  }
  double start = t[0] + std::atan2(sine, cosine) / two_pi * pace;
  std::vector<double> number(n);
  for (std::size_t i = 0; i < n; ++i) {
    number[i] = std::nearbyint((t[i] - start) / pace);
    start += (t[i] - pace * number[i] - start) / static_cast<double>(fewest);
  }
  const Line first(t, number);
  for (std::size_t i = 0; i < n; ++i) number[i] = std::nearbyint((t[i] - first.start) / first.step);
  for (std::size_t i = 1; i < n; ++i)
    if (!(number[i] > number[i - 1])) return std::nullopt;
  const Line line(t, number);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < n; ++i) {
    const double off = t[i] - line.start - line.step * number[i];
    low = std::min(low, off);
    high = std::max(high, off);
  }
  // The line is not exactly the clock, and times off by less than their rounding are better made even.
  if (high - low > 1.25 * r) return std::nullopt;

  const KnownStep known = likely_step(possible_steps(t, number, r, line.step));
  EvenClock clock{{}, known.step, known.error, round_within(r, 1e-4)};
  const double middle = 0.5 * (number.front() + number.back());
  const double grain = 1e-6 * clock.spacing;  // a start at 0 is 0
  double begin = grain * std::nearbyint((line.start + (line.step - clock.spacing) * middle) / grain);
  // Of times with so many digits the first are known best.
  if (!(same > 0) && number.front() == 0 && std::fabs(begin - t.front()) < 0.01 * r) begin = t.front();
  for (const double k : number) clock.t.push_back(begin + clock.spacing * k);
  return clock;
}

}  // namespace

Steps describe_steps(std::span<const double> t) {
  constexpr double gap_of_steps = 1.5, lost_of_steps = 0.5;
  Steps result;
  if (t.size() < 2) return result;
  // Steps that differ by rounding alone need no search for a clock.
  if (const EvenSteps even = even_steps(t); even.farthest <= noise_of(t) && noise_of(t) < 1e-6 * even.mean) {
    result.rate = round_within(1 / even.mean, noise_of(t) / even.mean);
    return result;
  }
  const double step = median(differences(t, 1)), rounding = noise_of(t) / step;
  const std::optional<EvenClock> clock = even_clock(t, step);
  const std::span<const double> at = clock ? clock->t : t;
  const double pace = clock ? clock->spacing : pace_of(t, step);

  // A gap is no jitter.
  const auto missing = [&](std::size_t i) {
    return at[i + 1] - at[i] > gap_of_steps * pace && (clock || lateness(t, i, pace) > lost_of_steps * pace);
  };
  std::vector<double> kept;
  for (std::size_t i = 0; i + 1 < t.size(); ++i)
    if (missing(i))
      result.gaps.push_back({at[i], at[i + 1] - at[i]});
    else
      kept.push_back(t[i + 1] - t[i]);
  double mean = 0, squares = 0;
  for (const double h : kept) mean += h / static_cast<double>(kept.size());
  for (const double h : kept) squares += (h - mean) * (h - mean);
  result.rate = clock ? round_within(1 / clock->spacing, rounding)
                      : round_within(1 / mean, rounding / static_cast<double>(kept.size()));
  const double jitter = std::sqrt(squares / static_cast<double>(kept.size())) / step;
  result.jitter = jitter > rounding ? jitter : 0;
  result.clock = clock;
  return result;
}

}  // namespace cromer::core::dialects
