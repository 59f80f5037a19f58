// What speaks against a fit that converged: a swing that is not free, or that no law tried describes.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// None where nothing is suspicious. Looked for are an amplitude that rises, one that
/// falls by a few percent at most over twenty periods, a motion of a rounding step or two, what departures.h
/// names, and residuals well above the noise from sample to sample that stand out about the swing's own
/// frequency. `only_law`: no other law was tried. `unit` is the record's.
std::vector<Notice> doubts(const Record& record, const LawFit& fit, bool only_law = false,
                           std::string_view unit = {});

/// The same of a motion that is driven at `drive` [rad/s], or by a recorded force (0): lines that the law
/// leaves, with what they may be, and that no law describes the recording. `residuals` are the record's,
/// `fit` the driven law.
std::vector<Notice> driven_doubts(const Record& record, const LawFit& fit, std::span<const double> residuals,
                                  double drive, bool only_law = false, std::string_view unit = {});

/// More terms may be worth trying: the residuals are above the rounding, and stand out about the swing's
/// frequency or a harmonic drive's, or their first harmonics; under a recorded force, they are not white.
bool something_is_left(const Record& record, const LawFit& fit);

/// What residuals that are correlated have done to the uncertainties; empty where they are white.
Notice widening(const LawFit& fit, std::size_t samples);

}  // namespace cromer::core
