#include "cromer/tasks/fit/fitted_quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cromer/analysis/air.h"
#include "cromer/analysis/ground_motion.h"
#include "cromer/analysis/swing.h"
#include "cromer/base/dual.h"
#include "cromer/base/pi.h"
#include "cromer/identify/describe_fit.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "cromer/identify/motion/parameter_unit.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {
namespace {

// Unit of a force's coefficient, the default that of a force itself. Where the unit of length is not known it
// has newtons only if displacements cancel.
std::string unit_with_mass(const CoefficientInfo& info, std::string_view length) {
  return length == "m" || info.length == -1
             ? unit_of(info, Powers::superscript)
             : unit_of_powers({{"kg", 1}, {length, 1 + info.length}, {"s", info.time - 2}});
}

// c times an estimate; c has a relative uncertainty of its own, independent of the estimate.
Estimate scaled(const Estimate& estimate, double c, double relative_uncertainty, double t) {
  const double value = c * estimate.value;
  Estimate result =
      make_estimate(value, std::hypot(c * estimate.standard_error, value * relative_uncertainty), t);
  // An interval that is not centred, or cut at a bound, stays so.
  const double widening =
      estimate.standard_error > 0 ? result.standard_error / (c * estimate.standard_error) : 1;
  result.low = value + c * widening * (estimate.low - estimate.value);
  result.high = value + c * widening * (estimate.high - estimate.value);
  if (estimate.low >= 0) result.low = std::max(result.low, 0.0);
  return result;
}

// The interval is that of the root, squared.
Estimate squared(const Estimate& root) {
  const double low = std::max(0.0, root.low);
  return {root.value * root.value, 2 * root.value * root.standard_error, low * low, root.high * root.high};
}

using Real = Dual<double, max_parameters>;

/// The law over numbers that carry their derivatives by its own parameters.
struct LawAtAmplitude {
  Swing<Real> swing;
  CycleDecay<Real> decay;
  Real position, velocity;
};

LawAtAmplitude law_at_amplitude(const LawFit& fit) {
  const auto variable = [&](std::string_view name) {
    const auto i =
        static_cast<std::size_t>(std::find(fit.names.begin(), fit.names.end(), name) - fit.names.begin());
    return i < fit.names.size() ? Real::variable(fit.estimates[i].value, i) : Real(0.0);
  };
  LawAtAmplitude law;
  Oscillator<Real>& per_mass = law.swing.per_mass;
  per_mass.stiffness = Real(0.0);
  for_each_term([&]<class T>() {
    if (!fit.law.has<T>()) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const CoefficientInfo& info = T::coefficients[i];
      per_mass.*T::template members<Real>[i] = from_fitted(info.fitted, variable(info.parameter));
    }
  });
  law.decay.per_mass = per_mass;
  law.position = variable("position");
  law.velocity = variable("velocity");
  return law;
}

// How many standard errors the interval of a parameter reaches; one side may be cut at 0.
double reach_of(const Estimate& estimate, double otherwise) {
  const double s = estimate.standard_error;
  if (!(s > 0)) return otherwise;
  const bool cut = estimate.low == 0;
  return (cut ? estimate.high - estimate.value : 0.5 * (estimate.high - estimate.low)) / s;
}

// The interval reaches as far as those of the parameters that it follows from: each has degrees of freedom of
// its own.
Estimate estimate_of(double value, std::span<const double> slope, const LawFit& fit) {
  const std::size_t n = fit.names.size();
  std::vector<double> reach(n);
  for (std::size_t i = 0; i < n; ++i) reach[i] = reach_of(fit.estimates[i], fit.student);
  double variance = 0, square = 0, above = 0, below = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double part = slope[i] * fit.covariance[i * n + j] * slope[j];
      variance += part;
      square += reach[i] * part * reach[j];
    }
    // A parameter on its bound has no covariance, and goes to one side alone.
    const Estimate& parameter = fit.estimates[i];
    if (fit.covariance[i * n + i] > 0 || !(parameter.standard_error > 0)) continue;
    variance += std::pow(slope[i] * parameter.standard_error, 2);
    const double most = slope[i] * (parameter.high - parameter.value),
                 least = slope[i] * (parameter.low - parameter.value);
    above += std::pow(std::max(most, least), 2);
    below += std::pow(std::min(most, least), 2);
  }
  square = std::max(0.0, square);
  return {value, std::sqrt(std::max(0.0, variance)), value - std::sqrt(square + below),
          value + std::sqrt(square + above)};
}

Estimate estimate_of(const Real& number, const LawFit& fit) {
  return estimate_of(number.value, number.derivative, fit);
}

// Of a quantity that is never negative.
Estimate cut_at_zero(Estimate estimate) {
  estimate.low = std::max(estimate.low, 0.0);
  return estimate;
}

// Where the law's damping is cut at 0, so is what follows from it.
Estimate of_damping(const Real& number, const LawFit& fit) {
  const Estimate* rate = fit.find(Viscous::coefficients[0].parameter);
  const Estimate found = estimate_of(number, fit);
  return rate && rate->low == 0 ? cut_at_zero(found) : found;
}

