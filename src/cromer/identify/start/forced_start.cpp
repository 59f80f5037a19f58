#include "cromer/identify/start/driven_start.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "cromer/analysis/fourier.h"
#include "cromer/analysis/spectrum.h"
#include "cromer/base/dual.h"
#include "cromer/base/pi.h"
#include "cromer/identify/fit_settings.h"

namespace cromer::core {
namespace {

using Complex = std::complex<double>;
constexpr std::size_t longest_segment = 65'536;

// The longest length up to n whose transform is quick: no prime factor above 5.
std::size_t quick_length(std::size_t n) {
  for (;; --n) {
    std::size_t rest = n;
    for (std::size_t prime : {2u, 3u, 5u})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return n;
  }
}

// Fills in missing samples by straight lines; the first and the last are known.
std::vector<double> without_holes(std::span<const double> z) {
  std::vector<double> full(z.begin(), z.end());
  std::size_t last = 0;
  for (std::size_t i = 1; i < full.size(); ++i) {
    if (std::isnan(full[i])) continue;
    for (std::size_t k = last + 1; k < i; ++k)
      full[k] =
          full[last] + (full[i] - full[last]) * static_cast<double>(k - last) / static_cast<double>(i - last);
    last = i;
  }
  return full;
}

// A term that bends the spring: its force of a unit coefficient, and the slope of that.
struct Bend {
  double Oscillator<double>::*coefficient;
  double (*force)(double);
  double (*slope)(double);
};

template <class T>
constexpr Bend bend_of{
    T::template members<double>[0], [](double z) { return T::force(z, 0.0, 1.0); },
    [](double z) { return T::force(Dual<double, 1>::variable(z, 0), 0.0, 1.0).derivative[0]; }};

// Every bent spring looks quadratic and cubic, but for one that softens and then stiffens farther out.
std::vector<Bend> bends_of(const Law& law) {
  if (law.contains(law_with<OddQuadratic, Quintic>)) return {bend_of<OddQuadratic>, bend_of<Quintic>};
  if (law.shares(law_with<Quadratic, Cubic>)) return {bend_of<Quadratic>, bend_of<Cubic>};
  return {};
}

// The transforms, over one segment, of the equation's terms under w(t) exp(-i omega t): each is one term of
//   target = gain u + bias 1 + 2g (z') - s1 z - the bends
// with z' and z'' moved onto the window by parts: (z') is minus the transform of z'.
struct Segment {
  std::vector<Complex> force, one, z, z_by_slope, z_by_curvature;
  std::vector<std::vector<Complex>> bends;
};

Segment transform(std::span<const double> u, std::span<const double> z, double h,
                  const std::vector<Bend>& bends) {
  const std::size_t n = z.size();
  const double turn = two_pi / static_cast<double>(n);
  const double rate = turn / h;  // [rad/s] of the window
  std::vector<double> product(n);
  const auto of = [&](auto value) {
    for (std::size_t i = 0; i < n; ++i) product[i] = value(i);
    std::vector<Complex> result;
    fourier_transform(product, result);
    return result;
  };
  // The square of Hann's window and its derivatives: zero at both ends up to the third.
  const auto window = [&](std::size_t i) {
    const double c = std::cos(turn * static_cast<double>(i));
    return 0.25 * (1 - c) * (1 - c);
  };
  const auto slope = [&](std::size_t i) {
    const double a = turn * static_cast<double>(i);
    return 0.5 * rate * (1 - std::cos(a)) * std::sin(a);
  };
  const auto curvature = [&](std::size_t i) {
    const double a = turn * static_cast<double>(i);
    return 0.5 * rate * rate * (std::cos(a) - std::cos(2 * a));
  };
  Segment s;
  s.force = of([&](std::size_t i) { return window(i) * u[i]; });
  s.one = of(window);
  s.z = of([&](std::size_t i) { return window(i) * z[i]; });
  s.z_by_slope = of([&](std::size_t i) { return slope(i) * z[i]; });
  s.z_by_curvature = of([&](std::size_t i) { return curvature(i) * z[i]; });
  for (const Bend& bend : bends)
    s.bends.push_back(of([&](std::size_t i) { return window(i) * bend.force(z[i]); }));
  return s;
}

// Order of the unknowns of the linear problem.
enum Unknown { gain, bias, resistance, stiffness, first_bend, most_unknowns = first_bend + 2 };

NormalEquations linear_equations(const std::vector<Segment>& segments, double h, std::size_t length, int size,
                                 double s1, double resistance_before) {
  NormalEquations equations;
  equations.size = size;
  const double step = two_pi / (static_cast<double>(length) * h);
  for (const Segment& s : segments) {
    const std::size_t bins = s.z.size() * 9 / 10;
    // Without a spring nothing ties the place down: the slowest line says nothing.
    for (std::size_t k = s1 > 0 ? 0 : 1; k < bins; ++k) {
      const double w = step * static_cast<double>(k);
      const Complex i_w(0, w);
      const double weight = 1 / std::norm(Complex(s1 - w * w, resistance_before * w));
      const Complex first = s.z_by_slope[k] - i_w * s.z[k];
      const Complex target = s.z_by_curvature[k] - 2.0 * i_w * s.z_by_slope[k] - w * w * s.z[k];
      Complex row[most_unknowns] = {s.force[k], s.one[k], first, -s.z[k]};
      for (int i = first_bend; i < size; ++i) row[i] = -s.bends[static_cast<std::size_t>(i - first_bend)][k];
      for (int i = 0; i < size; ++i) {
        equations.right[i] += weight * (std::conj(row[i]) * target).real();
        for (int j = 0; j < size; ++j) equations.matrix[i][j] += weight * (std::conj(row[i]) * row[j]).real();
      }
    }
  }
  return equations;
}

// Slope of the straight line through the samples of the first 1/16 of a period, at least three.
double first_slope(const std::vector<double>& z, double h, double w) {
  const auto count =
      static_cast<std::size_t>(std::clamp(pi / (8 * w * h), 3.0, static_cast<double>(z.size())));
  double mean = 0, top = 0, bottom = 0;
  const double middle = 0.5 * static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) mean += z[i] / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) - middle;
    top += s * (z[i] - mean);
    bottom += s * s;
  }
  return top / (bottom * h);
}

