// Records of a known motion under a condition: an accurate simulation, sampled, with seeded noise.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/calibration/condition.h"
#include "bench/calibration/truth.h"
#include "cromer/identify/record.h"

namespace cromer::core::bench {

/// One motion on a grid so fine that jittered samples fall on it.
struct Waveform {
  static constexpr int points_per_sample = 20;

  Truth truth;            ///< the equilibrium is 0
  double step = 0;        // [s] of the grid
  std::vector<double> x;  // [m]

  std::size_t samples() const { return (x.size() - 1) / points_per_sample; }
};

/// By dormand-prince to a relative 1e-12, from a start of the given phase [rad].
Waveform simulate_waveform(const Oscillator<double>& oscillator, double phase, double cycles);

struct SimulatedRecord {
  std::vector<double> t, y;
  double resolution = 0;
  Truth truth;

  Record record() const { return {t, y, resolution}; }
};

/// The same seed gives the same record everywhere.
SimulatedRecord simulate_record(const Waveform& waveform, const Condition& condition, std::uint64_t seed);

/// Standard deviation [m] of the white noise that has the density of the condition's noise at a frequency
/// [rad/s]: what a bound on the scatter is made of.
double effective_noise(const Condition& condition, double angular_frequency);

}  // namespace cromer::core::bench
