#include "cromer/identify/start/forced_start.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "cromer/analysis/spectrum.h"
#include "cromer/identify/motion/recorded_force.h"

namespace cromer {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
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

// Missing samples by straight lines; before the first and after the last one that is there by its value.
std::vector<double> without_holes(std::span<const double> z) {
  std::vector<double> full(z.begin(), z.end());
  std::size_t last = full.size();  // none yet
  for (std::size_t i = 0; i < full.size(); ++i) {
    if (std::isnan(full[i])) continue;
    const std::size_t from = last == full.size() ? 0 : last + 1;
    for (std::size_t k = from; k < i; ++k)
      full[k] = from == 0 ? full[i]
                          : full[last] + (full[i] - full[last]) * static_cast<double>(k - last) /
                                             static_cast<double>(i - last);
    last = i;
  }
  for (std::size_t k = last + 1; k < full.size(); ++k) full[k] = full[last];
  return full;
}

// The transforms, over one segment, of the equation's terms under w(t) exp(-i omega t): each is one term of
//   target = gain u + bias 1 + 2g (z') - s1 z - s2 z² - s3 z³
// with z' and z'' moved onto the window by parts.
struct Segment {
  std::vector<Complex> force, one, z, z_by_slope, z_by_curvature, square, cube;
};

Segment transform(std::span<const double> u, std::span<const double> z, double h, bool curved) {
  const std::size_t n = z.size();
  const double turn = 2 * pi / static_cast<double>(n);
  const double rate = turn / h;  // [rad/s] of the window
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> product(n);
  const auto of = [&](auto value) {
    for (std::size_t i = 0; i < n; ++i) product[i] = value(i);
    std::vector<Complex> result;
    fft.fwd(result, product);
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
  if (curved) {
    s.square = of([&](std::size_t i) { return window(i) * z[i] * z[i]; });
    s.cube = of([&](std::size_t i) { return window(i) * z[i] * z[i] * z[i]; });
  }
  return s;
}

// Order of the unknowns of the linear problem.
enum Unknown { gain, bias, resistance, stiffness, quadratic, cubic, most_unknowns };

NormalEquations linear_equations(const std::vector<Segment>& segments, double h, std::size_t length, int size,
                                 double s1, double resistance_before) {
  NormalEquations equations;
  equations.size = size;
  const double step = 2 * pi / (static_cast<double>(length) * h);
  for (const Segment& s : segments) {
    const std::size_t bins = s.z.size() * 9 / 10;
    for (std::size_t k = 0; k < bins; ++k) {
      const double w = step * static_cast<double>(k);
      const Complex i_w(0, w);
      const double weight = 1 / std::norm(Complex(s1 - w * w, resistance_before * w));
      const Complex first = s.z_by_slope[k] - i_w * s.z[k];
      const Complex target = s.z_by_curvature[k] - 2.0 * i_w * s.z_by_slope[k] - w * w * s.z[k];
      Complex row[most_unknowns] = {s.force[k], s.one[k], first, -s.z[k], 0, 0};
      if (size == most_unknowns) {
        row[quadratic] = -s.square[k];
        row[cubic] = -s.cube[k];
      }
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

}  // namespace

Parameters forced_start(std::span<const double> force, const ForcedSamples& samples, double spacing,
                        bool curved) {
  const std::vector<double> z = without_holes(samples.z);
  const std::size_t n = z.size(), length = quick_length(std::min(n, longest_segment));
  std::vector<Segment> segments;
  for (std::size_t from = 0; from + length <= n; from += std::max<std::size_t>(1, length / 2))
    segments.push_back(
        transform(force.subspan(from, length), std::span(z).subspan(from, length), spacing, curved));

  const auto line = strongest_line(amplitude_spectrum(std::span(z).first(length), spacing));
  const double w_line = line ? line->angular_frequency : 2 * pi / (static_cast<double>(length) * spacing);
  double s1 = w_line * w_line, resistance_now = 0.2 * w_line;
  const int size = curved ? most_unknowns : stiffness + 1;
  Parameters found{};
  for (int round = 0; round < 4; ++round) {
    const NormalEquations equations = linear_equations(segments, spacing, length, size, s1, resistance_now);
    const ScaledCholesky factor(equations.matrix, size, 1e-13, all_free);
    if (!factor.ok()) break;
    found = factor.solve(equations.right);
    if (!(found[stiffness] > 0)) break;
    s1 = found[stiffness];
    resistance_now = std::clamp(found[resistance], 1e-4 * std::sqrt(s1), 2 * std::sqrt(s1));
  }

  const ForcedLayout at = forced_layout(RecordedForce::parameters, {.curved = curved});
  Parameters start{};
  start[RecordedForce::gain] = found[gain];
  start[at.bias] = found[bias];
  start[at.decay] = 0.5 * resistance_now;
  start[at.stiffness] = s1;
  if (curved) {
    start[at.quadratic] = found[quadratic];
    start[at.cubic] = found[cubic];
  }
  start[at.position] = z.front();
  start[at.velocity] = first_slope(z, spacing, std::sqrt(s1));
  return start;
}

}  // namespace cromer
