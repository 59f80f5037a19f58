#include "cromer/identify/start/driven_start.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/base/pi.h"
#include "cromer/identify/start/two_lines.h"

namespace cromer::core {
namespace {

constexpr std::size_t most_even_samples = 2048;
constexpr double slowest = 0.12;     // decay over the record
constexpr double dial_error = 0.01;  // of a drive's frequency, as its user gives it

struct EvenSamples {
  std::vector<double> t, y;  // times from the first sample
  double step() const { return t[1]; }
  double duration() const { return t.back(); }
};

// On an even grid of at most `most` points over the whole record, by straight lines between samples. The mean
// of what lies around a point would smooth fast lines away.
EvenSamples even_samples(const Record& record, std::size_t most) {
  const double t0 = record.t.front(), T = record.t.back() - t0;
  const std::size_t count = std::min(record.t.size(), most);
  EvenSamples even;
  for (std::size_t k = 0, i = 0; k < count; ++k) {
    const double t = t0 + T * static_cast<double>(k) / static_cast<double>(count - 1);
    while (i + 2 < record.t.size() && record.t[i + 1] <= t) ++i;
    const double share = std::clamp((t - record.t[i]) / (record.t[i + 1] - record.t[i]), 0.0, 1.0);
    even.t.push_back(t - t0);
    even.y.push_back((1 - share) * record.y[i] + share * record.y[i + 1]);
  }
  return even;
}

// The spectrum's highest lines, at most `count`, each with its frequency.
std::vector<double> highest_lines(std::span<const double> y, double h, std::size_t count) {
  Spectrum spectrum = amplitude_spectrum(y, h);
  std::vector<double> lines;
  while (lines.size() < count) {
    const auto line = strongest_line(spectrum);
    if (!line) break;
    lines.push_back(line->angular_frequency);
    // Down its slopes on both sides.
    auto& a = spectrum.amplitude;
    const auto top = static_cast<std::size_t>(
        std::clamp(line->angular_frequency / spectrum.step + 0.5, 1.0, static_cast<double>(a.size() - 1)));
    const double width = two_pi / (h * static_cast<double>(y.size()) * spectrum.step);  // bins per resolution
    const auto reach = static_cast<std::size_t>(1 + 1.5 * width);
    const std::size_t from = top > reach ? top - reach : 0, to = std::min(a.size(), top + reach + 1);
    std::fill(a.begin() + static_cast<std::ptrdiff_t>(from), a.begin() + static_cast<std::ptrdiff_t>(to),
              0.0);
  }
  return lines;
}

// Samples of a phasor, z^k with k from 0: a steady or decaying cosine and sine.
struct SampledPhasor {
  std::complex<double> ratio;       // z, from one sample to the next
  std::complex<double> projection;  // sum of z^k y_k
};

// Horner's rule from the last sample, in lanes that take every fourth: one alone waits for its own products.
// By hand, not by std::complex, whose product looks for NaN: that takes several times as long.
SampledPhasor sampled_phasor(std::complex<double> z, const EvenSamples& samples) {
  constexpr std::size_t lanes = 4;
  const std::complex<double> stride = z * z * z * z;
  const std::vector<double>& y = samples.y;
  double re[lanes]{}, im[lanes]{};
  const auto add = [&](std::size_t lane, double value) {
    const double next = re[lane] * stride.real() - im[lane] * stride.imag() + value;
    im[lane] = re[lane] * stride.imag() + im[lane] * stride.real();
    re[lane] = next;
  };
  std::size_t i = y.size() / lanes * lanes;
  for (std::size_t k = i; k < y.size(); ++k) add(k - i, y[k]);
  for (; i > 0; i -= lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(lane, y[i - lanes + lane]);
  std::complex<double> sum = 0;
  for (std::size_t lane = lanes; lane-- > 0;) sum = sum * z + std::complex<double>(re[lane], im[lane]);
  return {z, sum};
}

// 1 + z + … + zⁿ⁻¹.
std::complex<double> geometric_sum(std::complex<double> z, double n) {
  const std::complex<double> rest = 1.0 - z;
  return std::abs(rest) < 1e-12 ? n : (1.0 - std::pow(z, n)) / rest;
}

// The level, the decaying sinusoid's cosine and sine, the steady one's; the level's own equation, of n
// samples, is given. All sums of products but those with the samples are geometric.
LinearFit best_linear(NormalEquations equations, double n, const SampledPhasor& decaying,
                      const SampledPhasor& steady) {
  // Sums of the products of cosines and sines of two of them, from the product of their ratios and that with
  // the conjugate.
  const auto multiply = [&](const SampledPhasor& one, const SampledPhasor& other, int row, int column) {
    const auto together = geometric_sum(one.ratio * other.ratio, n),
               apart = geometric_sum(one.ratio * std::conj(other.ratio), n);
    equations.matrix[row][column] = (apart.real() + together.real()) / 2;
    equations.matrix[row + 1][column + 1] = (apart.real() - together.real()) / 2;
    equations.matrix[row][column + 1] = (together.imag() - apart.imag()) / 2;
    equations.matrix[row + 1][column] = (together.imag() + apart.imag()) / 2;
  };
  multiply(decaying, decaying, 1, 1);
  multiply(decaying, steady, 1, 3);
  multiply(steady, steady, 3, 3);
  for (const auto& [each, column] : {std::pair{decaying, 1}, std::pair{steady, 3}}) {
    const std::complex<double> sum = geometric_sum(each.ratio, n);
    equations.matrix[0][column] = sum.real();
    equations.matrix[0][column + 1] = sum.imag();
    equations.right[column] = each.projection.real();
    equations.right[column + 1] = each.projection.imag();
  }
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < i; ++j) equations.matrix[i][j] = equations.matrix[j][i];
  return solve(equations, 1e-9);
}

// A decaying sinusoid and a steady one; the order is that of two_lines.
struct Lines {
  double level, w, cosine, sine, g, drive, steady_cosine, steady_sine;
  double rest = HUGE_VAL;  ///< sum of squares
};

// Whether the two lie within a fifth of what the record resolves.
enum class Pair { apart, in_resonance };

// The best on the grid: a swing at each of the frequencies `natural` beside a drive at each of `drives`. In
// resonance the decay alone tells the two apart.
Lines best_pair(Pair pair, const std::vector<double>& natural, const std::vector<double>& drives,
                const EvenSamples& samples) {
  const double step = samples.step(), T = samples.duration(), resolution = two_pi / T;
  const auto n = static_cast<double>(samples.y.size());
  NormalEquations level_alone{.size = 5};
  for (const double y : samples.y) {
    const double row[] = {1};
    level_alone.add_row(row, y);
  }
  std::vector<SampledPhasor> driven;
  for (const double wd : drives) driven.push_back(sampled_phasor(std::polar(1.0, wd * step), samples));
  Lines best{};
  const auto is_near = [&](double w, double wd) { return std::abs(w - wd) < 0.2 * resolution; };
  for (const double w : natural) {
    const bool resonates =
        std::any_of(drives.begin(), drives.end(), [&](double wd) { return is_near(w, wd); });
    if (!(w > 0.2 * resolution) || (pair == Pair::in_resonance && !resonates)) continue;
    for (double g = (pair == Pair::apart ? slowest : 0.7) / T; g < w; g *= 2.5) {
      const SampledPhasor decaying = sampled_phasor(std::polar(std::exp(-g * step), w * step), samples);
      for (std::size_t i = 0; i < drives.size(); ++i) {
        if (!(drives[i] > 0) || is_near(w, drives[i]) != (pair == Pair::in_resonance)) continue;
        const LinearFit fit = best_linear(level_alone, n, decaying, driven[i]);
        const Parameters& x = fit.x;
        if (fit.rest < best.rest) best = {x[0], w, x[1], x[2], g, drives[i], x[3], x[4], fit.rest};
      }
    }
  }
  return best;
}

// Their least squares. In resonance the force follows from differences of what is found here, and the
// motion's own iteration creeps along a bent valley; from here it need not.
Lines closest_lines(const Lines& lines, const EvenSamples& samples) {
  if (!std::isfinite(lines.rest)) return lines;
  const Parameters start{lines.level, lines.w,     lines.cosine,        lines.sine,
                         lines.g,     lines.drive, lines.steady_cosine, lines.steady_sine};
  Record record;
  record.t = samples.t;
  record.y = samples.y;
  const double scale = centred_norm(samples.y);
  const LeastSquaresSummary found = two_lines::fit(record, start, two_lines::steady, scale);
  const Parameters& p = found.parameters;
  const Lines closest{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], found.equations.sum_of_squares};
  // Two that cancel one another are no better a start.
  const double most = 10 * scale / std::sqrt(static_cast<double>(samples.y.size()));
  const bool cancel = std::hypot(closest.cosine, closest.sine) > most &&
                      std::hypot(closest.steady_cosine, closest.steady_sine) > most;
  return closest.g > 0 && closest.w > closest.g && !cancel ? closest : lines;
}

}  // namespace

