// Quantiles of some values.
#pragma once

#include <span>
#include <vector>

namespace cromer::core {

/// The value that this share of the values is below, 0 <= share < 1: of n sorted values the one at place
/// share n, counted from 0. May reorder the values. There must be at least one, and no NaN among them.
double quantile(std::span<double> values, double share);

/// The middle value; of an even number of values the upper of the two in the middle. As quantile().
double upper_median(std::span<double> values);

/// The middle value, or the mean of the two in the middle; NaN of nothing. Takes a copy on purpose.
double median(std::vector<double> values);

}  // namespace cromer::core
