// What else oscillates in a recording, once the fitted motion is taken off.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// An angular frequency that may change as the motion dies down.
struct FrequencyBand {
  double low = 0, high = 0;  // [rad/s]
  double error = 0;          // [rad/s] standard error of both

  bool holds(double w, double multiple, double slack) const {
    return w > multiple * low - slack && w < multiple * high + slack;
  }
};

inline constexpr FrequencyBand no_band{.low = 1, .high = -HUGE_VAL};

/// Which multiple, 2 to 15, of a motion's own frequency another is, to three standard errors of both and a
/// tenth of a resolution (2 pi over the record's length [s]); 0 where it is none.
int harmonic_of(double angular_frequency, double error, const FrequencyBand& own, double duration);

struct ResidualLine {
  double angular_frequency = 0;  // [rad/s]
  double frequency_error = 0;    // [rad/s] its standard error
  double amplitude = 0;          ///< at the first sample, in the unit of the record
  double told_amplitude = 0;  ///< what to say of it: of a harmonic that dies down, by the first quarter alone
  double decay_rate = 0;      // [1/s] roughly
  bool lasts = false;         ///< it hardly decays within the record
  int harmonic = 0;           ///< of the swing's own frequency, as harmonic_of says
  bool among_others = false;  ///< the spectrum has a peak 1/0.8 times as large that is no line
};

/// Lines of the residuals' spectrum, the strongest first, at most three: each stands six times above its
/// surroundings, carries a twentieth of the residuals' power and is no skirt of the swing's own line. What
/// lies closer to that than four over the record's length (in cycles) is not told from it.
std::vector<ResidualLine> residual_lines(const Record& record, const LawFit& fit);

/// The period of the slowest beat of one of the lines with the fitted swing [s]; 0 of none.
double slowest_beat(const std::vector<ResidualLine>& lines, const LawFit& fit);

/// The lines of a fit as notices; `unit` is that of its record, of this derivative of the displacement.
std::vector<Notice> second_modes(const std::vector<ResidualLine>& lines, const LawFit& fit, int derivative,
                                 std::string_view unit);

/// Of what a driven law leaves: lines beside the drive, at `drive` [rad/s] where it is one frequency (else
/// 0), and what they may be. `residuals` with their times and the record's resolution; none in the band
/// `left_out`.
std::vector<Notice> second_drives(const Record& residuals, double drive, std::string_view unit,
                                  const FrequencyBand& left_out = no_band);

}  // namespace cromer::core
