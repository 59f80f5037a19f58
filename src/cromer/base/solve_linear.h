// A few linear equations, by Gaussian elimination.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "cromer/base/dual.h"

namespace cromer::core {

/// Solves matrix * y = x by Gaussian elimination with partial pivoting; y takes the place of x.
template <class Real, std::size_t size>
void solve_linear(std::array<std::array<Real, size>, size>& matrix, std::array<Real, size>& x) {
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t pivot = i;
    for (std::size_t row = i + 1; row < size; ++row)
      if (std::abs(value_of(matrix[row][i])) > std::abs(value_of(matrix[pivot][i]))) pivot = row;
    std::swap(matrix[i], matrix[pivot]);
    std::swap(x[i], x[pivot]);
    for (std::size_t row = i + 1; row < size; ++row) {
      const Real factor = matrix[row][i] / matrix[i][i];
      for (std::size_t k = i; k < size; ++k) matrix[row][k] = matrix[row][k] - factor * matrix[i][k];
      x[row] = x[row] - factor * x[i];
    }
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t k = i + 1; k < size; ++k) x[i] = x[i] - matrix[i][k] * x[k];
    x[i] = x[i] / matrix[i][i];
  }
}

}  // namespace cromer::core
