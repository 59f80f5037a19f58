// The loop over a motion's steps and a record's times, for every law and drive that has code of its own. Each
// kind of drive is compiled in one unit: free_motions.cpp, harmonic_motions.cpp and recorded_motions.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

#include "cromer/base/function_ref.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/identify/motion/motion_system.h"
#include "cromer/identify/motion/path.h"
#include "cromer/model/law_force.h"

namespace cromer::core {

// The laws that have code of their own: a measured choice. Every other law uses the code with the fewest
// columns that serves it; code of more than six terms asks which of them are present.

inline constexpr Law every_term_but_hysteresis = smooth_terms.with(law_with<Friction>);
inline constexpr Law every_term = every_term_but_hysteresis.with(law_with<Hysteresis>);

#ifdef CROMER_PAGE
inline constexpr LawCode free_laws[] = {law_of("viscous+drag"), {every_term_but_hysteresis, 6}, every_term};
inline constexpr LawCode driven_laws[] = {law_of("viscous"), law_of("viscous+drag+quadratic+cubic"),
                                          every_term};
#else
inline constexpr LawCode free_laws[] = {law_of("viscous"),
                                        law_of("viscous+drag"),
                                        law_of("viscous+cubic"),
                                        law_of("viscous+odd-quadratic"),
                                        law_of("viscous+drag+cubic"),
                                        law_of("viscous+drag+odd-quadratic"),
                                        law_of("viscous+drag+pendulum"),
                                        law_of("viscous+drag+friction"),
                                        law_of("viscous+drag+friction+cubic"),
                                        law_of("viscous+drag+friction+odd-quadratic"),
                                        law_of("viscous+drag+friction+pendulum"),
                                        law_of("viscous+hysteresis"),
                                        {smooth_terms, 5},
                                        {every_term_but_hysteresis, 6},
                                        {every_term, 8},
                                        every_term};
inline constexpr LawCode driven_laws[] = {law_of("viscous"),
                                          law_of("viscous+drag"),
                                          law_of("viscous+quadratic+cubic"),
                                          law_of("viscous+drag+quadratic+cubic"),
                                          law_of("viscous+friction+odd-quadratic"),
                                          law_of("viscous+friction+quadratic+cubic"),
                                          law_of("viscous+drag+friction+pendulum"),
                                          law_of("viscous+hysteresis"),
                                          {smooth_terms, 5},
                                          {every_term_but_hysteresis, 6},
                                          {every_term, 8},
                                          every_term};
#endif

/// The functions of one unit; see motion_model.h.
struct MotionFunctions {
  Trajectory (*states)(const Motion&, const Drive&, std::span<const double>, double);
  std::vector<double> (*observed)(const Motion&, const Drive&, std::span<const double>, int, double);
  NormalEquations (*equations)(const FittedParameters&, const Parameters&, const Drive&, const Record&,
                               double);
  std::vector<double> (*jacobian)(const FittedParameters&, const Parameters&, const Drive&, const Record&,
                                  double);
};

extern const MotionFunctions free_motions, harmonic_motions, recorded_motions;

/// A motion at one sample: what is observed of it, its velocity and position, each with its columns.
template <class Path>
class MotionSample {
 public:
  using Number = typename Path::Number;

  MotionSample(const Path& path, double t, double length, double share)
      : path_(path), t_(t), length_(length), share_(share) {}

  int direction() const { return path_.direction(); }
  Number x() const { return observable(state().x); }
  Number v() const { return observable(state().v); }
  Number a() const {
    const auto y = state();
    return path_.acceleration(t_, y.x, y.v);
  }
  /// This derivative of the displacement: 0, 1 or 2.
  Number observed(int derivative) const {
    if (derivative == 0) return x();
    return derivative == 1 ? v() : a();
  }

