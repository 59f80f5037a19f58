// What gets through the spring and damper of a driven run: from a shaking base to the mass, or from a force
// on the mass to the ground.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "cromer/analysis/frequency_response.h"

namespace cromer::core {

struct SimulateOptions;
struct SimulatedRun;

/// What goes in is a displacement [m] under --drive base, else a force [N]; so is what comes out.
struct RunTransmission {
  bool of_motion = false;
  double sent = 0;                          // [m] or [N] amplitude
  double frequency_ratio = 0;               ///< drive over undamped natural frequency
  Transmission exact{};                     ///< infinite at undamped resonance
  std::optional<Transmission> simulated{};  ///< where the method's own motion settles; empty where it does
                                            ///< not, and for methods that choose their own steps

  bool bounded() const { return std::isfinite(exact.amplitude); }
  /// Relative, of the amplitude that comes out.
  std::optional<double> error() const {
    return simulated && bounded() ? std::optional(simulated->amplitude / exact.amplitude - 1) : std::nullopt;
  }
};

/// Whether it is the base that moves.
bool sends_motion(const SimulateOptions& options);

/// The amplitude of what goes in.
double sent_amplitude(const SimulateOptions& options, const SimulatedRun& run);

/// Of a linear law with a spring under a harmonic force, an unbalance or a shaking base; the run's effect
/// must be known. Empty otherwise.
std::optional<RunTransmission> transmission_of(const SimulateOptions& options, const SimulatedRun& run);

/// "transmissibility: displacement of the mass over that of the base".
std::string_view transmission_title(const RunTransmission& transmission);

}  // namespace cromer::core
