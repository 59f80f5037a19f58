#include "cromer/model/linear_network.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

namespace cromer::core {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using MatrixView = Eigen::Map<const Matrix>;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

MatrixView as_matrix(const std::vector<double>& matrix, std::size_t size) {
  return {matrix.data(), index(size), index(size)};
}

}  // namespace

State<double> slopes_at_rest(const Oscillator<double>& law) {
  using D = Dual<double, 1>;
  const D rest(0.0), moved = D::variable(0.0, 0);
  return {stiffness_at(law, 0), resisting_force<any_terms>(law, law_of(law), rest, moved).derivative[0]};
}

LinearNetwork linearised(const Network& network) {
  LinearNetwork linear;
  linear.size = network.masses.size();
  for (const NetworkMass& mass : network.masses) linear.mass.push_back(mass.mass);
  linear.stiffness.assign(linear.size * linear.size, 0);
  linear.damping = linear.stiffness;
  for (const NetworkLink& link : network.links) {
    const State<double> slopes = slopes_at_rest(link.law);
    const auto add = [&](std::size_t row, std::size_t column, double sign) {
      if (row == ground || column == ground) return;
      linear.stiffness[row * linear.size + column] += sign * slopes.x;
      linear.damping[row * linear.size + column] += sign * slopes.v;
    };
    add(link.from, link.from, 1);
    add(link.to, link.to, 1);
    add(link.from, link.to, -1);
    add(link.to, link.from, -1);
  }
  return linear;
}

UndampedModes undamped_modes(const LinearNetwork& network) {
  const std::size_t n = network.size;
  UndampedModes modes{n, std::vector<double>(n), std::vector<double>(n * n)};
  if (n == 1) {
    modes.squares[0] = network.stiffness[0] / network.mass[0];
    modes.shapes[0] = 1;
    return modes;
  }
  Eigen::VectorXd roots(index(n));
  for (std::size_t i = 0; i < n; ++i) roots[index(i)] = 1 / std::sqrt(network.mass[i]);
  const Matrix scaled = roots.asDiagonal() * as_matrix(network.stiffness, n) * roots.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix> solved(scaled);
  for (std::size_t j = 0; j < n; ++j) {
    const Eigen::VectorXd shape = roots.cwiseProduct(solved.eigenvectors().col(index(j)));
    Eigen::Index largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    for (std::size_t i = 0; i < n; ++i) modes.shapes[i * n + j] = shape[index(i)] / shape[largest];
    modes.squares[j] = solved.eigenvalues()[index(j)];
  }
  return modes;
}

std::vector<double> modal_damping(const LinearNetwork& network, const UndampedModes& modes) {
  constexpr double alike = 1e-13;
  const std::size_t n = network.size;
  const MatrixView shapes = as_matrix(modes.shapes, n);
  const Matrix damping = shapes.transpose() * as_matrix(network.damping, n) * shapes;
  const Eigen::Map<const Eigen::VectorXd> mass(network.mass.data(), index(n));
  const Matrix masses = shapes.transpose() * mass.asDiagonal() * shapes;
  const double rounding = alike * damping.diagonal().cwiseAbs().maxCoeff();
  std::vector<double> result;
  for (Eigen::Index j = 0; j < index(n); ++j) {
    for (Eigen::Index i = 0; i < j; ++i)
      if (std::abs(damping(i, j)) > rounding) return {};
    result.push_back(damping(j, j) / masses(j, j));
  }
  return result;
}

NetworkByModes::NetworkByModes(const Network& network, const UndampedModes& modes,
                               const std::vector<double>& damping)
    : NetworkSystem<>(network), modes_(modes), weights_(modes.shapes) {
  const std::size_t n = modes.size;
  for (std::size_t j = 0; j < n; ++j) {
    double mass = 0;
    for (std::size_t i = 0; i < n; ++i)
      mass += modes.shapes[i * n + j] * (network.masses[i].mass * modes.shapes[i * n + j]);
    for (std::size_t i = 0; i < n; ++i) weights_[i * n + j] *= network.masses[i].mass / mass;
    laws_.push_back({.decay_rate = damping[j] / 2, .stiffness = modes.squares[j]});
  }
  for (std::size_t i = 0; i < n; ++i)
    if (const NetworkMass& mass = network.masses[i]; mass.drive.amplitude != 0)
      drives_.emplace_back(i, force_of(mass.drive, mass.mass));
}

