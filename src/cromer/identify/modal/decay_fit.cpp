#include "cromer/identify/modal/decay_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/analysis/fourier.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"

namespace cromer::core {
namespace {

Eigenvalues eigenvalues_of(const Parameters& parameters, std::size_t modes) {
  Eigenvalues result;
  for (std::size_t j = 0; j < modes; ++j) result.emplace_back(-parameters[2 * j + 1], parameters[2 * j]);
  return result;
}

// The power near eigenvalues, and what noise has there that is as strong as at the middle one of the other
// frequencies.
struct PowerNear {
  double all = 0, noise = 0;
};

PowerNear power_near(const Eigen::VectorXd& values, const ModalRecord& record,
                     const Eigenvalues& eigenvalues) {
  const Periodogram spectrum = periodogram(values, record);
  const double resolution = two_pi / (static_cast<double>(values.size()) * record.step);
  PowerNear power;
  std::vector<double> elsewhere;
  for (std::size_t k = 1; k < spectrum.power.size(); ++k) {
    const double w = static_cast<double>(k) * spectrum.step;
    const bool near =
        std::any_of(eigenvalues.begin(), eigenvalues.end(), [&](const std::complex<double>& each) {
          return std::abs(w - each.imag()) < std::max(3 * resolution, 2 * std::abs(each.real()));
        });
    if (near)
      power.all += spectrum.power[k];
    else
      elsewhere.push_back(spectrum.power[k]);
  }
  const auto count = static_cast<double>(spectrum.power.size() - 1 - elsewhere.size());
  // The power of noise is spread as an exponential is, whose median is ln 2 of its mean.
  if (!elsewhere.empty()) power.noise = count * upper_median(elsewhere) / std::numbers::ln2;
  return power;
}

}  // namespace

Eigen::MatrixXd values_of(const ModalRecord& record) {
  Eigen::MatrixXd values(static_cast<Eigen::Index>(record.samples()),
                         static_cast<Eigen::Index>(record.channels.size()));
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    values.col(static_cast<Eigen::Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(record.channels[c].data(), values.rows());
  return values;
}

std::vector<std::vector<double>> without_oscillations(const ModalRecord& record,
                                                      const Eigenvalues& eigenvalues) {
  const DecayBasis basis(record, values_of(record), eigenvalues);
  std::vector<std::vector<double>> rest;
  for (const auto& column : basis.residuals().colwise()) rest.emplace_back(column.begin(), column.end());
  return rest;
}

DecayBasis::DecayBasis(const ModalRecord& record, const Eigen::MatrixXd& values,
                       const Eigenvalues& eigenvalues)
    : eigenvalues_(eigenvalues),
      modes_(static_cast<Eigen::Index>(eigenvalues.size())),
      times_(values.rows()) {
  const double start = record.time(0);
  for (Eigen::Index i = 0; i < times_.size(); ++i)
    times_(i) = record.time(static_cast<std::size_t>(i)) - start;
  columns_ = columns_at(times_);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns_);
  const Eigen::Index n = columns_.cols();
  orthogonal_ = qr.householderQ() * Eigen::MatrixXd::Identity(columns_.rows(), n);
  triangle_ = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd projected = orthogonal_.transpose() * values;
  residuals_ = values - orthogonal_ * projected;
  amplitudes_ = triangle_.triangularView<Eigen::Upper>().solve(projected);
}

Eigen::MatrixXd DecayBasis::columns_at(const Eigen::VectorXd& times) const {
  Eigen::MatrixXd columns(times.size(), 2 * modes_ + 2);
  const double duration = times_(times_.size() - 1);
  for (Eigen::Index j = 0; j < modes_; ++j) {
    const double w = eigenvalues_[static_cast<std::size_t>(j)].imag(),
                 rate = eigenvalues_[static_cast<std::size_t>(j)].real();
    for (Eigen::Index i = 0; i < times.size(); ++i) {
      const double size = std::exp(rate * times(i)), angle = w * times(i);
      columns(i, 2 * j) = size * std::cos(angle);
      columns(i, 2 * j + 1) = size * std::sin(angle);
    }
  }
  columns.col(2 * modes_).setOnes();
  columns.col(2 * modes_ + 1) = times.array() / duration - 0.5;
  return columns;
}

Eigen::MatrixXd DecayBasis::before(const Eigen::VectorXd& seconds) const {
  return columns_at(-seconds) * amplitudes_;
}

Eigen::Index DecayBasis::weakest_mode() const {
  Eigen::Index weakest = 0;
  const auto power = [&](Eigen::Index j) {
    return (columns_.middleCols(2 * j, 2) * amplitudes_.middleRows(2 * j, 2)).squaredNorm();
  };
  for (Eigen::Index j = 1; j < modes_; ++j)
    if (power(j) < power(weakest)) weakest = j;
  return weakest;
}

Eigen::MatrixXd DecayBasis::derivatives(Eigen::Index channel) const {
  Eigen::MatrixXd result(columns_.rows(), 2 * modes_);
  for (Eigen::Index j = 0; j < modes_; ++j) {
    const double p = amplitudes_(2 * j, channel), q = amplitudes_(2 * j + 1, channel);
    result.col(2 * j) = times_.cwiseProduct(q * columns_.col(2 * j) - p * columns_.col(2 * j + 1));
    result.col(2 * j + 1) = -times_.cwiseProduct(p * columns_.col(2 * j) + q * columns_.col(2 * j + 1));
  }
  return result;
}

Eigen::MatrixXd DecayBasis::projected_out(const Eigen::MatrixXd& of) const {
  return of - orthogonal_ * (orthogonal_.transpose() * of);
}

Eigen::MatrixXd DecayBasis::coordinates(const Eigen::MatrixXd& of) const {
  return triangle_.triangularView<Eigen::Upper>().solve(orthogonal_.transpose() * of);
}

Eigen::VectorXd DecayBasis::dual(Eigen::Index k) const {
  Eigen::VectorXd unit = Eigen::VectorXd::Unit(columns_.cols(), k);
  triangle_.triangularView<Eigen::Upper>().transpose().solveInPlace(unit);
  return orthogonal_ * unit;
}

PowerAbout power_about(const DecayBasis& basis, const Eigen::MatrixXd& values, const ModalRecord& record,
                       const Eigenvalues& about) {
  const DecayBasis line(record, values, {});
  PowerAbout power;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const Eigen::VectorXd motion = line.residuals().col(c);
    const double scale = motion.squaredNorm();
    if (!(scale > 0)) continue;
    const PowerNear left = power_near(basis.residuals().col(c), record, about);
    power.all += power_near(motion, record, about).all / scale;
    power.left += left.all / scale;
    power.noise += left.noise / scale;
  }
  return power;
}

