// A group of oscillators that run side by side: plain numbers, which units compiled for different instruction
// sets share. Its namespace is its own: those units rename `cromer` (units/unit.h).
#pragma once

namespace cromer_group {

/// Oscillators of one group. A group is the smallest piece of work: what a member does depends on its own
/// numbers alone, and the step counts on those of its group.
inline constexpr int size = 32;

/// One number for each oscillator.
struct alignas(64) Numbers {
  double of[size];
};

/// Weighted sums over the states at the beginnings of steps. c and s are the cosine and sine of the drive's
/// angle w t + phi then.
struct Sums {
  Numbers x, c, s, cc, cs, ss, xc, xs, xx;
  Numbers energy;  // per unit mass [m^2/s^2]
};

/// Most terms a law can have.
inline constexpr int most_terms = 16;

struct Group {
  // Fixed: the law per unit mass, the drive per unit mass, and each oscillator's step [s].
  Numbers coefficients[most_terms];  ///< of each term, at its place in the registry of terms
  Numbers drive_amplitude, drive_frequency, drive_phase;
  Numbers step;
  unsigned law;  ///< the terms that any oscillator of the group has: bit i, the i-th of the registry
  bool driven;   ///< any of them

  // Where they stand: x [m], v [m/s] and what the method carries from step to step.
  Numbers x, v;
  Numbers memory[3];
  double steps;  ///< taken so far, by each; 0 starts the method
  int lanes;     ///< of a register of the unit that ran it last

  // What is kept of the steps taken, the group's state at their ends included.
  Numbers peak;    ///< largest |x| [m]: grows from what it was
  Numbers failed;  ///< not 0 where Newton's iteration did not converge in some step
  Sums sums;       ///< grow from what they were, with weights only
};

/// How to run it.
struct Order {
  unsigned method;   ///< its place in the list of methods
  double tolerance;  ///< of Newton's iteration
  double beta, gamma, rho_inf;
  long long steps;        ///< to take now
  const double* weights;  ///< one for each of them, for the sums; nullptr: no sums
};

/// Runs the group. False: no method of fixed steps is at that place.
using Advance = bool (*)(Group& group, const Order& order);

}  // namespace cromer_group
