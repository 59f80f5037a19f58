#include "cromer/identify/start/start_values.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/least_squares/sampling.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_samples = 8192;  // of the part searched
constexpr double most_steps = 32768;        // of its duration

// A copy of some of a record's samples.
struct Samples {
  std::vector<double> t, y;

  void add(double time, double value) {
    t.push_back(time);
    y.push_back(value);
  }
  Record record() const { return {t, y, 0}; }
};

double duration_of(const Record& record) { return record.t.back() - record.t.front(); }

double mean_step(const Record& record) {
  return duration_of(record) / static_cast<double>(record.t.size() - 1);
}

// Means over groups of consecutive samples; a gap ends a group.
Samples group_means(const Record& record, std::size_t groups) {
  Samples means;
  const std::size_t n = record.t.size(), size = (n + groups - 1) / groups;
  const double longest = 2 * static_cast<double>(size) * mean_step(record);
  for (std::size_t i = 0; i < n;) {
    double t = 0, y = 0;
    std::size_t j = i;
    for (; j < std::min(n, i + size) && (j == i || record.t[j] - record.t[i] < longest); ++j) {
      t += record.t[j];
      y += record.y[j];
    }
    means.add(t / static_cast<double>(j - i), y / static_cast<double>(j - i));
    i = j;
  }
  return means;
}

// One sample in so many, few enough for a search and at least eight a period.
Samples thinned(const Record& all, double w) {
  constexpr std::size_t wanted = 1024;
  const auto most = static_cast<std::size_t>(std::max(1.0, two_pi / (8 * w * mean_step(all))));
  const std::size_t stride = std::min(most, std::max<std::size_t>(1, all.t.size() / wanted));
  Samples thin;
  for (std::size_t i = 0; i < all.t.size(); i += stride) thin.add(all.t[i], all.y[i]);
  return thin;
}

double variation(const Record& samples) {
  double mean = 0, sum = 0;
  for (double y : samples.y) mean += y;
  mean /= static_cast<double>(samples.y.size());
  for (double y : samples.y) sum += (y - mean) * (y - mean);
  return sum / static_cast<double>(samples.y.size());
}

// A fit of one spectral line to the samples of a part.
struct LineFit {
  Parameters phasor{};
  double mean_square = HUGE_VAL;  // of what it leaves
  double frequency_error = 0;     // [rad/s]
  double rival = 0, rival_excess = 0;
};

// The best of the frequencies and decay rates tried, with the amplitudes that fit best.
struct GridPoint {
  Parameters phasor{};
  double sum_of_squares = HUGE_VAL;

  void try_at(const DampedPhasor& model, double w, double g) {
    const DampedPhasor::Linear at = model.best_linear(w, g);
    if (at.sum_of_squares < sum_of_squares)
      *this = {{w, g, at.equilibrium, at.cosine, at.sine}, at.sum_of_squares};
  }

  // The decay rates worth trying: none, and from one that is hardly seen within the record to one gone within
  // a radian (most_damping 1) or less. The minimum is narrower than three to the next. Where none is best,
  // the swing may grow.
  void try_decays(const DampedPhasor& model, double w, double duration, double most_damping) {
    const double before = sum_of_squares, least = 0.1 / duration;
    for (double g = 0; g <= most_damping * w; g = g > 0 ? 3 * g : least) try_at(model, w, g);
    if (phasor[DampedPhasor::decay_rate] > 0 || !(sum_of_squares < before)) return;
    for (double g = least; g <= std::min(most_damping * w, 30 / duration); g *= 3) try_at(model, w, -g);
  }
};

// The minimum nearest to a grid point.
LineFit refined(const Record& samples, const DampedPhasor& model, const GridPoint& point) {
  const auto n = static_cast<double>(samples.t.size());
  LeastSquaresOptions settings;
  settings.iteration_limit = 12;
  settings.error_tolerance = 0.1;
  settings.scale = std::sqrt(n * variation(samples));
  settings.residuals = static_cast<int>(samples.t.size());
  settings.lower[DampedPhasor::angular_frequency] = 1e-3 / duration_of(samples);
  if (point.phasor[DampedPhasor::decay_rate] >= 0) settings.lower[DampedPhasor::decay_rate] = 0;
  const LeastSquaresSummary minimum = minimise(model, point.phasor, settings);
  return {minimum.parameters, minimum.equations.sum_of_squares / n,
          frequency_error(minimum, samples.t.size())};
}

