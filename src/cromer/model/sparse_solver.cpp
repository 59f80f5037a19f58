#include "cromer/model/sparse_solver.h"

#include <Eigen/SparseLU>
#include <limits>

namespace cromer::core {

struct SparseSolver::Factors {
  std::size_t count = 1;  ///< unknowns a row
  Eigen::SparseMatrix<double> matrix;
  std::vector<std::size_t> diagonal;  ///< places among the matrix' values of each block's diagonal
  std::vector<std::size_t> entry;     ///< and of each block's entries
  std::vector<double> values, factored;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> lu;
  Eigen::VectorXd right;

  Factors(std::size_t unknowns, std::size_t size, const std::vector<MatrixPlace>& places) : count(unknowns) {
    const auto index = [&](std::size_t i, std::size_t k) { return static_cast<int>(i * count + k); };
    std::vector<Eigen::Triplet<double>> all;
    const auto for_each = [&](const auto& at) {
      for (std::size_t p = 0; p < count; ++p)
        for (std::size_t q = 0; q < count; ++q) {
          for (std::size_t i = 0; i < size; ++i) at(diagonal, index(i, p), index(i, q));
          for (const MatrixPlace& place : places) at(entry, index(place.row, p), index(place.column, q));
        }
    };
    for_each([&](auto&, int row, int column) { all.emplace_back(row, column, 1.0); });
    const int n = static_cast<int>(size * count);
    matrix.resize(n, n);
    matrix.setFromTriplets(all.begin(), all.end());
    for_each([&](std::vector<std::size_t>& where, int row, int column) {
      where.push_back(static_cast<std::size_t>(&matrix.coeffRef(row, column) - matrix.valuePtr()));
    });
    values.resize(static_cast<std::size_t>(matrix.nonZeros()));
    right.resize(n);
    lu.analyzePattern(matrix);
  }

  void fill(std::span<const MatrixBlock> blocks, std::size_t size, std::size_t places) {
    for (double& value : values) value = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      for (std::size_t i = 0; i < size; ++i) values[diagonal[b * size + i]] += blocks[b].diagonal;
      if (!blocks[b].entries || blocks[b].entries->size() == 0) continue;
      for (std::size_t e = 0; e < places; ++e) values[entry[b * places + e]] += (*blocks[b].entries)[e];
    }
  }

  /// False where the matrix is singular.
  bool factorize() {
    if (values == factored) return lu.info() == Eigen::Success;
    std::copy(values.begin(), values.end(), matrix.valuePtr());
    lu.factorize(matrix);
    factored = values;
    return lu.info() == Eigen::Success;
  }
};

SparseSolver::SparseSolver(std::size_t size, std::vector<MatrixPlace> places)
    : size_(size), places_(std::move(places)) {}
SparseSolver::~SparseSolver() = default;

void SparseSolver::solve(std::span<const MatrixBlock> blocks, std::span<Vector> right) {
  const std::size_t count = right.size();
  for (Vector& each : right)
    if (each.size() == 0) {
      const double number = each[0];
      each = Vector::of_size(size_);
      for (std::size_t i = 0; i < size_; ++i) each[i] = number;
    }
  std::unique_ptr<Factors>& kept = factors_[count - 1];
  if (!kept) kept = std::make_unique<Factors>(count, size_, places_);
  Factors& factors = *kept;
  factors.fill(blocks, size_, places_.size());
  // One or two equations by Cramer's rule, as for a single mass: then the two agree to the last bit.
  if (size_ * count == 1) {
    right[0][0] = right[0][0] / factors.values[0];
    return;
  }
  if (size_ * count == 2) {
    double &r = right[0][0], &s = count == 2 ? right[1][0] : right[0][1];
    const auto& v = factors.values;  // column by column
    const bool full = v.size() == 4;
    const double r0 = v[0], s0 = full ? v[1] : 0, r1 = full ? v[2] : 0, s1 = v.back();
    const double determinant = r0 * s1 - r1 * s0;
    const double first = (r * s1 - r1 * s) / determinant, second = (r0 * s - r * s0) / determinant;
    r = first;
    s = second;
    return;
  }
  const bool good = factors.factorize();
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t k = 0; k < count; ++k)
      factors.right[static_cast<Eigen::Index>(i * count + k)] = right[k][i];
  if (good)
    factors.right = factors.lu.solve(factors.right).eval();
  else
    factors.right.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t k = 0; k < count; ++k)
      right[k][i] = factors.right[static_cast<Eigen::Index>(i * count + k)];
}

}  // namespace cromer::core
