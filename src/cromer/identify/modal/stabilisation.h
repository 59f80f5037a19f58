// Which poles are modes: those that stay, as the model's order grows.
#pragma once

#include <vector>

#include "cromer/identify/modal/subspace.h"

namespace cromer::core {

struct Stabilisation {
  std::vector<ModelPoles> models;  ///< of orders 2, 4, ...
  std::vector<StabilityPole> poles;
  std::vector<std::vector<std::size_t>>
      groups;  ///< indices of the stable and first poles of one mode, by order

  const ModelPoles& model(int order) const { return models[static_cast<std::size_t>(order / 2 - 1)]; }
  /// At how many orders the group is.
  int orders(const std::vector<std::size_t>& group) const;
  /// The lowest order from which on each of these groups has appeared; 0 of none.
  int first_common_order(const std::vector<std::vector<std::size_t>>& some) const;
};

/// Orders 2 to highest_order, even; `subspace` is prepared for them. Of each group there are at least five
/// orders and two fifths of those from its first one on, which is among the lower six tenths. Damping ratios
/// are less than 0.25, frequencies lie between from and to [Hz]. Poles grow by less than `growth` [1/s].
/// `step` [s] between lags.
Stabilisation stabilise(const Subspace& subspace, int highest_order, double step, double from, double to,
                        double growth);

}  // namespace cromer::core
