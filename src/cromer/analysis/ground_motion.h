// Measures of a recorded acceleration itself: how strong, how long, at which frequencies.
#pragma once

#include <span>
#include <vector>

#include "cromer/model/sampled_drive.h"

namespace cromer::core {

inline constexpr double standard_gravity = 9.80665;  // [m/s^2]

/// Arias intensity and the significant duration: the time from 5 to 95 % of it (A. Arias, in Seismic Design
/// for Nuclear Power Plants, MIT Press 1970; M. D. Trifunac & A. G. Brady, Bull. Seism. Soc. Am. 65, 581
/// (1975)).
struct Intensity {
  double arias = 0;        // [m/s] pi/(2 g) times the integral of a^2; NaN where that is beyond any double
  double decades = 0;      ///< its decimal logarithm, which is always there; 0 where nothing shakes
  double from = 0;         // [s] after the first sample, when 5 % of it have come
  double duration = 0;     // [s] from there until 95 %
  double duration_75 = 0;  // [s] from there until 75 %
};

/// The intensity of samples h [s] apart, at least two, of any finite size; exact for the motion that
/// `between` joins them to. All 0 where nothing shakes.
Intensity intensity(std::span<const double> acceleration, double h, BetweenSamples between);

/// Velocity and displacement of a ground that rests at the first sample.
struct GroundPath {
  std::vector<double> velocity, displacement;  // [m/s], [m] at the samples
  double peak_velocity = 0;                    // [m/s] largest magnitude, between the samples too
  double peak_displacement = 0;                // [m] likewise
};

/// Both integrals of samples h [s] apart, at least two; exact for the motion that `between` joins them to
/// (linear or hold). A hold of the last sample counts for the peaks.
GroundPath ground_path(std::span<const double> acceleration, double h, BetweenSamples between);

/// [m/s] Integral of |a| (EPRI NP-5930 (1988)); exact as above.
double cumulative_absolute_velocity(std::span<const double> acceleration, double h, BetweenSamples between);

inline constexpr double bracket = 0.05 * standard_gravity;  // [m/s^2]

/// [s] From the first time that |a| reaches `level` until the last (B. A. Bolt, Proc. 5th World Conf. Earthq.
/// Eng., 1304 (1973)); exact as above. 0 where it never does.
double bracketed_duration(std::span<const double> acceleration, double h, BetweenSamples between,
                          double level = bracket);

/// |integral of a(t) e^{-i W t} dt| by the discrete transform, padded with zeros to a power of two.
struct FourierAmplitude {
  double step = 0;                // [Hz] between neighbouring values
  std::vector<double> amplitude;  // [m/s] at 0, step, 2 step, ... up to half the sampling frequency
};

FourierAmplitude fourier_amplitude(std::span<const double> acceleration, double h);

}  // namespace cromer::core
