#include "cromer/identify/free_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/methods/rk4.h"

namespace cromer {
namespace {

// The law per unit mass; terms that are absent cost nothing.
template <class Real, bool drag_term, bool cubic_term>
struct FreeLaw {
  Real stiffness;   // w0^2
  Real resistance;  // 2 g
  Real drag;
  Real cubic;

  Real acceleration(double, const Real& x, const Real& v) const {
    using std::abs;
    Real a = -(stiffness * x) - resistance * v;
    if constexpr (drag_term) a -= drag * (v * abs(v));
    if constexpr (cubic_term) a -= cubic * (x * x * x);
    return a;
  }
};

// Calls visit(i, state) at every time, integrating in between in equal steps of at most h. Stops where the
// state is no longer finite.
template <class Real, class System, class Visit>
void integrate(const System& law, std::span<const double> t, double h, State<Real> y, Visit visit) {
  const Rk4 method;
  visit(std::size_t{0}, y);
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double dt = t[i] - t[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / h - 1e-9)));
    const double step = dt / steps;
    auto memory = method.start(law, t[i - 1], y);
    for (int n = 0; n < steps; ++n) y = method.step(law, t[i - 1] + n * step, step, y, memory).y;
    visit(i, y);
    if (!std::isfinite(value_of(y.x))) return;
  }
}

// The law and the start as functions of N parameters other than the equilibrium, in the order of
// fitted_parameters.
template <class Real, class Value, class Run>
void with_law(const Law& law, const MotionParameters& motion, Value value, Run run) {
  const Real w0 = value(&MotionParameters::angular_frequency, motion.angular_frequency);
  const Real g = value(&MotionParameters::decay_rate, motion.decay_rate);
  const Real q = value(&MotionParameters::drag, motion.drag);
  const Real k3 = value(&MotionParameters::cubic, motion.cubic);
  const State<Real> start{value(&MotionParameters::position, motion.position),
                          value(&MotionParameters::velocity, motion.velocity)};
  if (law.drag && law.cubic)
    run(FreeLaw<Real, true, true>{w0 * w0, g + g, q, k3}, start);
  else if (law.drag)
    run(FreeLaw<Real, true, false>{w0 * w0, g + g, q, k3}, start);
  else if (law.cubic)
    run(FreeLaw<Real, false, true>{w0 * w0, g + g, q, k3}, start);
  else
    run(FreeLaw<Real, false, false>{w0 * w0, g + g, q, k3}, start);
}

constexpr int no_derivative = -1;

// Where a parameter's derivative stands among those of the displacement; the equilibrium has none.
int derivative_index(const FittedParameters& fitted, double MotionParameters::*member) {
  int index = 0;
  for (int i = 0; i < fitted.count; ++i) {
    if (fitted.member[i] == &MotionParameters::equilibrium) continue;
    if (fitted.member[i] == member) return index;
    ++index;
  }
  return no_derivative;
}

template <std::size_t N>
auto dual_value(const FittedParameters& fitted) {
  return [&fitted](double MotionParameters::*member, double value) {
    using Real = Dual<double, N>;
    const int i = derivative_index(fitted, member);
    return i == no_derivative ? Real(value) : Real::variable(value, static_cast<std::size_t>(i));
  };
}

template <std::size_t N>
NormalEquations equations_of(const Law& law, const FittedParameters& fitted, const MotionParameters& motion,
                             const Record& record, double h) {
  using Real = Dual<double, N>;
  constexpr std::size_t columns = N + 1;  // the last is the equilibrium's, 1 throughout
  double gram[columns][columns]{}, right[columns]{}, sum_of_squares = 0;
  with_law<Real>(law, motion, dual_value<N>(fitted), [&](const auto& system, const State<Real>& start) {
    integrate<Real>(system, record.t, h, start, [&](std::size_t i, const State<Real>& y) {
      const double r = record.y[i] - motion.equilibrium - y.x.value;
      double row[columns];
      for (std::size_t j = 0; j < N; ++j) row[j] = y.x.derivative[j];
      row[N] = 1;
      for (std::size_t j = 0; j < columns; ++j) {
        right[j] += row[j] * r;
        for (std::size_t l = 0; l <= j; ++l) gram[j][l] += row[j] * row[l];
      }
      sum_of_squares += r * r;
    });
  });

  NormalEquations equations;
  equations.size = fitted.count;
  equations.sum_of_squares = sum_of_squares;
  const auto column = [&](int i) {
    const int d = derivative_index(fitted, fitted.member[i]);
    return d == no_derivative ? N : static_cast<std::size_t>(d);
  };
  for (int i = 0; i < fitted.count; ++i) {
    equations.right[i] = right[column(i)];
    for (int j = 0; j < fitted.count; ++j)
      equations.matrix[i][j] = gram[std::max(column(i), column(j))][std::min(column(i), column(j))];
  }
  return equations;
}

