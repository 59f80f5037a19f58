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

}  // namespace cromer_walk
