#include "cromer/identify/free_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/identify/free_law.h"
#include "cromer/identify/phases.h"

namespace cromer {
namespace {

constexpr int no_derivative = -1;

// The derivatives that ride along: of all parameters of the law with viscous damping, but for the
// equilibrium, whose is 1 throughout.
template <Law law>
constexpr std::size_t derivatives = 4 + law.drag + law.friction + law.cubic;

// Where a parameter's derivative stands among them.
int derivative_index(const Law& law, double MotionParameters::*member) {
  Law viscous = law;
  viscous.viscous = true;
  const FittedParameters all = fitted_parameters(viscous);
  int index = 0;
  for (int i = 0; i < all.count; ++i) {
    if (all.member[i] == &MotionParameters::equilibrium) continue;
    if (all.member[i] == member) return index;
    ++index;
  }
  return no_derivative;
}

// The law's coefficients and start, each made by value(member, number).
template <class Real, class Value>
FreeStart<Real> start_of(const MotionParameters& motion, Value value) {
  const Real w0 = value(&MotionParameters::angular_frequency, motion.angular_frequency);
  const Real g = value(&MotionParameters::decay_rate, motion.decay_rate);
  return {{.mass = Real(1),
           .stiffness = w0 * w0,
           .damping = g + g,
           .drag = value(&MotionParameters::drag, motion.drag),
           .friction = value(&MotionParameters::friction, motion.friction),
           .cubic = value(&MotionParameters::cubic, motion.cubic),
           .static_friction = Real(0)},
          {value(&MotionParameters::position, motion.position),
           value(&MotionParameters::velocity, motion.velocity)},
          motion.pendulum};
}

FreeStart<double> start_of(const MotionParameters& motion) {
  return start_of<double>(motion, [](double MotionParameters::*, double value) { return value; });
}

template <Law law>
auto phases_with_derivatives(const MotionParameters& motion) {
  using Real = Dual<double, derivatives<law>>;
  const auto value = [](double MotionParameters::*member, double number) {
    const int i = derivative_index(law, member);
    return i == no_derivative ? Real(number) : Real::variable(number, static_cast<std::size_t>(i));
  };
  return phases_of<law>(start_of<Real>(motion, value), start_of(motion));
}

// What the record holds of a motion, but for the equilibrium.
template <class Seen>
auto observed(const Seen& seen, int derivative) {
  return derivative == 0 ? seen.x() : derivative == 1 ? seen.v() : seen.a();
}

template <Law law>
NormalEquations equations_of(const FittedParameters& fitted, const MotionParameters& motion,
                             const Record& record, double h) {
  constexpr std::size_t N = derivatives<law>, columns = N + 1;  // the last is the equilibrium's
  double gram[columns][columns]{}, right[columns]{}, sum_of_squares = 0;
  follow(phases_with_derivatives<law>(motion), record.t, h, [&](std::size_t i, const auto& seen) {
    const auto model = observed(seen, record.derivative);
    const double r = record.y[i] - motion.equilibrium - model.value;
    double row[columns];
    for (std::size_t j = 0; j < N; ++j) row[j] = model.derivative[j];
    row[N] = 1;
    for (std::size_t j = 0; j < columns; ++j) {
      right[j] += row[j] * r;
      for (std::size_t l = 0; l <= j; ++l) gram[j][l] += row[j] * row[l];
    }
    sum_of_squares += r * r;
  });

  NormalEquations equations;
  equations.size = fitted.count;
  equations.sum_of_squares = sum_of_squares;
  std::size_t column[max_parameters];
  for (int i = 0; i < fitted.count; ++i) {
    const int d = derivative_index(law, fitted.member[i]);
    column[i] = d == no_derivative ? N : static_cast<std::size_t>(d);
  }
  for (int i = 0; i < fitted.count; ++i) {
    equations.right[i] = right[column[i]];
    for (int j = 0; j < fitted.count; ++j)
      equations.matrix[i][j] = gram[std::max(column[i], column[j])][std::min(column[i], column[j])];
  }
  return equations;
}

// The terms that a motion shows.
Law law_of(const MotionParameters& motion) {
  return {.viscous = true,
          .drag = motion.drag != 0,
          .friction = motion.friction != 0,
          .cubic = motion.cubic != 0,
          .pendulum = motion.pendulum};
}

// Calls visit(i, seen) along the motion, without derivatives.
template <class Visit>
void follow_values(const MotionParameters& motion, std::span<const double> t, double h, Visit visit) {
  const FreeStart<double> start = start_of(motion);
  with_constant(law_of(motion), [&]<Law law>() {
    follow(phases_of<law>(start, start), t, h, visit);
    return true;
  });
}

}  // namespace

FittedParameters fitted_parameters(const Law& law) {
  FittedParameters fitted;
  fitted.pendulum = law.pendulum;
  const auto add = [&](double MotionParameters::*member, const char* name) {
    fitted.member[fitted.count] = member;
    fitted.name[fitted.count++] = name;
  };
  add(&MotionParameters::angular_frequency, "angular_frequency");
  if (law.viscous) add(&MotionParameters::decay_rate, "decay_rate");
  if (law.drag) add(&MotionParameters::drag, "drag");
  if (law.friction) add(&MotionParameters::friction, "friction");
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
  motion.pendulum = fitted.pendulum;
  for (int i = 0; i < fitted.count; ++i) motion.*fitted.member[i] = parameters[i];
  return motion;
}

double motion_step(double angular_frequency, double duration, double error) {
  const double period = 2 * std::numbers::pi / angular_frequency;
  const double phase = std::max(1.0, angular_frequency * duration);
  const double h = std::pow(3600 * std::max(error, 0.0) / phase, 0.2) / angular_frequency;
  return std::clamp(h, period / 600, period / 20);
}

Trajectory free_motion(const MotionParameters& motion, std::span<const double> t, double h) {
  Trajectory trajectory;
  if (t.empty()) return trajectory;
  trajectory.t.assign(t.begin(), t.end());
  trajectory.x.reserve(t.size());
  trajectory.v.reserve(t.size());
  follow_values(motion, t, h, [&](std::size_t, const auto& seen) {
    trajectory.x.push_back(seen.x());
    trajectory.v.push_back(seen.v());
  });
  trajectory.t.resize(trajectory.x.size());
  return trajectory;
}

std::vector<double> motion_residuals(const MotionParameters& motion, const Record& record, double h) {
  std::vector<double> r;
  r.reserve(record.t.size());
  follow_values(motion, record.t, h, [&](std::size_t i, const auto& seen) {
    r.push_back(record.y[i] - motion.equilibrium - observed(seen, record.derivative));
  });
  return r;
}

NormalEquations motion_equations(const Law& law, const Parameters& parameters, const Record& record,
                                 double h) {
  const FittedParameters fitted = fitted_parameters(law);
  const MotionParameters motion = unpack(fitted, parameters);
  return with_constant(law, [&]<Law terms>() { return equations_of<terms>(fitted, motion, record, h); });
}

Rest rest_of(const Law& law, const Parameters& parameters, const Record& record, double h) {
  const FittedParameters fitted = fitted_parameters(law);
  const MotionParameters motion = unpack(fitted, parameters);
  return with_constant(law, [&]<Law terms>() {
    Rest rest;
    int direction = 0;
    follow(phases_with_derivatives<terms>(motion), record.t, h, [&](std::size_t i, const auto& seen) {
      const int now = seen.direction();
      if (now != 0) {
        rest.half_swings += now != direction;
        rest.first = i + 1;
      } else if (rest.first == i) {
        const auto x = seen.x();
        rest.position = x.value;
        for (int j = 0; j < fitted.count; ++j) {
          const int d = derivative_index(terms, fitted.member[j]);
          rest.derivative[j] = d == no_derivative ? 0 : x.derivative[static_cast<std::size_t>(d)];
        }
      }
      direction = now;
    });
    return rest;
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
  const double times[] = {0, duration};
  return with_constant(law, [&]<Law terms>() {
    VelocityGradient result;
    follow(phases_with_derivatives<terms>(motion), times, h, [&](std::size_t, const auto& seen) {
      const auto v = seen.v();
      result.velocity = v.value;
      for (int i = 0; i < fitted.count; ++i) {
        const int d = derivative_index(terms, fitted.member[i]);
        result.derivative[i] = d == no_derivative ? 0 : v.derivative[static_cast<std::size_t>(d)];
      }
    });
    return result;
  });
}

}  // namespace cromer
