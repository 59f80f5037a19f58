// Newton's iteration where the scalar is a vector of many masses: what newton.h finds for it. To be included
// where networks meet methods.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cromer/base/vector_unknown.h"
#include "cromer/methods/newton.h"

namespace cromer::core {

template <std::size_t count>
struct UnknownOf<Coupled<Vector>, count> {
  using Type = Coupled<VectorUnknown<count>>;
};

/// For `count` unknowns that are vectors; sizes are those of the largest component. The second components of
/// the pairs, inner states, stay as they are: there are none yet.
template <std::size_t count, class Residual>
NewtonResult<Coupled<Vector>, std::array<Coupled<Vector>, count>> newton_of_pairs(
    const Residual& residual, const std::array<Coupled<Vector>, count>& guess,
    const NewtonScale<Coupled<double>>& scale, const NewtonOptions& options) {
  NewtonArrival<double> arrived({scale.motion.first, scale.rounding.first}, options.tolerance);
  std::array<Coupled<Vector>, count> u = guess;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    std::array<Coupled<VectorUnknown<count>>, count> variables;
    for (std::size_t k = 0; k < count; ++k)
      variables[k] = {VectorUnknown<count>::variable(u[k].first, k), VectorUnknown<count>(u[k].second)};
    const std::array<Coupled<VectorUnknown<count>>, count> r = residual(variables);
    std::array<Vector, count> update;
    std::array<MatrixBlock, count * count> blocks;
    for (std::size_t p = 0; p < count; ++p) {
      update[p] = r[p].first.value;
      for (std::size_t q = 0; q < count; ++q)
        blocks[p * count + q] = {r[p].first.slope[q], &r[p].first.entries[q]};
    }
    r[0].first.solver->solve(blocks, update);
    double moved = 0, root = 0;
    bool finite = true;
    for (std::size_t k = 0; k < count; ++k) {
      u[k].first -= update[k];
      moved = larger(moved, magnitude(update[k]));
      root = larger(root, magnitude(u[k].first));
      finite = finite && std::isfinite(magnitude(update[k]));
    }
    // A comparison with NaN must not pass for a small update.
    if (finite && arrived(moved, root, false)) return {u, i, true};
  }
  return {u, options.iteration_limit, false};
}

}  // namespace cromer::core
