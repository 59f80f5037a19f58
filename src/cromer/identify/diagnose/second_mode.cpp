#include "cromer/identify/diagnose/second_mode.h"

#include <algorithm>
#include <cmath>

#include "cromer/analysis/spectrum.h"
#include "cromer/analysis/swing.h"
#include "cromer/base/even_steps.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/motion/damped_phasor.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_residuals = 1U << 17;

// The residuals at even times.
std::vector<double> even(std::span<const double> t, const std::vector<double>& r, double h) {
  if (even_steps(t).farthest < 1e-6 * h) return r;
  std::vector<double> values;
  values.reserve(t.size());
  std::size_t i = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double at = t.front() + static_cast<double>(k) * h;
    while (i + 2 < t.size() && t[i + 1] <= at) ++i;
    const double share = std::clamp((at - t[i]) / (t[i + 1] - t[i]), 0.0, 1.0);
    values.push_back((1 - share) * r[i] + share * r[i + 1]);
  }
  return values;
}

// The swing's own frequencies, from its first amplitude to rest.
FrequencyBand own_band(const LawFit& fit) {
  const Motion& p = fit.motion;
  const double w0 = p.angular_frequency();
  const double w = std::sqrt(std::max(0.01 * w0 * w0, w0 * w0 - p.decay_rate() * p.decay_rate()));
  const double A = std::hypot(p.position, p.velocity / w0);
  double first = p.law.has<Pendulum>() ? w * std::max(0.2, 1 - A * A / 16) : w;
  for_each_term([&]<class T>() {
    if constexpr (!HasInnerState<T>)
      if (p.law.has<T>() && !springs.has<T>())
        first += p.per_mass.*T::template members<double>[0] * cycle_average<T>(A, w).shift;
  });
  return {std::min(w, std::max(first, 0.2 * w)), std::max(w, first), fit.swing_frequency().standard_error};
}

double median_around(const std::vector<double>& a, std::size_t k, std::size_t reach) {
  std::vector<double> around;
  for (std::size_t i = k > reach ? k - reach : 1; i < std::min(a.size(), k + reach + 1); ++i)
    if (i + 4 < k || i > k + 4) around.push_back(a[i]);
  return around.empty() ? 0 : upper_median(around);
}

struct Exponential {
  double decay_rate = 0;  // [1/s]
  DampedPhasor::Linear linear;

  double amplitude() const { return std::hypot(linear.cosine, linear.sine); }
};

// The exponential of this frequency that leaves least, of decay rates from 0 on below `most`, in steps by the
// record's `duration` [s].
Exponential best_exponential(const DampedPhasor& phasor, double duration, double angular_frequency,
                             double most) {
  Exponential best;
  double least = HUGE_VAL, g = 0;
  do {
    const DampedPhasor::Linear linear = phasor.best_linear(angular_frequency, g);
    if (linear.sum_of_squares < least) {
      least = linear.sum_of_squares;
      best = {g, linear};
    }
    g = g > 0 ? 1.6 * g : 0.3 / duration;
  } while (g < most);
  return best;
}

// Amplitude at the first sample, decay rate and frequency of one line: from a grid of decay rates by least
// squares.
void measure(const Record& residuals, ResidualLine& line) {
  const double duration = residuals.t.back() - residuals.t.front();
  const DampedPhasor phasor(residuals);
  const Exponential found = best_exponential(phasor, duration, line.angular_frequency, 20 / duration);
  line.decay_rate = found.decay_rate;
  line.amplitude = found.amplitude();
  Parameters start{};
  start[DampedPhasor::angular_frequency] = line.angular_frequency;
  start[DampedPhasor::decay_rate] = found.decay_rate;
  start[DampedPhasor::equilibrium] = found.linear.equilibrium;
  start[DampedPhasor::cosine] = found.linear.cosine;
  start[DampedPhasor::sine] = found.linear.sine;
  line.frequency_error = two_pi / duration;
  const auto n = static_cast<double>(residuals.t.size());
  LeastSquaresOptions options;
  options.scale = centred_norm(residuals.y);
  options.residuals = static_cast<int>(residuals.t.size());
  options.iteration_limit = 20;
  options.error_tolerance = 1e-2;
  options.lower[DampedPhasor::angular_frequency] = 1e-3 / duration;
  options.lower[DampedPhasor::decay_rate] = 0;
  const LeastSquaresSummary fit = minimise(phasor, start, options);
  const double w = fit.parameters[DampedPhasor::angular_frequency];
  if (fit.reason != LeastSquaresReason::converged || std::abs(w - line.angular_frequency) > two_pi / duration)
    return;
  const SquareMatrix covariance = inverse(fit.equations.matrix, DampedPhasor::parameter_count);
  const double variance = fit.equations.sum_of_squares / n;
  const double error = std::sqrt(variance * covariance[0][0]);
  if (!std::isfinite(error)) return;
  line.angular_frequency = w;
  line.frequency_error = error;
  line.decay_rate = fit.parameters[DampedPhasor::decay_rate];
  line.amplitude = std::hypot(fit.parameters[DampedPhasor::cosine], fit.parameters[DampedPhasor::sine]);
}

