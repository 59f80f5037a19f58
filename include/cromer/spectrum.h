// Response and shock spectra of a recorded acceleration.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <cromer/drive.h>
#include <cromer/export.h>
#include <cromer/notice.h>
#include <cromer/result.h>
#include <cromer/status.h>

namespace cromer {

namespace core {
struct SpectrumResult;
}

/// Where extremes are looked for: everywhere; at the samples; or, as PEER does, at the fewest equal parts of
/// an interval that are at most T/10 long.
enum class Peaks { continuous, samples, peer };

/// "continuous", "samples", "peer".
constexpr std::string_view name(Peaks peaks) {
  return peaks == Peaks::continuous ? "continuous" : peaks == Peaks::samples ? "samples" : "peer";
}

/// Whose extremes a shock spectrum has (ISO 18431-4): of the mass on a base that moves as recorded. z is its
/// displacement relative to the base.
enum class ShockResponse {
  absolute_acceleration,
  relative_velocity,              // dz/dt
  relative_displacement,          // z
  pseudo_velocity,                // w z
  equivalent_static_acceleration  // -w^2 z, what the spring alone gives the mass
};
inline constexpr std::array<std::string_view, 5> shock_responses{"absolute-acceleration", "relative-velocity",
                                                                 "relative-displacement", "pseudo-velocity",
                                                                 "equivalent-static-acceleration"};

/// "absolute-acceleration", "relative-velocity", ...
constexpr std::string_view name(ShockResponse of) { return shock_responses[static_cast<std::size_t>(of)]; }

/// Extremes of that response, all as magnitudes, in SI.
struct Shock {
  double primary = 0;   ///< while the shock lasts
  double residual = 0;  ///< after it
  double positive = 0;  ///< towards positive values, during or after
  double negative = 0;  ///< towards negative values, during or after

  double maximax() const { return std::max(positive, negative); }
};

struct SpectrumOptions {
  double damping_ratio = 0.05;  // 0 to 20
  /// 0.001 to 2: hysteretic damping instead; then without second, peaks and between.
  std::optional<double> loss_factor{};
  /// Above 1 to 100: springs that yield, elastoplastic, whose peak is so many times their displacement at
  /// yield; the spectrum is of that at yield. Then without loss_factor, shock, second and peaks.
  std::optional<double> ductility{};
  std::optional<ShockResponse> shock{};  ///< a shock spectrum of this response; then without second
  /// [s] From a thousandth of the spacing to a million times the record; empty: 200 from 0.01 s to 10 s in
  /// even ratios, of a shock from a tenth of a cycle within it to ten samples a cycle.
  std::span<const double> periods{};
  std::span<const double> second{};  // [m/s^2] the other horizontal component, sampled alike; empty: none
  Peaks peaks = Peaks::continuous;   // peer: with linear `between` only
  BetweenSamples between = BetweenSamples::linear;
  Progress progress{};
};

/// Each vector has one value for each period. Of two components all but rotd50 and rotd100 are of the first.
/// A shock spectrum has shock in place of displacement and what follows from it.
struct ResponseSpectrum {
  std::vector<double> period;               // [s]
  std::vector<double> displacement;         // [m] SD: largest |x| relative to the ground
  std::vector<double> pseudo_velocity;      // [m/s] PSV = w SD
  std::vector<double> pseudo_acceleration;  // [m/s^2] PSA = w^2 SD
  std::vector<double> rotd50, rotd100;      // [m] of two components: SD over all horizontal directions
  std::vector<Shock> shock;                 // of the response asked for, in SI
  /// Of the ground, at its samples, from rest at the first one.
  std::vector<double> ground_velocity, ground_displacement;  // [m/s], [m]
  double peak_acceleration = 0;                              // [m/s^2] PGA of the ground
  double peak_velocity = 0;                                  // [m/s] PGV
  double peak_displacement = 0;                              // [m] PGD
  double cumulative_absolute_velocity = 0;                   // [m/s] CAV
  double arias_intensity = 0;                                // [m/s]
  double duration_5_75 = 0, duration_5_95 = 0;               // [s] significant durations
  double duration_bracketed = 0;  // [s] from the first to the last |a| of 0.05 g; 0: none
  bool interrupted = false;       ///< then the vectors are empty
  std::vector<Notice> notices;    ///< what else there is to know
  std::shared_ptr<const core::SpectrumResult> detail{};
};

/// Of the ground's acceleration [m/s^2], evenly sampled every `spacing` [s] > 0, at least two samples. By the
/// exact recurrence (Nigam & Jennings, Bull. Seism. Soc. Am. 59, 909 (1969)), extremes between samples
/// included; error about 1e-13 of the largest. An Error names the argument.
CROMER_API Result<ResponseSpectrum> response_spectrum(std::span<const double> acceleration, double spacing,
                                                      const SpectrumOptions& options = {});

}  // namespace cromer
