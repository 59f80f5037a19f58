#include "cromer/model/sparse_solver.h"

#include <Eigen/SparseLU>
#include <limits>

#include "cromer/base/solve_linear.h"

namespace cromer::core {

struct SparseSolver::Factors {
  /// An entry of a block: its place among the matrix' values, and what it is multiplied by.
  struct Entry {
    std::size_t value;
    double factor;
  };

  std::size_t count, size;  ///< unknowns a row, rows
  Eigen::SparseMatrix<double> matrix;
  std::vector<std::size_t> diagonal;  ///< places among the matrix' values of each block's diagonal
  std::vector<Entry> entry, inner;    ///< and of each block's entries
  std::vector<double> values, factored;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> lu;
  Eigen::VectorXd right;

  Factors(std::size_t unknowns, std::size_t rows, const MatrixPattern& pattern)
      : count(unknowns), size(rows) {
    const std::size_t moving = size - pattern.inner;
    const auto place_of = [&](std::size_t column) {
      if (column >= pattern.masses) return moving + (column - pattern.masses);
      return pattern.group.empty() ? column : pattern.group[column];
    };
    const auto index = [&](std::size_t i, std::size_t k) { return static_cast<int>(i * count + k); };
    const auto for_each = [&](const auto& of_diagonal, const auto& of_places, const auto& of_inner) {
      for (std::size_t p = 0; p < count; ++p)
        for (std::size_t q = 0; q < count; ++q) {
          for (std::size_t i = 0; i < size; ++i) of_diagonal(index(i, p), index(i, q));
          for (const MatrixPlace& place : pattern.places)
            of_places(index(place_of(place.row), p), index(place_of(place.column), q),
                      pattern.share.empty() ? 1.0 : pattern.share[place.row]);
          for (const MatrixPlace& place : pattern.inner_places)
            of_inner(index(moving + place.row, p), index(place_of(place.column), q));
        }
    };
    std::vector<Eigen::Triplet<double>> all;
    for_each([&](int row, int column) { all.emplace_back(row, column, 1.0); },
             [&](int row, int column, double) { all.emplace_back(row, column, 1.0); },
             [&](int row, int column) { all.emplace_back(row, column, 1.0); });
    const int n = static_cast<int>(size * count);
    matrix.resize(n, n);
    matrix.setFromTriplets(all.begin(), all.end());
    const auto where = [&](int row, int column) {
      return static_cast<std::size_t>(&matrix.coeffRef(row, column) - matrix.valuePtr());
    };
    for_each([&](int row, int column) { diagonal.push_back(where(row, column)); },
             [&](int row, int column, double factor) {
               entry.push_back({where(row, column), factor});
             },
             [&](int row, int column) {
               inner.push_back({where(row, column), 1.0});
             });
    values.resize(static_cast<std::size_t>(matrix.nonZeros()));
    right.resize(n);
    lu.analyzePattern(matrix);
  }

  void fill(std::span<const MatrixBlock> blocks) {
    for (double& value : values) value = 0;
    const auto add = [&](const Vector* numbers, const std::vector<Entry>& at, std::size_t b) {
      if (!numbers || numbers->size() == 0) return;
      const std::size_t places = at.size() / blocks.size();
      for (std::size_t e = 0; e < places; ++e) {
        const auto& [value, factor] = at[b * places + e];
        values[value] += factor * (*numbers)[e];
      }
    };
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      for (std::size_t i = 0; i < size; ++i) values[diagonal[b * size + i]] += blocks[b].diagonal;
      add(blocks[b].entries, entry, b);
      add(blocks[b].inner, inner, b);
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

  /// A mass with one inner state, by the elimination for a single oscillator: the two agree to the last bit.
  template <std::size_t all>
  void solve_densely() {
    std::array<std::array<double, all>, all> full{};
    std::array<double, all> x{};
    // Here unknown by unknown, there equation by equation.
    const auto place = [&](std::size_t i) { return i % count * size + i / count; };
    std::copy(values.begin(), values.end(), matrix.valuePtr());
    for (int column = 0; column < static_cast<int>(all); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
        full[place(static_cast<std::size_t>(it.row()))][place(static_cast<std::size_t>(column))] = it.value();
    for (std::size_t i = 0; i < all; ++i) x[place(i)] = right[static_cast<Eigen::Index>(i)];
    solve_linear(full, x);
    for (std::size_t i = 0; i < all; ++i) right[static_cast<Eigen::Index>(i)] = x[place(i)];
  }

  /// The solution takes the place of `right`.
  void solve() {
    if (factorize())
      right = lu.solve(right).eval();
    else
      right.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
};

SparseSolver::SparseSolver(MatrixPattern pattern) : pattern_(std::move(pattern)) {}
SparseSolver::~SparseSolver() = default;

void SparseSolver::solve(std::span<const MatrixBlock> blocks, std::span<Vector> right,
                         std::span<Vector> right_inner) {
  const std::size_t count = right.size(), masses = pattern_.masses, inner = pattern_.inner;
  const bool grouped = !pattern_.group.empty();
  const std::size_t moving = grouped ? pattern_.groups : masses, size = moving + inner;
  const auto sized = [](Vector& each, std::size_t numbers) {
    if (each.size() != 0) return;
    const double number = each[0];
    each = Vector::of_size(numbers);
    for (std::size_t i = 0; i < numbers; ++i) each[i] = number;
  };
  for (Vector& each : right) sized(each, masses);
  if (inner > 0)
    for (Vector& each : right_inner) sized(each, inner);

  std::unique_ptr<Factors>& kept = factors_[count - 1];
  if (!kept) kept = std::make_unique<Factors>(count, size, pattern_);
  Factors& factors = *kept;
  factors.fill(blocks);
  // One or two equations by Cramer's rule, as for a single mass: then the two agree to the last bit.
  if (masses * count == 1 && inner == 0 && !grouped) {
    right[0][0] = right[0][0] / factors.values[0];
    return;
  }
  if (masses * count == 2 && inner == 0 && !grouped) {
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
  const auto place = [&](std::size_t i, std::size_t k) { return static_cast<Eigen::Index>(i * count + k); };
  const auto group = [&](std::size_t i) { return grouped ? pattern_.group[i] : i; };
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < masses; ++i) factors.right[place(group(i), k)] = right[k][i];
    for (std::size_t l = 0; l < inner; ++l) factors.right[place(moving + l, k)] = right_inner[k][l];
  }
  if (size == 2 && inner == 1 && count == 1)
    factors.solve_densely<2>();
  else if (size == 2 && inner == 1 && count == 2)
    factors.solve_densely<4>();
  else
    factors.solve();
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < masses; ++i) right[k][i] = factors.right[place(group(i), k)];
    for (std::size_t l = 0; l < inner; ++l) right_inner[k][l] = factors.right[place(moving + l, k)];
  }
}

}  // namespace cromer::core