Motion integrated(const Motion& derivative, double pull) {
  const double w0 = derivative.angular_frequency(), acceleration = derivative.velocity;
  Motion motion = derivative;
  motion.velocity = derivative.position;
  motion.position = (pull - 2 * motion.decay_rate() * motion.velocity - acceleration) / (w0 * w0);
  return motion;
}

std::optional<Motion> driven_start(const Record& observed, std::optional<double> drive) {
  // About their mean: sums keep their digits.
  double level = 0;
  for (const double y : observed.y) level += y / static_cast<double>(observed.y.size());
  std::vector<double> z(observed.y.begin(), observed.y.end());
  for (double& value : z) value -= level;
  Record record = observed;
  record.y = z;
  const EvenSamples fine = even_samples(record, 65'536);
  const double h = fine.step(), T = fine.duration(), resolution = two_pi / T;
  std::vector<double> lines = highest_lines(fine.y, h, 4);
  if (lines.empty()) return std::nullopt;
  // What is left at the end is the drive's.
  const std::size_t third = fine.y.size() / 3;
  const std::vector<double> last =
      highest_lines(std::span(fine.y).last(std::max<std::size_t>(third, 8)), h, 1);
  lines.insert(lines.end(), last.begin(), last.end());

  // A dial may be off by more than the resolution of a long record; then another line is the drive's.
  std::vector<double> drives = lines, natural = lines, beside;
  if (drive) {
    drives = {*drive};
    for (const double line : lines)
      if (const double off = std::abs(line - *drive); off < 2 * resolution)
        drives.push_back(line);
      else if (off < dial_error * *drive)
        beside.push_back(line);
  }
  // Beside the drive's line, where the spectrum shows but one.
  for (const auto& each : {drives, beside})
    for (const double at : each)
      for (double off : {-3.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 3.0})
        natural.push_back(at + off * resolution);

  // Few enough samples for a search, and enough of them in a period of the fastest line.
  const double fastest = *std::max_element(lines.begin(), lines.end());
  const auto needed = static_cast<std::size_t>(8 * std::max(fastest, drive.value_or(0)) * T / two_pi) + 64;
  const EvenSamples coarse =
      even_samples(record, std::clamp(needed, most_even_samples, 4 * most_even_samples));

  Lines found = best_pair(Pair::apart, natural, drives, coarse);
  const double at_drive = static_cast<double>(coarse.y.size()) / 2 *
                          (found.steady_cosine * found.steady_cosine + found.steady_sine * found.steady_sine);
  if (!beside.empty() && at_drive < 0.1 * found.rest)  // nothing is there
    if (const Lines other = best_pair(Pair::apart, natural, beside, coarse); other.rest < found.rest)
      found = other;
  natural.insert(natural.end(), drives.begin(), drives.end());
  const Lines resonant = best_pair(Pair::in_resonance, natural, drives, coarse);
  const Lines best = std::min(closest_lines(found, coarse), closest_lines(resonant, coarse),
                              [](const Lines& one, const Lines& other) { return one.rest < other.rest; });
  if (!std::isfinite(best.rest)) return std::nullopt;
  const double s1 = best.w * best.w + best.g * best.g;
  const std::complex<double> steady(best.steady_cosine, -best.steady_sine);
  const std::complex<double> force =
      steady * std::complex<double>(s1 - best.drive * best.drive, 2 * best.g * best.drive);
  Motion start{.cosine = force.real(),
               .sine = -force.imag(),
               .drive_frequency = best.drive,
               .equilibrium = level + best.level,
               .position = best.cosine + best.steady_cosine,
               .velocity = best.w * best.sine - best.g * best.cosine + best.drive * best.steady_sine};
  start.set_angular_frequency(std::sqrt(s1));
  start.set_decay_rate(best.g);
  for (int d = record.derivative; d > 0; --d) {
    start = integrated(start, -start.sine / best.drive);
    const double cosine = start.cosine;
    start.cosine = -start.sine / best.drive;
    start.sine = cosine / best.drive;
  }
  return start;
}

}  // namespace cromer::core
