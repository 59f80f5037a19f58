// From the options of `spectrum` and its files to what is computed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cromer/base/grid.h"
#include "cromer/result.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// The value of an option's word; an Error suggests the nearest word.
Result<Peaks> peaks_of(const SpectrumOptions& options);

Result<BetweenSamples> between_of(const SpectrumOptions& options);

/// Damping ratios, or loss factors if those are given.
Result<std::vector<double>> damping_ratios_of(const SpectrumOptions& options);

/// The ductilities asked for; 1 alone if there are none.
Result<std::vector<double>> ductilities_of(const SpectrumOptions& options);

/// Periods [s], or frequencies [rad/s], as asked for, all positive; empty where nothing is asked for.
Result<std::optional<Grid>> grid_of(const SpectrumOptions& options);

/// One file, or two components of one motion, and no more.
Result<void> check_components(const SpectrumOptions& options, std::size_t files);

/// The one or two components, sampled alike and equally long; `notices` grows.
Result<std::vector<Component>> read_components(std::span<const Recording> recordings,
                                               const SpectrumOptions& options, std::vector<Notice>& notices);

/// The periods asked for [s], or the default ones for this recording, which are then written into `options`.
Result<std::vector<double>> periods_of(SpectrumOptions& options, const Component& component,
                                       std::size_t damping_ratios);

/// Notices on periods about which this recording says little.
std::vector<Notice> period_notices(const SpectrumOptions& options, std::span<const double> periods,
                                   const Component& component, Peaks peaks);

}  // namespace cromer::core