 private:
  State<typename Path::Real> state() const {
    if (path_.sticks() || share_ == 1) return path_.last().to;
    if (share_ == 0) return path_.last().from;
    if constexpr (requires { path_.last().acceleration_from; })
      return {displacement_within(path_.last(), length_, share_),
              velocity_within(path_.last(), length_, share_)};
    else
      return path_.last().to;
  }

  const Path& path_;
  double t_, length_, share_;
};

/// The most steps that a motion may take through the times: many times as many as steps of length h would.
/// A motion that needs more does not belong to the record, and is not followed to its end.
inline double most_steps(std::span<const double> t, double h) {
  constexpr double many = 20, few = 10'000;
  return few + many * steps_through(t, h);
}

/// Calls visit(i, sample) at every time, strictly increasing, in steps of at most h. Stops where the motion
/// is no longer finite.
template <class Code, class Visit>
void integrate_freely(const Motion& motion, const typename Code::Drive& drive, std::span<const double> t,
                      double h, Visit visit) {
  using OnPath = Path<Code, DormandPrince>;
  OnPath path(motion, drive);
  const double origin = t.front();
  double now = 0;
  const double most = most_steps(t, h);
  double steps = 0;
  for (std::size_t i = 0; i < t.size() && steps < most; ++steps) {
    const double length = path.step(now, h);
    for (; i < t.size() && t[i] - origin <= now + length; ++i) {
      const double at = t[i] - origin;
      visit(i, MotionSample<OnPath>(path, at, length, (at - now) / length));
    }
    if (!std::isfinite(observable(path.last().to.x).value)) return;
    now += length;
  }
}

/// The same under a recorded force, whose samples the times lie at: each of its intervals is cut into equal
/// steps of at most h.
template <class Code, class Visit>
void integrate_under_force(const Motion& motion, const ForceRecord& force, std::span<const double> t,
                           double h, Visit visit) {
  using OnPath = Path<Code, Rk4>;
  const int steps = std::max(1, static_cast<int>(std::ceil(force.spacing / h - 1e-9)));
  const double origin = t.front(), step = force.spacing / steps;
  RecordedColumns drive(motion, force, origin, steps);
  OnPath path(motion, drive);
  const auto sample_at = [&](double time) {
    return static_cast<std::size_t>(std::max(0.0, std::round((time - force.begin) / force.spacing)));
  };
  const std::size_t first = sample_at(origin), last = sample_at(t.back());
  std::size_t i = 0;
  for (std::size_t k = first; k <= last && i < t.size(); ++k) {
    const double begin = force.time(k) - origin;
    const bool here = sample_at(t[i]) == k;
    if (k + 1 < force.samples.size()) drive.prepare(k);
    if (here && k == first) {
      path.step(begin, 0);  // starts it
      visit(i++, MotionSample<OnPath>(path, begin, 1, 1));
    } else if (here) {
      visit(i++, MotionSample<OnPath>(path, begin, 1, 1));
    }
    if (k == last || k + 1 >= force.samples.size()) break;
    for (int n = 0; n < steps; ++n) {
      const double end = begin + (n + 1) * step;
      for (double now = begin + n * step; end - now > 1e-9 * step;) now += path.step(now, end - now);
    }
    if (!std::isfinite(observable(path.last().to.x).value)) return;
  }
}

/// The place among `codes` of the one with the fewest columns that serves a law; the first of equals, and
/// codes.size() if none does.
constexpr std::size_t code_for(std::span<const LawCode> codes, Law law) {
  std::size_t best = codes.size();
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (codes[i].serves(law) && (best == codes.size() || codes[i].room < codes[best].room)) best = i;
  return best;
}

/// f.operator()<code>() with the code for a law.
template <const auto& codes, class F>
void with_code_among(const Law& law, F&& f) {
  const std::size_t best = code_for(codes, law);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (void)((best == i && (f.template operator()<codes[i]>(), true)) || ...);
  }
  (std::make_index_sequence<std::size(codes)>{});
}

