#include "cromer/analysis/hysteretic_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "cromer/analysis/fourier.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

using Amplitudes = std::vector<std::complex<double>>;

/// Between two repetitions [s]: until a free motion has fallen to 1e-4, and the tail of a large loss factor,
/// which falls as t^-2, to 1e-3.
double pause(double duration, double period, double loss_factor) {
  const double fallen = std::log(1e4) * period / (std::numbers::pi * loss_factor);
  return std::max(fallen, 8 * loss_factor / (1 + loss_factor * loss_factor) * duration);
}

/// Values computed for each sample: 16 in the fastest recorded cycle if the oscillator is as fast, fewer if
/// it hardly follows that cycle.
std::size_t refinement(double period, double h) { return period > 60 * h ? 2 : period > 10 * h ? 4 : 8; }

/// How high the quartic through five values, one apart, rises beside the middle one, the highest of them.
double top_of_quartic(const std::array<double, 5>& y) {
  const double slope = (y[0] - 8 * y[1] + 8 * y[3] - y[4]) / 12;
  const double bend = (-y[0] + 16 * y[1] - 30 * y[2] + 16 * y[3] - y[4]) / 24;
  const double third = (-y[0] + 2 * y[1] - 2 * y[3] + y[4]) / 12;
  const double fourth = (y[0] - 4 * y[1] + 6 * y[2] - 4 * y[3] + y[4]) / 24;
  double t = 0;
  for (int i = 0; i < 4; ++i) {
    const double curvature = 2 * bend + t * (6 * third + t * 12 * fourth);
    if (!(curvature < 0)) return y[2];
    t = std::clamp(t - (slope + t * (2 * bend + t * (3 * third + t * 4 * fourth))) / curvature, -1.0, 1.0);
  }
  return std::max(y[2], y[2] + t * (slope + t * (bend + t * (third + t * fourth))));
}

/// The largest magnitude of a motion that repeats, between its values too: each maximum that may be the
/// largest is refined.
double peak_of(const std::vector<double>& x) {
  const auto magnitude = [&](std::size_t i) { return std::abs(x[i % x.size()]); };
  double most = 0;
  for (const double value : x) most = std::max(most, std::abs(value));
  double peak = most;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (magnitude(i) < 0.9 * most || magnitude(i + 1) > magnitude(i) ||
        magnitude(i + x.size() - 1) > magnitude(i))
      continue;
    std::array<double, 5> values;
    for (std::size_t k = 0; k < 5; ++k)
      values[k] = std::copysign(1.0, x[i]) * x[(i + x.size() + k - 2) % x.size()];
    peak = std::max(peak, top_of_quartic(values));
  }
  return peak;
}

}  // namespace

double hysteretic_samples(std::size_t samples, double h, double longest_period, double loss_factor) {
  const auto n = static_cast<double>(samples);
  return n + pause(n * h, longest_period, loss_factor) / h;
}

std::vector<double> hysteretic_peaks(std::span<const double> acceleration, double h,
                                     std::span<const double> periods, double loss_factor) {
  std::map<std::size_t, Amplitudes> transforms;  // by the length they were padded to
  std::vector<double> peaks;
  for (const double period : periods) {
    const std::size_t n = power_of_two(hysteretic_samples(acceleration.size(), h, period, loss_factor));
    Amplitudes& ground = transforms[n];
    if (ground.empty()) {
      std::vector<double> padded(n, 0.0);
      std::copy(acceleration.begin(), acceleration.end(), padded.begin());
      fourier_transform(padded, ground);
    }
    const double w = two_pi / period;
    const Oscillator<double> oscillator{.mass = 1, .stiffness = w * w};
    const std::size_t values = refinement(period, h);
    Amplitudes answer(n * values / 2 + 1);
    for (std::size_t i = 0; i < ground.size(); ++i) {
      const double driven = two_pi * static_cast<double>(i) / (static_cast<double>(n) * h);
      const SteadyState steady = hysteretic_response(oscillator, loss_factor, 1, driven);
      answer[i] = ground[i] * std::polar(steady.amplitude, -steady.phase_lag);
    }
    // Below frequency 0 the lag turns round: there the answer is the mean of both sides.
    answer[0] = answer[0].real();
    // The highest frequency stands for two halves; on a finer grid each has its own place.
    answer[ground.size() - 1] *= 0.5;
    std::vector<double> x;
    inverse_fourier_transform(answer, n * values, x);
    peaks.push_back(static_cast<double>(values) * peak_of(x));
  }
  return peaks;
}

}  // namespace cromer::core
