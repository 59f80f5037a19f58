// Simulated records of several channels whose modes are known.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

struct TrueMode {
  double frequency = 0;  // [Hz]
  double damping_ratio = 0;
  std::vector<std::complex<double>> shape;

  std::complex<double> eigenvalue() const {
    const double w = 2 * std::numbers::pi * frequency;
    return {-damping_ratio * w, w * std::sqrt(1 - damping_ratio * damping_ratio)};
  }
};

struct MadeChannels {
  std::vector<std::vector<double>> values;
  double step = 1;

  ModalRecord record() const {
    ModalRecord result;
    for (const auto& each : values) result.channels.emplace_back(each);
    result.step = step;
    return result;
  }
};

// Two equal masses between three springs, the middle one weaker; unit masses.
inline std::vector<TrueMode> two_masses() { return {{1.6, 0.006, {1.0, 1.0}}, {4.5, 0.012, {-1.0, 1.0}}}; }

inline void add_noise(MadeChannels& channels, double share, std::mt19937& random) {
  std::normal_distribution<double> normal;
  for (auto& channel : channels.values) {
    double square = 0;
    for (const double each : channel) square += each * each / static_cast<double>(channel.size());
    for (double& each : channel) each += share * std::sqrt(square) * normal(random);
  }
}

// Accelerations under white forces that are held over each step: exact. Of modes with real, orthogonal
// shapes.
inline MadeChannels under_white_forces(const std::vector<TrueMode>& modes, std::size_t samples, double step,
                                       unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  MadeChannels channels{
      std::vector<std::vector<double>>(modes.front().shape.size(), std::vector<double>(samples)), step};
  for (const TrueMode& mode : modes) {
    const std::complex<double> value = mode.eigenvalue(), turn = std::exp(value * step),
                               push = (turn - 1.0) / value;
    std::complex<double> z = 0;
    const auto before = static_cast<std::size_t>(5 / (-value.real() * step));
    for (std::size_t i = 0; i < before + samples; ++i) {
      const double force = normal(random);
      const double acceleration = (value * value * z).imag() / value.imag() + force;
      if (i >= before)
        for (std::size_t c = 0; c < channels.values.size(); ++c)
          channels.values[c][i - before] += mode.shape[c].real() * acceleration;
      z = turn * z + push * force;
    }
  }
  add_noise(channels, 0.05, random);
  return channels;
}

inline MadeChannels let_go(const std::vector<TrueMode>& modes, const std::vector<double>& amplitudes,
                           std::size_t samples, double step, double noise, unsigned seed) {
  std::mt19937 random(seed);
  MadeChannels channels{
      std::vector<std::vector<double>>(modes.front().shape.size(), std::vector<double>(samples)), step};
  for (std::size_t j = 0; j < modes.size(); ++j)
    for (std::size_t i = 0; i < samples; ++i) {
      const auto turned = std::exp(modes[j].eigenvalue() * (static_cast<double>(i) * step));
      for (std::size_t c = 0; c < channels.values.size(); ++c)
        channels.values[c][i] += amplitudes[j] * (modes[j].shape[c] * turned).real();
    }
  add_noise(channels, noise, random);
  return channels;
}

inline bool holds(const Estimate& estimate, double value) {
  return estimate.low <= value && value <= estimate.high;
}

}  // namespace cromer::core
