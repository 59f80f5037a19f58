#include "cromer/analysis/complex_modes.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

namespace cromer::core {
namespace {

using Shape = std::vector<std::complex<double>>;

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

void scale_to_largest(Shape& shape) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < shape.size(); ++i)
    // Of two as large the first: rounding must not choose.
    if (std::abs(shape[i]) > std::abs(shape[largest]) * (1 + 1e-9)) largest = i;
  const std::complex<double> unit = shape[largest];
  for (auto& each : shape) each /= unit;
  shape[largest] = 1;
}

/// The roots of z^2 + 2 b z + s.
ComplexMode mode_of(double b, double s, Shape shape) {
  const double discriminant = b * b - s;
  if (discriminant < 0) {
    const double swing = std::sqrt(-discriminant);
    return {{-b, swing}, {-b, -swing}, std::move(shape)};
  }
  const double far = -(b + std::copysign(std::sqrt(discriminant), b));
  return {far, far == 0 ? 0 : s / far, std::move(shape)};
}

struct EigenPair {
  std::complex<double> value;
  Shape shape;
};

/// The eigenvalues with Im >= 0 and the first components of their vectors.
std::vector<EigenPair> eigen_pairs(const Eigen::MatrixXd& matrix, std::size_t components) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solved(matrix);
  std::vector<EigenPair> pairs;
  for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
    if (solved.eigenvalues()[k].imag() < 0) continue;
    EigenPair& pair = pairs.emplace_back(EigenPair{solved.eigenvalues()[k], Shape(components)});
    const Eigen::VectorXcd vector = solved.eigenvectors().col(k);
    for (std::size_t i = 0; i < components; ++i) pair.shape[i] = vector[at(i)];
  }
  return pairs;
}

std::vector<ComplexMode> tied_modes(const LinearNetwork& network) {
  const std::size_t n = network.size;
  // Velocities over a frequency of the network: entries stay comparable.
  double square = 0;
  for (std::size_t i = 0; i < n; ++i)
    square = std::max(square, std::abs(network.stiffness[i * n + i]) / network.mass[i]);
  const double unit = square > 0 ? std::sqrt(square) : 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(at(2 * n), at(2 * n));
  for (std::size_t i = 0; i < n; ++i) {
    matrix(at(i), at(n + i)) = unit;
    for (std::size_t j = 0; j < n; ++j) {
      matrix(at(n + i), at(j)) = -network.stiffness[i * n + j] / network.mass[i] / unit;
      matrix(at(n + i), at(n + j)) = -network.damping[i * n + j] / network.mass[i];
    }
  }
  std::vector<EigenPair> pairs = eigen_pairs(matrix, n);
  double largest = 0;
  for (const EigenPair& pair : pairs) largest = std::max(largest, std::abs(pair.value));
  // A double 0, of a free body, splits by the root of the rounding.
  constexpr double not_told_from_0 = 1e-7;
  std::vector<ComplexMode> modes;
  std::vector<EigenPair> real;
  for (EigenPair& pair : pairs) {
    if (std::abs(pair.value) <= not_told_from_0 * largest) {
      real.push_back({0, pair.shape});
      if (pair.value.imag() > 0) real.push_back({0, std::move(pair.shape)});
    } else if (pair.value.imag() > 0) {
      modes.push_back({pair.value, std::conj(pair.value), std::move(pair.shape)});
    } else {
      real.push_back(std::move(pair));
    }
  }
  // Of those that do not swing, the two with the shapes most alike belong together.
  while (real.size() >= 2) {
    std::size_t one = 0, other = 1;
    double most = -1;
    for (std::size_t i = 0; i < real.size(); ++i)
      for (std::size_t j = i + 1; j < real.size(); ++j)
        if (const double alike = modal_assurance(real[i].shape, real[j].shape); alike > most) {
          most = alike;
          one = i;
          other = j;
        }
    const bool slower = std::abs(real[one].value) < std::abs(real[other].value);
    modes.push_back({real[one].value, real[other].value, real[slower ? one : other].shape});
    real.erase(real.begin() + static_cast<std::ptrdiff_t>(other));
    real.erase(real.begin() + static_cast<std::ptrdiff_t>(one));
  }
  return modes;
}

}  // namespace

double modal_assurance(const Shape& a, const Shape& b) {
  std::complex<double> both = 0;
  double of_a = 0, of_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += std::conj(a[i]) * b[i];
    of_a += std::norm(a[i]);
    of_b += std::norm(b[i]);
  }
  return std::norm(both) / (of_a * of_b);
}

