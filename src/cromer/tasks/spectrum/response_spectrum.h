// Task: response and shock spectra of a recorded acceleration.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/analysis/ground_motion.h"
#include "cromer/base/interrupt.h"
#include "cromer/ensemble/response_peaks.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/spectrum.h"
#include "cromer/tasks/spectrum/correction.h"

namespace cromer::core {

struct SpectrumOptions {
  std::vector<std::string> damping_ratio{};  ///< grids, 0 to 20; 0.05 by default
  std::vector<std::string> loss_factor{};    ///< in place of it: grids, above 0 to 2
  std::vector<std::string> ductility{};      ///< grids, above 1 to 100, of springs that yield
  std::string periods{};                     ///< grid [s], as parse_grid reads it
  std::string frequencies{};                 ///< in place of periods: grid of natural frequencies [rad/s]
  std::string peaks{};                       ///< continuous (by default), samples or peer
  std::string between_samples{};             ///< linear (by default), hold or band-limited
  bool shock = false;                        ///< shock response spectrum
  std::string shock_response{};              ///< of which response; absolute-acceleration by default
  std::string baseline{};                    ///< constant, linear, quadratic or cubic: is taken off
  std::string band_pass{};                   ///< "0.1:25 Hz"
  std::optional<int> band_pass_order{};      ///< 1 to 12; 4 by default
  bool causal = false;                       ///< the filter runs forwards alone
  bool in_g = false;                         ///< accelerations are written in g
  std::vector<std::string> column{};         ///< one, or two components
  std::optional<int> run{};                  ///< > 0; the first by default
  std::string unit{};                        ///< of the acceleration, where the file says none
  ReadOptions read{};
  std::vector<double> these_periods{};  // [s] in place of the grids. Set by the caller, not an option
  double memory = 0;  // [bytes] most that may be used; 0: no limit. Set by the caller, not an option

  /// The oscillators were given by their frequencies, and are shown by them.
  bool by_frequency() const { return !frequencies.empty(); }
};

/// One of two horizontal components, or the only one.
struct Component {
  std::string file, column;
  std::string motion;                ///< event and station, where the file names them
  std::vector<double> acceleration;  // [m/s^2] as recorded, then corrected; empty after forget()
  double begins = 0;                 // [s] the first sample, below 0 where zeros were added
  double baseline = 0;               // [m/s^2] largest magnitude of what was taken off
  std::size_t samples = 0;           ///< filled in by the task
  double spacing = 0;                // [s]
  double peak = 0;                   // [m/s^2] largest |a|: the peak ground acceleration
  GroundPath path;                   ///< at the samples; its motions are empty after forget()
  double absolute_velocity = 0;      // [m/s] cumulative, CAV
  double bracketed_duration = 0;     // [s] of 0.05 g
  Intensity intensity;
  FourierAmplitude fourier;

  double duration() const { return spacing * static_cast<double>(samples - 1); }
};

/// The spectrum of one damping ratio, at all periods.
struct ResponseSpectrum {
  double damping_ratio = 0;
  double ductility = 1;  ///< above 1 the spring yields, and displacement is that of yield
  std::vector<std::vector<double>> displacement{};            // [m] SD of each component
  std::vector<double> geometric_mean{}, rotd50{}, rotd100{};  // [m] SD, of two components
  std::vector<Shock> shock{};                                 ///< of a shock spectrum, which has nothing else
  std::vector<std::size_t>
      after_the_end{};  ///< indices of periods whose peak comes after the last sample and is higher by 1 %
};

/// Pseudo-velocity [m/s] and pseudo-acceleration [m/s^2] of a peak displacement [m].
double pseudo_velocity(double displacement, double period);
double pseudo_acceleration(double displacement, double period);

struct SpectrumResult {
  SpectrumOptions options;  ///< as used, defaults filled in
  Peaks peaks = Peaks::continuous;
  ShockResponse shock_of = ShockResponse::absolute_acceleration;
  Correction correction{};
  std::vector<double> periods{};  // [s] in the order asked for
  std::vector<Component> components{};
  std::vector<ResponseSpectrum> spectra{};
  std::vector<Notice> notices{};
  /// The springs have hysteretic damping, and damping_ratio is their loss factor.
  bool hysteretic() const { return !options.loss_factor.empty(); }
  bool by_frequency() const { return options.by_frequency(); }
  /// The springs yield.
  bool inelastic() const { return !options.ductility.empty(); }

  bool interrupted = false;  ///< then `spectra` is empty

  /// Gives up what is as long as the recordings: motions and Fourier amplitudes.
  void forget();
};

/// One of many motions: its spectra, or why there are none.
struct MotionSpectra {
  std::vector<std::string> files;  ///< one, or two of its components
  Result<SpectrumResult> result;   ///< forgotten what is as long as the recordings

  bool succeeded() const { return result.ok(); }
};

/// Checks of the options what can be checked without the recordings; a motion has so many `files`.
Result<void> check_spectrum_options(const SpectrumOptions& options, std::size_t files);

/// Checks the options and the recordings (one, or two components of one motion), then computes. An Error
/// names option or file, value and cure.
Result<SpectrumResult> response_spectrum(std::span<const Recording> recordings,
                                         const SpectrumOptions& options, const Watch& watch = {});

/// The same of components whose file, column, acceleration and spacing are set; two must be sampled alike and
/// equally long.
Result<SpectrumResult> response_spectrum(std::vector<Component> components, const SpectrumOptions& options,
                                         const Watch& watch = {});

}  // namespace cromer::core
