// Which samples lie between two times.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "cromer/result.h"

namespace cromer::core {

/// From the first up to before the end.
struct SampleRange {
  std::size_t first = 0, end = 0;
};

/// The samples at times t [s], rising, from `from` to `to` [s], both included to a millionth of a step (30 s
/// as typed and as printed by a logger); all where neither is given. `rate` [1/s], 0 if unknown. An Error if
/// there is none.
Result<SampleRange> samples_between(std::span<const double> t, double rate, const std::optional<double>& from,
                                    const std::optional<double>& to);

/// An Error where both are given and none lies between.
Result<void> check_from_before_to(const std::optional<double>& from, const std::optional<double>& to);

}  // namespace cromer::core
