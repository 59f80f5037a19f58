// Forced motions whose law and force are known: integrated finely, force and position recorded as samples.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "cromer/identify/choose/choose_law.h"
#include "cromer/methods/dormand_prince.h"

namespace cromer::core {

struct ForcedTruth {
  double w0 = 12, g = 0.35, drag = 0, quadratic = 0, cubic = 0, gain = 2.5, offset = 0;
  double equilibrium = 0, position = 0.1, velocity = -0.4;
};

/// A force of many sinusoids, none above the given frequency [rad/s]: band-limited and known at all times.
inline std::function<double(double)> multisine(double highest, unsigned seed, int lines = 60) {
  struct Line {
    double w, phase;
  };
  std::vector<Line> all;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < lines; ++i)
    all.push_back({highest * (i + part(engine)) / lines, 2 * 3.141592653589793 * part(engine)});
  return [all](double t) {
    double sum = 0;
    for (const Line& line : all) sum += std::cos(line.w * t + line.phase);
    return sum * std::sqrt(2.0 / static_cast<double>(all.size()));
  };
}

/// What a recorder makes of a force, taken back to all times.
inline std::function<double(double)> read_between(const std::vector<double>& samples, double h, bool hold) {
  return [samples, h, hold](double t) {
    const double u = t / h + 1e-9;
    const auto i = std::min(static_cast<std::size_t>(std::max(0.0, u)), samples.size() - 2);
    return hold ? samples[i] : samples[i] + (u - static_cast<double>(i)) * (samples[i + 1] - samples[i]);
  };
}

struct ForcedSynthetic {
  std::vector<double> t, force, y;
  double spacing = 0;
  int derivative = 0;

  Record record() const { return {t, y, 0, derivative}; }
  ForceRecord recorded(BetweenSamples between) const { return {force, 0, spacing, between}; }
};

/// One law under one reading of the force.
inline LawFit fit_forced(const ForcedSynthetic& record, const Law& law, BetweenSamples between) {
  return fit_law(record.record(), {.law = law, .drive = Drive::recorded(record.recorded(between))});
}

/// What is not given is chosen.
inline LawChoice choose_forced(const ForcedSynthetic& record, std::optional<Law> law,
                               std::optional<BetweenSamples> between) {
  return choose_law(record.record(), {.drive = Drive::recorded(record.recorded(BetweenSamples::linear))}, {},
                    {law, between});
}

/// The same of a harmonic drive, whose frequency may be known.
inline LawFit fit_driven(const Record& record, const Law& law, std::optional<double> drive) {
  return fit_law(record, {.law = law, .drive = Drive::harmonic(), .drive_frequency = drive});
}
inline LawChoice choose_driven(const Record& record, std::optional<Law> law, std::optional<double> drive) {
  return choose_law(record, {.drive = Drive::harmonic(), .drive_frequency = drive}, {}, {law, {}});
}

/// Samples of the motion, or of that derivative of it; `force` acts and is recorded. The integration starts
/// anew at each sample and ends a hair before the next, so that a force may jump there.
inline ForcedSynthetic forced_synthetic(const ForcedTruth& truth, const std::function<double(double)>& force,
                                        std::size_t n, double spacing, double noise, unsigned seed,
                                        int derivative = 0) {
  struct System {
    const ForcedTruth& p;
    const std::function<double(double)>& u;
    double end = 0;
    double acceleration(double t, double x, double v) const {
      return p.gain * (u(std::min(t, end)) + p.offset) - p.w0 * p.w0 * x - 2 * p.g * v -
             p.drag * v * std::abs(v) - p.quadratic * x * x - p.cubic * x * x * x;
    }
  };
  ForcedSynthetic record;
  record.spacing = spacing;
  record.derivative = derivative;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  State<double> y{truth.position, truth.velocity};
  const DormandPrince method;
  constexpr int steps = 24;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) * spacing;
    record.t.push_back(t);
    record.force.push_back(force(t));
    const System system{truth, force, t + spacing * (1 - 1e-7)};
    const double observed = derivative == 0 ? y.x : derivative == 1 ? y.v : system.acceleration(t, y.x, y.v);
    record.y.push_back(truth.equilibrium + observed + noise * normal(engine));
    auto memory = method.start(system, t, y);
    for (int k = 0; k < steps; ++k)
      y = method.step(system, t + k * spacing / steps, spacing / steps, y, memory).y;
  }
  return record;
}

}  // namespace cromer::core
