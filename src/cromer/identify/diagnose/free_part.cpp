#include "cromer/identify/diagnose/free_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cromer/base/extent.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/record.h"

namespace cromer::core {
namespace {

/// Linear least squares; row(i) gives the values of the n functions at the i-th place.
template <std::size_t n, class Row>
LinearFit fitted(std::span<const double> values, Row row) {
  NormalEquations equations{.size = n};
  for (std::size_t i = 0; i < values.size(); ++i) equations.add_row(row(i), values[i]);
  LinearFit curve = solve(equations);
  if (!curve.ok) return curve;
  // Summed afresh: what is left may be less than the rounding of the squares.
  curve.rest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<double, n> f = row(i);
    double off = values[i];
    for (std::size_t j = 0; j < n; ++j) off -= f[j] * curve.x[j];
    curve.rest += off * off;
  }
  return curve;
}

/// The least squares that the envelope of two sinusoids leaves which decay together: its square is a level
/// and a sinusoid times an exponential, s from -1 to 1.
double beat_squares(std::span<const double> s, std::span<const double> envelope) {
  // Over twice the square itself: then its error is one of the logarithm.
  const std::vector<double> half(envelope.size(), 0.5);
  double best = HUGE_VAL;
  for (double turn = 0.6; turn < 30; turn *= 1.12)   // [rad] of the beat in half the stretch
    for (double rate = 0; rate < 3; rate += 0.25) {  // of the squares over it
      const LinearFit curve = fitted<3>(half, [&](std::size_t i) {
        const double scale = std::exp(-rate * s[i]) / (2 * envelope[i] * envelope[i]);
        return std::array<double, 3>{scale, scale * std::cos(turn * s[i]), scale * std::sin(turn * s[i])};
      });
      best = std::min(best, curve.rest);
    }
  return best;
}

}  // namespace

std::optional<Kink> find_kink(std::span<const double> t, std::span<const double> amplitude) {
  constexpr std::size_t fewest = 8;  // on each side
  const std::size_t n = t.size();
  if (n < 2 * fewest) return std::nullopt;
  // From -1 to 1, for the digits.
  const double middle = 0.5 * (t.front() + t.back()), half = 0.5 * (t.back() - t.front());
  std::vector<double> s;
  for (const double each : t) s.push_back((each - middle) / half);
  std::vector<double> values;
  for (const double A : amplitude) values.push_back(std::log(A));
  const LinearFit smooth = fitted<5>(values, [&](std::size_t i) {
    const double at = s[i];
    return std::array<double, 5>{1, at, at * at, at * at * at, at * at * at * at};
  });
  LinearFit best;
  double place = 0;
  for (std::size_t i = fewest; i + fewest <= n; ++i) {
    const double kink = s[i];
    const LinearFit bent = fitted<4>(values, [&](std::size_t k) {
      const double before = std::min(s[k] - kink, 0.0), after = std::max(s[k] - kink, 0.0);
      return std::array<double, 4>{1, before, after, after * after};
    });
    if (!(bent.rest < best.rest)) continue;
    best = bent;
    place = kink;
  }
  const auto fits_better_than = [&](double rest) { return 3 * best.rest < rest; };
  if (!fits_better_than(smooth.rest) || !fits_better_than(beat_squares(s, amplitude))) return std::nullopt;
  return Kink{middle + half * place, best.x[1] / half, best.x[2] / half};
}

