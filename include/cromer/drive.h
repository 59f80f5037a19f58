// What pushes the oscillator from outside.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

namespace cromer {

/// What a recorded quantity did between its samples: straight lines; each value held until the next, as a
/// digital-to-analogue converter does (in spectra the last one for one spacing as well); or what a
/// band-limited signal does, by a windowed sinc over 16 samples to each side, in spectra over 128.
enum class BetweenSamples { linear, hold, band_limited };

/// "linear", "hold", "band-limited".
constexpr std::string_view name(BetweenSamples between) {
  return between == BetweenSamples::linear ? "linear"
         : between == BetweenSamples::hold ? "hold"
                                           : "band-limited";
}

/// F cos(w t + phi).
struct Harmonic {
  double amplitude = 0;  // [N] >= 0
  double frequency = 0;  // [rad/s] >= 0, angular
  double phase = 0;      // [rad]
};

/// A rotating unbalance: m_u e w^2 cos(w t + phi). Its mass is part of the oscillator's.
struct Unbalance {
  double mass = 0;          // [kg] > 0
  double eccentricity = 0;  // [m] > 0
  double frequency = 0;     // [rad/s] > 0, angular
  double phase = 0;         // [rad]
};

/// A shaking base: Y cos(w t + phi); x is the displacement relative to it.
struct ShakingBase {
  double displacement = 0;  // [m] > 0, amplitude Y
  double frequency = 0;     // [rad/s] > 0, angular
  double phase = 0;         // [rad]
};

/// A force that sets in and ends; a step does not end.
struct Pulse {
  enum class Shape { step, rectangular, half_sine, triangular };
  Shape shape = Shape::step;
  double amplitude = 0;  // [N] > 0, its height
  double start = 0;      // [s] >= 0
  double duration = 0;   // [s] > 0; ignored for a step
};

/// F cos(angle), whose frequency rises or falls evenly or, if logarithmic, by equal ratios in equal times.
struct Chirp {
  double amplitude = 0;              // [N] > 0
  double from = 0, to = 0;           // [rad/s] >= 0; > 0 if logarithmic
  double start = 0;                  // [s] >= 0
  std::optional<double> duration{};  // [s] > 0; to the end of the run if not given
  double phase = 0;                  // [rad] at its start
  bool logarithmic = false;
};

/// A recorded force, evenly sampled from t = 0 on. A run that lasts longer is an Error.
struct SampledForce {
  std::span<const double> force;  // [N] at least two, all finite
  double spacing = 0;             // [s] > 0
  BetweenSamples between = BetweenSamples::linear;
};

/// The recorded acceleration of the ground, evenly sampled from t = 0 on; x is the displacement relative to
/// it. A run that lasts longer is an Error.
struct GroundMotion {
  std::span<const double> acceleration;  // [m/s^2] at least two, all finite
  double spacing = 0;                    // [s] > 0
  BetweenSamples between = BetweenSamples::linear;
};

/// Nothing, or one of these.
using Drive =
    std::variant<std::monostate, Harmonic, Unbalance, ShakingBase, Pulse, Chirp, SampledForce, GroundMotion>;

}  // namespace cromer
