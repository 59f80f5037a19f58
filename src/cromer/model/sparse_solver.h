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

/// Which unknowns there are, and where their matrix has entries. Columns are numbered through: masses first,
/// then inner states.
struct MatrixPattern {
  std::size_t masses = 0, inner = 0;
  std::vector<MatrixPlace> places{};        ///< in the rows of masses
  std::vector<MatrixPlace> inner_places{};  ///< in those of inner states, which begin with 0

  /// Of each mass the group that moves as one, and its share in the group's motion: the equation of a group
  /// is the sum of those of its masses, each times its share. Empty where each moves by itself.
  std::vector<std::size_t> group{};
  std::vector<double> share{};
  std::size_t groups = 0;
};

/// A has its entries at fixed places; several at one place are added. The order of elimination is found once;
/// where the matrix is that of the last call, its factors are used again. Time and memory grow with the
/// entries of the factors: of chains and trees, with the places.
class SparseSolver final : public BlockSolver {
 public:
  explicit SparseSolver(MatrixPattern pattern);
  ~SparseSolver() override;
  SparseSolver(const SparseSolver&) = delete;
  SparseSolver& operator=(const SparseSolver&) = delete;

  const MatrixPattern& pattern() const { return pattern_; }

  /// At most two unknowns a row. Masses of a group have equal right sides and get equal unknowns.
  void solve(std::span<const MatrixBlock> blocks, std::span<Vector> right,
             std::span<Vector> right_inner) override;

 private:
  struct Factors;
  MatrixPattern pattern_;
  std::array<std::unique_ptr<Factors>, 2> factors_;  ///< with one and with two unknowns
};

}  // namespace cromer::core
