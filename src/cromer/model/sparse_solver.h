// Linear equations whose matrix has few entries, always at the same places: what Newton's iteration for many
// masses solves.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "cromer/base/vector_unknown.h"

namespace cromer::core {

/// A place of a matrix.
struct MatrixPlace {
  std::size_t row = 0, column = 0;
};

/// A has its entries at fixed places; several at one place are added. The order of elimination is found once;
/// where the matrix is that of the last call, its factors are used again. Time and memory grow with the
/// entries of the factors: of chains and trees, with the places.
class SparseSolver final : public BlockSolver {
 public:
  SparseSolver(std::size_t size, std::vector<MatrixPlace> places);
  ~SparseSolver() override;
  SparseSolver(const SparseSolver&) = delete;
  SparseSolver& operator=(const SparseSolver&) = delete;

  /// At most two unknowns a row.
  void solve(std::span<const MatrixBlock> blocks, std::span<Vector> right) override;

 private:
  struct Factors;
  std::size_t size_;
  std::vector<MatrixPlace> places_;
  std::array<std::unique_ptr<Factors>, 2> factors_;  ///< with one and with two unknowns
};

}  // namespace cromer::core
