// What a recording shows beside a free swing, by its name: a zero that drifts or jumps, a hand that stops it,
// samples too few to tell its frequency.
#pragma once

#include <span>
#include <string_view>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// The zero drifts, or jumps: a straight line or one step accounts for three tenths of the residuals'
/// variance. Empty where neither does.
Notice wandering_zero(const Record& record, std::span<const double> residuals, std::string_view unit);

/// Share of the residuals' variance that the better of the two accounts for.
double wandering_share(const Record& record, std::span<const double> residuals);

/// From one period to the next the swing ends, a tenth of its amplitude left, and does not come back. Empty
/// where it does not. A law with friction ends nearly so too: where a law describes the record, only what no
/// friction does is said.
Notice sudden_stop(const Record& record, double period, std::string_view unit, bool described);

/// Even samples, fewer than four in a period: which other frequencies would look the same. Else empty.
Notice few_samples(const Record& record, double angular_frequency);

/// An angle [rad] that goes through more than a full turn: the pendulum turns over. Else empty.
Notice turning_over(const Record& record);

/// The residuals stand out about this angular frequency [rad/s], the swing's own or the drive's or a
/// multiple, so many times in power above the median on either side: what noise leaves has no line there,
/// what a wrong law leaves has.
bool leaves_a_line(const Record& record, const LawFit& fit, std::span<const double> residuals,
                   double angular_frequency, double times = 30);

}  // namespace cromer::core
