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

/// For `count` unknowns that are vectors; magnitudes are those of the largest component. Inner states, where
/// there are any, arrive by themselves.
template <std::size_t count, class Residual>
NewtonResult<Coupled<Vector>, std::array<Coupled<Vector>, count>> newton_of_pairs(
    const Residual& residual, const std::array<Coupled<Vector>, count>& guess,
    const NewtonScale<Coupled<double>>& scale, const NewtonOptions& options) {
  NewtonArrival<double> first_arrived({scale.motion.first, scale.rounding.first}, options.tolerance);
  NewtonArrival<double> second_arrived({scale.motion.second, scale.rounding.second}, options.tolerance);
  std::array<Coupled<Vector>, count> u = guess;
  bool first_done = false, second_done = guess[0].second.size() == 0;
  for (int i = 1; i <= options.iteration_limit; ++i) {
    std::array<Coupled<VectorUnknown<count>>, count> variables;
    for (std::size_t k = 0; k < count; ++k)
      variables[k] = {VectorUnknown<count>::variable(u[k].first, k),
                      VectorUnknown<count>::variable(u[k].second, k)};
    const std::array<Coupled<VectorUnknown<count>>, count> r = residual(variables);
    std::array<Vector, count> first, second;
    std::array<MatrixBlock, count * count> blocks;
    for (std::size_t p = 0; p < count; ++p) {
      first[p] = r[p].first.value;
      second[p] = r[p].second.value;
      for (std::size_t q = 0; q < count; ++q)
        blocks[p * count + q] = {r[p].first.slope[q], &r[p].first.entries[q], &r[p].second.entries[q]};
    }
    r[0].first.solver->solve(blocks, first, second);
    Coupled<double> moved, root;
    bool finite = true;
    for (std::size_t k = 0; k < count; ++k) {
      u[k].first -= first[k];
      u[k].second -= second[k];
      const Coupled<double> change{magnitude(first[k]), magnitude(second[k])};
      moved = larger(moved, change);
      root = larger(root, magnitude(u[k]));
      finite = finite && std::isfinite(change.first) && std::isfinite(change.second);
    }
    // A comparison with NaN must not pass for a small update.
    if (!finite) continue;
    first_done = first_arrived(moved.first, root.first, first_done);
    second_done = second_done || second_arrived(moved.second, root.second, false);
    if (first_done && second_done) return {u, i, true};
  }
  return {u, options.iteration_limit, false};
}

}  // namespace cromer::core