std::vector<ComplexMode> complex_modes(const LinearNetwork& network) {
  const std::size_t n = network.size;
  const UndampedModes natural = undamped_modes(network);
  std::vector<ComplexMode> modes;
  if (const std::vector<double> damping = modal_damping(network, natural); !damping.empty()) {
    const double largest = std::max(std::abs(natural.squares.front()), std::abs(natural.squares.back()));
    for (std::size_t j = 0; j < n; ++j) {
      Shape shape(n);
      for (std::size_t i = 0; i < n; ++i) shape[i] = natural.shapes[i * n + j];
      const double square = natural.squares[j];
      modes.push_back(mode_of(damping[j] / 2, std::abs(square) <= 1e-13 * largest ? 0 : square, shape));
    }
  } else {
    modes = tied_modes(network);
  }
  for (ComplexMode& mode : modes) scale_to_largest(mode.shape);
  std::stable_sort(modes.begin(), modes.end(), [](const ComplexMode& a, const ComplexMode& b) {
    return a.law().stiffness < b.law().stiffness;
  });
  return modes;
}

double participation(const LinearNetwork& network, const ComplexMode& mode) {
  std::complex<double> shared = 0;
  double of_mode = 0, whole = 0;
  for (std::size_t i = 0; i < network.size; ++i) {
    shared += network.mass[i] * mode.shape[i];
    of_mode += network.mass[i] * std::norm(mode.shape[i]);
    whole += network.mass[i];
  }
  return std::norm(shared) / (of_mode * whole);
}

EffectiveNetwork effective_network(
    const std::vector<ComplexMode>& modes, std::size_t parts, double h,
    const std::function<std::vector<double>(const std::vector<double>&)>& image) {
  const std::size_t n = modes.size(), size = parts * n;
  EffectiveNetwork effective{.modes = std::vector<EffectiveOscillator>(n)};
  Eigen::MatrixXd map(at(size), at(size));
  for (std::size_t k = 0; k < size; ++k) {
    std::vector<double> basis(size);
    basis[k] = 1;
    const std::vector<double> moved = image(basis);
    for (std::size_t i = 0; i < size; ++i) map(at(i), at(k)) = moved[i];
  }
  if (!map.allFinite()) {
    effective.spectral_radius = std::numeric_limits<double>::quiet_NaN();
    return effective;
  }
  const std::vector<EigenPair> pairs = eigen_pairs(map, n);
  std::size_t swinging = 0;
  for (const EigenPair& pair : pairs) {
    effective.spectral_radius = std::max(effective.spectral_radius, std::abs(pair.value));
    swinging += pair.value.imag() > 0;
  }

  // The best match of all first. Of eigenvalues alike in shape (a carried acceleration has them too) the one
  // nearest to the mode's own, and sooner a large one: what a method carries dies down.
  struct Match {
    double score;
    std::size_t mode, pair;
  };
  std::vector<Match> matches;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (std::size_t j = 0; j < n; ++j) {
      const std::complex<double> z = pairs[k].value;
      const double off =
          std::min(std::abs(z - std::exp(modes[j].first * h)), std::abs(z - std::exp(modes[j].second * h)));
      matches.push_back({modal_assurance(modes[j].shape, pairs[k].shape) -
                             0.25 * (std::min(1.0, off) - std::min(1.0, std::abs(z))),
                         j, k});
    }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.score > b.score; });

  // Each mode takes one that swings, with its conjugate, or two real ones.
  std::vector<std::vector<std::complex<double>>> taken(n);
  std::vector<bool> is_taken(pairs.size());
  std::size_t creeping = 0;
  const std::size_t most_creeping = n - std::min(n, swinging);
  for (const bool begins : {true, false})
    for (const Match& match : matches) {
      std::vector<std::complex<double>>& own = taken[match.mode];
      const std::complex<double> z = pairs[match.pair].value;
      const bool swings = z.imag() > 0;
      if (is_taken[match.pair] || own.size() > 1 || (swings && !own.empty())) continue;
      if (!swings && own.empty() && !(begins && creeping < most_creeping)) continue;
      creeping += !swings && own.empty();
      is_taken[match.pair] = true;
      own.push_back(z);
      if (swings) own.push_back(std::conj(z));
    }
  for (std::size_t j = 0; j < n; ++j) {
    EffectiveOscillator& result = effective.modes[j];
    for (const std::complex<double>& z : taken[j]) {
      result.eigenvalues.push_back({z.real(), z.imag()});
      result.spectral_radius = std::max(result.spectral_radius, std::abs(z));
    }
    if (const std::complex<double> z = taken[j].empty() ? 0 : taken[j].front(); z.imag() > 0) {
      result.decay_rate = -std::log(std::abs(z)) / h;
      result.angular_frequency = std::arg(z) / h;
    }
  }
  return effective;
}

}  // namespace cromer::core