namespace {

struct SwingAbout {
  double centre = 0;  // what it swings about
  double period = 0;  // [s]
};

// Period and centre without a spectrum: the median time between upward crossings of the mean of a part of the
// samples, told from noise by a band about it.
std::optional<SwingAbout> swing_about_mean_of(std::span<const double> part, const Record& record) {
  const std::size_t n = record.t.size();
  SwingAbout swing;
  for (const double y : part) swing.centre += y / static_cast<double>(part.size());
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
  swing.period = upper_median(intervals);
  return swing;
}

// Of a swing that may have been held or driven at first.
std::optional<SwingAbout> swing_at_end(const Record& record) {
  return swing_about_mean_of(record.y.last(record.y.size() / 3), record);
}

// Root two times the standard deviation, over windows of two periods, each begun half a period after the
// last.
std::vector<AmplitudeWindow> windows_of(const Record& record, double period) {
  std::vector<AmplitudeWindow> windows;
  const double length = 2 * period;
  for (double from = record.t.front(); from + length <= record.t.back(); from += 0.5 * period) {
    const auto first = std::lower_bound(record.t.begin(), record.t.end(), from) - record.t.begin();
    const auto last = std::lower_bound(record.t.begin(), record.t.end(), from + length) - record.t.begin();
    if (last - first < 12) continue;
    const std::span<const double> y =
        record.y.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
    windows.push_back({from, from + length, sinusoid_amplitude(y)});
  }
  return windows;
}

// A drive that stops: the amplitude, risen or level, has a kink and then only falls.
std::optional<FreePart> after_the_drive(const std::vector<AmplitudeWindow>& windows, double period) {
  constexpr double least_fall = 0.08, least_duration = 8;  // of the top; [periods]
  double top = 0;
  for (const AmplitudeWindow& window : windows) top = std::max(top, window.amplitude);
  // From where it is about level to where little is left: in between the fall has one curvature.
  std::size_t first = 0, last = 0;
  while (first < windows.size() && windows[first].amplitude < 0.95 * top) ++first;
  while (last < windows.size() && (last <= first || windows[last].amplitude > 0.25 * top)) ++last;
  // Means of neighbours, so that there are some 200 at most.
  const std::size_t each = 1 + (last - first) / 200;
  std::vector<double> t, amplitude;
  for (std::size_t k = first; k + each <= last; k += each) {
    double middle = 0, sum = 0;
    for (std::size_t i = k; i < k + each; ++i) {
      middle += 0.5 * (windows[i].from + windows[i].to) / static_cast<double>(each);
      sum += windows[i].amplitude / static_cast<double>(each);
    }
    t.push_back(middle);
    amplitude.push_back(sum);
  }
  const std::optional<Kink> kink = find_kink(t, amplitude);
  if (!kink || !(kink->after < 0) || kink->before < 0.15 * kink->after) return std::nullopt;
  if (kink->t - t.front() < least_duration * period || windows.back().to - kink->t < least_duration * period)
    return std::nullopt;
  // It stays level before, and falls for good.
  double driven = HUGE_VAL, lowest = top;
  for (std::size_t k = first; k < windows.size(); ++k) {
    const AmplitudeWindow& window = windows[k];
    if (0.5 * (window.from + window.to) < kink->t) driven = std::min(driven, window.amplitude);
    if (window.from < kink->t) continue;
    if (window.amplitude > lowest + 0.3 * least_fall * top) return std::nullopt;
    lowest = std::min(lowest, window.amplitude);
  }
  constexpr double level = 0.85;  // of the top
  if (driven < level * top || driven - lowest < least_fall * top) return std::nullopt;
  const double from = kink->t + period;
  return FreePart{from, Notice{"level_until", {{"time", kink->t}}}};
}

// What a swing itself makes of the second differences that noise is told by.
double noise_of_swing(const SwingAbout& swing, double amplitude, const Record& record) {
  const double step = (record.t.back() - record.t.front()) / static_cast<double>(record.t.size() - 1);
  return amplitude * (1 - std::cos(two_pi * step / swing.period)) / std::sqrt(3);
}

// The noise of all samples, without what the swing itself makes of their second differences.
double noise_beside(const SwingAbout& swing, double amplitude, const Record& record) {
  const double own = noise_of_swing(swing, amplitude, record), all = noise_of(record.y);
  return std::sqrt(std::max(0.0, all * all - own * own));
}

// The first sample, `first` or later, after which the values are no rougher than those of the rest: while a
// hand is at it they shake. A quarter of a period later: it may still be there when half of one is calm.
std::size_t steady_from(const Record& record, std::size_t first, const SwingAbout& swing, double amplitude) {
  constexpr double rough = 3;
  const double own = noise_of_swing(swing, amplitude, record);
  const auto end_of = [&](std::size_t i) {
    const double to = record.t[i] + 0.5 * swing.period;
    return static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), to) -
                                    record.t.begin());
  };
  std::size_t steady = first;
  for (int half = 0; half < 6; ++half) {  // of a period: a hand is gone then
    const std::size_t end = end_of(first);
    if (end < first + 8 || end + 64 > record.y.size()) break;
    const double noise = noise_of(record.y.subspan(first, end - first));
    if (noise > rough * std::max(own, noise_of(record.y.subspan(end))))
      steady = std::min(end + (end - first) / 2, record.y.size() - 1);
    first = end;
  }
  return steady;
}

