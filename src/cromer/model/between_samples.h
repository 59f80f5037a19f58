// What something recorded did between its samples.
#pragma once

#include <optional>
#include <string_view>

namespace cromer {

/// Straight lines; each value until the next, as a converter does; or the sinc series through all of them.
enum class BetweenSamples { linear, hold, band_limited };

constexpr std::string_view name(BetweenSamples between) {
  return between == BetweenSamples::linear ? "linear"
         : between == BetweenSamples::hold ? "hold"
                                           : "band-limited";
}

/// Nothing of another word.
constexpr std::optional<BetweenSamples> between_samples_of(std::string_view word) {
  for (const BetweenSamples each :
       {BetweenSamples::linear, BetweenSamples::hold, BetweenSamples::band_limited})
    if (word == name(each)) return each;
  return std::nullopt;
}

}  // namespace cromer