// The record's values and the force at the force's own times, from the first sample to the last. Missing
// values are filled in by straight lines.
struct OnGrid {
  std::vector<double> z, u;
  double level = 0;  // of y where z is 0
};

OnGrid on_grid(const Record& record, const ForceRecord& force) {
  const auto place = [&](double t) {
    return static_cast<std::size_t>(std::max(0.0, std::round((t - force.begin) / force.spacing)));
  };
  const std::size_t first = place(record.t.front());
  const std::size_t last = std::min(place(record.t.back()), force.samples.size() - 1);
  OnGrid grid;
  for (const double y : record.y) grid.level += y / static_cast<double>(record.y.size());
  grid.z.assign(last - first + 1, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < record.t.size(); ++i)
    if (const std::size_t k = place(record.t[i]); k <= last) grid.z[k - first] = record.y[i] - grid.level;
  grid.z = without_holes(grid.z);
  grid.u.assign(force.samples.begin() + static_cast<std::ptrdiff_t>(first),
                force.samples.begin() + static_cast<std::ptrdiff_t>(last + 1));
  return grid;
}

// By central differences: noise does no harm where a fit begins.
std::vector<double> slopes(const std::vector<double>& values, double spacing) {
  const std::size_t last = values.size() - 1;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
    result[i] = (values[after] - values[before]) / (static_cast<double>(after - before) * spacing);
  }
  return result;
}

// The spring that was found: pull(z) = bias - s1 z - the bends, z from the level.
struct FoundSpring {
  double bias = 0, s1 = 0;
  const std::vector<Bend>& bends;
  const double* coefficients;

  double pull(double z) const {
    double sum = bias - s1 * z;
    for (std::size_t i = 0; i < bends.size(); ++i) sum -= coefficients[i] * bends[i].force(z);
    return sum;
  }
  double stiffness(double z) const {
    double sum = s1;
    for (std::size_t i = 0; i < bends.size(); ++i) sum += coefficients[i] * bends[i].slope(z);
    return sum;
  }
  // The place of rest nearest 0.
  double rest() const {
    double z = 0;
    for (int i = 0; i < 50 && stiffness(z) > 0; ++i) z += pull(z) / stiffness(z);
    return std::isfinite(z) ? z : 0;
  }
};

}  // namespace