template <std::size_t N>
VelocityGradient gradient_of(const Law& law, const FittedParameters& fitted, const MotionParameters& motion,
                             double duration, double h) {
  using Real = Dual<double, N>;
  VelocityGradient result;
  const double times[] = {0, duration};
  with_law<Real>(law, motion, dual_value<N>(fitted), [&](const auto& system, const State<Real>& start) {
    integrate<Real>(system, times, h, start, [&](std::size_t, const State<Real>& y) {
      result.velocity = y.v.value;
      for (int i = 0; i < fitted.count; ++i) {
        const int d = derivative_index(fitted, fitted.member[i]);
        result.derivative[i] = d == no_derivative ? 0 : y.v.derivative[static_cast<std::size_t>(d)];
      }
    });
  });
  return result;
}

// f of the number of derivatives as a constant: 3 (undamped) to 6.
template <class F>
auto with_derivatives(int count, F f) {
  switch (count) {
    case 3:
      return f(std::integral_constant<std::size_t, 3>{});
    case 4:
      return f(std::integral_constant<std::size_t, 4>{});
    case 5:
      return f(std::integral_constant<std::size_t, 5>{});
    default:
      return f(std::integral_constant<std::size_t, 6>{});
  }
}

}  // namespace

FittedParameters fitted_parameters(const Law& law) {
  FittedParameters fitted;
  const auto add = [&](double MotionParameters::*member, const char* name) {
    fitted.member[fitted.count] = member;
    fitted.name[fitted.count++] = name;
  };
  add(&MotionParameters::angular_frequency, "angular_frequency");
  if (law.viscous) add(&MotionParameters::decay_rate, "decay_rate");
  if (law.drag) add(&MotionParameters::drag, "drag");
  if (law.cubic) add(&MotionParameters::cubic, "cubic");
  add(&MotionParameters::equilibrium, "equilibrium");
  add(&MotionParameters::position, "position");
  add(&MotionParameters::velocity, "velocity");
  return fitted;
}

Parameters pack(const FittedParameters& fitted, const MotionParameters& motion) {
  Parameters parameters{};
  for (int i = 0; i < fitted.count; ++i) parameters[i] = motion.*fitted.member[i];
  return parameters;
}

MotionParameters unpack(const FittedParameters& fitted, const Parameters& parameters) {
  MotionParameters motion;
  for (int i = 0; i < fitted.count; ++i) motion.*fitted.member[i] = parameters[i];
  return motion;
}

double motion_step(double angular_frequency, double duration, double error) {
  const double period = 2 * std::numbers::pi / angular_frequency;
  const double phase = std::max(1.0, angular_frequency * duration);
  const double h = std::pow(120 * std::max(error, 0.0) / phase, 0.25) / angular_frequency;
  return std::clamp(h, period / 2000, period / 40);
}

Trajectory free_motion(const MotionParameters& motion, std::span<const double> t, double h) {
  Trajectory trajectory;
  if (t.empty()) return trajectory;
  trajectory.t.assign(t.begin(), t.end());
  trajectory.x.reserve(t.size());
  trajectory.v.reserve(t.size());
  const Law law{true, motion.drag != 0, false, motion.cubic != 0};
  with_law<double>(
      law, motion, [](double MotionParameters::*, double value) { return value; },
      [&](const auto& system, const State<double>& start) {
        integrate<double>(system, t, h, start, [&](std::size_t, const State<double>& y) {
          trajectory.x.push_back(y.x);
          trajectory.v.push_back(y.v);
        });
      });
  trajectory.t.resize(trajectory.x.size());
  return trajectory;
}

std::vector<double> motion_residuals(const MotionParameters& motion, const Record& record, double h) {
  const Trajectory trajectory = free_motion(motion, record.t, h);
  std::vector<double> r(trajectory.size());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = record.y[i] - motion.equilibrium - trajectory.x[i];
  return r;
}

NormalEquations motion_equations(const Law& law, const Parameters& parameters, const Record& record,
                                 double h) {
  const FittedParameters fitted = fitted_parameters(law);
  const MotionParameters motion = unpack(fitted, parameters);
  return with_derivatives(fitted.count - 1, [&](auto n) {
    return equations_of<decltype(n)::value>(law, fitted, motion, record, h);
  });
}

VelocityGradient velocity_gradient(const Law& law, const MotionParameters& motion, double duration,
                                   double h) {
  const FittedParameters fitted = fitted_parameters(law);
  if (duration <= 0) {
    VelocityGradient start{motion.velocity, {}};
    start.derivative[fitted.count - 1] = 1;
    return start;
  }
  return with_derivatives(fitted.count - 1, [&](auto n) {
    return gradient_of<decltype(n)::value>(law, fitted, motion, duration, h);
  });
}

}  // namespace cromer
