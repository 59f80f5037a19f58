// A recorded force at the stages of a method: what it did between its samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/model/band_limited.h"

namespace cromer {

/// Straight from sample to sample; each value until the next, as a converter does; or the sinc series through
/// all of them.
enum class ForceBetween { linear, hold, band_limited };

constexpr std::string_view name(ForceBetween between) {
  return between == ForceBetween::linear ? "linear" : between == ForceBetween::hold ? "hold" : "band-limited";
}

/// One parameter: the gain, acceleration per unit of the force. Works through the record block by block:
/// memory does not grow with it.
class RecordedForce {
 public:
  static constexpr int parameters = 1;
  static constexpr int gain = 0;

  /// Samples `spacing` [s] > 0 apart, of which the motion's first coincides with number `first`; each
  /// interval is cut into `steps` > 0 steps of a method with stages at their ends and middles.
  RecordedForce(std::span<const double> samples, double spacing, std::size_t first, ForceBetween between,
                int steps)
      : samples_(samples), first_(first), between_(between), nodes_(2 * steps), per_node_(nodes_ / spacing) {}

  /// Makes interval i of the motion ready, which begins at time t [s] from its first sample; i + 1 < number
  /// of the motion's samples.
  void prepare(std::size_t i, double t, double, int) {
    begin_ = t;
    const std::size_t k = first_ + i;
    if (between_ == ForceBetween::band_limited) {
      if (k < block_ || k >= block_ + block) refine(k);
      node_ = fine_.data() + (k - block_ + margin_) * static_cast<std::size_t>(nodes_);
      return;
    }
    fine_.resize(static_cast<std::size_t>(nodes_) + 1);
    const double here = samples_[k];
    const double rise = between_ == ForceBetween::hold ? 0 : samples_[k + 1] - here;
    for (int j = 0; j <= nodes_; ++j)
      fine_[static_cast<std::size_t>(j)] = here + rise * (static_cast<double>(j) / nodes_);
    node_ = fine_.data();
  }

  void add_to(const Parameters& p, double t, double& acceleration, double* by_parameter) const {
    const double u = node_[static_cast<int>((t - begin_) * per_node_ + 0.5)];
    acceleration += p[gain] * u;
    if (by_parameter) by_parameter[gain] = u;
  }

 private:
  static constexpr std::size_t block = 1024;  ///< intervals
  static constexpr std::size_t reach = 16;    ///< samples to each side that the series needs

  void refine(std::size_t k) {
    block_ = k;
    margin_ = std::min(k, reach);
    const std::size_t from = k - margin_, to = std::min(samples_.size(), k + block + 1 + reach);
    fine_ = refine_band_limited(samples_.subspan(from, to - from), nodes_);
  }

  std::span<const double> samples_;
  std::size_t first_;
  ForceBetween between_;
  int nodes_;
  double per_node_;
  double begin_ = 0;
  std::vector<double> fine_;
  const double* node_ = nullptr;
  std::size_t block_ = static_cast<std::size_t>(-1) - block, margin_ = 0;
};

}  // namespace cromer
