// Where the energy of a run came from and went: the work of the drive and of each resistance.
//
// For an exact motion by quadrature between the states (exact_energy_balance.h), with dry friction from stop
// to stop (exact_friction_balance.h), closed to rounding. For the other methods from their states alone
// (energy_ledger.h): what is then left over is energy that the method itself made or lost, to the error of
// the quadrature.
#pragma once

#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"

namespace cromer {

/// end - start = drive - damping - drag - friction + method.
struct EnergyBalance {
  double start = 0, end = 0;  // [J] stored in the oscillator
  double drive = 0;           // [J] work done by the drive, either sign
  double damping = 0;         // [J] taken by c v; >= 0
  double drag = 0;            // [J] taken by d v|v|; >= 0
  double friction = 0;        // [J] taken by dry friction; >= 0

  /// [J] made (+) or lost (-) by the method itself; 0 to rounding for an exact motion.
  double method() const { return (end - start) - (drive - damping - drag - friction); }
};

/// What the balance is an integral of.
struct Power {
  double drive = 0;     // [W]
  double square = 0;    // [m^2/s^2] v^2
  double cube = 0;      // [m^3/s^3] |v|^3
  double distance = 0;  // [m/s] |v|

  friend Power operator+(const Power& a, const Power& b) {
    return {a.drive + b.drive, a.square + b.square, a.cube + b.cube, a.distance + b.distance};
  }
  friend Power operator*(double factor, const Power& a) {
    return {factor * a.drive, factor * a.square, factor * a.cube, factor * a.distance};
  }
  friend Power operator-(const Power& a, const Power& b) { return a + -1.0 * b; }
};

/// At a velocity v [m/s] under a force [N] of the drive.
inline Power power_of(double force, double v) {
  const double speed = std::abs(v), square = v * v;
  return {force * v, square, square * speed, speed};
}

/// The balance from its integrals.
inline EnergyBalance energy_balance(const Oscillator<double>& oscillator, const State<double>& start,
                                    const State<double>& end, const Power& work) {
  return {.start = energy(oscillator, start),
          .end = energy(oscillator, end),
          .drive = work.drive,
          .damping = oscillator.damping * work.square,
          .drag = oscillator.drag * work.cube,
          .friction = oscillator.friction * work.distance};
}

}  // namespace cromer
