// Values of a network's links from a record of its free or driven motion.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/model/network.h"
#include "cromer/quantity.h"
#include "cromer/status.h"

namespace cromer::core {

/// A coefficient of a link's law that is sought. Its smooth terms are sums of such, each in proportion to its
/// coefficient.
struct SoughtValue {
  std::size_t link = 0;  ///< its place in the network's list
  double Oscillator<double>::*member = nullptr;
  bool never_negative = false;
};

/// Positions of all masses, in their order, at times [s] that increase strictly; missing values are NaN.
struct NetworkRecord {
  std::span<const double> t;
  std::vector<std::span<const double>> y;  ///< one column for each mass, as long as t
};

/// What was found of a mass, and what is left of its column.
struct FittedColumn {
  Estimate position{}, velocity{};  ///< at the first sample
  Estimate offset{};                ///< what the column reads where the mass rests
  std::vector<double> residual{};   ///< measured less fitted; NaN where missing
  double rms = 0;                   ///< of these
  double explained = 0;             ///< 1 - rms^2/variance of the column
};

/// Half of each column is accounted for, or nine tenths where what is left of it is no noise. Where it is
/// white, half of one column is enough: the others are mostly noise, and the law says all of them that can be
/// said.
bool explains(const std::vector<FittedColumn>& columns);

struct NetworkFit {
  FitStatus status = FitStatus::iteration_limit;
  int iterations = 0;
  bool runs_away = false;          ///< by the values tried the motion does not stay finite
  Network network{};               ///< with the values found, and the start at the first sample
  std::vector<Estimate> values{};  ///< of what was sought, in that order; errors are NaN where unknown
  std::vector<std::size_t> undetermined{};  ///< of these, those that the record does not tell by themselves
  std::vector<FittedColumn> columns{};
  double independent_samples =
      0;  ///< samples of all columns over how much correlated residuals widen the variance
};

/// The most values that can be sought in a network of so many masses; 0: it has too many.
std::size_t most_sought(std::size_t masses);

/// The values that leave the smallest sum of squared residuals, each column weighed by its own noise, along
/// with where each mass starts, how fast, and what its column reads at rest. Start values are not needed: the
/// equations of motion are solved for the coefficients first, in windows that take the derivatives off the
/// record (M. Shinbrot, Trans. ASME 79, 547 (1957)). Then trajectories are fitted, over the beginning first.
/// A fit is accepted that explains half of each column, or nine tenths where what it leaves is no noise. Laws
/// of smooth terms only; at least one value is sought, at most most_sought().
NetworkFit fit_network(const Network& network, const std::vector<SoughtValue>& sought,
                       const NetworkRecord& record, const Watch& watch = {});

}  // namespace cromer::core
