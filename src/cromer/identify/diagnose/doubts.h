// What speaks against a fit that converged: a swing that is not free, or that no law tried describes.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// Whether it says that no law, or not the given one, describes the recording.
bool is_of_no_law(const Notice& notice);

// Departures from a free swing that have a name.

/// The zero drifts, or jumps: a straight line or one step accounts for three tenths of the residuals'
/// variance. Empty where neither does.
Notice wandering_zero(const Record& record, std::span<const double> residuals, std::string_view unit);

/// Share of the residuals' variance that the better of the two accounts for.
double wandering_share(const Record& record, std::span<const double> residuals);

struct SwingStop {
  double from = 0, to = 0;  // [s] it is free until `from`, and has stopped by `to`
  double amplitude = 0;     ///< of the last period up to `from`, in the record's unit

  /// A notice of this code that says so.
  Notice notice(const char* code, std::string_view unit) const;
};

/// Where the swing stops for good: within two to four periods less than a tenth of its amplitude is left.
/// With `described` (a law describes the record) only after a fall of less than three tenths in the two
/// periods before, which friction cannot make. Needs eight periods [s] of six samples each.
std::optional<SwingStop> find_stop(const Record& record, double period, bool described);

/// The same in words; empty without a stop.
Notice sudden_stop(const Record& record, double period, std::string_view unit, bool described);

/// Even samples, fewer than four in a period: which other frequencies would look the same. Else empty.
Notice few_samples(const Record& record, double angular_frequency);

/// An angle [rad] that goes through more than a full turn: the pendulum turns over. Else empty.
Notice turning_over(const Record& record);

/// The noise that a line stands out of: the same at all frequencies, or one that may fall with their square,
/// as what wanders does: powers are then compared times the square of the frequency.
enum class Background { even, may_wander };

/// How many times the power beside it a line has that a wrong law leaves, at least.
inline constexpr double line_of_a_wrong_law = 30;

/// True if the residuals at times t have a line about this angular frequency [rad/s], that of a swing which
/// decays at a rate [1/s], or of a drive, or a multiple of them: more than `times` the median power on either
/// side. A wrong law leaves such a line, noise does not.
bool leaves_a_line(std::span<const double> t, std::span<const double> residuals, double decay_rate,
                   double angular_frequency, double times = line_of_a_wrong_law,
                   Background noise = Background::even);

/// Whether residuals of a motion y are smooth, and larger than twice the noise from sample to sample, than a
/// rounding step and than arithmetic makes them. A wrong law leaves such where a period has many samples.
bool exceeds_noise(std::span<const double> y, double resolution, double rms, double autocorrelation,
                   double noise);

/// How many times the noise from sample to sample such residuals are.
double times_noise(double rms, double noise);

/// Whether the amplitude rises from one window to a later one by more than 2 % of the largest, a fifth of
/// what counts as a rise: else no part of the record has one, and no drive makes it beat. False of fewer than
/// three windows.
bool may_rise(const Record& record, double period);

/// What speaks against the fit; empty where nothing is suspicious. Looked for are the departures above, an
/// amplitude that rises, one that falls by a few percent at most over twenty periods, a motion of one or two
/// rounding steps, and residuals well above the noise from sample to sample that stand out about the swing's
/// own frequency. `only_law`: no other law was tried. `unit` is the record's.
std::vector<Notice> doubts(const Record& record, const LawFit& fit, bool only_law = false,
                           std::string_view unit = {});

/// The same for a motion that is driven at `drive` [rad/s]; 0 means a recorded force. Reported are lines
/// that the law leaves, with what they may be, and that no law describes the recording. `residuals` are the
/// record's, `fit` the driven law.
std::vector<Notice> driven_doubts(const Record& record, const LawFit& fit, std::span<const double> residuals,
                                  double drive, bool only_law = false, std::string_view unit = {});

/// True if more terms may be worth trying: the residuals are above the rounding, and stand out about the
/// swing's frequency or a harmonic drive's, or their first harmonics; under a recorded force, they are not
/// white.
bool something_is_left(const Record& record, const LawFit& fit);

/// How correlated residuals have widened the uncertainties; empty where they are white.
Notice widening(const LawFit& fit, std::size_t samples);

}  // namespace cromer::core
