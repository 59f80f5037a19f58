// The slow part of a recording that is no motion.
#pragma once

#include <span>
#include <vector>

namespace cromer::core {

/// The polynomial of this degree (0 or more, below the number of samples) that is nearest to the samples in
/// the sense of least squares, at each of them.
std::vector<double> least_squares_polynomial(std::span<const double> samples, int degree);

}  // namespace cromer::core
