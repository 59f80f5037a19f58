// From the options of `spectrum` and its files to what is computed.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// Words of the options as values; an Error suggests the nearest right one.
Result<Peaks> peaks_of(const SpectrumOptions& options);

Result<BetweenSamples> between_of(const SpectrumOptions& options);

/// Damping ratios, or loss factors where those are given.
Result<std::vector<double>> damping_ratios_of(const SpectrumOptions& options);

/// The one or two components, sampled alike and equally long; `notices` grows.
Result<std::vector<Component>> read_components(std::span<const SpectrumFile> files,
                                               const SpectrumOptions& options, std::vector<Notice>& notices);

/// The periods asked for, or those of this recording by default. `options` then says which.
Result<std::vector<double>> periods_of(SpectrumOptions& options, const Component& component,
                                       std::size_t damping_ratios);

/// What is doubtful about these periods with this recording.
std::vector<Notice> period_notices(const SpectrumOptions& options, std::span<const double> periods,
                                   const Component& component, Peaks peaks);

}  // namespace cromer::core
