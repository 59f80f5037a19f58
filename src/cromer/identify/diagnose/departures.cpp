#include "cromer/identify/diagnose/departures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/median.h"
#include "cromer/base/pi.h"
#include "cromer/identify/diagnose/amplitude_windows.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {
namespace {

// Share of the variance of r that one step takes away, at its best place.
struct Step {
  double share = 0, size = 0;
  std::size_t at = 0;
};

Step best_step(std::span<const double> r, double variance) {
  const auto n = static_cast<double>(r.size());
  double total = 0, before = 0;
  for (const double value : r) total += value;
  Step best;
  for (std::size_t i = 1; i < r.size(); ++i) {
    before += r[i - 1];
    const auto left = static_cast<double>(i), right = n - left;
    const double size = (total - before) / right - before / left;
    const double share = left * right / (n * n) * size * size / variance;
    if (share > best.share) best = {share, size, i};
  }
  return best;
}

struct Wandering {
  double line = 0, slope = 0;  ///< of a straight line: its share of the variance, and its slope [unit/s]
  Step step;
};

Wandering wandering_of(const Record& record, std::span<const double> r) {
  const auto n = static_cast<double>(r.size());
  double mean = 0, time = 0;
  for (std::size_t i = 0; i < r.size(); ++i) mean += r[i] / n, time += record.t[i] / n;
  double variance = 0, times = 0, product = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double dt = record.t[i] - time, dr = r[i] - mean;
    variance += dr * dr / n;
    times += dt * dt / n;
    product += dt * dr / n;
  }
  if (!(variance > 0)) return {};
  return {product * product / (times * variance), product / times, best_step(r, variance)};
}

}  // namespace

double wandering_share(const Record& record, std::span<const double> r) {
  if (r.size() < 2) return 0;
  const Wandering wandering = wandering_of(record, r);
  return std::max(wandering.line, wandering.step.share);
}

Notice wandering_zero(const Record& record, std::span<const double> r, std::string_view unit) {
  constexpr double enough = 0.3;  // of the variance
  if (r.size() < 32) return {};
  const Wandering wandering = wandering_of(record, r);
  if (std::max(wandering.line, wandering.step.share) < enough) return {};
  const double duration = record.t.back() - record.t.front();
  if (wandering.line >= wandering.step.share)
    return Notice{"zero_drifts", {{"drift", wandering.slope * duration}, {"unit", unit}}};
  return Notice{"zero_jumps",
                {{"jump", wandering.step.size}, {"unit", unit}, {"time", record.t[wandering.step.at]}}};
}

Notice sudden_stop(const Record& record, double period, std::string_view unit, bool described) {
  // Friction stops a motion too, but the amplitude then halves within the last swings. Where a law describes
  // the record, only a stop after a slower fall is reported.
  constexpr double no_friction = 0.7;
  const double least_before = described ? no_friction : 0.6;
  std::vector<AmplitudeWindow> windows = amplitude_windows(record, period, 6);
  if (windows.size() < 8) return {};
  // What is left at the end, too.
  if (const double end = record.t.back(); end > windows.back().to + 0.25 * period) {
    const auto first = std::lower_bound(record.t.begin(), record.t.end(), end - period) - record.t.begin();
    windows.push_back(
        {end - period, end, sinusoid_amplitude(record.y.subspan(static_cast<std::size_t>(first)))});
  }
  double largest = 0, later = 0;
  for (const AmplitudeWindow& window : windows) largest = std::max(largest, window.amplitude);
  // From the end: the largest amplitude of all that follows, against the one before the window between.
  for (std::size_t i = windows.size() - 1; i >= 4; --i) {
    later = std::max(later, windows[i].amplitude);
    const double before = windows[i - 2].amplitude;
    const bool in_full_swing = before > 0.2 * largest && before > least_before * windows[i - 4].amplitude,
               nearly_done = before > 0.03 * largest && before > 10 * record.resolution &&
                             before > no_friction * windows[i - 4].amplitude;
    if ((in_full_swing || nearly_done) && later < 0.1 * before)
      return Notice{
          "swing_stops",
          {{"from", windows[i - 2].to}, {"to", windows[i].from}, {"amplitude", before}, {"unit", unit}}};
  }
  return {};
}

Notice few_samples(const Record& record, double w) {
  const std::size_t n = record.t.size();
  const double h = (record.t.back() - record.t.front()) / static_cast<double>(n - 1);
  for (std::size_t i = 1; i < n; ++i)
    if (std::abs(record.t[i] - record.t[i - 1] - h) > 0.01 * h) return {};
  const double rate = 1 / h, frequency = w / (2 * pi);
  if (rate / frequency >= 4) return {};
  return Notice{"few_samples_in_a_period",
                {{"samples", rate / frequency},
                 {"rate", rate},
                 {"slower", rate - frequency},
                 {"faster", rate + frequency},
                 {"frequency", frequency}}};
}

Notice turning_over(const Record& record) {
  if (record.derivative != 0 || record.t.size() < 2) return {};
  const auto [low, high] = std::minmax_element(record.y.begin(), record.y.end());
  if (*high - *low <= 2 * pi) return {};
  // It swings about the last multiple of a turn once it has stayed within half a turn of it.
  const double rest = 2 * pi * std::round(record.y.back() / (2 * pi));
  std::size_t last = record.t.size();
  while (last > 0 && std::abs(record.y[last - 1] - rest) < pi) --last;
  const double turns = (*high - *low) / (2 * pi);
  if (last == record.t.size()) return Notice{"turns_over", {{"turns", turns}}};
  return Notice{"turns_over_at_first", {{"turns", turns}, {"time", record.t[last]}}};
}

bool leaves_a_line(const Record& record, const LawFit& fit, std::span<const double> residuals, double w,
                   double times) {
  const std::size_t n = std::min<std::size_t>(residuals.size(), 20'000);
  if (n < 32) return true;
  const DampedPhasor phasor({record.t.first(n), residuals.first(n), 0, 0});
  const double resolution = 2 * pi / (record.t[n - 1] - record.t.front());
  const auto power = [&](double at) {
    const DampedPhasor::Linear line = phasor.best_linear(at, 0);
    return line.cosine * line.cosine + line.sine * line.sine;
  };
  const double reach = std::max(3 * resolution, 3 * fit.decay_rate().value);
  double top = 0;
  for (int k = -12; k <= 12; ++k)
    if (const double at = w + reach * k / 12; at > 0) top = std::max(top, power(at));
  std::vector<double> beside;
  for (int k = 1; k <= 24; ++k)
    for (const double sign : {-1.0, 1.0}) {
      const double at = w + sign * (2 * reach + k * std::max(resolution, (0.5 * w - 2 * reach) / 24));
      if (at > 2 * resolution) beside.push_back(power(at));
    }
  if (beside.size() < 8) return true;
  return top > times * upper_median(beside);
}

}  // namespace cromer::core
