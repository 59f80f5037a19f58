// What a sensor's rounding does to a fit, where its noise is too small to blur the steps.
#pragma once

#include <span>
#include <vector>

#include "cromer/identify/record.h"

namespace cromer::core {

/// Expected rounding error (rounded minus exact) of a value with normal noise, in steps of 1:
///   sum over k of (-1)^k sin(2 pi k value) exp(-2 pi² k² noise²) / (pi k).
/// Widrow & Kollár, Quantization Noise (2008), chapter 4. Exact below a noise of 0.05, where no noise is
/// assumed.
double expected_rounding_error(double value, double noise);

/// The fitted motion with the rounding errors that the sensor would make of it: a fit of these values is
/// off by as much as rounding may have moved the record's own fit. The errors repeat with each period, so
/// they do not average out. `residuals` are the record's minus the fit. Empty where the resolution is
/// unknown, or the noise blurs it (rms > 0.6 resolution).
std::vector<double> rounded_motion(const Record& record, std::span<const double> residuals);

}  // namespace cromer::core
