// A recorded force as a part of the acceleration, with its derivatives: what it did between its samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/motion/motion.h"
#include "cromer/identify/record.h"
#include "cromer/model/between_samples.h"

namespace cromer::core {

/// gain (u + offset): columns of the gain and the offset. Works through the record block by block: memory
/// does not grow with it.
class RecordedColumns {
 public:
  static constexpr int count = 2;

  /// Each interval between samples is cut into `steps` > 0 steps of a method with stages at their ends and
  /// middles. Times are counted from `origin` [s].
  RecordedColumns(const Motion& motion, const ForceRecord& force, double origin, int steps)
      : gain_(motion.force_gain),
        offset_(motion.force_offset),
        force_(force),
        begin_(force.begin - origin),
        nodes_(2 * steps) {}

  /// Makes the interval after sample k ready.
  void prepare(std::size_t k) {
    at_ = k;
    if (force_.between == BetweenSamples::band_limited) {
      if (k < block_ || k >= block_ + block) refine(k);
      node_ = fine_.data() + (k - block_ + margin_) * static_cast<std::size_t>(nodes_);
      return;
    }
    fine_.resize(static_cast<std::size_t>(nodes_) + 1);
    const double here = force_.samples[k];
    const double rise = force_.between == BetweenSamples::hold ? 0 : force_.samples[k + 1] - here;
    for (int j = 0; j <= nodes_; ++j)
      fine_[static_cast<std::size_t>(j)] = here + rise * (static_cast<double>(j) / nodes_);
    node_ = fine_.data();
  }

  /// At s [s] within the prepared interval.
  void add(double s, double& acceleration, double* columns) const {
    const double u = value(s) + offset_;
    acceleration += gain_ * u;
    if (!columns) return;
    columns[0] = u;
    columns[1] = gain_;
  }

 private:
  static constexpr std::size_t block = 1024;  ///< intervals
  static constexpr std::size_t reach = 16;    ///< samples to each side that the series needs

  // At a node its value; in between, where a motion turns, the parabola through the nearest three.
  double value(double s) const {
    const double place = (s - begin_ - static_cast<double>(at_) * force_.spacing) * (nodes_ / force_.spacing);
    const int near = std::clamp(static_cast<int>(std::lround(place)), 0, nodes_);
    const double off = place - near;
    if (std::abs(off) < 1e-6) return node_[near];
    const int middle = std::clamp(near, 1, nodes_ - 1);
    const double u = place - middle;
    const double rise = 0.5 * (node_[middle + 1] - node_[middle - 1]);
    const double bend = 0.5 * (node_[middle + 1] + node_[middle - 1]) - node_[middle];
    return node_[middle] + u * (rise + u * bend);
  }

  void refine(std::size_t k) {
    block_ = k;
    margin_ = std::min(k, reach);
    const std::size_t from = k - margin_, to = std::min(force_.samples.size(), k + block + 1 + reach);
    fine_ = refine_band_limited(force_.samples.subspan(from, to - from), nodes_);
  }

  double gain_, offset_;
  ForceRecord force_;
  double begin_;
  int nodes_;
  std::size_t at_ = 0;
  std::vector<double> fine_;
  const double* node_ = nullptr;
  std::size_t block_ = static_cast<std::size_t>(-1) - block, margin_ = 0;
};

}  // namespace cromer::core