// Whether the means of four parts are alike: a swing that moves by steps of the sensor stays in a wide band
// too.
bool is_still(std::span<const double> held, double amplitude) {
  constexpr std::size_t parts = 4;
  const std::size_t each = held.size() / parts;
  std::array<double, parts> means{};
  for (std::size_t part = 0; part < parts; ++part)
    for (std::size_t i = 0; i < each; ++i) means[part] += held[part * each + i] / static_cast<double>(each);
  const auto [low, high] = extent_of(std::span<const double>(means));
  return high - low < 0.35 * amplitude + 4 * noise_of(held) / std::sqrt(static_cast<double>(each));
}

// Held still, displaced or at rest.
std::optional<FreePart> after_the_hold(const Record& record, const SwingAbout& swing) {
  // The amplitude by the largest distances but a few, which may be spikes.
  std::vector<double> distances;
  distances.reserve(record.y.size());
  for (const double y : record.y) distances.push_back(std::abs(y - swing.centre));
  const auto n = static_cast<double>(distances.size());
  const double amplitude = quantile(distances, 1 - std::max(2.5 / n, 0.005));
  // A first value alone may be off by noise: the mean of the first quarter period.
  double held = 0;
  std::size_t quarter = 0;
  while (record.t[quarter] - record.t[0] < 0.25 * swing.period) held += record.y[quarter++];
  if (quarter < 3) return std::nullopt;
  held /= static_cast<double>(quarter);
  // It is let go where three samples in a row leave the band on one side; noise alone does not do that.
  const double band = std::max(0.05 * amplitude, 4 * noise_of(record.y.first(quarter)));
  // A swing itself would stay in a wider one for half a period.
  if (std::max(band, 4 * noise_beside(swing, amplitude, record)) > 0.7 * amplitude) return std::nullopt;
  const auto side = [&](std::size_t i) {
    const double off = record.y[std::min(i, record.y.size() - 1)] - held;
    return off > band ? 1 : off < -band ? -1 : 0;
  };
  std::size_t last = 0;
  while (last < record.t.size() &&
         !(side(last) != 0 && side(last + 1) == side(last) && side(last + 2) == side(last)))
    ++last;
  // A swing stays so close to its turning point for a fifth of a period at most.
  if (last < 4 || last >= record.t.size() || record.t[last] - record.t[0] < 0.5 * swing.period)
    return std::nullopt;
  if (!is_still(record.y.first(last), amplitude)) return std::nullopt;
  double from = record.t[last - 1];
  const double displaced = std::abs(held - swing.centre);
  // What is held displaced is let go once: a step of the sensor where the swing turns comes back.
  if (displaced >= 0.5 * amplitude) {
    const double as_long = 0.8 * (record.t[last - 1] - record.t[0]);
    double since = HUGE_VAL;  // when it came within the band
    for (std::size_t i = last; i < record.t.size(); ++i) {
      if (side(i) != 0)
        since = HUGE_VAL;
      else if (since = std::min(since, record.t[i]); record.t[i] - since > as_long)
        return std::nullopt;
    }
  }
  // Where it was at rest, something has set it going: free it is when it comes back from its first large
  // swing.
  if (displaced < 0.5 * amplitude) {
    std::size_t i = last;
    while (i < record.t.size() && std::abs(record.y[i] - swing.centre) < 0.8 * amplitude) ++i;
    // A beat rises slowly.
    if (i >= record.t.size() || record.t[i] - record.t[last] > 2 * swing.period) return std::nullopt;
    const double first = record.y[i] - swing.centre;
    while (i < record.t.size() && (record.y[i] - swing.centre) * first > 0) ++i;
    if (i >= record.t.size()) return std::nullopt;
    from = record.t[steady_from(record, i, swing, amplitude)];
  }
  if (record.t.back() - from < 4 * swing.period) return std::nullopt;
  return FreePart{from, Notice{displaced < 0.5 * amplitude ? "held_still_then_set_going" : "held_still_until",
                               {{"time", record.t[last - 1]}}}};
}