std::optional<Eigenvalues> fit_eigenvalues(const ModalRecord& record, const Eigen::MatrixXd& values,
                                           const Eigenvalues& start) {
  const auto size = static_cast<int>(2 * start.size());
  Parameters parameters{};
  for (std::size_t j = 0; j < start.size(); ++j) {
    parameters[2 * j] = start[j].imag();
    parameters[2 * j + 1] = -start[j].real();
  }
  LeastSquaresOptions options;
  options.scale = values.norm();
  options.residuals = static_cast<int>(std::min<Eigen::Index>(values.size(), 1'000'000'000));
  const auto model = [&](const Parameters& at) {
    NormalEquations equations;
    equations.size = size;
    const DecayBasis basis(record, values, eigenvalues_of(at, start.size()));
    equations.sum_of_squares = basis.residuals().squaredNorm();
    for (Eigen::Index c = 0; c < values.cols(); ++c) {
      const Eigen::MatrixXd jacobian = basis.projected_out(basis.derivatives(c));
      const Eigen::MatrixXd matrix = jacobian.transpose() * jacobian;
      const Eigen::VectorXd right = jacobian.transpose() * basis.residuals().col(c);
      for (int i = 0; i < size; ++i) {
        equations.right[i] += right(i);
        for (int k = 0; k < size; ++k) equations.matrix[i][k] += matrix(i, k);
      }
    }
    return equations;
  };
  const LeastSquaresSummary summary = minimise(model, parameters, options);
  if (summary.reason != LeastSquaresReason::converged) return std::nullopt;
  Eigenvalues found = eigenvalues_of(summary.parameters, start.size());
  // The conjugate is the same motion, and at even times so is what lies above half the rate; at others none
  // was looked for there.
  for (std::complex<double>& each : found) {
    const double below = std::abs(std::remainder(each.imag(), two_pi / record.step));
    if (!record.times.empty() && std::abs(each.imag()) > two_pi / (2 * record.step)) return std::nullopt;
    each.imag(record.times.empty() ? below : std::abs(each.imag()));
  }
  return found;
}

Periodogram periodogram(const Eigen::MatrixXd& values, const ModalRecord& record, std::size_t padding) {
  const std::vector<std::size_t> places = places_with_short_gaps(record);
  const std::size_t padded = power_of_two(static_cast<double>(padding * (places.back() + 1)));
  Periodogram result{two_pi / (static_cast<double>(padded) * record.step),
                     std::vector<double>(padded / 2 + 1)};
  std::vector<std::complex<double>> transformed;
  for (const auto& column : values.colwise()) {
    std::vector<double> y(padded, 0.0);
    for (std::size_t i = 0; i < places.size(); ++i) y[places[i]] = column(static_cast<Eigen::Index>(i));
    fourier_transform(y, transformed);
    for (std::size_t k = 0; k < transformed.size(); ++k) result.power[k] += std::norm(transformed[k]);
  }
  return result;
}

}  // namespace cromer::core
