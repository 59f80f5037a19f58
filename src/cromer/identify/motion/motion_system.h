// What a method integrates of a fitted motion: its acceleration and, along with it, the derivatives by every
// number that a fit may adjust (the variational equation).
//
// Each term's own force gives its slopes: it is called with a dual number of one derivative in one place at a
// time and plain doubles in the others. Duals carried through every product of the law would compute each
// derivative several times over.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "cromer/base/coupled.h"
#include "cromer/base/dual.h"
#include "cromer/identify/motion/motion.h"
#include "cromer/identify/record.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/model/between_samples.h"
#include "cromer/model/law_force.h"

namespace cromer::core {

// The drive as a part of the acceleration, with the columns of its derivatives: none, harmonic, or a recorded
// force.

/// No drive.
struct FreeColumns {
  static constexpr int count = 0;

  FreeColumns in_step(double, double) const { return {}; }
  void add(double, double&, double*) const {}
};

/// C cos(w s) + S sin(w s) per unit mass, s from the motion's first sample: columns of C, S and w.
class HarmonicColumns {
 public:
  static constexpr int count = 3;

  explicit HarmonicColumns(const Motion& motion)
      : cosine_(motion.cosine), sine_(motion.sine), w_(motion.drive_frequency) {}

  /// For a step of h [s] from s [s]: at its stages the phase is turned from that at its beginning, by angles
  /// that are the same in all steps of one length.
  HarmonicColumns in_step(double s, double h) const {
    if (h != h_) {
      for (std::size_t i = 0; i < stages; ++i) turns_[i] = phase_at(DormandPrince::nodes[i] * h);
      h_ = h;
    }
    HarmonicColumns within = *this;
    const Phase begin = phase_at(s);
    for (std::size_t i = 0; i < stages; ++i) {
      const Phase& turn = turns_[i];
      within.phases_[i] = {begin.cosine * turn.cosine - begin.sine * turn.sine,
                           begin.sine * turn.cosine + begin.cosine * turn.sine};
    }
    within.left_ = stages + 1;
    return within;
  }

  /// Adds the drive at s [s] to the acceleration and sets its columns. Within a step it is asked once for
  /// each stage, in their order.
  void add(double s, double& acceleration, double* columns) const {
    const auto [c, d] = left_ > 0 ? phases_[std::min(stages - 1, stages + 1 - left_--)] : phase_at(s);
    acceleration += cosine_ * c + sine_ * d;
    if (!columns) return;
    columns[0] = c;
    columns[1] = d;
    columns[2] = s * (sine_ * c - cosine_ * d);
  }

 private:
  struct Phase {
    double cosine, sine;
  };
  static constexpr std::size_t stages = DormandPrince::nodes.size();
  static_assert(DormandPrince::info.evaluations == stages + 1,
                "a step asks at each node, and at the last one twice");

  Phase phase_at(double s) const { return {std::cos(w_ * s), std::sin(w_ * s)}; }

  double cosine_, sine_, w_;
  mutable double h_ = std::numeric_limits<double>::quiet_NaN();
  mutable std::array<Phase, stages> turns_{};
  std::array<Phase, stages> phases_{};
  mutable std::size_t left_ = 0;  ///< stages of the step to come, the last one twice
};

/// gain (u + offset): columns of the gain and the offset. Works through the record block by block: memory
/// does not grow with it.
class RecordedColumns {
 public:
  static constexpr int count = 2;

  /// Each interval between samples is cut into `steps` > 0 steps of a method with stages at their ends and
  /// middles. Times are counted from `origin` [s].
  RecordedColumns(const Motion& motion, const ForceRecord& force, double origin, int steps)
      : gain_(motion.force_gain),
        offset_(motion.force_offset),
        force_(force),
        begin_(force.begin - origin),
        nodes_(2 * steps) {}

  /// Makes the interval after sample k ready.
  void prepare(std::size_t k) {
    at_ = k;
    if (force_.between == BetweenSamples::band_limited) {
      if (k < block_ || k >= block_ + block) refine(k);
      node_ = fine_.data() + (k - block_ + margin_) * static_cast<std::size_t>(nodes_);
      return;
    }
    fine_.resize(static_cast<std::size_t>(nodes_) + 1);
    const double here = force_.samples[k];
    const double rise = force_.between == BetweenSamples::hold ? 0 : force_.samples[k + 1] - here;
    for (int j = 0; j <= nodes_; ++j)
      fine_[static_cast<std::size_t>(j)] = here + rise * (static_cast<double>(j) / nodes_);
    node_ = fine_.data();
  }

