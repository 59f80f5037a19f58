// Samples that stand out alone from what a law leaves: a sensor's spikes.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "cromer/identify/record.h"

namespace cromer {

/// Indices, increasing, of samples whose residuals stand out from all of them and from the ten on either
/// side: by more than sqrt(2 ln 5n) robust standard deviations, at least 4, so that normal noise has one in
/// ten records or fewer. What a wrong law leaves is smooth and does not stand out. None where they are more
/// than a tenth of all: those are no outliers. Scale: median absolute deviation (Rousseeuw & Croux, J. Am.
/// Stat. Assoc. 88, 1273 (1993)). `residuals` are the record's, or empty.
std::vector<std::size_t> outliers(const Record& record, std::span<const double> residuals);

/// A record's samples without some of them. The first one, where the motion begins, keeps its place in any
/// case, with the value of the fit that it is an outlier from.
struct KeptSamples {
  std::vector<double> t, y;

  KeptSamples(const Record& record, const std::vector<std::size_t>& without,
              std::span<const double> residuals);
  Record record() const { return {t, y, resolution_, derivative_}; }

 private:
  double resolution_;
  int derivative_;
};

/// Fits, sets aside the outliers from the fit, and fits the rest, until no sample changes sides (five times
/// at most). `fit(record)` gives a result, `residuals_of(result, record)` the record's residuals from it,
/// empty where there are none. Returns the last result, and the samples that were set aside.
template <class Fit, class ResidualsOf>
auto fit_without_outliers(const Record& record, const Fit& fit, const ResidualsOf& residuals_of) {
  auto result = fit(record);
  std::vector<std::size_t> aside;
  for (int round = 0; round < 5; ++round) {
    const std::vector<double> residuals = residuals_of(result, record);
    std::vector<std::size_t> found = outliers(record, residuals);
    if (found == aside) break;
    aside = std::move(found);
    const KeptSamples kept(record, aside, residuals);
    result = fit(kept.record());
  }
  return std::pair(std::move(result), std::move(aside));
}

}  // namespace cromer
