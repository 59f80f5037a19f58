#include "cromer/analysis/effective_oscillator.h"

#include <algorithm>

namespace cromer::core {
namespace {

using Pair = std::array<Complex<Precise>, 2>;

/// Eigenvalues of ((a, b), (c, d)), with the discriminant as a sum: tr^2/4 - det would lose five digits.
Pair eigenvalues(Precise a, Precise b, Precise c, Precise d) {
  const Precise mean = 0.5 * (a + d), half_difference = 0.5 * (a - d);
  Precise discriminant = half_difference * half_difference + b * c;
  // Two terms that cancel to rounding leave 0: at critical damping both eigenvalues are one.
  const Precise size = half_difference * half_difference + std::abs(b * c);
  if (std::abs(discriminant) <= 64 * std::numeric_limits<Precise>::epsilon() * size) discriminant = 0;
  if (discriminant < 0) {
    const Precise im = std::sqrt(-discriminant);
    return {Complex<Precise>{mean, im}, Complex<Precise>{mean, -im}};
  }
  const Precise larger = mean + std::copysign(std::sqrt(discriminant), mean);
  const Precise smaller = larger == 0 ? 0 : (a * d - b * c) / larger;
  return {Complex<Precise>{larger, 0}, Complex<Precise>{smaller, 0}};
}

/// z^3 - c2 z^2 + c1 z - c0.
struct Cubic {
  Precise c0, c1, c2;

  Precise operator()(Precise z) const { return ((z - c2) * z + c1) * z - c0; }

  Precise any_root() const {
    const Precise bound = 1 + std::max({std::abs(c0), std::abs(c1), std::abs(c2)});
    Precise low = -bound, high = bound;
    while (true) {
      const Precise middle = low + 0.5 * (high - low);
      if (!(low < middle && middle < high)) return middle;
      ((*this)(middle) < 0 ? low : high) = middle;
    }
  }