std::optional<Motion> forced_start(const Record& record, const ForceRecord& force, const Law& law) {
  OnGrid grid = on_grid(record, force);
  const bool sprung = law.shares(springs);
  const std::vector<Bend> bends = record.derivative == 0 ? bends_of(law) : std::vector<Bend>{};
  double mean_force = 0;
  for (const double u : grid.u) mean_force += u / static_cast<double>(grid.u.size());
  // The derivative of a linear motion is the motion under the force's derivative.
  std::vector<double> first_forces;
  for (int d = 0; d < record.derivative; ++d) {
    first_forces.push_back(grid.u.front());
    grid.u = slopes(grid.u, force.spacing);
  }
  const std::vector<double>& z = grid.z;
  const std::size_t n = z.size(), length = quick_length(std::min(n, longest_segment));
  const double h = force.spacing;
  std::vector<Segment> segments;
  for (std::size_t from = 0; from + length <= n; from += std::max<std::size_t>(1, length / 2))
    segments.push_back(
        transform(std::span(grid.u).subspan(from, length), std::span(z).subspan(from, length), h, bends));

  const auto line = strongest_line(amplitude_spectrum(std::span(z).first(length), h));
  const double w_line = line ? line->angular_frequency : two_pi / (static_cast<double>(length) * h);
  double s1 = sprung ? w_line * w_line : 0, resistance_now = 0.2 * w_line;
  const int size = sprung ? first_bend + static_cast<int>(bends.size()) : resistance + 1;
  Parameters found{};
  for (int round = 0; round < 4; ++round) {
    const NormalEquations equations = linear_equations(segments, h, length, size, s1, resistance_now);
    const ScaledCholesky factor(equations.matrix, size, 1e-13, all_free);
    if (!factor.ok()) break;
    found = factor.solve(equations.right);
    if (sprung && !(found[stiffness] > 0)) break;
    if (sprung) s1 = found[stiffness];
    const double w = sprung ? std::sqrt(s1) : w_line;
    resistance_now = std::clamp(found[resistance], 1e-4 * w, 2 * w);
  }

  Motion start;
  start.law = law;
  start.force_gain = found[gain];
  start.set_decay_rate(0.5 * resistance_now);
  const double slope = first_slope(z, h, sprung ? std::sqrt(s1) : w_line);
  if (!sprung) {
    const bool place = record.derivative == 0;
    if (place) start.position = z.front() + grid.level;
    start.velocity = place ? slope : record.derivative == 1 ? z.front() + grid.level : 0;
    // On average the force drives against the resistance.
    const double balance = place ? found[bias] : resistance_now * grid.level - found[gain] * mean_force;
    start.force_offset = found[gain] != 0 ? balance / found[gain] : 0;
    return start;
  }
  const FoundSpring spring{found[bias], s1, bends, &found[first_bend]};
  if (record.derivative > 0) {
    start.set_angular_frequency(std::sqrt(s1));
    start.equilibrium = grid.level + spring.rest();
    start.position = z.front() - spring.rest();
    start.velocity = slope;
    for (int d = record.derivative; d > 0; --d)
      start = integrated(start, start.force_gain * first_forces[static_cast<std::size_t>(d - 1)]);
    return start;
  }
  const bool amid = held_parameters(record, law, DriveKind::recorded).equilibrium;
  const double e = amid ? -grid.level : spring.rest();
  if (!(spring.stiffness(e) > 0)) return std::nullopt;
  start.set_angular_frequency(std::sqrt(spring.stiffness(e)));
  for (std::size_t i = 0; i < bends.size(); ++i) start.per_mass.*bends[i].coefficient = found[first_bend + i];
  start.per_mass.quadratic += 3 * start.per_mass.cubic * e;  // about the rest
  start = start.under(law);
  start.equilibrium = grid.level + e;
  start.force_offset = amid && found[gain] != 0 ? spring.pull(e) / found[gain] : 0;
  start.position = z.front() - e;
  start.velocity = slope;
  return start;
}

}  // namespace cromer::core