Notice name_of(const ResidualLine& line, const FrequencyBand& own) {
  if (line.harmonic == 0) return Notice{line.among_others ? "line_among_others" : "second_mode"};
  // It is one of the swing at the amplitude that it had then.
  const double swing = std::clamp(line.angular_frequency / line.harmonic, own.low, own.high);
  const bool varies = own.high - own.low > 1e-4 * own.high;
  return Notice{line.harmonic == 2   ? "second_harmonic"
                : line.harmonic == 3 ? "third_harmonic"
                                     : "higher_harmonic",
                {{"order", line.harmonic}, {"swing", swing / two_pi}, {"frequencies", varies ? 2 : 1}}};
}

Notice at_first(const ResidualLine& line) { return Notice{line.lasts ? "lasting_with" : "at_first_with"}; }

// How far the skirts of a line reach on either side, [rad/s].
double skirt_of(double duration, const LawFit& fit) {
  return 4 * std::max(two_pi / duration, fit.decay_rate().value);
}

struct LinesOfSpectrum {
  std::vector<ResidualLine> lines;
  double top = 0, top_amplitude = 0;  // [rad/s] where the spectrum is largest, and how large
};

// The lines that stand out of a spectrum of the residuals at even times, over `duration` [s], and are not the
// swing's own; and its largest peak.
LinesOfSpectrum residual_lines_of(const std::vector<double>& values, double h, double duration,
                                  const FrequencyBand& own, double skirt) {
  const Spectrum spectrum = amplitude_spectrum(values, h);
  const std::vector<double>& a = spectrum.amplitude;
  double power = 0;
  for (const double value : values) power += value * value / static_cast<double>(values.size());
  const double resolution = two_pi / duration;
  const auto bins = static_cast<std::size_t>(std::max(1.0, std::round(resolution / spectrum.step)));

  LinesOfSpectrum found;
  for (std::size_t k = 2; k + 1 < a.size(); ++k) {
    const double w = static_cast<double>(k) * spectrum.step;
    const bool is_peak = a[k] >= a[k - 1] && a[k] > a[k + 1];
    // Slower than four cycles in the record is drift.
    if (!is_peak || w < 4 * resolution) continue;
    if (a[k] > found.top_amplitude) {
      found.top = w;
      found.top_amplitude = a[k];
    }
    if (own.holds(w, 1, skirt)) continue;
    // The window lets a lasting line's amplitude through; its power is half the square.
    if (0.5 * a[k] * a[k] < 0.05 * power || a[k] < 6 * median_around(a, k, 40 * bins)) continue;
    ResidualLine line;
    line.angular_frequency = w + offset_of_maximum(a[k - 1], a[k], a[k + 1]) * spectrum.step;
    line.amplitude = a[k];
    found.lines.push_back(line);
  }
  return found;
}

// The strongest lines, three at most, that rounding has not made; `own` and its skirts are left out.
std::vector<ResidualLine> strongest_lines(const Record& residuals, const FrequencyBand& own, double skirt) {
  const double duration = residuals.t.back() - residuals.t.front();
  const double h = duration / static_cast<double>(residuals.t.size() - 1);
  const std::vector<double> r(residuals.y.begin(), residuals.y.end());
  LinesOfSpectrum found = residual_lines_of(even(residuals.t, r, h), h, duration, own, skirt);
  std::vector<ResidualLine>& lines = found.lines;
  std::sort(lines.begin(), lines.end(), [](const ResidualLine& one, const ResidualLine& other) {
    return one.amplitude > other.amplitude;
  });
  // The skirts of a strong line are no lines of their own.
  std::vector<ResidualLine> distinct;
  for (const ResidualLine& line : lines) {
    const bool near = std::any_of(distinct.begin(), distinct.end(), [&](const ResidualLine& stronger) {
      return std::abs(stronger.angular_frequency - line.angular_frequency) < skirt;
    });
    if (!near && distinct.size() < 3) distinct.push_back(line);
  }
  constexpr double as_large = 0.8;
  const bool top_is_line = std::any_of(distinct.begin(), distinct.end(), [&](const ResidualLine& line) {
    return std::abs(line.angular_frequency - found.top) < 2 * two_pi / duration;
  });
  for (ResidualLine& line : distinct)
    line.among_others = !top_is_line && line.amplitude < as_large * found.top_amplitude;
  constexpr double hardly = 0.3;  // e-folds within the record: its amplitude is then right to 15 % throughout
  for (ResidualLine& line : distinct) {
    measure({residuals.t, residuals.y, 0}, line);
    line.lasts = line.decay_rate * duration < hardly;
    line.told_amplitude = line.amplitude;
  }
  // Rounding makes lines of its own.
  const auto rounding = [&](const ResidualLine& line) { return line.amplitude < residuals.resolution; };
  distinct.erase(std::remove_if(distinct.begin(), distinct.end(), rounding), distinct.end());
  return distinct;
}

}  // namespace