/// Calls visit(i, sample) with numbers, and in columns their derivatives.
template <LawCode code, class DriveColumns, bool derivatives, class Visit>
void integrate_through(const Motion& motion, const Drive& drive, std::span<const double> t, double h,
                       Visit visit) {
  using Code = MotionCode<code, DriveColumns, derivatives>;
  if constexpr (std::is_same_v<DriveColumns, RecordedColumns>)
    integrate_under_force<Code>(motion, drive.force, t, h, visit);
  else if constexpr (std::is_same_v<DriveColumns, HarmonicColumns>)
    integrate_freely<Code>(motion, HarmonicColumns(motion), t, h, visit);
  else
    integrate_freely<Code>(motion, FreeColumns{}, t, h, visit);
}

/// Which column of the code, times which factor, a fitted parameter is; none of an equilibrium's, which is 1
/// throughout.
struct ColumnOf {
  int column = -1;
  double factor = 1;
};

template <class Code>
ColumnOf column_of(const FittedParameter& parameter, Law law, double value) {
  ColumnOf found{-1, parameter.coefficient ? parameter.slope(value) : 1};
  const CoefficientColumns columns(Code::asks ? law : Code::law);
  for_each_term([&]<class T>() {
    if constexpr (Code::law.template has<T>())
      for (std::size_t i = 0; i < coefficients_of<T>; ++i)
        if (parameter.coefficient == T::template members<double>[i])
          found.column = static_cast<int>(columns.of<T>() + i);
  });
  constexpr int drive = static_cast<int>(Code::drive_column);
  const std::pair<double Motion::*, int> others[] = {
      {&Motion::cosine, drive},
      {&Motion::sine, drive + 1},
      {&Motion::drive_frequency, drive + 2},
      {&Motion::force_gain, drive},
      {&Motion::force_offset, drive + 1},
      {&Motion::position, static_cast<int>(Code::position_column)},
      {&Motion::velocity, static_cast<int>(Code::velocity_column)}};
  for (const auto& [member, column] : others)
    if (parameter.member && parameter.member == member) found.column = column;
  return found;
}

/// What a unit offers for its kind of drive.
template <const auto& laws, class DriveColumns>
struct MotionUnit {
  static constexpr MotionFunctions functions() { return {states, observed, equations, jacobian}; }

  /// Visits every time with the state, and the acceleration where it is asked for.
  using VisitValues = FunctionRef<void(std::size_t i, const State<double>& y, double acceleration)>;

  static void values(const Motion& motion, const Drive& drive, std::span<const double> t, bool acceleration,
                     double h, VisitValues visit) {
    with_code_among<laws>(motion.law, [&]<LawCode code>() {
      integrate_through<code, DriveColumns, false>(
          motion, drive, t, h, [&](std::size_t i, const auto& sample) {
            visit(i, {sample.x().value, sample.v().value}, acceleration ? sample.a().value : 0);
          });
    });
  }

  static Trajectory states(const Motion& motion, const Drive& drive, std::span<const double> t, double h) {
    Trajectory trajectory;
    values(motion, drive, t, false, h, [&](std::size_t i, const State<double>& y, double) {
      trajectory.t.push_back(t[i]);
      trajectory.x.push_back(y.x);
      trajectory.v.push_back(y.v);
    });
    return trajectory;
  }

  static std::vector<double> observed(const Motion& motion, const Drive& drive, std::span<const double> t,
                                      int derivative, double h) {
    std::vector<double> observed;
    observed.reserve(t.size());
    values(motion, drive, t, derivative == 2, h, [&](std::size_t, const State<double>& y, double a) {
      observed.push_back(motion.equilibrium + (derivative == 0 ? y.x : derivative == 1 ? y.v : a));
    });
    return observed;
  }

