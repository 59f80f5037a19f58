// The laws whose fits are calibrated, and what is true of them.
#pragma once

#include <cmath>
#include <string_view>

#include "cromer/base/state.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/model/oscillator.h"

namespace cromer::core::bench {

inline constexpr double amplitude = 0.05;       // [m] at the first sample
inline constexpr double natural_frequency = 6;  // [rad/s]
inline constexpr double samples_per_cycle = 50;

/// A law and its coefficients for a mass of 1 kg: over the twenty cycles of the base condition each term is
/// known to a few percent.
struct TrueLaw {
  const char* law;  ///< as --law takes it
  Oscillator<double> oscillator;
};

inline constexpr double stiffness = natural_frequency * natural_frequency;
inline constexpr TrueLaw true_laws[] = {
    {"viscous", {.stiffness = stiffness, .damping = 0.14}},
    {"viscous+drag", {.stiffness = stiffness, .damping = 0.08, .drag = 0.8}},
    {"viscous+cubic", {.stiffness = stiffness, .damping = 0.14, .cubic = -400}},
    {"viscous+drag+cubic", {.stiffness = stiffness, .damping = 0.08, .drag = 0.8, .cubic = -400}},
    {"friction", {.stiffness = stiffness, .friction = 0.012}},
    {"viscous+friction", {.stiffness = stiffness, .damping = 0.08, .friction = 0.006}},
    {"viscous+friction+cubic", {.stiffness = stiffness, .damping = 0.08, .friction = 0.006, .cubic = -400}},
};

/// A law, where its motion begins, and about which value the sensor sees it.
struct Truth {
  Oscillator<double> oscillator;  // mass 1 kg
  State<double> start;
  double equilibrium = 0;  // [m]

  /// By the name that a fit gives the parameter.
  double of(std::string_view parameter) const {
    if (parameter == "angular_frequency") return std::sqrt(oscillator.stiffness);
    if (parameter == "decay_rate") return oscillator.damping / 2;
    if (parameter == "drag") return oscillator.drag;
    if (parameter == "friction") return oscillator.friction;
    if (parameter == "cubic") return oscillator.cubic;
    if (parameter == "equilibrium") return equilibrium;
    if (parameter == "position") return start.x;
    if (parameter == "velocity") return start.v;
    return NAN;
  }

  Parameters packed(const FittedParameters& fitted) const {
    Parameters parameters{};
    for (int i = 0; i < fitted.count; ++i) parameters[i] = of(fitted.of[i].name);
    return parameters;
  }
};

}  // namespace cromer::core::bench