  /// At s [s] within the prepared interval.
  void add(double s, double& acceleration, double* columns) const {
    const double u = value(s) + offset_;
    acceleration += gain_ * u;
    if (!columns) return;
    columns[0] = u;
    columns[1] = gain_;
  }

 private:
  static constexpr std::size_t block = 1024;  ///< intervals
  static constexpr std::size_t reach = 16;    ///< samples to each side that the series needs

  // At a node its value; in between, where a motion turns, the parabola through the nearest three.
  double value(double s) const {
    const double place = (s - begin_ - static_cast<double>(at_) * force_.spacing) * (nodes_ / force_.spacing);
    const int near = std::clamp(static_cast<int>(std::lround(place)), 0, nodes_);
    const double off = place - near;
    if (std::abs(off) < 1e-6) return node_[near];
    const int middle = std::clamp(near, 1, nodes_ - 1);
    const double u = place - middle;
    const double rise = 0.5 * (node_[middle + 1] - node_[middle - 1]);
    const double bend = 0.5 * (node_[middle + 1] + node_[middle - 1]) - node_[middle];
    return node_[middle] + u * (rise + u * bend);
  }

  void refine(std::size_t k) {
    block_ = k;
    margin_ = std::min(k, reach);
    const std::size_t from = k - margin_, to = std::min(force_.samples.size(), k + block + 1 + reach);
    fine_ = refine_band_limited(force_.samples.subspan(from, to - from), nodes_);
  }

  double gain_, offset_;
  ForceRecord force_;
  double begin_;
  int nodes_;
  std::size_t at_ = 0;
  std::vector<double> fine_;
  const double* node_ = nullptr;
  std::size_t block_ = static_cast<std::size_t>(-1) - block, margin_ = 0;
};

/// The columns of a law's coefficients: those of its terms one after the other, in the registry's order.
class CoefficientColumns {
 public:
  constexpr explicit CoefficientColumns(Law law) {
    for_each_term([&]<class T>() {
      first_[place_of_term<T>] = static_cast<unsigned char>(count_);
      if (law.has<T>()) count_ += coefficients_of<T>;
    });
  }

  constexpr std::size_t count() const { return count_; }
  /// Of the first coefficient of a term that the law has.
  template <class T>
  constexpr std::size_t of() const {
    return first_[place_of_term<T>];
  }

 private:
  std::array<unsigned char, term_count> first_{};
  std::size_t count_ = 0;
};

/// Code compiled for a law. It serves every law whose terms are among that law's and whose coefficients fit
/// in `room` columns.
struct LawCode {
  Law law;
  std::size_t room;

  constexpr LawCode(Law of)
      : law(of), room(CoefficientColumns(of).count()) {}  // NOLINT: implicit, so that lists name laws
  constexpr LawCode(Law all, std::size_t room_for) : law(all), room(room_for) {}

  constexpr bool serves(Law other) const {
    return law.contains(other) && CoefficientColumns(other).count() <= room;
  }
};

/// What code is compiled for: a law, or those that share it, a kind of drive, and whether derivatives are
/// wanted.
template <LawCode code_, class Drive_, bool with_derivatives>
struct MotionCode {
  static constexpr LawCode code = code_;
  static constexpr Law law = code.law;
  using Drive = Drive_;
  static constexpr bool hysteretic = law.template has<Hysteresis>();
  static constexpr bool has_friction = law.template has<Friction>();
  /// If so many terms share the code, each is asked whether it is present, and has its column if it is.
  static constexpr bool asks = law.size() > 6;

  /// Columns: the coefficients, the drive's, position and velocity at the start.
  static constexpr std::size_t drive_column = code.room, position_column = code.room + Drive::count,
                               velocity_column = position_column + 1;
  static constexpr std::size_t columns = with_derivatives ? velocity_column + 1 : 0;

  using Number = Dual<double, columns>;
  using Real = std::conditional_t<hysteretic, Coupled<Number>, Number>;
};

/// A value and its slope, of a term's force; the slope of what does not depend on the dual is 0.
constexpr double slope_of(double) { return 0; }
constexpr double slope_of(const Dual<double, 1>& y) { return y.derivative[0]; }

/// One way of sliding; without friction, any way.
template <class Code>
class MotionSystem {
 public:
  using Number = typename Code::Number;
  using Real = typename Code::Real;
  static constexpr bool depends_on_velocity = true;

