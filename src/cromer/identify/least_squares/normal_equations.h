// The normal equations of a small least-squares problem, and their solution.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace cromer::core {

/// The most parameters a fit can have.
inline constexpr int max_parameters = 20;

using Parameters = std::array<double, max_parameters>;

/// Which parameters take part in a solution: all.
inline constexpr std::array<bool, max_parameters> all_free = [] {
  std::array<bool, max_parameters> all{};
  all.fill(true);
  return all;
}();

/// JᵀJ and Jᵀr of a model with Jacobian J = d(model)/d(parameter) and residuals r = data - model; the first
/// `size` rows and columns count.
struct NormalEquations {
  int size = 0;
  std::array<Parameters, max_parameters> matrix{};
  Parameters right{};
  double sum_of_squares = 0;  ///< of the residuals

  /// A sample's row of the Jacobian, `size` long, and its residual. With an array, whose length is known when
  /// compiling, several times as fast as with a vector.
  template <class Row>
  void add_row(const Row& row, double residual) {
    for (std::size_t i = 0; i < std::size(row); ++i) {
      right[i] += row[i] * residual;
      for (std::size_t j = 0; j < std::size(row); ++j) matrix[i][j] += row[i] * row[j];
    }
    sum_of_squares += residual * residual;
  }
};

using SquareMatrix = std::array<Parameters, max_parameters>;

/// Cholesky factor of a symmetric matrix that was first scaled to unit diagonal: the parameters' units then
/// do not matter.
class ScaledCholesky {
 public:
  /// Factors matrix + lambda * diagonal over the parameters that are `free`; the others keep a step of zero.
  ScaledCholesky(const SquareMatrix& matrix, int size, double lambda,
                 const std::array<bool, max_parameters>& free)
      : size_(size), free_(free) {
    for (int i = 0; i < size_; ++i) {
      const double diagonal = matrix[i][i];
      if (!free_[i]) continue;
      if (!(diagonal > 0)) return;
      scale_[i] = 1 / std::sqrt(diagonal);
    }
    for (int i = 0; i < size_; ++i) {
      if (!free_[i]) continue;
      for (int j = 0; j <= i; ++j) {
        if (!free_[j]) continue;
        double sum = matrix[i][j] * scale_[i] * scale_[j] + (i == j ? lambda : 0);
        for (int l = 0; l < j; ++l) sum -= factor_[i][l] * factor_[j][l];
        if (i != j) {
          factor_[i][j] = sum / factor_[j][j];
        } else if (sum > 1e-14) {
          factor_[i][i] = std::sqrt(sum);
        } else {
          return;  // a parameter the data say nothing about
        }
      }
    }
    ok_ = true;
  }

  /// False where the matrix is not positive definite to rounding.
  bool ok() const { return ok_; }

  /// The logarithm of the determinant; only when ok() and all are free.
  double log_determinant() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += 2 * std::log(factor_[i][i] / scale_[i]);
    return sum;
  }

  /// The x with matrix * x = right; only when ok().
  Parameters solve(const Parameters& right) const {
    Parameters x{};
    for (int i = 0; i < size_; ++i) {
      if (!free_[i]) continue;
      double sum = right[i] * scale_[i];
      for (int j = 0; j < i; ++j) sum -= factor_[i][j] * x[j];
      x[i] = sum / factor_[i][i];
    }
    for (int i = size_ - 1; i >= 0; --i) {
      if (!free_[i]) continue;
      double sum = x[i];
      for (int j = i + 1; j < size_; ++j) sum -= factor_[j][i] * x[j];
      x[i] = sum / factor_[i][i];
    }
    for (int i = 0; i < size_; ++i) x[i] *= scale_[i];
    return x;
  }

 private:
  int size_;
  std::array<bool, max_parameters> free_;
  Parameters scale_{};
  SquareMatrix factor_{};
  bool ok_ = false;
};

/// The solution of normal equations, and the sum of squares that it leaves if the model is linear; not `ok`
/// where the matrix is singular to rounding.
struct LinearFit {
  bool ok = false;
  Parameters x{};
  double rest = HUGE_VAL;
};

/// Of matrix + lambda * diagonal.
inline LinearFit solve(const NormalEquations& equations, double lambda = 0) {
  const ScaledCholesky factor(equations.matrix, equations.size, lambda, all_free);
  if (!factor.ok()) return {};
  LinearFit fit{true, factor.solve(equations.right), equations.sum_of_squares};
  for (int i = 0; i < equations.size; ++i) fit.rest -= fit.x[i] * equations.right[i];
  return fit;
}

/// Inverse of the first `size` rows and columns; all infinite where the matrix is singular to rounding.
inline SquareMatrix inverse(const SquareMatrix& matrix, int size) {
  const ScaledCholesky factor(matrix, size, 0, all_free);
  SquareMatrix result{};
  for (int j = 0; j < size; ++j) {
    Parameters unit{};
    unit[j] = 1;
    Parameters column{};
    if (factor.ok())
      column = factor.solve(unit);
    else
      column[j] = HUGE_VAL;
    for (int i = 0; i < size; ++i) result[i][j] = column[i];
  }
  return result;
}

}  // namespace cromer::core