// The value that the last samples have most often, to half a rounding step.
double last_value(const Record& record) {
  const std::size_t n = record.y.size(), few = std::max<std::size_t>(16, n / 20);
  std::vector<double> last(record.y.end() - static_cast<std::ptrdiff_t>(few), record.y.end());
  std::sort(last.begin(), last.end());
  std::size_t most = 0;
  double value = last.front();
  for (std::size_t first = 0, i = 1; i <= last.size(); ++i) {
    if (i < last.size() && last[i] - last[first] <= 0.5 * record.resolution) continue;
    if (i - first > most) most = i - first, value = last[first];
    first = i;
  }
  return value;
}

// Root mean square of the changes over these samples, and half of what their values span.
struct Liveliness {
  double change = 0, amplitude = 0;
};

Liveliness liveliness_of(std::span<const double> y) {
  Liveliness found;
  for (std::size_t i = 1; i < y.size(); ++i)
    found.change += (y[i] - y[i - 1]) * (y[i] - y[i - 1]) / static_cast<double>(y.size() - 1);
  found.change = std::sqrt(found.change);
  const auto [low, high] = extent_of(y);
  found.amplitude = 0.5 * (high - low);
  return found;
}

}  // namespace

std::optional<FreePart> find_free_part(const Record& record) {
  if (record.t.size() < 64) return std::nullopt;
  const std::optional<SwingAbout> swing = swing_at_end(record);
  if (!swing) return std::nullopt;
  if (auto part = after_the_drive(windows_of(record, swing->period), swing->period)) return part;
  return after_the_hold(record, *swing);
}

std::optional<double> period_at_start(const Record& record) {
  const auto swing = swing_about_mean_of(record.y.first(record.y.size() / 3), record);
  return swing ? std::optional(swing->period) : std::nullopt;
}

std::optional<LostMotion> find_lost_motion(const Record& record) {
  const std::span<const double> y = record.y;
  const std::size_t n = y.size();
  if (n < 64) return std::nullopt;
  LostMotion lost;
  lost.value = last_value(record);
  const auto stays = [&](std::size_t i) { return std::abs(y[i] - lost.value) <= 0.5 * record.resolution; };
  // From the end back, as far as those at the value outnumber the others.
  long score = 0, best = 0;
  lost.seen = n;
  for (std::size_t i = n; i-- > 0;) {
    score += stays(i) ? 1 : -1;
    if (score > best) best = score, lost.seen = i;
  }
  if (lost.seen < 32 || lost.seen + 8 > n) return std::nullopt;
  std::size_t at_value = 0;
  for (std::size_t i = lost.seen; i < n; ++i) at_value += stays(i);
  lost.share = static_cast<double>(at_value) / static_cast<double>(n - lost.seen);
  if (lost.share < 0.6) return std::nullopt;

  // In full swing: what was seen last is as lively as a swing is, and where it stays is no turning point.
  const Record seen{record.t.first(lost.seen), y.first(lost.seen), record.resolution, record.derivative};
  const std::optional<SwingAbout> swing = swing_at_end(seen);
  if (!swing || record.t.back() - record.t[lost.seen] < swing->period) return std::nullopt;
  const auto since = [&](double periods) {
    const double from = seen.t.back() - periods * swing->period;
    return static_cast<std::size_t>(std::lower_bound(seen.t.begin(), seen.t.end(), from) - seen.t.begin());
  };
  const std::size_t period = since(1), moment = std::min(since(1.0 / 16), lost.seen - 3);
  if (lost.seen - period < 8) return std::nullopt;
  const Liveliness last = liveliness_of(y.subspan(period, lost.seen - period)), all = liveliness_of(seen.y);
  if (last.amplitude < std::max(5 * record.resolution, 0.1 * all.amplitude)) return std::nullopt;
  const bool moving = liveliness_of(y.subspan(moment, lost.seen - moment)).change > 0.8 * last.change;
  const bool jumps = std::abs(lost.value - seen.y.back()) > 4 * last.change;
  const bool away = std::abs(lost.value - swing->centre) > 0.6 * last.amplitude;
  if (!moving && !jumps && !away) return std::nullopt;
  return lost;
}

}  // namespace cromer::core