  /// Keeps references to both. `direction` is the sign of the velocity.
  MotionSystem(const Motion& motion, const typename Code::Drive& drive, int direction = 0)
      : motion_(&motion), drive_(&drive), direction_(direction), columns_(motion.law) {}

  MotionSystem sliding(int direction) const {
    MotionSystem same = *this;
    same.direction_ = direction;
    return same;
  }
  /// The same, where the drive knows its step.
  MotionSystem under(const typename Code::Drive& drive) const {
    MotionSystem same = *this;
    same.drive_ = &drive;
    return same;
  }
  const typename Code::Drive& drive() const { return *drive_; }

  /// [unit/s^2] at s [s] from the first sample.
  Number acceleration(double s, const Number& position, const Number& velocity) const {
    const double x = position.value, v = velocity.value;
    double sum = 0, by_x = 0, by_v = 0;
    Number result;
    drive_->add(s, sum, Code::columns > 0 ? result.derivative.data() + Code::drive_column : nullptr);
    for_each_term([&]<class T>() {
      if constexpr (Code::law.template has<T>() && smooth_terms.has<T>()) {
        if (is_absent<T>()) return;
        add<T>(x, v, sum, by_x, by_v, result);
      }
    });
    if constexpr (Code::has_friction) {
      sum -= direction_ * motion_->per_mass.friction;
      if constexpr (Code::columns > 0)
        if (!is_absent<Friction>()) result.derivative[columns_.template of<Friction>()] = -direction_;
    }
    for (std::size_t i = 0; i < Code::columns; ++i)
      result.derivative[i] += by_x * position.derivative[i] + by_v * velocity.derivative[i];
    result.value = sum;
    return result;
  }

  /// The same with the hysteretic force beside the velocity, and that force's own rate.
  Coupled<Number> acceleration(double s, const Coupled<Number>& position,
                               const Coupled<Number>& velocity) const requires(Code::hysteretic) {
    const Number& force = velocity.second;
    return {acceleration(s, position.first, velocity.first) - force, rate(velocity.first, force)};
  }

 private:
  using One = Dual<double, 1>;

  /// Known when compiling where the code is one law's.
  struct OwnColumns {
    explicit OwnColumns(Law) {}
    template <class T>
    static constexpr std::size_t of() {
      return CoefficientColumns(Code::law).template of<T>();
    }
  };
  using Columns = std::conditional_t<Code::asks, CoefficientColumns, OwnColumns>;

  template <class T>
  bool is_absent() const {
    return Code::asks && !motion_->law.has<T>();
  }

  template <class T>
  void add(double x, double v, double& sum, double& by_x, double& by_v, Number& result) const {
    const double p = motion_->per_mass.*T::template members<double>[0];
    sum -= T::force(x, v, p);
    by_x -= slope_of(T::force(One::variable(x, 0), v, p));
    by_v -= slope_of(T::force(x, One::variable(v, 0), p));
    if constexpr (Code::columns > 0)
      result.derivative[columns_.template of<T>()] = -slope_of(T::force(x, v, One::variable(p, 0)));
  }

  Number rate(const Number& velocity, const Number& force) const {
    const Oscillator<double>& law = motion_->per_mass;
    const double v = velocity.value, z = force.value, n = law.hysteresis_exponent;
    const double A = law.hysteresis_stiffness, beta = law.hysteresis_beta, gamma = law.hysteresis_gamma;
    Number result(Hysteresis::rate(v, z, A, beta, gamma, n));
    if constexpr (Code::columns > 0) {
      if (is_absent<Hysteresis>()) return result;
      const std::size_t column = columns_.template of<Hysteresis>();
      const double by_v = slope_of(Hysteresis::rate(One::variable(v, 0), z, A, beta, gamma, n));
      const double by_z = slope_of(Hysteresis::rate(v, One::variable(z, 0), A, beta, gamma, n));
      for (std::size_t i = 0; i < Code::columns; ++i)
        result.derivative[i] = by_v * velocity.derivative[i] + by_z * force.derivative[i];
      result.derivative[column] += slope_of(Hysteresis::rate(v, z, One::variable(A, 0), beta, gamma, n));
      result.derivative[column + 1] += slope_of(Hysteresis::rate(v, z, A, One::variable(beta, 0), gamma, n));
      result.derivative[column + 2] += slope_of(Hysteresis::rate(v, z, A, beta, One::variable(gamma, 0), n));
    }
    return result;
  }

  const Motion* motion_;
  const typename Code::Drive* drive_;
  int direction_;
  [[no_unique_address]] Columns columns_;
};

}  // namespace cromer::core
