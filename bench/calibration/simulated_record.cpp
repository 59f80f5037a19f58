#include "bench/calibration/simulated_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/sensor.h"
#include "cromer/run/solve.h"

namespace cromer::core::bench {
namespace {

constexpr double sample_step = 2 * std::numbers::pi / natural_frequency / samples_per_cycle;  // [s]

double noise_of(const Condition& condition) { return amplitude / condition.amplitude_to_noise; }

// Samples that the gaps of a condition leave: three stretches are gone, and one in ten of the rest.
bool is_missing(std::size_t i, std::size_t n, SplitMix64& random) {
  const double place = static_cast<double>(i) / static_cast<double>(n);
  const bool in_gap =
      (place > 0.2 && place < 0.26) || (place > 0.41 && place < 0.5) || (place > 0.8 && place < 0.83);
  return random.next_signed_unit() < -0.8 || in_gap;
}

// Half of the samples, in three blocks within the record.
bool is_in_half(std::size_t i, std::size_t n) {
  const double place = 10 * static_cast<double>(i) / static_cast<double>(n);
  return (place > 1.5 && place < 3.5) || (place > 4.5 && place < 6) || (place > 7.5 && place < 9);
}

// The waveform between its points, u in points.
double between(const std::vector<double>& x, double u) {
  const auto i = static_cast<std::size_t>(std::clamp(u, 0.0, static_cast<double>(x.size() - 2)));
  return x[i] + (u - static_cast<double>(i)) * (x[i + 1] - x[i]);
}

}  // namespace

Waveform simulate_waveform(const Oscillator<double>& oscillator, double phase, double cycles) {
  const State<double> start{amplitude * std::cos(phase), -amplitude * natural_frequency * std::sin(phase)};
  Waveform waveform{{oscillator, start}, sample_step / Waveform::points_per_sample, {}};
  const double count = std::round(cycles * samples_per_cycle) * Waveform::points_per_sample;
  const Interval interval{0, count * waveform.step};
  KeepEvery keep(1, count_steps(interval, waveform.step));
  with_terms(oscillator, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, DormandPrince{}, interval, start, {waveform.step, 1e-12}, keep);
  });
  waveform.x = keep.take().x;
  return waveform;
}

SimulatedRecord simulate_record(const Waveform& waveform, const Condition& condition, std::uint64_t seed) {
  SplitMix64 random(seed);
  NormalDeviates normal(random.next());
  SimulatedRecord result;
  result.truth = waveform.truth;
  result.resolution = condition.resolution;
  // Where the motion lies on the sensor's steps must not matter.
  result.truth.equilibrium = 0.2 + condition.resolution * random.next_signed_unit();

  const double noise = noise_of(condition), memory = condition.correlation;
  const double innovation = noise * std::sqrt(1 - memory * memory);
  double disturbance = noise * normal.next();
  const std::size_t n = waveform.samples();
  const auto points = static_cast<std::size_t>(Waveform::points_per_sample);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t at = i * points;
    if (condition.jitter > 0 && i > 0)
      at += static_cast<std::size_t>(points * (1 + condition.jitter * random.next_signed_unit()) + 0.5) -
            points;
    if (i > 0) disturbance = memory * disturbance + innovation * normal.next();
    double x = waveform.x[at];
    if (condition.late > 0)
      x = between(waveform.x, static_cast<double>(at) + condition.late * normal.next() / waveform.step);
    double y = result.truth.equilibrium + x + disturbance;
    if (condition.growth > 0) y += condition.growth * x * normal.next();
    if (random.next_signed_unit() < 2 * condition.outliers - 1) y += amplitude * random.next_signed_unit();
    if (condition.gaps && i > 0 && is_missing(i, n, random)) continue;
    if (condition.half && is_in_half(i, n)) continue;
    if (condition.resolution > 0)
      y = to_15_digits(condition.resolution * std::round(y / condition.resolution));
    const double t = waveform.step * static_cast<double>(at);
    result.t.push_back(condition.clock > 0 ? to_15_digits(condition.clock * std::round(t / condition.clock))
                                           : t);
    result.y.push_back(y);
  }
  return result;
}

double effective_noise(const Condition& condition, double angular_frequency) {
  const double noise = noise_of(condition), r = condition.correlation;
  // An AR(1) process has the density (1 - r²)/|1 - r exp(-i w h)|².
  const double density = (1 - r * r) / (1 - 2 * r * std::cos(angular_frequency * sample_step) + r * r);
  return std::sqrt(noise * noise * density + condition.resolution * condition.resolution / 12);
}

}  // namespace cromer::core::bench