int harmonic_of(double angular_frequency, double error, const FrequencyBand& own, double duration) {
  constexpr int most = 15;
  for (int multiple = 2; multiple <= most; ++multiple)
    if (own.holds(angular_frequency, multiple,
                  3 * std::hypot(error, multiple * own.error) + 0.1 * two_pi / duration))
      return multiple;
  return 0;
}

std::vector<ResidualLine> residual_lines(const Record& record, const LawFit& fit) {
  const std::size_t n = std::min(record.t.size(), most_residuals);
  if (n < 64 || fit.status != FitStatus::converged) return {};
  const Record part = record.first(n);
  const std::vector<double> r = residuals_of(fit, part);
  if (r.size() != n) return {};
  const double duration = part.t.back() - part.t.front();
  const FrequencyBand own = own_band(fit);
  const Record residuals{part.t, r, record.resolution};
  std::vector<ResidualLine> lines = strongest_lines(residuals, own, skirt_of(duration, fit));
  for (ResidualLine& line : lines) {
    line.harmonic = harmonic_of(line.angular_frequency, line.frequency_error, own, duration);
    // It dies down as the swing does, and was not at first what an exponential makes of its whole.
    if (line.harmonic > 0 && !line.lasts)
      line.told_amplitude = best_exponential(DampedPhasor(residuals.first(n / 4)), duration / 4,
                                             line.angular_frequency, 1.6 * line.decay_rate)
                                .amplitude();
  }
  return lines;
}

std::vector<Notice> second_drives(const Record& residuals, double drive, std::string_view unit,
                                  const FrequencyBand& left_out) {
  std::vector<Notice> found;
  if (residuals.t.size() < 64) return found;
  const Record part = residuals.first(std::min(residuals.t.size(), most_residuals));
  const double duration = part.t.back() - part.t.front();
  for (const ResidualLine& line : strongest_lines(part, left_out, 4 * two_pi / duration)) {
    const int harmonic =
        drive > 0 ? harmonic_of(line.angular_frequency, line.frequency_error, {drive, drive}, duration) : 0;
    found.push_back(Notice{"line_beside_drive",
                           {{"frequency", line.angular_frequency / two_pi},
                            {"when", at_first(line)},
                            {"amplitude", line.amplitude},
                            {"unit", unit},
                            {"what", harmonic > 0 ? Notice{"harmonic_of_drive", {{"order", harmonic}}}
                                                  : Notice{"another_drive"}}}});
  }
  return found;
}

double slowest_beat(const std::vector<ResidualLine>& lines, const LawFit& fit) {
  double beat = 0;
  for (const ResidualLine& line : lines)
    beat = std::max(beat, two_pi / std::abs(line.angular_frequency - fit.swing_frequency().value));
  return beat;
}

std::vector<Notice> second_modes(const std::vector<ResidualLine>& lines, const LawFit& fit, int derivative,
                                 std::string_view unit) {
  std::vector<Notice> found;
  const Motion& p = fit.motion;
  const double w0 = p.angular_frequency();
  const double swing = std::hypot(p.position, p.velocity / w0) * std::pow(w0, derivative);
  const FrequencyBand own = own_band(fit);
  for (const ResidualLine& line : lines) {
    found.push_back(Notice{"line_beside_swing",
                           {{"frequency", line.angular_frequency / two_pi},
                            {"when", at_first(line)},
                            {"amplitude", line.told_amplitude},
                            {"unit", unit},
                            {"percent", 100 * line.told_amplitude / swing},
                            {"what", name_of(line, own)}}});
  }
  return found;
}

}  // namespace cromer::core
