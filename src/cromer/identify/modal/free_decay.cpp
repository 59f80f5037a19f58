#include "cromer/identify/modal/free_decay.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "cromer/analysis/complex_modes.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {
namespace {

using Eigenvalues = std::vector<std::complex<double>>;

// The decaying cosines and sines of all modes, and a constant, and the channels as their sums.
class DecayBasis {
 public:
  DecayBasis(const ModalRecord& record, const Eigen::MatrixXd& values, const Eigenvalues& eigenvalues)
      : times_(values.rows()),
        columns_(values.rows(), 2 * static_cast<Eigen::Index>(eigenvalues.size()) + 1) {
    const double start = record.time(0);
    for (Eigen::Index i = 0; i < times_.size(); ++i)
      times_(i) = record.time(static_cast<std::size_t>(i)) - start;
    for (std::size_t j = 0; j < eigenvalues.size(); ++j) {
      const auto column = 2 * static_cast<Eigen::Index>(j);
      const double w = eigenvalues[j].imag(), rate = eigenvalues[j].real();
      for (Eigen::Index i = 0; i < times_.size(); ++i) {
        const double size = std::exp(rate * times_(i)), angle = w * times_(i);
        columns_(i, column) = size * std::cos(angle);
        columns_(i, column + 1) = size * std::sin(angle);
      }
    }
    columns_.rightCols(1).setOnes();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns_);
    const Eigen::Index n = columns_.cols();
    orthogonal_ = qr.householderQ() * Eigen::MatrixXd::Identity(columns_.rows(), n);
    triangle_ = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd projected = orthogonal_.transpose() * values;
    residuals_ = values - orthogonal_ * projected;
    amplitudes_ = triangle_.triangularView<Eigen::Upper>().solve(projected);
  }

  const Eigen::MatrixXd& residuals() const { return residuals_; }
  const Eigen::MatrixXd& orthogonal() const { return orthogonal_; }
  std::complex<double> amplitude(Eigen::Index channel, Eigen::Index mode) const {
    return {amplitudes_(2 * mode, channel), -amplitudes_(2 * mode + 1, channel)};
  }

  Eigen::Index weakest_mode() const {
    Eigen::Index weakest = 0;
    const auto power = [&](Eigen::Index j) {
      return (columns_.middleCols(2 * j, 2) * amplitudes_.middleRows(2 * j, 2)).squaredNorm();
    };
    for (Eigen::Index j = 1; j < columns_.cols() / 2; ++j)
      if (power(j) < power(weakest)) weakest = j;
    return weakest;
  }

  // The derivatives of a channel's motion by each mode's angular frequency and decay rate, its amplitudes
  // held.
  Eigen::MatrixXd derivatives(Eigen::Index channel) const {
    const Eigen::Index modes = columns_.cols() / 2;
    Eigen::MatrixXd result(columns_.rows(), 2 * modes);
    for (Eigen::Index j = 0; j < modes; ++j) {
      const double p = amplitudes_(2 * j, channel), q = amplitudes_(2 * j + 1, channel);
      result.col(2 * j) = times_.cwiseProduct(q * columns_.col(2 * j) - p * columns_.col(2 * j + 1));
      result.col(2 * j + 1) = -times_.cwiseProduct(p * columns_.col(2 * j) + q * columns_.col(2 * j + 1));
    }
    return result;
  }
  Eigen::MatrixXd projected_out(const Eigen::MatrixXd& of) const {
    return of - orthogonal_ * (orthogonal_.transpose() * of);
  }
  // How much of each column there is in a vector, by least squares: a row for each.
  Eigen::MatrixXd coordinates(const Eigen::MatrixXd& of) const {
    return triangle_.triangularView<Eigen::Upper>().solve(orthogonal_.transpose() * of);
  }
  // The sensitivity of column k's coordinate to each sample.
  Eigen::VectorXd dual(Eigen::Index k) const {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(columns_.cols(), k);
    triangle_.triangularView<Eigen::Upper>().transpose().solveInPlace(unit);
    return orthogonal_ * unit;
  }

 private:
  Eigen::VectorXd times_;
  Eigen::MatrixXd columns_, orthogonal_, triangle_, residuals_, amplitudes_;
};