// If something surely feeds the swing, and something surely bounds it. The slopes are differences: the cycle
// has no closed form.
std::optional<Estimate> limit_cycle(const LawFit& fit, double near, double period) {
  const Estimate* bound = fit.find(VanDerPol::coefficients[0].parameter);
  if (!is_fed(fit) || !bound || !(bound->low > 0)) return std::nullopt;
  const FittedParameters fitted = fitted_parameters(fit.law, fit.drive.kind, {}, fit.motion);
  const auto value = limit_cycle_amplitude(fit.motion.per_mass, near, period);
  if (!value) return std::nullopt;
  std::vector<double> slope(fit.names.size(), 0.0);
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const int place = fitted.place_of(fit.names[i]);
    const double step = 0.1 * fit.estimates[i].standard_error;
    if (place < 0 || !fitted.of[place].coefficient || !(step > 0)) continue;
    Motion motion = fit.motion;
    fitted.of[place].set(motion, fit.estimates[i].value + step);
    if (const auto moved = limit_cycle_amplitude(motion.per_mass, *value, period))
      slope[i] = (*moved - *value) / step;
  }
  return cut_at_zero(estimate_of(*value, slope, fit));
}

std::vector<Parameter> at_amplitude(LawAtAmplitude law, const Real& A, const LawFit& fit,
                                    const std::string& unit) {
  const Real undamped = law.swing.angular_frequency(A);
  law.decay.angular_frequency = undamped;
  const Real g = 0.5 * law.decay.per_mass.damping, equivalent = law.decay.equivalent_rate(A);
  const Real w = sqrt(undamped * undamped - g * g);
  const Real period = two_pi / w;
  const Estimate ratio = of_damping(equivalent / undamped, fit);
  std::vector<Parameter> list{{"frequency", cut_at_zero(estimate_of(1 / period, fit)), "Hz"},
                              {"period", cut_at_zero(estimate_of(period, fit)), "s"},
                              {"damping_ratio", ratio, "1"}};
  // A motion that is fed, or grows, has no quality factor.
  const bool fed = value_of(g) < 0;
  if (!fed && !(value_of(equivalent) < 0)) {
    // The interval is the damping ratio's, turned over; damping that may be none leaves Q without an upper
    // end.
    Estimate quality = estimate_of(undamped / (2 * equivalent), fit);
    quality.low = 1 / (2 * ratio.high);
    if (!std::isfinite(quality.value)) quality.standard_error = std::numeric_limits<double>::quiet_NaN();
    quality.high = ratio.low > 0 ? 1 / (2 * ratio.low) : std::numeric_limits<double>::infinity();
    list.push_back({"quality_factor", quality, "1"});
  }
  list.push_back({"logarithmic_decrement", of_damping(law.decay.rate(A) * period, fit), "1"});
  list.push_back({"at_amplitude", cut_at_zero(estimate_of(A, fit)), unit});
  if (const auto limit = limit_cycle(fit, value_of(A), value_of(period)))
    list.push_back({"limit_cycle_amplitude", *limit, unit});
  return list;
}

constexpr std::string_view names_for_goals[] = {"frequency",
                                                "period",
                                                "damping_ratio",
                                                "quality_factor",
                                                "logarithmic_decrement",
                                                "limit_cycle_amplitude"};

// What an overdamped motion does not have, as it has no cycle.
constexpr std::string_view no_cycle[] = {"frequency", "period", "logarithmic_decrement"};

}  // namespace

const std::span<const std::string_view> derived_names = names_for_goals;

Quantity Body::effective_mass() const {
  const Quantity spring = spring_mass.value_or(Quantity{});
  return {mass->value + spring.value / 3, std::hypot(mass->uncertainty, spring.uncertainty / 3)};
}

std::vector<Parameter> law_parameters(const LawFit& fit, std::string_view observed, int derivative,
                                      std::string_view force_unit) {
  std::vector<Parameter> result;
  for (std::size_t i = 0; i < fit.names.size(); ++i)
    result.push_back({fit.names[i], fit.estimates[i],
                      unit_of_parameter(fit.names[i], fit.motion, observed, derivative, force_unit)});
  return result;
}

