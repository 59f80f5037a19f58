#include "cromer/analysis/hysteretic_peaks.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "cromer/analysis/frequency_response.h"

namespace cromer {
namespace {

using Amplitudes = std::vector<std::complex<double>>;

/// Until a free motion has fallen to 1e-4.
double pause(double period, double loss_factor) {
  return std::log(1e4) * period / (std::numbers::pi * loss_factor);
}

std::size_t power_of_two(double least) {
  std::size_t n = 8;
  while (static_cast<double>(n) < least) n *= 2;
  return n;
}

/// Values for each sample: slow oscillators follow nothing fast.
std::size_t refinement(double period, double h) {
  std::size_t values = 1;
  while (values < 8 && period * static_cast<double>(values) < 40 * h) values *= 2;
  return values;
}

/// The largest magnitude, by a parabola through it and its neighbours.
double peak_of(const std::vector<double>& x) {
  std::size_t top = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(x[i]) > std::abs(x[top])) top = i;
  const double before = std::abs(x[(top + x.size() - 1) % x.size()]), here = std::abs(x[top]);
  const double after = std::abs(x[(top + 1) % x.size()]);
  const double bend = 2 * here - before - after;
  return bend > 0 ? here + (after - before) * (after - before) / (8 * bend) : here;
}

}  // namespace

double hysteretic_samples(std::size_t samples, double h, double longest_period, double loss_factor) {
  return static_cast<double>(samples) + pause(longest_period, loss_factor) / h;
}

std::vector<double> hysteretic_peaks(std::span<const double> acceleration, double h,
                                     std::span<const double> periods, double loss_factor) {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::map<std::size_t, Amplitudes> transforms;  // by the length they were padded to
  std::vector<double> peaks;
  for (const double period : periods) {
    const std::size_t n = power_of_two(hysteretic_samples(acceleration.size(), h, period, loss_factor));
    Amplitudes& ground = transforms[n];
    if (ground.empty()) {
      std::vector<double> padded(n, 0.0);
      std::copy(acceleration.begin(), acceleration.end(), padded.begin());
      fft.fwd(ground, padded);
    }
    const double w = 2 * std::numbers::pi / period;
    const Oscillator<double> oscillator{.mass = 1, .stiffness = w * w};
    const std::size_t values = refinement(period, h);
    Amplitudes answer(n * values / 2 + 1);
    for (std::size_t i = 0; i < ground.size(); ++i) {
      const double driven = 2 * std::numbers::pi * static_cast<double>(i) / (static_cast<double>(n) * h);
      const SteadyState steady = hysteretic_response(oscillator, i == 0 ? 0 : loss_factor, 1, driven);
      answer[i] = ground[i] * std::polar(steady.amplitude, -steady.phase_lag);
    }
    // The highest frequency stands for two halves, which part where there is more room.
    if (values > 1) answer[ground.size() - 1] *= 0.5;
    std::vector<double> x;
    fft.inv(x, answer, static_cast<Eigen::Index>(n * values));
    peaks.push_back(static_cast<double>(values) * peak_of(x));
  }
  return peaks;
}

}  // namespace cromer
