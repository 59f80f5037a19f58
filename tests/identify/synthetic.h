// Free motions by the numbers that people give them, and records whose law is known: the closed form, and
// seeded noise.
#pragma once

#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "cromer/identify/law_fit.h"
#include "cromer/identify/motion/motion_model.h"

namespace cromer::core {

inline std::vector<double> even_times(std::size_t n, double h) {
  std::vector<double> t(n);
  for (std::size_t i = 0; i < n; ++i) t[i] = static_cast<double>(i) * h;
  return t;
}

/// A free motion by its parameters; terms that are 0 are not in its law, but for the viscous one.
struct TrueSwing {
  double angular_frequency = 0, decay_rate = 0, drag = 0, friction = 0, cubic = 0;
  double equilibrium = 0, position = 0, velocity = 0;
  bool pendulum = false;

  operator Motion() const {  // NOLINT: the same motion
    Motion motion{.equilibrium = equilibrium, .position = position, .velocity = velocity};
    motion.per_mass.drag = drag;
    motion.per_mass.friction = friction;
    motion.per_mass.cubic = cubic;
    if (pendulum) motion.law = law_of("viscous+pendulum");
    motion.set_angular_frequency(angular_frequency);
    motion.set_decay_rate(decay_rate);
    motion.law = motion.law.with(law_of(motion.per_mass));
    if (pendulum) motion.law = motion.law.without(law_with<Spring>);
    return motion;
  }
};

/// With normal noise, the same each time.
inline std::vector<double> noisy(std::vector<double> y, double noise) {
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0, noise);
  for (double& each : y) each += normal(engine);
  return y;
}

/// Displacements and velocities at times t, in steps of at most h.
inline Trajectory free_motion(const Motion& motion, std::span<const double> t, double h) {
  return motion_states(motion, {}, t, h);
}

struct SyntheticRecord {
  std::vector<double> t, y;
  double resolution = 0;

  Record record() const { return {t, y, resolution}; }
};

struct ViscousTruth {
  double w0 = 8.849, g = 0.03, equilibrium = 0.2, position = 0.036, velocity = 0.01;
};

/// The closed form at times t, with normal noise, rounded to the resolution.
inline SyntheticRecord viscous_record(const ViscousTruth& truth, const std::vector<double>& t,
                                      double noise = 0, double resolution = 0, unsigned seed = 1) {
  SyntheticRecord record{t, {}, resolution};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const double w = std::sqrt(truth.w0 * truth.w0 - truth.g * truth.g);
  const double sine = (truth.velocity + truth.g * truth.position) / w;
  for (double time : t) {
    const double s = time - t.front();
    double y = truth.equilibrium +
               std::exp(-truth.g * s) * (truth.position * std::cos(w * s) + sine * std::sin(w * s)) +
               (noise > 0 ? noise * normal(engine) : 0);
    if (resolution > 0) y = resolution * std::round(y / resolution);
    record.y.push_back(y);
  }
  return record;
}

}  // namespace cromer::core
