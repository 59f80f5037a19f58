// Amplitude spectrum of a sampled quantity and its strongest line.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace cromer::core {

/// One-sided amplitude spectrum: a sinusoid of amplitude A shows a peak of A.
struct Spectrum {
  double step = 0;                // [rad/s] between neighbouring values
  std::vector<double> amplitude;  ///< at 0, step, 2 step, ... up to half the sampling frequency
};

/// Spectrum of samples h [s] apart, h > 0, at least 4 of them, all finite: mean taken off, Hann window,
/// padded with zeros to a power of two.
Spectrum amplitude_spectrum(std::span<const double> y, double h);

/// The same at any times t [s], strictly increasing, gaps or none: at each frequency the sinusoid and the
/// mean that fit best, weighted by the Hann window (M. Zechmeister & M. Kuerster, Astron. Astrophys. 496, 577
/// (2009)). On a grid of times h [s] apart; samples between its points are shared by the two beside them.
Spectrum least_squares_spectrum(std::span<const double> t, std::span<const double> y, double h);

/// Where a maximum lies of which these are three values one step apart: steps from the middle one, by a
/// parabola through the logarithms. 0 where they have none.
double offset_of_maximum(double before, double at, double after);

struct SpectralLine {
  double angular_frequency = 0;  // [rad/s]
  double amplitude = 0;
};

/// The highest local maximum, refined by a parabola through the logarithms of three values: a few hundredths
/// of the window's resolution 2 pi/(n h) for a lone undamped line, the amplitude 5 %. Drift that falls off
/// from zero frequency is passed over. Empty where nothing rises.
std::optional<SpectralLine> strongest_line(const Spectrum& spectrum);

/// The local maxima of at least `share` of the highest, that one first; no more than `most` of them.
std::vector<SpectralLine> strongest_lines(const Spectrum& spectrum, double share, std::size_t most);

}  // namespace cromer::core