  static NormalEquations equations(const FittedParameters& fitted, const Parameters& parameters,
                                   const Drive& drive, const Record& record, double h) {
    const Motion motion = fitted.unpack(parameters);
    NormalEquations equations;
    with_code_among<laws>(motion.law, [&]<LawCode code>() {
      using Code = MotionCode<code, DriveColumns, true>;
      constexpr std::size_t N = Code::columns, columns = N + 1;  // the last is the equilibrium's
      double gram[columns][columns]{}, right[columns]{}, sum_of_squares = 0;
      std::size_t reached = 0;
      integrate_through<code, DriveColumns, true>(
          motion, drive, record.t, h, [&](std::size_t i, const auto& sample) {
            const auto model = sample.observed(record.derivative);
            const double r = record.y[i] - motion.equilibrium - model.value;
            double row[columns];
            for (std::size_t j = 0; j < N; ++j) row[j] = model.derivative[j];
            row[N] = 1;
            for (std::size_t j = 0; j < columns; ++j) {
              right[j] += row[j] * r;
              for (std::size_t l = 0; l <= j; ++l) gram[j][l] += row[j] * row[l];
            }
            sum_of_squares += r * r;
            reached = i + 1;
          });
      equations.size = fitted.count;
      equations.sum_of_squares = reached == record.t.size() ? sum_of_squares : HUGE_VAL;
      ColumnOf at[max_parameters];
      for (int i = 0; i < fitted.count; ++i) {
        at[i] = column_of<Code>(fitted.of[i], motion.law, parameters[i]);
        if (at[i].column < 0) at[i].column = static_cast<int>(N);
      }
      for (int i = 0; i < fitted.count; ++i) {
        equations.right[i] = at[i].factor * right[at[i].column];
        for (int j = 0; j < fitted.count; ++j)
          equations.matrix[i][j] =
              at[i].factor * at[j].factor *
              gram[std::max(at[i].column, at[j].column)][std::min(at[i].column, at[j].column)];
      }
    });
    return equations;
  }

  static std::vector<double> jacobian(const FittedParameters& fitted, const Parameters& parameters,
                                      const Drive& drive, const Record& record, double h) {
    const int equilibrium = fitted.place_of("equilibrium");
    std::vector<double> rows;
    rows.reserve(record.t.size() * static_cast<std::size_t>(fitted.count));
    gradients(fitted, parameters, drive, record.t, record.derivative, h,
              [&](std::size_t, int, double, const Parameters& gradient) {
                Parameters row = gradient;
                if (equilibrium >= 0) row[equilibrium] = 1;
                rows.insert(rows.end(), row.begin(), row.begin() + fitted.count);
              });
    if (rows.size() != record.t.size() * static_cast<std::size_t>(fitted.count)) rows.clear();
    return rows;
  }

  /// Visits every time with the direction of the motion, a derivative of the displacement (0, 1 or 2), and
  /// its own derivatives by the fitted parameters.
  using VisitGradients =
      FunctionRef<void(std::size_t i, int direction, double value, const Parameters& gradient)>;

  static void gradients(const FittedParameters& fitted, const Parameters& parameters, const Drive& drive,
                        std::span<const double> t, int derivative, double h, VisitGradients visit) {
    const Motion motion = fitted.unpack(parameters);
    with_code_among<laws>(motion.law, [&]<LawCode code>() {
      using Code = MotionCode<code, DriveColumns, true>;
      ColumnOf at[max_parameters];
      for (int i = 0; i < fitted.count; ++i) at[i] = column_of<Code>(fitted.of[i], motion.law, parameters[i]);
      integrate_through<code, DriveColumns, true>(
          motion, drive, t, h, [&](std::size_t i, const auto& sample) {
            const auto number = sample.observed(derivative);
            Parameters gradient{};
            for (int j = 0; j < fitted.count; ++j)
              if (const auto [column, factor] = at[j]; column >= 0)
                gradient[j] = factor * number.derivative[static_cast<std::size_t>(column)];
            visit(i, sample.direction(), number.value, gradient);
          });
    });
  }
};

}  // namespace cromer::core