Eigen::MatrixXd values_of(const ModalRecord& record) {
  Eigen::MatrixXd values(static_cast<Eigen::Index>(record.samples()),
                         static_cast<Eigen::Index>(record.channels.size()));
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    values.col(static_cast<Eigen::Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(record.channels[c].data(), values.rows());
  return values;
}

Eigenvalues eigenvalues_of(const Parameters& parameters, std::size_t modes) {
  Eigenvalues result;
  for (std::size_t j = 0; j < modes; ++j) result.emplace_back(-parameters[2 * j + 1], parameters[2 * j]);
  return result;
}

// The power about each eigenvalue, of a column.
double power_near(const Eigen::VectorXd& values, const ModalRecord& record, const Eigenvalues& eigenvalues) {
  std::size_t padded = 8;
  while (padded < static_cast<std::size_t>(values.size())) padded *= 2;
  std::vector<double> column(padded, 0.0);
  std::copy(values.data(), values.data() + values.size(), column.begin());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> transform;
  fft.fwd(transform, column);
  const double resolution = 2 * std::numbers::pi / (static_cast<double>(values.size()) * record.step);
  const double step = 2 * std::numbers::pi / (static_cast<double>(padded) * record.step);
  double power = 0;
  for (std::size_t k = 1; k < transform.size(); ++k) {
    const double w = static_cast<double>(k) * step;
    const bool near =
        std::any_of(eigenvalues.begin(), eigenvalues.end(), [&](const std::complex<double>& each) {
          return std::abs(w - each.imag()) < std::max(3 * resolution, 2 * std::abs(each.real()));
        });
    if (near) power += std::norm(transform[k]);
  }
  return power;
}

double share_of(const DecayBasis& basis, const Eigen::MatrixXd& values, const ModalRecord& record,
                const Eigenvalues& eigenvalues) {
  double all = 0, left = 0;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const Eigen::VectorXd centred = values.col(c).array() - values.col(c).mean();
    const double scale = centred.squaredNorm();
    if (!(scale > 0)) continue;
    all += power_near(centred, record, eigenvalues) / scale;
    left += power_near(basis.residuals().col(c), record, eigenvalues) / scale;
  }
  return all > 0 ? 1 - left / all : 0;
}

