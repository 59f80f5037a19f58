#include "cromer/base/even_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace cromer::core {

EvenSteps even_steps(std::span<const double> t) {
  const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  // In lanes, as each comparison waits for the one before it.
  constexpr std::size_t lanes = 4;
  double farthest[lanes]{};
  std::size_t i = 1;
  for (; i + lanes <= t.size(); i += lanes)
    for (std::size_t l = 0; l < lanes; ++l)
      farthest[l] = std::max(farthest[l], std::abs(t[i + l] - t[i + l - 1] - mean));
  for (; i < t.size(); ++i) farthest[0] = std::max(farthest[0], std::abs(t[i] - t[i - 1] - mean));
  return {mean, *std::max_element(std::begin(farthest), std::end(farthest))};
}

}  // namespace cromer::core
