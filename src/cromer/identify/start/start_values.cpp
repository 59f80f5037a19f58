#include "cromer/identify/start/start_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/motion/sampling.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr std::size_t longest_transform = 8192;
constexpr std::size_t grid_samples = 1024;

// A copy of some of a record's samples.
struct Samples {
  std::vector<double> t, y;

  void add(double time, double value) {
    t.push_back(time);
    y.push_back(value);
  }
  Record record() const { return {t, y, 0}; }
  double duration() const { return t.back() - t.front(); }
};

// Values on an even grid, by straight lines between the samples; a record that is even already is only
// copied.
Samples even_samples(const Record& record, std::size_t count, double h) {
  Samples even;
  const double t0 = record.t.front(), t1 = record.t[count - 1];
  const double wanted =
      (t1 - t0) / h + 1.0000001;  // may be beyond every whole number: one absurd time is enough
  const bool too_many = !(wanted <= static_cast<double>(4 * longest_transform));
  const std::size_t points = too_many ? 0 : static_cast<std::size_t>(wanted);
  if (points == count || too_many) {
    // Mostly gaps: the longest stretch without one, which is even enough.
    std::size_t first = 0, last = count;
    for (std::size_t begin = 0, i = 1; too_many && i <= count; ++i) {
      if (i < count && record.t[i] - record.t[i - 1] <= 1.5 * h) continue;
      if (begin == 0 || i - begin > last - first) first = begin, last = i;
      begin = i;
    }
    for (std::size_t i = first; i < last; ++i) even.add(record.t[i], record.y[i]);
    return even;
  }
  for (std::size_t i = 0, k = 0; k < points; ++k) {
    const double t = t0 + static_cast<double>(k) * h;
    while (i + 2 < count && record.t[i + 1] <= t) ++i;
    const double share = std::clamp((t - record.t[i]) / (record.t[i + 1] - record.t[i]), 0.0, 1.0);
    even.add(t, (1 - share) * record.y[i] + share * record.y[i + 1]);
  }
  return even;
}

// Means over groups of samples: the whole of a long record whose first part shows less than a few periods.
Samples group_means(const Record& record, std::size_t groups) {
  Samples means;
  const std::size_t size = (record.t.size() + groups - 1) / groups;
  for (std::size_t i = 0; i + size <= record.t.size(); i += size) {
    double t = 0, y = 0;
    for (std::size_t j = i; j < i + size; ++j) {
      t += record.t[j];
      y += record.y[j];
    }
    means.add(t / static_cast<double>(size), y / static_cast<double>(size));
  }
  return means;
}

// One sample in so many, few enough for a grid search and at least eight a period.
Samples thinned(const Samples& all, double w) {
  const double h = all.duration() / static_cast<double>(all.t.size() - 1);
  const auto most = static_cast<std::size_t>(std::max(1.0, two_pi / (8 * w * h)));
  const std::size_t stride = std::min(most, std::max<std::size_t>(1, all.t.size() / grid_samples));
  if (stride == 1) return all;
  Samples thin;
  for (std::size_t i = 0; i < all.t.size(); i += stride) thin.add(all.t[i], all.y[i]);
  return thin;
}

struct GridPoint {
  double w = 0, g = 0, mean_square = HUGE_VAL;  // of what it leaves
};

// The decay rates worth trying: none, and from one that is hardly seen within the record to one gone within a
// radian (most_damping 1) or less.
GridPoint search(const Samples& samples, double duration, double w_low, double w_high, int count,
                 double most_damping) {
  const DampedPhasor model(samples.record());
  GridPoint best;
  for (int i = 0; i < count; ++i) {
    const double w = count == 1 ? w_low : w_low + (w_high - w_low) * i / (count - 1);
    for (double g = 0; g <= most_damping * w; g = g > 0 ? 1.8 * g : 0.1 / duration) {
      const double rest = model.best_linear(w, g).sum_of_squares / static_cast<double>(samples.t.size());
      if (rest < best.mean_square) best = {w, g, rest};
    }
  }
  return best;
}

double step_of(const Samples& samples) {
  return samples.duration() / static_cast<double>(samples.t.size() - 1);
}

double variation(const Samples& samples) {
  double mean = 0, sum = 0;
  for (double y : samples.y) mean += y;
  mean /= static_cast<double>(samples.y.size());
  for (double y : samples.y) sum += (y - mean) * (y - mean);
  return sum / static_cast<double>(samples.y.size());
}

// The best point of a few frequencies, for records of a few periods: a window over them would blur every
// line.
GridPoint search_few_periods(const Samples& samples) {
  const double T = samples.duration();
  const Samples thin = thinned(samples, 7 * two_pi / T);
  return search(thin, T, 0.6 * two_pi / T, 7 * two_pi / T, 60, 10);
}

// The best point at the spectrum's line, if that is one: more than six periods, and a fiftieth of the
// variance at least. Above a drift without an oscillation stands nothing but rounding.
std::optional<GridPoint> search_line(const Samples& samples) {
  const std::optional<SpectralLine> line = strongest_line(amplitude_spectrum(samples.y, step_of(samples)));
  const double T = samples.duration();
  if (!line || line->angular_frequency * T < 6 * two_pi) return std::nullopt;
  const Samples thin = thinned(samples, line->angular_frequency);
  const GridPoint best = search(thin, T, line->angular_frequency, line->angular_frequency, 1, 1);
  if (best.mean_square > 0.98 * variation(thin)) return std::nullopt;
  return best;
}

}  // namespace

std::optional<StartValues> find_start_values(const Record& record) {
  const std::size_t n = record.t.size();
  StartValues start;
  start.samples = std::min(n, longest_transform);
  Samples part = even_samples(record, start.samples, find_sampling(record.t.first(start.samples)).step);
  std::optional<GridPoint> best = search_line(part);
  // The line may be noise on a motion of which the first part shows few periods.
  if (best && start.samples < n && search_few_periods(part).mean_square < best->mean_square)
    best = std::nullopt;
  if (!best && start.samples < n) {
    part = group_means(record, longest_transform);
    start.samples = n;
    best = search_line(part);
  }
  if (!best) best = search_few_periods(part);
  if (!std::isfinite(best->mean_square)) return std::nullopt;

  // Amplitudes from the part itself, now at the record's own times.
  const Record own{record.t.first(start.samples), record.y.first(start.samples), record.resolution};
  const DampedPhasor::Linear linear = DampedPhasor(own).best_linear(best->w, best->g);
  start.phasor[DampedPhasor::angular_frequency] = best->w;
  start.phasor[DampedPhasor::decay_rate] = best->g;
  start.phasor[DampedPhasor::equilibrium] = linear.equilibrium;
  start.phasor[DampedPhasor::cosine] = linear.cosine;
  start.phasor[DampedPhasor::sine] = linear.sine;
  return start;
}

}  // namespace cromer