State<MassVector> NetworkByModes::propagate(const MassVector& t0, const MassVector& t,
                                            const State<MassVector>& y0) const {
  const std::size_t n = modes_.size;
  const double from = value_of(t0), to = value_of(t);
  Vector x = Vector::of_size(n), v = x;
  for (std::size_t i = 0; i < n; ++i) x[i] = v[i] = 0;
  for (std::size_t j = 0; j < n; ++j) {
    State<double> q{0, 0};
    for (std::size_t i = 0; i < n; ++i) {
      q.x += weights_[i * n + j] * y0.x.first[i];
      q.v += weights_[i * n + j] * y0.v.first[i];
    }
    // The free motion goes with the first drive.
    LinearLaw<double> law = laws_[j];
    if (drives_.empty()) q = cromer::core::propagate(law, from, to, q);
    State<double> sum{0, 0};
    for (const auto& [mass, force] : drives_) {
      HarmonicForce<double> of_mode = force;
      of_mode.amplitude *= weights_[mass * n + j];
      const State<double> part = of_mode.propagate(law, from, to, q);
      sum = {sum.x + part.x, sum.v + part.v};
      q = {0, 0};
    }
    if (!drives_.empty()) q = sum;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += modes_.shapes[i * n + j] * q.x;
      v[i] += modes_.shapes[i * n + j] * q.v;
    }
  }
  return {{x, 0}, {v, 0}};
}

/// x, v, and of each drive its cosine and sine: z' = matrix z.
struct NetworkByExponential::Step {
  std::size_t masses = 0;
  std::vector<HarmonicForce<double>> drives;
  Eigen::MatrixXd matrix, over_step;
  double length = 0;  // [s] of the step
};

NetworkByExponential::NetworkByExponential(const Network& network)
    : NetworkSystem<>(network), step_(std::make_shared<Step>()) {
  const LinearNetwork linear = linearised(network);
  const std::size_t n = linear.size;
  Step& step = *step_;
  step.masses = n;
  std::vector<std::size_t> driven;
  for (std::size_t i = 0; i < n; ++i)
    if (const NetworkMass& mass = network.masses[i]; mass.drive.amplitude != 0) {
      driven.push_back(i);
      step.drives.push_back(force_of(mass.drive, mass.mass));
    }
  step.matrix = Eigen::MatrixXd::Zero(index(2 * (n + driven.size())), index(2 * (n + driven.size())));
  for (std::size_t i = 0; i < n; ++i) {
    step.matrix(index(i), index(n + i)) = 1;
    for (std::size_t j = 0; j < n; ++j) {
      step.matrix(index(n + i), index(j)) = -linear.stiffness[i * n + j] / linear.mass[i];
      step.matrix(index(n + i), index(n + j)) = -linear.damping[i * n + j] / linear.mass[i];
    }
  }
  for (std::size_t d = 0; d < driven.size(); ++d) {
    const Eigen::Index cosine = index(2 * (n + d)), sine = cosine + 1;
    step.matrix(index(n + driven[d]), cosine) = step.drives[d].amplitude;
    step.matrix(cosine, sine) = -step.drives[d].frequency;
    step.matrix(sine, cosine) = step.drives[d].frequency;
  }
}

State<MassVector> NetworkByExponential::propagate(const MassVector& t0, const MassVector& t,
                                                  const State<MassVector>& y0) const {
  Step& step = *step_;
  const double from = value_of(t0), length = value_of(t) - from;
  // Steps of one length differ by the rounding of their times.
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::abs(value_of(t));
  if (std::abs(length - step.length) > rounding || step.over_step.size() == 0) {
    step.over_step = (step.matrix * length).exp();
    step.length = length;
  }
  const std::size_t n = step.masses;
  Eigen::VectorXd z(step.matrix.rows());
  for (std::size_t i = 0; i < n; ++i) {
    z[index(i)] = y0.x.first[i];
    z[index(n + i)] = y0.v.first[i];
  }
  for (std::size_t d = 0; d < step.drives.size(); ++d) {
    const double angle = step.drives[d].frequency * from + step.drives[d].phase;
    z[index(2 * (n + d))] = std::cos(angle);
    z[index(2 * (n + d)) + 1] = std::sin(angle);
  }
  const Eigen::VectorXd moved = step.over_step.topRows(index(2 * n)) * z;
  Vector x = Vector::of_size(n), v = x;
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = moved[index(i)];
    v[i] = moved[index(n + i)];
  }
  return {{x, 0}, {v, 0}};
}

}  // namespace cromer::core
