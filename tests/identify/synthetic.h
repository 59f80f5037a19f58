// Records whose law is known: the closed form, and seeded noise.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "cromer/identify/law_fit.h"
#include "tests/identify/free_swing.h"

namespace cromer::core {

struct SyntheticRecord {
  std::vector<double> t, y;
  double resolution = 0;

  Record record() const { return {t, y, resolution}; }
};

struct Truth {
  double w0 = 8.849, g = 0.03, equilibrium = 0.2, position = 0.036, velocity = 0.01;
};

/// The closed form at times t, with normal noise, rounded to the resolution.
inline SyntheticRecord viscous_record(const Truth& truth, const std::vector<double>& t, double noise = 0,
                                      double resolution = 0, unsigned seed = 1) {
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
