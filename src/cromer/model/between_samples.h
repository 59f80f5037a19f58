// What something recorded did between its samples.
#pragma once

#include <optional>
#include <string_view>

#include "cromer/drive.h"

namespace cromer::core {

/// Nothing of another word.
constexpr std::optional<BetweenSamples> between_samples_of(std::string_view word) {
  for (const BetweenSamples each :
       {BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited})
    if (word == name(each)) return each;
  return std::nullopt;
}

}  // namespace cromer::core
