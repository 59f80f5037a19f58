#include "cromer/analysis/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "cromer/analysis/fourier.h"

namespace cromer::core {
namespace {

/// The samples at the ends of an interval; with a hold both are the first one.
struct Intervals {
  std::span<const double> a;
  bool hold;

  std::size_t count() const { return a.size() - (hold ? 0 : 1); }
  double begin(std::size_t i) const { return a[i]; }
  double end(std::size_t i) const { return hold ? a[i] : a[i + 1]; }
};

/// Integral of a^2 over the part p, 0 to 1, of an interval of unit length.
double square_integral(double a0, double a1, double p) {
  const double rise = p * (a1 - a0);
  return p * (a0 * a0 + a0 * rise + rise * rise / 3);
}

/// The part of the interval at which that integral reaches `share`, which it does.
double part_reaching(double a0, double a1, double share) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (square_integral(a0, a1, middle) < share ? low : high) = middle;
  }
  return high;
}

}  // namespace

Intensity intensity(std::span<const double> a, double h, BetweenSamples between) {
  double peak = 0;
  for (const double value : a) peak = std::max(peak, std::abs(value));
  if (!(peak > 0)) return {};
  // In units of a power of two near the peak, so that squares neither overflow nor vanish.
  const int exponent = std::clamp(std::ilogb(peak), -1000, 1000);
  const double scale = std::ldexp(1.0, -exponent);
  const Intervals joined{a, between == BetweenSamples::hold};
  const std::size_t intervals = joined.count();
  const auto begin = [&](std::size_t i) { return scale * joined.begin(i); };
  const auto end = [&](std::size_t i) { return scale * joined.end(i); };
  double all = 0;
  for (std::size_t i = 0; i < intervals; ++i) all += square_integral(begin(i), end(i), 1);
  if (!(all > 0)) return {};
  const auto time_of = [&](double share) {
    double sum = 0;
    for (std::size_t i = 0; i < intervals; ++i) {
      const double next = sum + square_integral(begin(i), end(i), 1);
      if (next >= share * all)
        return h * (static_cast<double>(i) + part_reaching(begin(i), end(i), share * all - sum));
      sum = next;
    }
    return h * static_cast<double>(intervals);
  };
  const double scaled = std::numbers::pi / (2 * standard_gravity) * h * all;
  const double arias = std::ldexp(scaled, 2 * exponent);
  const double from = time_of(0.05);
  return {std::isnormal(arias) ? arias : std::numeric_limits<double>::quiet_NaN(),
          std::log10(scaled) + 2 * exponent * std::log10(2.0), from, time_of(0.95) - from,
          time_of(0.75) - from};
}

GroundPath ground_path(std::span<const double> a, double h, BetweenSamples between) {
  const Intervals joined{a, between == BetweenSamples::hold};
  GroundPath path;
  path.velocity.reserve(a.size());
  path.displacement.reserve(a.size());
  double v = 0, x = 0;
  for (std::size_t i = 0; i < joined.count(); ++i) {
    path.velocity.push_back(v);
    path.displacement.push_back(x);
    const double a0 = joined.begin(i), rise = (joined.end(i) - a0) / h;
    const auto velocity = [&](double t) { return v + t * (a0 + t * rise / 2); };
    const auto displacement = [&](double t) { return x + t * (v + t * (a0 / 2 + t * rise / 6)); };
    const auto look_at = [&](double t, double& peak, const auto& value) {
      if (t > 0 && t < h) peak = std::max(peak, std::abs(value(t)));
    };
    if (rise != 0) look_at(-a0 / rise, path.peak_velocity, velocity);
    // The displacement turns where the velocity is 0: v + a0 t + rise t^2/2 = 0, without cancellation.
    const double root = std::sqrt(std::max(0.0, a0 * a0 - 2 * rise * v)), q = -(a0 + std::copysign(root, a0));
    if (rise != 0) look_at(q / rise, path.peak_displacement, displacement);
    if (q != 0) look_at(2 * v / q, path.peak_displacement, displacement);
    x = displacement(h);
    v = velocity(h);
    path.peak_velocity = std::max(path.peak_velocity, std::abs(v));
    path.peak_displacement = std::max(path.peak_displacement, std::abs(x));
  }
  if (path.velocity.size() < a.size()) {
    path.velocity.push_back(v);
    path.displacement.push_back(x);
  }
  return path;
}

double cumulative_absolute_velocity(std::span<const double> a, double h, BetweenSamples between) {
  const Intervals joined{a, between == BetweenSamples::hold};
  double sum = 0;
  for (std::size_t i = 0; i < joined.count(); ++i) {
    const double a0 = joined.begin(i), a1 = joined.end(i), both = std::abs(a0) + std::abs(a1);
    // Two triangles where the line crosses zero.
    const bool crosses = (a0 < 0) != (a1 < 0) && both > 0;
    sum += both / 2 * (crosses ? a0 / both * (a0 / both) + a1 / both * (a1 / both) : 1);
  }
  return h * sum;
}

double bracketed_duration(std::span<const double> a, double h, BetweenSamples between, double level) {
  const Intervals joined{a, between == BetweenSamples::hold};
  const auto reaches = [&](double value) { return std::abs(value) >= level; };
  // The part of an interval from the end that lies below the level to where it is reached.
  const auto part = [&](double below, double above) {
    return (std::copysign(level, above) - below) / (above - below);
  };
  double first = -1, last = 0;
  for (std::size_t i = 0; i < joined.count(); ++i) {
    const double a0 = joined.begin(i), a1 = joined.end(i), from = static_cast<double>(i);
    if (!reaches(a0) && !reaches(a1)) continue;
    if (first < 0) first = from + (reaches(a0) ? 0 : part(a0, a1));
    last = from + (reaches(a1) ? 1 : 1 - part(a1, a0));
  }
  return first < 0 ? 0 : h * (last - first);
}

FourierAmplitude fourier_amplitude(std::span<const double> a, double h) {
  const std::size_t padded = power_of_two(static_cast<double>(a.size()));
  std::vector<double> samples(padded, 0.0);
  std::copy(a.begin(), a.end(), samples.begin());
  std::vector<std::complex<double>> transformed;
  fourier_transform(samples, transformed);
  FourierAmplitude result{1 / (static_cast<double>(padded) * h), {}};
  result.amplitude.reserve(transformed.size());
  for (const auto& value : transformed) result.amplitude.push_back(h * std::abs(value));
  return result;
}

}  // namespace cromer::core
