// Many response filters walked along one recording together, a lane for each: plain numbers, which units
// compiled for different instruction sets share. Its namespace is its own: those units rename `cromer`
// (units/unit.h).
#pragma once

#include <cstddef>

namespace cromer_walk {

/// Filters that walk together. What one does depends on its own numbers alone.
inline constexpr std::size_t lanes = 24;

/// One number for each filter.
struct alignas(64) Numbers {
  double of[lanes];
};

struct Filters {
  Numbers decay, kappa, e0, e2;  // as response_filter.h has them
  Numbers u, d;                  // the state at the first sample
};

struct Walk {
  const double* force;         ///< at the samples
  std::size_t samples;         ///< >= 2
  std::size_t substeps = 1;    ///< of an interval, in which the force is a ramp; >= 1
  bool hold = false;           ///< each sample until the next instead of a ramp
  bool every = true;           ///< look at the end of every substep, not at samples alone
  std::size_t look_every = 1;  ///< else look at every n-th sample
  std::size_t block = 32;      ///< intervals per block, >= 1

  std::size_t blocks() const { return (samples - 1 + block - 1) / block; }
};

/// What is kept of a block of intervals.
struct Block {
  Numbers u, d;       // at its beginning
  Numbers low, high;  // least and greatest value looked at, over the gain; low > high if none was
};

/// Walks the filters along the recording; blocks() of them are written.
using Function = void (*)(const Filters& filters, const Walk& walk, Block* blocks);

// Two components of one ground, q1 and q2, and the directions between them: along the angle a it is
// cos(a) q1 + sin(a) q2.

inline constexpr std::size_t sketched = 8;  // directions, one every 180/8 degrees

/// What is kept of a block of two components.
struct BlockOfTwo {
  Numbers u[2], d[2];  // at its beginning
  /// Largest magnitude looked at in each direction, over the gain; 0 if none was.
  alignas(64) double reach[lanes][sketched];
};

/// `walk.force` and `across` are the components; of `across_filters` only u and d are looked at.
using FunctionOfTwo = void (*)(const Filters& filters, const Filters& across_filters, const Walk& walk,
                               const double* across, BlockOfTwo* blocks);

inline constexpr std::size_t directions = 180;  // one every degree

/// How far a motion reaches in each direction; the last few places fill up the vectors.
struct Reach {
  static constexpr std::size_t size = (directions + 7) / 8 * 8;
  alignas(64) double cosine[size], sine[size], magnitude[size];
};

/// The displacements of an oscillator at some steps.
struct Points {
  const double *x, *y;
  std::size_t count;
};

/// Raises the magnitudes to what the points reach.
using ReachOfPoints = void (*)(const Points& points, Reach& reach);

/// Steps of an oscillator that follow one another: displacement, velocity and force of both components.
struct Path {
  const double *x[2], *v[2], *f[2];
  std::size_t count;
  bool hold;                     ///< the force of each step until the next instead of a ramp
  double h;                      // [s] from step to step
  double decay_rate, stiffness;  // |both rates of the law| h <= 0.63
};

/// Raises the magnitudes to what the motion reaches between its steps, and there.
using ReachOfPath = void (*)(const Path& path, Reach& reach);

/// What a unit does.
struct Functions {
  Function walk = nullptr;
  FunctionOfTwo walk_two = nullptr;
  ReachOfPoints reach_of_points = nullptr;
  ReachOfPath reach_of_path = nullptr;
};

}  // namespace cromer_walk
