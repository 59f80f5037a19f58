#include "cromer/analysis/textbook_damping.h"

#include <cmath>
#include <vector>

#include "cromer/analysis/line.h"

namespace cromer::core {
namespace {

/// Vertex of the parabola through sample i and its neighbours, their steps taken as equal.
double peak_height(std::span<const double> y, std::size_t i) {
  if (i == 0 || i + 1 == y.size() || y[i] < y[i - 1] || y[i] < y[i + 1]) return y[i];
  const double curvature = y[i - 1] - 2 * y[i] + y[i + 1], slope = y[i + 1] - y[i - 1];
  return curvature < 0 ? y[i] - slope * slope / (8 * curvature) : y[i];
}

/// |integral of y exp(-i w t)|^2 by the trapezoid, so that samples need not be equally spaced.
double power_at(std::span<const double> t, std::span<const double> y, double w) {
  double re = 0, im = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double left = i > 0 ? t[i] - t[i - 1] : 0, right = i + 1 < t.size() ? t[i + 1] - t[i] : 0;
    const double weight = 0.5 * (left + right) * y[i], phase = w * (t[i] - t[0]);
    re += weight * std::cos(phase);
    im -= weight * std::sin(phase);
  }
  return re * re + im * im;
}

/// Where a falling function passes `level` between a (above it) and b (below it).
template <class F>
double crossing(const F& f, double a, double b, double level) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (a + b);
    (f(middle) > level ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

}  // namespace

std::optional<PeakDecrement> peak_decrement(std::span<const double> t, std::span<const double> y,
                                            double period, double noise) {
  std::vector<double> number, logarithm;
  // Windows of a period about the first top and those that follow it.
  std::size_t i = 0, first = 0;
  for (; i < t.size() && t[i] < t.front() + period; ++i)
    if (y[i] > y[first]) first = i;
  i = 0;
  for (int cycle = 0; i < t.size(); ++cycle) {
    const double end = t[first] + (cycle + 0.5) * period;
    if (end > t.back()) break;
    std::size_t top = i;
    for (; i < t.size() && t[i] < end; ++i)
      if (y[i] > y[top]) top = i;
    const double peak = peak_height(y, top);
    if (!(peak > 4 * noise)) break;
    number.push_back(cycle);
    logarithm.push_back(std::log(peak));
  }
  const std::size_t n = number.size();
  if (n < 3) return std::nullopt;
  const Line line = fit_line(number, logarithm);
  const double mean = 0.5 * static_cast<double>(n - 1);
  double square = 0, spread = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double rest = logarithm[k] - line.intercept - line.slope * number[k];
    square += rest * rest;
    spread += (number[k] - mean) * (number[k] - mean);
  }
  const double error = std::sqrt(square / static_cast<double>(n - 2) / spread);
  return PeakDecrement{-line.slope, error, static_cast<int>(n)};
}

std::optional<HalfPowerBandwidth> half_power_bandwidth(std::span<const double> t, std::span<const double> y,
                                                       double w) {
  if (t.size() < 8) return std::nullopt;
  const double duration = t.back() - t.front();
  const double narrowest = 5.566 / duration;  // sinc² falls to a half at 2.783/T on either side
  const auto power = [&](double at) { return power_at(t, y, at); };
  // The highest of points a quarter of the narrowest line apart, then by golden section.
  const double step = 0.25 * narrowest;
  double best = w, highest = power(w);
  for (int k = -8; k <= 8; ++k)
    if (const double p = power(w + k * step); p > highest) {
      highest = p;
      best = w + k * step;
    }
  double a = best - step, b = best + step;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 30; ++i) {
    const double left = b - golden * (b - a), right = a + golden * (b - a);
    if (power(left) > power(right))
      b = right;
    else
      a = left;
  }
  best = 0.5 * (a + b);
  highest = power(best);
  const auto half_width = [&](double sign) -> std::optional<double> {
    for (double far = 0; far < 0.5 * w;) {
      const double next = far + step;
      if (power(best + sign * next) < 0.5 * highest)
        return crossing([&](double off) { return power(best + sign * off); }, far, next, 0.5 * highest);
      far = next;
    }
    return std::nullopt;
  };
  const auto above = half_width(1), below = half_width(-1);
  if (!above || !below) return std::nullopt;
  return HalfPowerBandwidth{*above + *below, best, narrowest};
}

}  // namespace cromer::core