LeastSquaresSummary minimise_decay(const ModalRecord& record, const Eigen::MatrixXd& values,
                                   const Eigen::VectorXd& weight, const Eigenvalues& start) {
  const auto size = static_cast<int>(2 * start.size());
  Parameters parameters{};
  for (std::size_t j = 0; j < start.size(); ++j) {
    parameters[2 * j] = start[j].imag();
    parameters[2 * j + 1] = -start[j].real();
  }
  const Eigen::MatrixXd weighted = values * weight.asDiagonal();
  LeastSquaresOptions options;
  options.scale = weighted.norm();
  options.residuals = static_cast<int>(std::min<Eigen::Index>(weighted.size(), 1'000'000'000));
  const auto model = [&](const Parameters& at) {
    NormalEquations equations;
    equations.size = size;
    const DecayBasis basis(record, weighted, eigenvalues_of(at, start.size()));
    equations.sum_of_squares = basis.residuals().squaredNorm();
    for (Eigen::Index c = 0; c < weighted.cols(); ++c) {
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
  return minimise(model, parameters, options);
}

// What noise does to any quantity that is a sum over the samples: the channels follow each other as one
// record, with a gap between that nothing is correlated over.
class ChannelNoise {
 public:
  ChannelNoise(const ModalRecord& record, const Eigen::MatrixXd& residuals, const Eigen::MatrixXd& motion,
               Eigen::Index parameters) {
    std::vector<double> times(record.samples());
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = record.time(i);
    const SampleGrid one = find_grid(times);
    SampleGrid grid{one.step, {}};
    constexpr std::size_t gap = 600;
    std::size_t offset = 0;
    for (Eigen::Index c = 0; c < residuals.cols(); ++c) {
      for (std::size_t i = 0; i < times.size(); ++i) grid.place.push_back(offset + one.at(i));
      offset = grid.place.back() + gap;
    }
    if (residuals.cols() == 1) grid = one;
    const std::span<const double> r(residuals.data(), static_cast<std::size_t>(residuals.size()));
    noise_ = find_noise(grid, r, {motion.data(), static_cast<std::size_t>(motion.size())},
                        autocorrelations(r, grid, first_lags(r.size())));
    const auto n = static_cast<double>(r.size());
    noise_.sum_of_squares *= n / std::max(1.0, n - static_cast<double>(parameters));
  }

  // The estimate of a quantity to which each sample contributes its part.
  Estimate estimate(double value, const Eigen::MatrixXd& parts) const {
    const double square = parts.squaredNorm();
    const Eigen::MatrixXd column = parts / square;
    const EstimateNoise known =
        estimate_noise({column.data(), static_cast<std::size_t>(column.size())}, 1, noise_);
    return make_estimate(value, std::sqrt(known.covariance[0][0]), student_95(known.degrees[0]));
  }

 private:
  Noise noise_;
};

// A mode, and its largest amplitude in standard errors.
struct DecayingMode {
  MeasuredMode mode;
  double certainty = 0;
};

std::vector<DecayingMode> describe_decay(const ModalRecord& record, const Eigen::MatrixXd& values,
                                         const Eigen::VectorXd& weight, const Eigenvalues& eigenvalues) {
  const Eigen::MatrixXd weighted = values * weight.asDiagonal();
  const DecayBasis basis(record, weighted, eigenvalues);
  const auto modes = static_cast<Eigen::Index>(eigenvalues.size());
  const Eigen::Index channels = values.cols(), samples = values.rows();
  const ChannelNoise noise(record, basis.residuals(), weighted - basis.residuals(),
                           2 * modes + channels * (2 * modes + 1));

  // The Jacobian by the eigenvalues, the amplitudes following, channel after channel.
  Eigen::MatrixXd jacobian(samples * channels, 2 * modes);
  std::vector<Eigen::MatrixXd> following;  // d amplitudes / d eigenvalues, of each channel
  for (Eigen::Index c = 0; c < channels; ++c) {
    const Eigen::MatrixXd derivatives = basis.derivatives(c);
    jacobian.middleRows(c * samples, samples) = basis.projected_out(derivatives);
    following.push_back(-basis.coordinates(derivatives));
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(jacobian);
  // Each parameter as a sum over the samples: a column each.
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(2 * modes).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd inverse =
      triangle.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(2 * modes, 2 * modes));
  const Eigen::MatrixXd parts =
      qr.householderQ() * (Eigen::MatrixXd::Identity(jacobian.rows(), 2 * modes) * inverse.transpose());

  const double duration = record.time(record.samples() - 1) - record.time(0);
  std::vector<DecayingMode> result;
  for (Eigen::Index j = 0; j < modes; ++j) {
    const double w = eigenvalues[static_cast<std::size_t>(j)].imag(),
                 rate = -eigenvalues[static_cast<std::size_t>(j)].real();
    const double natural = std::hypot(w, rate), ratio = rate / natural;
    const auto combined = [&](double by_w, double by_rate) -> Eigen::MatrixXd {
      return by_w * parts.col(2 * j) + by_rate * parts.col(2 * j + 1);
    };
    MeasuredMode mode;
    mode.eigenvalue = {-rate, w};
    mode.lifetimes = rate * duration;
    mode.frequency = noise.estimate(natural / (2 * std::numbers::pi),
                                    combined(w / natural, ratio) / (2 * std::numbers::pi));
    mode.damping_ratio =
        noise.estimate(ratio, combined(-ratio * w / (natural * natural), (1 - ratio * ratio) / natural));

    Eigen::Index reference = 0;
    const auto own = [&](Eigen::Index c) { return basis.amplitude(c, j) / weight(c); };
    for (Eigen::Index c = 1; c < channels; ++c)
      if (std::abs(own(c)) > std::abs(own(reference))) reference = c;
    // What each sample contributes to the complex amplitude of a channel.
    const auto contributions = [&](Eigen::Index c) {
      Eigen::MatrixXcd sum(samples * channels, 1);
      const Eigen::RowVectorXd cosine = following[static_cast<std::size_t>(c)].row(2 * j),
                               sine = following[static_cast<std::size_t>(c)].row(2 * j + 1);
      sum.real() = parts * cosine.transpose();
      sum.imag() = -(parts * sine.transpose());
      sum.block(c * samples, 0, samples, 1).real() += basis.dual(2 * j);
      sum.block(c * samples, 0, samples, 1).imag() -= basis.dual(2 * j + 1);
      return Eigen::MatrixXcd(sum / weight(c));
    };
    const Eigen::MatrixXcd of_reference = contributions(reference);
    const std::complex<double> largest = own(reference);
    const Eigen::MatrixXd along = (std::conj(largest) / std::abs(largest) * of_reference).real();
    const double certainty = std::abs(largest) / noise.estimate(std::abs(largest), along).standard_error;
    for (Eigen::Index c = 0; c < channels; ++c) {
      const std::complex<double> component = own(c) / own(reference);
      mode.shape.push_back(component);
      if (c == reference) {
        mode.shape_error.emplace_back(0);
        continue;
      }
      const Eigen::MatrixXcd each = (contributions(c) - component * of_reference) / own(reference);
      mode.shape_error.emplace_back(noise.estimate(component.real(), each.real()).standard_error,
                                    noise.estimate(component.imag(), each.imag()).standard_error);
    }
    result.push_back({std::move(mode), certainty});
  }
  return result;
}

// One swing whose frequency or damping changes with its amplitude looks like two on top of each other.
bool is_double(const DecayingMode& mode, const std::vector<DecayingMode>& all) {
  return std::any_of(all.begin(), all.end(), [&](const DecayingMode& other) {
    const double width = std::abs(mode.mode.eigenvalue.real()) + std::abs(other.mode.eigenvalue.real());
    return other.certainty > mode.certainty &&
           std::abs(other.mode.eigenvalue.imag() - mode.mode.eigenvalue.imag()) < width / 2 &&
           modal_assurance(mode.mode.shape, other.mode.shape) > 0.9;
  });
}

}  // namespace

double decaying_share(const ModalRecord& record, const std::vector<std::complex<double>>& eigenvalues) {
  const Eigen::MatrixXd values = values_of(record);
  return share_of(DecayBasis(record, values, eigenvalues), values, record, eigenvalues);
}

FreeDecay fit_free_decay(const ModalRecord& record, std::vector<std::complex<double>> eigenvalues) {
  const Eigen::MatrixXd values = values_of(record);
  const Eigen::VectorXd sizes = (values.rowwise() - values.colwise().mean()).colwise().norm();
  const auto n = static_cast<double>(values.rows());
  FreeDecay result;
  while (!eigenvalues.empty()) {
    Eigen::VectorXd weight = sizes.cwiseInverse();
    for (int round = 0; round < 3; ++round) {
      const LeastSquaresSummary summary = minimise_decay(record, values, weight, eigenvalues);
      result.converged = summary.reason == LeastSquaresReason::converged;
      if (!result.converged) break;
      eigenvalues = eigenvalues_of(summary.parameters, eigenvalues.size());
      const DecayBasis basis(record, values, eigenvalues);
      result.residual_rms.clear();
      for (Eigen::Index c = 0; c < values.cols(); ++c) {
        result.residual_rms.push_back(basis.residuals().col(c).norm() / std::sqrt(n));
        weight(c) = 1 / std::max(result.residual_rms.back(), 1e-12 * sizes(c));
      }
      result.share = share_of(basis, values, record, eigenvalues);
    }
    if (!result.converged) {
      // The one that moves least is most likely none.
      const DecayBasis basis(record, values * sizes.cwiseInverse().asDiagonal(), eigenvalues);
      eigenvalues.erase(eigenvalues.begin() + static_cast<std::ptrdiff_t>(basis.weakest_mode()));
      continue;
    }
    std::vector<DecayingMode> found = describe_decay(record, values, weight, eigenvalues);
    eigenvalues.clear();
    result.modes.clear();
    std::vector<bool> doubles;
    for (const DecayingMode& each : found) doubles.push_back(is_double(each, found));
    for (std::size_t j = 0; j < found.size(); ++j) {
      DecayingMode& each = found[j];
      const bool known = each.mode.frequency.standard_error < 0.01 * each.mode.frequency.value;
      if (!(each.certainty > 6 && known) || doubles[j]) continue;
      eigenvalues.push_back(each.mode.eigenvalue);
      result.modes.push_back(std::move(each.mode));
    }
    if (result.modes.size() == found.size()) break;
    result.modes.clear();
  }
  std::sort(result.modes.begin(), result.modes.end(), [](const MeasuredMode& a, const MeasuredMode& b) {
    return a.frequency.value < b.frequency.value;
  });
  return result;
}

}  // namespace cromer::core
