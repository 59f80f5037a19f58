// Where the energy of a run came from and went: the work of the drive and of each resistance.
//
// EnergyLedger follows a run from its states alone: what is left over is energy that the method itself made
// or lost, to the error of the quadrature. Exact motions have balances that close to rounding
// (exact_energy_balance.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "cromer/analysis/energy.h"
#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// The terms that take energy: those of the velocity, and dry friction.
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

/// The integrand of the balance.
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

/// The power at a state under the drive's force [N].
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

/// A recorder that follows the balance of a run in equal steps (the last may be shorter): the trapezoidal
/// rule with Gregory's end corrections up to fifth differences. Where the power is smooth the error is of
/// order (w h)^7 and does not grow with the length of the run; each turn of |v|^3 costs (w h)^4, each turn
/// under friction and each jump of the drive (w h)^2 or less. F gives the drive's force [N] at a time [s].
template <class F>
class EnergyLedger {
 public:
  /// step [s] > 0
  EnergyLedger(const F& force, const Oscillator<double>& oscillator, double step)
      : force_(force), oscillator_(oscillator), step_(step) {}

  void operator()(double t, const State<double>& y) {
    const Power power = power_of(force_(t), y);
    if (count_ == 0) {
      start_ = y;
    } else {
      distance_ += distance(last_y_, y, t - last_t_);
      if (std::abs(t - last_t_ - step_) > 1e-6 * step_) {
        // Only the run's last step is shorter: the trapezoidal rule, over it alone.
        odd_ = odd_ + (0.5 * (t - last_t_)) * (newest(0) + power);
        last_t_ = t;
        last_y_ = y;
        return;
      }
    }
    if (count_ < kept) first_[count_] = power;
    recent_[count_ % kept] = power;
    sum_ = sum_ + power;
    ++count_;
    last_t_ = t;
    last_y_ = y;
  }

  /// Of the states so far (at least one).
  EnergyBalance balance() const {
    Power work = odd_;
    if (count_ > 1) work = work + step_ * (sum_ - 0.5 * (first_[0] + newest(0)) - end_corrections());
    work.taken.of<Friction>() = distance_;
    return energy_balance(oscillator_, start_, last_y_, work);
  }

 private:
  static constexpr std::size_t kept = 6;

  const Power& newest(std::size_t back) const { return recent_[(count_ - 1 - back) % kept]; }

  /// Path of a step whose velocity runs straight from one end to the other, through 0 where it changes sign.
  static double distance(const State<double>& a, const State<double>& b, double h) {
    const double from = std::abs(a.v), to = std::abs(b.v);
    if (a.v * b.v >= 0) return std::abs(b.x - a.x);
    return h / 2 * (from * from + to * to) / (from + to);
  }

  /// Gregory's: the differences at both ends, each with its coefficient.
  Power end_corrections() const {
    constexpr std::array<double, kept> coefficients{0,          1.0 / 12,  1.0 / 24,
                                                    19.0 / 720, 3.0 / 160, 863.0 / 60480};
    const std::size_t points = std::min(kept, count_);
    std::array<Power, kept> front{}, back{};
    for (std::size_t i = 0; i < points; ++i) {
      front[i] = first_[i];
      back[i] = newest(i);
    }
    Power sum{};
    for (std::size_t k = 1; k < points; ++k) {
      // Both are taken from the end inwards; so seen, every difference enters with the same sign.
      for (std::size_t i = 0; i + k < points; ++i) {
        front[i] = front[i] - front[i + 1];
        back[i] = back[i] - back[i + 1];
      }
      sum = sum + coefficients[k] * (front[0] + back[0]);
    }
    return sum;
  }

  F force_;
  Oscillator<double> oscillator_;
  double step_, last_t_ = 0, distance_ = 0;
  State<double> start_{}, last_y_{};
  std::array<Power, kept> first_{}, recent_{};
  Power sum_{}, odd_{};
  std::size_t count_ = 0;
};

}  // namespace cromer::core