// The best fit near one frequency.
LineFit fit_line(const Record& part, double w) {
  const Samples thin = thinned(part, w);
  const Record samples = thin.record();
  const DampedPhasor model(samples);
  GridPoint best;
  best.try_decays(model, w, duration_of(part), 1);
  return refined(samples, model, best);
}

bool is_even(std::span<const double> t) {
  const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  int off = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    off += std::abs(t[i] - t[0] - static_cast<double>(i) * mean) > 0.5 * mean;
  return off == 0;
}

// The best fit of a few periods: a window over them would blur every line. Of even samples no frequency above
// half their rate is tried: a lower one looks the same.
LineFit search_few_periods(const Record& part) {
  const double T = duration_of(part);
  const Samples means = group_means(part, 256), thin = thinned(part, 7 * two_pi / T);
  const DampedPhasor coarse(means.record());
  GridPoint best;
  const double half_rate = 0.5 * static_cast<double>(part.t.size() - 1);
  const double most = is_even(part.t) ? std::min(7.0, half_rate) : 7;
  for (double periods = 0.6; periods < most; periods += 0.16)
    best.try_decays(coarse, periods * two_pi / T, T, 10);
  return refined(thin.record(), DampedPhasor(thin.record()), best);
}

// The step that a tenth of all steps are shorter than.
double smaller_step(std::span<const double> t) {
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 1; i < t.size(); ++i) steps[i - 1] = t[i] - t[i - 1];
  return quantile(steps, 0.1);
}

// The spectrum's lines, highest first. Gaps make several of one sinusoid, any of which may be the true one.
std::vector<SpectralLine> lines_of(const Record& part) {
  if (is_even(part.t)) return strongest_lines(amplitude_spectrum(part.y, mean_step(part)), 0.7, 4);
  const double h = std::max(smaller_step(part.t), duration_of(part) / most_steps);
  return strongest_lines(least_squares_spectrum(part.t, part.y, h), 0.5, 16);
}

// The best fit at the spectrum's lines, if the first is one: more than six periods, and a fiftieth of the
// variance at least. Above a drift without an oscillation stands nothing but rounding.
std::optional<LineFit> search_lines(const Record& part) {
  const double duration = duration_of(part), slowest = 6 * two_pi / duration;
  const std::vector<SpectralLine> lines = lines_of(part);
  if (lines.empty() || lines[0].angular_frequency < slowest) return std::nullopt;
  std::vector<LineFit> fits;
  for (const SpectralLine& line : lines)
    if (line.angular_frequency >= slowest) fits.push_back(fit_line(part, line.angular_frequency));
  const auto leaves_less = [](const LineFit& a, const LineFit& b) { return a.mean_square < b.mean_square; };
  LineFit best = *std::min_element(fits.begin(), fits.end(), leaves_less);
  if (best.mean_square > 0.98 * variation(part)) return std::nullopt;
  // A fit that has run to the same minimum is no rival.
  const auto same = [&](const LineFit& fit) {
    return std::abs(fit.phasor[DampedPhasor::angular_frequency] -
                    best.phasor[DampedPhasor::angular_frequency]) *
               duration <
           0.5 * two_pi;
  };
  fits.erase(std::remove_if(fits.begin(), fits.end(), same), fits.end());
  if (fits.empty()) return best;
  const LineFit next = *std::min_element(fits.begin(), fits.end(), leaves_less);
  best.rival = next.phasor[DampedPhasor::angular_frequency];
  best.rival_excess = next.mean_square / best.mean_square - 1;
  return best;
}