  /// The only real root, or of three the one farthest from the others.
  Precise isolated_root() const {
    const Precise first = any_root();
    const Precise mean = 0.5 * (c2 - first), product = c1 - first * (c2 - first);
    const Precise discriminant = mean * mean - product;
    if (discriminant < 0) return first;
    const Precise root = std::sqrt(discriminant);
    std::array<Precise, 3> roots{first, mean - root, mean + root};
    std::sort(roots.begin(), roots.end());
    Precise z = roots[2] - roots[1] > roots[1] - roots[0] ? roots[2] : roots[0];
    for (int i = 0; i < 3; ++i) {
      const Precise slope = (3 * z - 2 * c2) * z + c1;
      if (slope != 0) z -= (*this)(z) / slope;
    }
    return z;
  }
};

/// All three eigenvalues of a map with a carried acceleration. The real root that stands alone is the
/// method's own; the motion takes place in the plane that its left eigenvector is normal to.
std::vector<Complex<Precise>> three_eigenvalues(const StepMap& map) {
  const auto m = [&](std::size_t i, std::size_t j) { return map.column[j][i]; };
  const auto principal = [&](std::size_t i, std::size_t j) { return m(i, i) * m(j, j) - m(i, j) * m(j, i); };
  const Cubic cubic{determinant<Precise>(m), principal(0, 1) + principal(0, 2) + principal(1, 2),
                    m(0, 0) + m(1, 1) + m(2, 2)};
  const Precise own = cubic.isolated_root();

  // Normal to the columns of map - own: the largest of their cross products.
  std::array<Precise, 3> normal{};
  Precise largest = -1;
  for (std::size_t skipped = 0; skipped < 3; ++skipped) {
    const std::size_t p = (skipped + 1) % 3, q = (skipped + 2) % 3;
    const auto off = [&](std::size_t i, std::size_t j) { return m(i, j) - (i == j ? own : 0); };
    std::array<Precise, 3> cross{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      cross[i] = off(j, p) * off(k, q) - off(k, p) * off(j, q);
    }
    const Precise size = std::hypot(cross[0], cross[1], cross[2]);
    if (size > largest) largest = size, normal = cross;
  }
  const auto steepest = std::max_element(normal.begin(), normal.end(),
                                         [](Precise a, Precise b) { return std::abs(a) < std::abs(b); });
  const auto k = static_cast<std::size_t>(steepest - normal.begin());
  const std::size_t i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;
  const auto in_plane = [&](std::size_t row, std::size_t column) {
    return m(row, column) - (*steepest == 0 ? 0 : m(row, k) * normal[column] / *steepest);
  };
  const Pair pair = eigenvalues(in_plane(i, i), in_plane(i, j), in_plane(j, i), in_plane(j, j));
  return {pair[0], pair[1], {own, 0}};
}

/// The physical pair first.
std::vector<Complex<Precise>> eigenvalues(const StepMap& map) {
  if (map.size == 3) return three_eigenvalues(map);
  const Pair pair = eigenvalues(map.column[0][0], map.column[1][0], map.column[0][1], map.column[1][1]);
  return {pair[0], pair[1]};
}

Precise modulus(const Complex<Precise>& z) { return std::hypot(z.re, z.im); }

/// Z of z_n = Re Z e^{i W n h}: one component of (e^{i W h} - map)^-1 drive, by Cramer's rule.
SteadyState steady_component(const StepMap& map, Precise phase_per_step, std::size_t component) {
  const Complex<Precise> z{std::cos(phase_per_step), std::sin(phase_per_step)};
  const auto left = [&](std::size_t i, std::size_t j) {
    const Complex<Precise> diagonal = i == j ? z : Complex<Precise>{};
    return diagonal - Complex<Precise>{map.column[j][i], 0};
  };
  const auto with_drive = [&](std::size_t i, std::size_t j) {
    return j == component ? map.drive[i] : left(i, j);
  };
  const auto found = determinant<Complex<Precise>>(with_drive) / determinant<Complex<Precise>>(left);
  Precise lag = std::atan2(-found.im, found.re);
  if (lag < -std::numbers::pi_v<Precise> / 2) lag += 2 * std::numbers::pi_v<Precise>;
  return {static_cast<double>(modulus(found)), static_cast<double>(lag)};
}

}  // namespace

std::optional<double> EffectiveOscillator::energy_factor() const {
  if (!decay_rate || !angular_frequency) return std::nullopt;
  return std::exp(-4 * std::numbers::pi * *decay_rate / *angular_frequency);
}

EffectiveOscillator analyse(const StepMap& map, double h, double drive_frequency) {
  EffectiveOscillator result;
  const auto values = eigenvalues(map);
  for (const auto& z : values) {
    result.eigenvalues.push_back({static_cast<double>(z.re), static_cast<double>(z.im)});
    result.spectral_radius = std::fmax(result.spectral_radius, static_cast<double>(modulus(z)));
  }
  if (!map.converged) result.spectral_radius = std::numeric_limits<double>::quiet_NaN();

  if (const auto& z = values.front(); z.im > 0) {
    result.decay_rate = static_cast<double>(-std::log(modulus(z)) / h);
    result.angular_frequency = static_cast<double>(std::atan2(z.im, z.re) / h);
  }
  const bool driven = std::any_of(map.drive.begin(), map.drive.end(),
                                  [](const Complex<Precise>& f) { return f.re != 0 || f.im != 0; });
  if (driven && result.spectral_radius < 1 - 1e-14) {
    result.steady_state = steady_component(map, drive_frequency * h, 0);
    result.steady_velocity = steady_component(map, drive_frequency * h, 1);
    result.steady_velocity->amplitude /= h;
  }
  return result;
}

std::optional<double> first_unstable_step(const LinearLaw<double>& law,
                                          const std::function<double(double)>& spectral_radius) {
  constexpr double rounding = 1e-12, dip = 1e-14, ratio = 1.02;
  const double w = std::sqrt(law.stiffness), unit = 1 / (w + 2 * law.decay_rate);
  double stable = 0, unstable = 0, damped = 0;
  for (double h = 1e-9 * unit; h < 1e3 * unit; h *= ratio) {
    const double radius = spectral_radius(h);
    if (!(radius <= 1 + rounding)) {
      unstable = h;
      break;
    }
    stable = h;
    if (radius < 1 - dip) damped = h;
  }
  if (unstable == 0) return std::nullopt;
  // Growth too slow to be told from rounding looks stable at first. A true limit lies beyond steps that damp,
  // or is comparable to the period.
  if (stable == 0 || (damped == 0 && w * stable < 0.05)) return 0.0;
  const double most = damped > 0 ? 1 : 1 + rounding;
  if (damped > 0) stable = damped;
  while (true) {
    const double middle = 0.5 * (stable + unstable);
    if (!(stable < middle && middle < unstable)) return stable;
    (spectral_radius(middle) <= most ? stable : unstable) = middle;
  }
}

}  // namespace cromer::core