std::vector<Parameter> force_parameters(const LawFit& fit, const Body& body, std::string_view length) {
  std::vector<Parameter> result;
  if (!body.mass) return result;
  const Quantity m = body.effective_mass();
  const double u_m = m.uncertainty / m.value;
  for_each_term([&]<class T>() {
    for (const CoefficientInfo& info : T::coefficients) {
      const Estimate* fitted = fit.find(info.parameter);
      if (!fit.law.has<T>() || info.in_si.empty() || !fitted) continue;
      const Estimate per_mass = info.fitted == FittedAs::square_root ? squared(*fitted) : *fitted;
      const double times = from_fitted(info.fitted, 1.0) * m.value;
      result.push_back(
          {std::string(info.in_si), scaled(per_mass, times, u_m, fit.student), unit_with_mass(info, length)});
    }
  });
  if (const Estimate* amplitude = fit.find("drive_amplitude"))
    result.push_back(
        {"drive_force", scaled(*amplitude, m.value, u_m, fit.student), unit_with_mass({}, length)});
  const Estimate* drag = fit.find(Drag::coefficients[0].parameter);
  if (drag && body.disc_diameter) {
    // d = rho S C_d / 2 with S = pi D²/4; rho goes as 1/T.
    const Quantity D = *body.disc_diameter;
    const double area = pi / 4 * D.value * D.value;
    const double factor = 2 * m.value / (air_density(body.temperature.value) * area);
    const double relative =
        std::hypot(u_m, 2 * D.uncertainty / D.value, body.temperature.uncertainty / body.temperature.value);
    result.push_back({"drag_coefficient", scaled(*drag, factor, relative, fit.student), "1"});
  }
  return result;
}

std::vector<std::string> coefficient_names(const Law& law, const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) {
    const bool is_there = std::any_of(parameters.begin(), parameters.end(),
                                      [&](const Parameter& each) { return each.name == name; });
    if (is_there) names.emplace_back(name);
    return is_there;
  };
  for_each_term([&]<class T>() {
    if (!law.has<T>()) return;
    for (const CoefficientInfo& info : T::coefficients) add(info.in_si) || add(info.parameter);
  });
  add("drag_coefficient");
  return names;
}

Parameter pendulum_length(const Estimate& w) {
  const auto length = [](double of) { return standard_gravity / (of * of); };
  const double L = length(w.value);
  return {"pendulum_length", {L, 2 * L * w.standard_error / w.value, length(w.high), length(w.low)}, "m"};
}

std::vector<Parameter> derived_quantities(const LawFit& fit, std::string_view observed, int derivative,
                                          const std::vector<double>& x, std::string_view force_unit) {
  const std::string length = displacement_unit(observed, derivative);
  if (!fit.law.shares(springs)) {
    const Estimate gain = fit["force_gain"];
    const double mass = 1 / gain.value, error = gain.standard_error / (gain.value * gain.value);
    const bool newtons = force_unit == "N" && length == "m";
    return {{"mass", make_estimate(mass, error, fit.student), newtons ? "kg" : ""}};
  }
  if (fit.law.has<Hysteresis>()) return {};
  const LawAtAmplitude law = law_at_amplitude(fit);
  const bool free = fit.drive.kind == DriveKind::none;
  const Real A = free ? law.swing.amplitude(law.position, law.velocity) : Real(sinusoid_amplitude(x));
  std::vector<Parameter> list = at_amplitude(law, A, fit, length);
  if (!free && fit.motion.decay_rate() >= fit.motion.angular_frequency())
    std::erase_if(list, [](const Parameter& number) {
      return std::find(std::begin(no_cycle), std::end(no_cycle), number.name) != std::end(no_cycle);
    });
  if (fit.law.has<Pendulum>()) list.push_back(pendulum_length(fit.angular_frequency()));
  return list;
}

std::vector<Parameter> decay_rate_ends(const LawFit& fit, double duration) {
  if (fit.drive.kind != DriveKind::none || !fit.law.shares(springs) || fit.law.has<Hysteresis>()) return {};
  LawAtAmplitude law = law_at_amplitude(fit);
  Real A = law.swing.amplitude(law.position, law.velocity);
  law.decay.angular_frequency = law.swing.angular_frequency(A);
  const Real first = law.decay.rate(A);
  if (!std::isfinite(value_of(first))) return {};
  std::vector<Parameter> ends{{"decay_rate_start", of_damping(first, fit), "1/s"}};
  const double other = value_of(law.decay.rate(0.5 * A));
  if (std::abs(other - value_of(first)) <= 1e-12 * std::abs(other)) {  // the same at every amplitude
    ends.push_back({"decay_rate_end", ends[0].estimate, "1/s"});
    return ends;
  }
  // Runge-Kutta of the fourth order, on the logarithm of the amplitude, which falls by half or less in a
  // step.
  constexpr double fewest = 32, most = 1000;
  const int steps = static_cast<int>(std::clamp(2 * std::abs(value_of(first)) * duration, fewest, most));
  const double h = duration / steps, nothing = 1e-12 * value_of(A);
  for (int i = 0; i < steps && value_of(A) > nothing; ++i) {
    const Real k1 = law.decay.rate(A), k2 = law.decay.rate(A * exp(-0.5 * h * k1)),
               k3 = law.decay.rate(A * exp(-0.5 * h * k2)), k4 = law.decay.rate(A * exp(-h * k3));
    const Real fall = h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    constexpr double to_rest = 2;  // in one step, by friction
    const bool falls = value_of(fall) < to_rest && h * value_of(k4) < to_rest;
    if (!falls && fit.law.has<Friction>()) return ends;
    A = A * exp(-fall);
  }
  ends.push_back({"decay_rate_end", of_damping(law.decay.rate(A), fit), "1/s"});
  return ends;
}

}  // namespace cromer::core
