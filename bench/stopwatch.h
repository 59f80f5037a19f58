// Medians of repeated runs.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "cromer/base/quantile.h"

namespace cromer::core::bench {

/// Times several pieces of work in turn, so that a machine that drifts drifts for all of them, and gives the
/// median of each [s].
template <class Work>
std::vector<double> medians(const std::vector<Work>& works, int rounds) {
  std::vector<std::vector<double>> times(works.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < works.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      works[i]();
      times[i].push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  std::vector<double> result;
  for (auto& t : times) result.push_back(upper_median(t));
  return result;
}

/// The median time of one piece of work [s].
template <class Work>
double median_seconds(const Work& work, int rounds) {
  return medians(std::vector<Work>{work}, rounds).front();
}

}  // namespace cromer::core::bench
