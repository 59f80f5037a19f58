// A harmonic drive as a part of the acceleration, with its derivatives.
#pragma once

#include <cmath>

#include "cromer/identify/motion/motion.h"

namespace cromer::core {

/// No drive.
struct FreeColumns {
  static constexpr int count = 0;

  void add(double, double&, double*) const {}
};

/// C cos(w s) + S sin(w s) per unit mass, s from the motion's first sample: columns of C, S and w.
class HarmonicColumns {
 public:
  static constexpr int count = 3;

  explicit HarmonicColumns(const Motion& motion)
      : cosine_(motion.cosine), sine_(motion.sine), w_(motion.drive_frequency) {}

  /// Adds the drive at s [s] to the acceleration and sets its columns.
  void add(double s, double& acceleration, double* columns) const {
    const double c = std::cos(w_ * s), d = std::sin(w_ * s);
    acceleration += cosine_ * c + sine_ * d;
    if (!columns) return;
    columns[0] = c;
    columns[1] = d;
    columns[2] = s * (sine_ * c - cosine_ * d);
  }

 private:
  double cosine_, sine_, w_;
};

}  // namespace cromer::core
