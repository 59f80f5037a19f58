// The unknowns of an implicit step of many masses, with their derivatives by themselves: a multiple of the
// unit matrix, and the sparse matrix that the forces add.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "cromer/base/coupled.h"
#include "cromer/base/vector.h"

namespace cromer::core {

/// d I + A; A's entries stand at places that the solver knows, and are none where they have no size. `inner`
/// are those in the rows of inner states.
struct MatrixBlock {
  double diagonal = 0;
  const Vector* entries = nullptr;
  const Vector* inner = nullptr;
};

/// Solves the equations made of count x count blocks, row by row; the solution takes the place of the right
/// sides, those of the masses and those of inner states (without a size where there are none). Of a singular
/// matrix it is not finite.
class BlockSolver {
 public:
  virtual ~BlockSolver() = default;
  virtual void solve(std::span<const MatrixBlock> blocks, std::span<Vector> right,
                     std::span<Vector> right_inner) = 0;
};

/// A vector that depends on `count` vectors of unknowns u: its derivative by u[j] is slope[j] I + entries[j].
/// The system's acceleration makes entries of slopes, and names the solver.
template <std::size_t count>
struct VectorUnknown {
  Vector value{};
  std::array<double, count> slope{};
  std::array<Vector, count> entries{};
  BlockSolver* solver = nullptr;

  VectorUnknown() = default;
  VectorUnknown(Vector constant) : value(std::move(constant)) {}  // NOLINT: a constant has no derivatives
  template <IsScaled A>
  VectorUnknown(A&& constant) : value(std::forward<A>(constant)) {}  // NOLINT

  static VectorUnknown variable(const Vector& value, std::size_t i) {
    VectorUnknown u(value);
    u.slope[i] = 1;
    return u;
  }

  VectorUnknown operator-() const { return -1 * *this; }
  friend VectorUnknown operator+(VectorUnknown a, const VectorUnknown& b) {
    a.value += b.value;
    for (std::size_t j = 0; j < count; ++j) {
      a.slope[j] += b.slope[j];
      a.entries[j] += b.entries[j];
    }
    if (!a.solver) a.solver = b.solver;
    return a;
  }
  friend VectorUnknown operator-(VectorUnknown a, const VectorUnknown& b) {
    a.value -= b.value;
    for (std::size_t j = 0; j < count; ++j) {
      a.slope[j] -= b.slope[j];
      a.entries[j] -= b.entries[j];
    }
    if (!a.solver) a.solver = b.solver;
    return a;
  }
  friend VectorUnknown operator*(double c, VectorUnknown a) {
    a.value = c * std::move(a.value);
    for (std::size_t j = 0; j < count; ++j) {
      a.slope[j] = c * a.slope[j];
      a.entries[j] = c * std::move(a.entries[j]);
    }
    return a;
  }
};

}  // namespace cromer::core