// The first samples; where they span too long a time, those of the fullest stretch that does not.
StartValues searched_part(const Record& record) {
  const std::size_t n = record.t.size();
  StartValues part;
  part.samples = std::min(n, most_samples);
  if (is_even(record.t.first(part.samples))) return part;
  const double longest = most_steps * find_sampling(record.t.first(part.samples)).step;
  if (record.t[part.samples - 1] - record.t[0] <= longest) return part;
  part.samples = 0;
  for (std::size_t first = 0, last = 0; first < n; ++first) {
    while (last < n && last - first < most_samples && record.t[last] - record.t[first] <= longest) ++last;
    if (last - first > part.samples) part.first = first, part.samples = last - first;
  }
  return part;
}

void set_line(StartValues& start, const LineFit& fit) {
  start.phasor = fit.phasor;
  start.frequency_error = fit.frequency_error;
  start.rival = fit.rival;
  start.rival_excess = fit.rival_excess;
}

// Moves a phasor's first time by dt [s].
void shift(Parameters& phasor, double dt) {
  const std::complex<double> turn = std::exp(
      std::complex<double>(-phasor[DampedPhasor::decay_rate], phasor[DampedPhasor::angular_frequency]) * dt);
  const double A = phasor[DampedPhasor::cosine], B = phasor[DampedPhasor::sine];
  phasor[DampedPhasor::cosine] = A * turn.real() + B * turn.imag();
  phasor[DampedPhasor::sine] = B * turn.real() - A * turn.imag();
}

}  // namespace

std::optional<StartValues> find_start_values(const Record& record) {
  StartValues start = searched_part(record);
  const Record part = record.part(start.first, start.samples);
  const bool whole = start.samples == record.t.size();
  std::optional<LineFit> best = search_lines(part), few;
  // The line may be noise on a motion of which the part shows few periods, which then accounts for more, or
  // is none at all where it dies down within a period.
  const auto is_line = [&](const LineFit& fit) {
    const double w = fit.phasor[DampedPhasor::angular_frequency], g = fit.phasor[DampedPhasor::decay_rate];
    return fit.mean_square <= 0.5 * variation(part) && w * duration_of(part) > two_pi && 3 * w > g;
  };
  if (!best || !is_line(*best)) few = search_few_periods(part);
  if (best && few && few->mean_square < best->mean_square) best = std::nullopt;
  if (best || whole) {
    set_line(start, best ? *best : *few);
  } else {
    const Samples means = group_means(record, most_samples);
    const std::optional<LineFit> slow = search_lines(means.record());
    set_line(start, slow ? *slow : search_few_periods(means.record()));
    start.first = 0;
    start.samples = record.t.size();
    shift(start.phasor, record.t.front() - means.t.front());
  }
  if (!std::isfinite(start.phasor[DampedPhasor::cosine])) return std::nullopt;
  return start;
}

double frequency_error(const LeastSquaresSummary& minimum, std::size_t samples) {
  constexpr int unknowns = DampedPhasor::parameter_count;
  const double degrees = std::max(1.0, static_cast<double>(samples) - unknowns);
  const SquareMatrix scatter = inverse(minimum.equations.matrix, unknowns);
  return std::sqrt(scatter[0][0] * minimum.equations.sum_of_squares / degrees);
}

StartValues grown(const Record& record, const StartValues& start) {
  constexpr double widened = 4;  // noise may be correlated, and the law another
  const std::size_t more = 7 * start.samples;
  const std::size_t after = std::min(more, record.t.size() - start.first - start.samples);
  StartValues next = start;
  next.first -= std::min(start.first, more - after);
  next.samples = std::min(start.first - next.first + start.samples + after, record.t.size());
  const Record part = record.part(next.first, next.samples);
  shift(next.phasor, part.t.front() - record.t[start.first]);
  const double error = widened * start.frequency_error, T = duration_of(part);
  const double beside = std::ceil(error * T);
  constexpr double most = 2000;  // an absurd time cannot be reached
  if (error * T < 0.5 || !(beside < most)) return next;
  const double w = next.phasor[DampedPhasor::angular_frequency];
  const Samples thin = thinned(part, w);
  const DampedPhasor model(thin.record());
  GridPoint best;
  for (double i = -beside; i <= beside; ++i)
    best.try_at(model, w + i / T, next.phasor[DampedPhasor::decay_rate]);
  next.phasor = best.phasor;
  return next;
}

}  // namespace cromer::core
