// Samples that are not the motion's: a sensor's spikes, which stand out alone from what a law leaves, and
// drop-outs, flat runs far outside the motion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "cromer/identify/record.h"

namespace cromer::core {

/// Indices, increasing, of samples whose residuals stand out from all of them and from the ten on either
/// side: by more than sqrt(2 ln 5n) robust standard deviations, at least 4, so that normal noise has one in
/// ten records or fewer. What a wrong law leaves is smooth and does not stand out. None where they are more
/// than a tenth of all: those are no outliers. Scale: median absolute deviation (Rousseeuw & Croux, J. Am.
/// Stat. Assoc. 88, 1273 (1993)). `residuals` are the record's, or empty.
std::vector<std::size_t> outliers(const Record& record, std::span<const double> residuals);

/// A record's samples without some of them. The first one, where the motion begins, keeps its place in any
/// case, with the value of the fit that it is an outlier from; its own where that fit failed (no residuals).
struct KeptSamples {
  std::vector<double> t, y;

  KeptSamples(const Record& record, const std::vector<std::size_t>& without,
              std::span<const double> residuals);
  Record record() const {
    Record kept = like_;
    kept.t = t;
    kept.y = y;
    return kept;
  }

 private:
  Record like_;
};

/// The samples that a fit to all others sets aside, and that fit. `fit(record)` gives a result,
/// `residuals_of(result, record)` the whole record's residuals from it, empty where there are none.
template <class Result>
struct WithoutOutliers {
  Result result;
  std::vector<std::size_t> aside;
  std::vector<double> residuals;  ///< of the whole record, from the result
};

/// From a result without some samples: sets aside the outliers from it and fits the rest, until no sample
/// changes sides (five times at most), or the same ones do again.
template <class Result, class Fit, class ResidualsOf>
WithoutOutliers<Result> settle_outliers(const Record& record, Result result, std::vector<std::size_t> aside,
                                        const Fit& fit, const ResidualsOf& residuals_of) {
  std::vector<std::vector<std::size_t>> seen{aside};
  std::vector<double> residuals = residuals_of(result, record);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::size_t> found = outliers(record, residuals);
    if (std::find(seen.begin(), seen.end(), found) != seen.end()) break;
    seen.push_back(found);
    aside = std::move(found);
    result = fit(KeptSamples(record, aside, residuals).record());
    residuals = residuals_of(result, record);
  }
  return {std::move(result), std::move(aside), std::move(residuals)};
}

/// Indices, increasing, of runs of three equal values or more that lie outside the band of the motion (5 % to
/// 95 % of the values, widened by its own width) and are reached and left by a jump that the motion
/// does not make. None where they are more than a tenth of all: that is no drop-out.
std::vector<std::size_t> drop_outs(const Record& record);

}  // namespace cromer::core
