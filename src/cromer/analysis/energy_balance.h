// Where the energy of a run came from and went: the work of the drive and of each resistance.
//
// For an exact motion by quadrature between the states (exact_energy_balance.h), with dry friction from stop
// to stop (exact_friction_balance.h), closed to rounding. For the other methods from their states alone
// (energy_ledger.h): what is then left over is energy that the method itself made or lost, to the error of
// the quadrature.
#pragma once

#include <array>
#include <cstddef>

#include "cromer/analysis/energy.h"
#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// What takes energy, each in its place: the terms of the velocity, and dry friction.
inline constexpr Law resistances = terms_of_velocity.with(law_with<Friction>);

/// Calls f.operator()<T>() for every resistance, in the order of the registry.
template <class F>
constexpr void for_each_resistance(F&& f) {
  for_each_term([&]<class T>() {
    if constexpr (resistances.has<T>()) f.template operator()<T>();
  });
}

/// One number for each resistance.
struct OfResistances {
  std::array<double, static_cast<std::size_t>(resistances.size())> numbers{};

  template <class T>
  double& of() {
    return numbers[place<T>];
  }
  template <class T>
  double of() const {
    return numbers[place<T>];
  }
  double sum() const {
    double all = 0;
    for (const double each : numbers) all += each;
    return all;
  }

 private:
  /// How many of them come before.
  template <class T>
  static constexpr std::size_t place =
      static_cast<std::size_t>(Law{resistances.terms & (law_with<T>.terms - 1)}.size());
};

/// end - start = drive - what the resistances took + method.
struct EnergyBalance {
  double start = 0, end = 0;  // [J] stored in the oscillator
  double drive = 0;           // [J] work done by the drive, either sign
  OfResistances taken{};      // [J] by each resistance; >= 0 but for a term that may feed

  template <class T>
  double taken_by() const {
    return taken.of<T>();
  }

  /// [J] made (+) or lost (-) by the method itself; 0 to rounding for an exact motion.
  double method() const { return (end - start) - (drive - taken.sum()); }
};

/// What the balance is an integral of.
struct Power {
  double drive = 0;       // [W]
  OfResistances taken{};  ///< force times velocity, each with a coefficient of 1

  friend Power operator+(Power a, const Power& b) {
    a.drive += b.drive;
    for (std::size_t i = 0; i < a.taken.numbers.size(); ++i) a.taken.numbers[i] += b.taken.numbers[i];
    return a;
  }
  friend Power operator*(double factor, Power a) {
    a.drive *= factor;
    for (double& each : a.taken.numbers) each *= factor;
    return a;
  }
  friend Power operator-(const Power& a, const Power& b) { return a + -1.0 * b; }
};

/// Of a state under a force [N] of the drive.
inline Power power_of(double force, const State<double>& y) {
  Power power{.drive = force * y.v};
  for_each_resistance([&]<class T>() { power.taken.of<T>() = T::force(y.x, y.v, 1.0) * y.v; });
  return power;
}

/// The balance from its integrals.
inline EnergyBalance energy_balance(const Oscillator<double>& oscillator, const State<double>& start,
                                    const State<double>& end, const Power& work) {
  EnergyBalance balance{
      .start = energy(oscillator, start), .end = energy(oscillator, end), .drive = work.drive};
  for_each_resistance([&]<class T>() {
    balance.taken.of<T>() = oscillator.*T::template members<double>[0] * work.taken.of<T>();
  });
  return balance;
}

}  // namespace cromer::core
