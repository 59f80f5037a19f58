#include "cromer/identify/modal/free_decay.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cromer/analysis/complex_modes.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantile.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/modal/steady_lines.h"

namespace cromer::core {
namespace {

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
                           2 * modes + channels * basis.columns());

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
    mode.frequency = noise.estimate(natural / two_pi, combined(w / natural, ratio) / two_pi);
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

// Those that change their size over the record; all where none does.
Eigenvalues changing_of(const ModalRecord& record, const Eigenvalues& eigenvalues) {
  Eigenvalues result;
  for (const std::complex<double>& each : eigenvalues)
    if (!is_steady(record, each)) result.push_back(each);
  return result.empty() ? eigenvalues : result;
}

// The fit from these start values alone, and what it leaves, each channel over its rms.
struct FitFromStart {
  FreeDecay decay;
  Eigenvalues eigenvalues;
  Eigen::MatrixXd rest;
};

FitFromStart fit_from_start(const ModalRecord& record, Eigenvalues eigenvalues) {
  const Eigen::MatrixXd values = values_of(record);
  const Eigen::VectorXd sizes = DecayBasis(record, values, {}).residuals().colwise().norm();
  FreeDecay result;
  while (!eigenvalues.empty()) {
    Eigen::VectorXd weight = sizes.cwiseInverse();
    for (int round = 0; round < 3; ++round) {
      const auto fitted = fit_eigenvalues(record, values * weight.asDiagonal(), eigenvalues);
      result.converged = fitted.has_value();
      if (!fitted) break;
      eigenvalues = *fitted;
      const DecayBasis basis(record, values, eigenvalues);
      weight = basis.residuals().colwise().norm().transpose().cwiseMax(1e-12 * sizes).cwiseInverse();
      const PowerAbout power = power_about(basis, values, record, changing_of(record, eigenvalues));
      result.share = power.share();
      result.unexplained = power.unexplained();
    }
    if (!result.converged) {
      // The one that moves least is most likely none.
      const DecayBasis basis(record, values * sizes.cwiseInverse().asDiagonal(), eigenvalues);
      eigenvalues.erase(eigenvalues.begin() + basis.weakest_mode());
      continue;
    }
    std::vector<DecayingMode> found = describe_decay(record, values, weight, eigenvalues);
    // What moves stays in the fit, known or not: the others would take its motion for noise.
    constexpr double moves = 4, sure = 6, known = 0.01;
    eigenvalues.clear();
    for (const DecayingMode& each : found)
      if (each.certainty > moves && !is_double(each, found)) eigenvalues.push_back(each.mode.eigenvalue);
    if (eigenvalues.size() < found.size()) continue;
    for (DecayingMode& each : found)
      if (each.certainty > sure && each.mode.frequency.standard_error < known * each.mode.frequency.value)
        result.modes.push_back(std::move(each.mode));
    break;
  }
  std::sort(result.modes.begin(), result.modes.end(), [](const MeasuredMode& a, const MeasuredMode& b) {
    return a.frequency.value < b.frequency.value;
  });
  FitFromStart all{std::move(result), std::move(eigenvalues), {}};
  all.rest = DecayBasis(record, values, all.eigenvalues).residuals();
  const Eigen::VectorXd rms = all.rest.colwise().norm().cwiseMax(1e-300);
  all.rest *= rms.cwiseInverse().asDiagonal();
  return all;
}

// Where the highest peak of the rest stands out, and is no harmonic of another: a start value with the
// damping ratio of the least damped.
std::optional<std::complex<double>> start_in_rest(const ModalRecord& record, const FitFromStart& fit) {
  const Periodogram spectrum = periodogram(fit.rest, record.step);
  const auto highest = std::max_element(spectrum.power.begin() + 1, spectrum.power.end() - 1);
  std::vector<double> sorted = spectrum.power;
  constexpr double stands_out = 30;
  if (*highest < stands_out * upper_median(sorted)) return std::nullopt;
  const double w = static_cast<double>(highest - spectrum.power.begin()) * spectrum.step;
  double damping_ratio = 1;
  for (const std::complex<double>& each : fit.eigenvalues) {
    constexpr double near = 0.02;
    for (const int multiple : {1, 2, 3})
      if (std::abs(w - multiple * each.imag()) < near * w) return std::nullopt;
    damping_ratio = std::min(damping_ratio, std::abs(each.real()) / std::abs(each));
  }
  return std::complex<double>(-damping_ratio * w, w);
}

}  // namespace

FreeDecay fit_free_decay(const ModalRecord& record, Eigenvalues eigenvalues) {
  FitFromStart best = fit_from_start(record, std::move(eigenvalues));
  // A start value may lack where a mode moves little; with more modes than channels it would be a guess.
  while (best.decay.converged &&
         best.eigenvalues.size() < std::min(record.channels.size(), most_decaying_modes)) {
    const auto start = start_in_rest(record, best);
    if (!start) break;
    Eigenvalues more = best.eigenvalues;
    more.push_back(*start);
    FitFromStart next = fit_from_start(record, std::move(more));
    if (!next.decay.converged || next.decay.modes.size() <= best.decay.modes.size()) break;
    best = std::move(next);
  }
  return std::move(best.decay);
}

}  // namespace cromer::core
