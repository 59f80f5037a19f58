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

// What the fit leaves about a mode beyond the noise there: another force acts, or the law is not linear.
struct LeftAbout {
  double energy = 0;          // the squares of it; 0 where no more than noise is left
  double times_noise = 1;     // in amplitude
  double degrees = HUGE_VAL;  // of freedom that it has left
};

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

  // Estimates of quantities: what each sample contributes to one stands in its column. `more` is what else
  // their variances have, with so many degrees of freedom.
  std::vector<Estimate> estimates(const std::vector<double>& values, const Eigen::MatrixXd& parts,
                                  const std::vector<double>& more, double degrees) const {
    const SumNoise known = of_sums(parts, true);
    std::vector<Estimate> result;
    for (std::size_t i = 0; i < values.size(); ++i)
      result.push_back(make_estimate(values[i], std::sqrt(known.variance[i] + more[i]),
                                     student_95(std::min(known.degrees[i], degrees))));
    return result;
  }
  std::vector<double> standard_errors(const Eigen::MatrixXd& parts) const {
    std::vector<double> result;
    for (Eigen::Index first = 0; first < parts.cols(); first += max_parameters) {
      const Eigen::Index columns = std::min<Eigen::Index>(max_parameters, parts.cols() - first);
      const SumNoise known = of_sums(parts.middleCols(first, columns), false);
      for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i)
        result.push_back(std::sqrt(known.variance[i]));
    }
    return result;
  }

 private:
  SumNoise of_sums(const Eigen::MatrixXd& parts, bool with_degrees) const {
    const Eigen::MatrixXd rows = parts.transpose();
    return noise_of_sums({rows.data(), static_cast<std::size_t>(rows.size())}, static_cast<int>(parts.cols()),
                         noise_, with_degrees);
  }

  Noise noise_;
};

// What least squares tell of eigenvalues: how sure each is, and each as a mode with its errors, which take
// much longer.
class DecayEstimates {
 public:
  DecayEstimates(const ModalRecord& record, const Eigen::MatrixXd& values, const Eigen::VectorXd& weight,
                 const Eigenvalues& eigenvalues)
      : eigenvalues_(eigenvalues),
        weight_(weight),
        basis_(record, values * weight.asDiagonal(), eigenvalues),
        noise_(record, basis_.residuals(), values * weight.asDiagonal() - basis_.residuals(),
               2 * modes() + values.cols() * basis_.columns()),
        duration_(record.time(record.samples() - 1) - record.time(0)) {
    for (Eigen::Index c = 0; c < channels(); ++c) {
      const double rms = basis_.residuals().col(c).norm() / std::sqrt(static_cast<double>(values.rows()));
      if (!is_arithmetic(rms / weight(c), {&values(0, c), static_cast<std::size_t>(values.rows())}))
        left_.push_back(periodogram(basis_.residuals().middleCols(c, 1), record));
    }
    // The Jacobian by the eigenvalues, the amplitudes following, channel after channel.
    const Eigen::Index samples = values.rows();
    Eigen::MatrixXd jacobian(samples * channels(), 2 * modes());
    for (Eigen::Index c = 0; c < channels(); ++c) {
      const Eigen::MatrixXd derivatives = basis_.derivatives(c);
      jacobian.middleRows(c * samples, samples) = basis_.projected_out(derivatives);
      following_.push_back(-basis_.coordinates(derivatives));
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(jacobian);
    triangle_ = qr.matrixQR().topRows(2 * modes()).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd inverse =
        triangle_.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(2 * modes(), 2 * modes()));
    parts_ =
        qr.householderQ() * (Eigen::MatrixXd::Identity(jacobian.rows(), 2 * modes()) * inverse.transpose());
    Eigen::MatrixXd along(parts_.rows(), modes());
    for (Eigen::Index j = 0; j < modes(); ++j) {
      const std::complex<double> largest = own(reference_of(j), j);
      along.col(j) = (std::conj(largest) / std::abs(largest) * contributions(reference_of(j), j)).real();
    }
    errors_ = noise_.standard_errors(along);
  }

  // A mode's largest amplitude in standard errors.
  double certainty(std::size_t mode) const {
    const auto j = static_cast<Eigen::Index>(mode);
    return std::abs(own(reference_of(j), j)) / errors_[mode];
  }

  // One swing whose frequency or damping changes with its amplitude looks like two on top of each other.
  bool is_double(std::size_t mode) const {
    const auto shape = [&](std::size_t of) { return shape_of(static_cast<Eigen::Index>(of)); };
    for (std::size_t other = 0; other < eigenvalues_.size(); ++other) {
      const std::complex<double> difference = eigenvalues_[other] - eigenvalues_[mode];
      const double width = std::abs(eigenvalues_[mode].real()) + std::abs(eigenvalues_[other].real());
      if (certainty(other) > certainty(mode) && std::abs(difference.imag()) < width / 2 &&
          modal_assurance(shape(mode), shape(other)) > 0.9)
        return true;
    }
    return false;
  }

  // What noise makes of |eigenvalue| [1/s].
  double frequency_error(std::size_t mode) const {
    return noise_.standard_errors(frequency_parts(static_cast<Eigen::Index>(mode)))[0];
  }

  MeasuredMode described(std::size_t mode) const {
    const auto j = static_cast<Eigen::Index>(mode);
    const double w = eigenvalues_[mode].imag(), rate = -eigenvalues_[mode].real();
    const double natural = std::hypot(w, rate), ratio = rate / natural;
    MeasuredMode result{};
    result.eigenvalue = {-rate, w};
    result.lifetimes = rate * duration_;
    result.shape = shape_of(j);

    // Frequency and damping ratio, then the shape.
    const Eigen::Index of_shape = 2 * channels();
    Eigen::MatrixXd parts(parts_.rows(), 2 + of_shape);
    parts.col(0) = frequency_parts(j) / two_pi;
    parts.col(1) = combined(j, -ratio * w / (natural * natural), (1 - ratio * ratio) / natural);
    const Eigen::Index reference = reference_of(j);
    const Eigen::VectorXcd of_reference = contributions(reference, j);
    for (Eigen::Index c = 0; c < channels(); ++c) {
      const std::complex<double> component = result.shape[static_cast<std::size_t>(c)];
      const Eigen::VectorXcd each = (contributions(c, j) - component * of_reference) / own(reference, j);
      parts.col(2 + 2 * c) = each.real();
      parts.col(3 + 2 * c) = each.imag();
    }

    const LeftAbout left = left_about(eigenvalues_[mode]);
    const std::vector<double> more = left.energy > 0
                                         ? pushed(j, parts, left.energy)
                                         : std::vector<double>(static_cast<std::size_t>(parts.cols()), 0.0);
    const std::vector<Estimate> both =
        noise_.estimates({natural / two_pi, ratio}, parts.middleCols(0, 2), more, left.degrees);
    result.frequency = both[0];
    result.damping_ratio = both[1];
    result.times_noise = left.times_noise;
    std::vector<double> errors = noise_.standard_errors(parts.middleCols(2, of_shape));
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = std::hypot(errors[i], std::sqrt(more[2 + i]));
    for (std::size_t c = 0; c < result.shape.size(); ++c)
      result.shape_error.emplace_back(errors[2 * c], errors[2 * c + 1]);
    result.shape_error[static_cast<std::size_t>(reference)] = 0;
    return result;
  }

 private:
  Eigen::Index modes() const { return static_cast<Eigen::Index>(eigenvalues_.size()); }
  Eigen::Index channels() const { return weight_.size(); }
  // The parts of a sum of a mode's angular frequency and decay rate.
  Eigen::VectorXd combined(Eigen::Index mode, double by_w, double by_rate) const {
    return by_w * parts_.col(2 * mode) + by_rate * parts_.col(2 * mode + 1);
  }
  Eigen::VectorXd frequency_parts(Eigen::Index mode) const {
    const std::complex<double> value = eigenvalues_[static_cast<std::size_t>(mode)];
    return combined(mode, value.imag() / std::abs(value), -value.real() / std::abs(value));
  }
  std::complex<double> own(Eigen::Index channel, Eigen::Index mode) const {
    return basis_.amplitude(channel, mode) / weight_(channel);
  }
  // The channel that moves most.
  Eigen::Index reference_of(Eigen::Index mode) const {
    Eigen::Index reference = 0;
    for (Eigen::Index c = 1; c < channels(); ++c)
      if (std::abs(own(c, mode)) > std::abs(own(reference, mode))) reference = c;
    return reference;
  }
  std::vector<std::complex<double>> shape_of(Eigen::Index mode) const {
    std::vector<std::complex<double>> shape;
    for (Eigen::Index c = 0; c < channels(); ++c)
      shape.push_back(own(c, mode) / own(reference_of(mode), mode));
    return shape;
  }
  // What each sample contributes to the complex amplitude of a channel.
  Eigen::VectorXcd contributions(Eigen::Index channel, Eigen::Index mode) const {
    const Eigen::MatrixXd& following = following_[static_cast<std::size_t>(channel)];
    const Eigen::RowVectorXd cosine = following.row(2 * mode), sine = following.row(2 * mode + 1);
    const Eigen::Index samples = parts_.rows() / channels();
    Eigen::VectorXcd sum(parts_.rows());
    sum.real() = parts_ * cosine.transpose();
    sum.imag() = -(parts_ * sine.transpose());
    sum.segment(channel * samples, samples).real() += basis_.dual(2 * mode);
    sum.segment(channel * samples, samples).imag() -= basis_.dual(2 * mode + 1);
    return sum / weight_(channel);
  }
  // The energy about a mode beyond what noise as strong as beside it has there by chance. Of its freedom the
  // fit has taken an amplitude and a phase in each channel, and a frequency and a damping.
  LeftAbout left_about(std::complex<double> mode) const {
    constexpr double widths = 4, by_chance = 2.33;  // standard deviations: one in a hundred
    const double w = mode.imag(), bin = two_pi / duration_;
    const double reach = widths * std::max(bin, std::abs(mode.real()));
    const double from = std::max(w - reach, bin), to = w + reach;
    double degrees = 0, energy = 0, noise = 0;
    for (const Periodogram& left : left_) {
      const auto place = [&](double frequency) {
        return std::min(static_cast<std::size_t>(std::lround(frequency / left.step)), left.power.size() - 1);
      };
      double taken = 0;
      for (const std::complex<double>& each : eigenvalues_)
        if (each.imag() > from && each.imag() < to) taken += 2 + 2 / static_cast<double>(channels());
      const double free = std::max(1.0, 2 * (to - from) / bin - taken);
      std::vector<double> beside(left.power.begin() + static_cast<std::ptrdiff_t>(place(0.5 * w)),
                                 left.power.begin() + static_cast<std::ptrdiff_t>(place(1.5 * w)) + 1);
      // Noise has exponential powers.
      noise += free * upper_median(beside) / std::log(2.0) / static_cast<double>(basis_.residuals().rows());
      for (std::size_t k = place(from); k <= place(to); ++k)
        energy += left.power[k] / static_cast<double>(left.power.size() - 1);
      degrees += free;
    }
    const double at_most = noise * std::max(1.0, chi_squared(degrees, by_chance) / degrees);
    if (!(energy > at_most)) return {};
    return {energy - at_most, std::sqrt(energy / noise), degrees / static_cast<double>(left_.size())};
  }

  // The variances of quantities, whose parts stand in the columns, where a push at an unknown time in this
  // mode has left so much energy: most of what it did the fit has taken for other frequencies and dampings.
  // Three quarters of all times make them no larger.
  std::vector<double> pushed(Eigen::Index mode, const Eigen::MatrixXd& parts, double energy) const {
    constexpr int times = 16;
    const std::complex<double> value = eigenvalues_[static_cast<std::size_t>(mode)];
    const Eigen::Index samples = basis_.residuals().rows();
    Eigen::MatrixXd push(samples, channels());
    // What the push adds to a quantity whose parts stand in the column.
    const auto added = [&](const Eigen::MatrixXd& to, Eigen::Index column) {
      double sum = 0;
      for (Eigen::Index i = 0; i < push.size(); ++i) sum += to(i, column) * push.data()[i];
      return sum;
    };
    std::vector<std::vector<double>> squares(static_cast<std::size_t>(parts.cols()));
    for (int k = 0; k < times; ++k) {
      const double at = duration_ * (k + 0.5) / times;
      double left = 0;
      std::vector<double> moved(squares.size());
      for (const std::complex<double> phase : {std::complex<double>(1), std::complex<double>(0, 1)}) {
        for (Eigen::Index i = 0; i < samples; ++i) {
          const double since = basis_.times()(i) - at;
          const std::complex<double> swing = since > 0 ? phase * std::exp(value * since) : 0;
          for (Eigen::Index c = 0; c < channels(); ++c)
            push(i, c) = (basis_.amplitude(c, mode) * swing).real();
        }
        for (std::size_t i = 0; i < moved.size(); ++i)
          moved[i] += std::pow(added(parts, static_cast<Eigen::Index>(i)), 2);
        std::vector<double> taken;
        for (Eigen::Index i = 0; i < parts_.cols(); ++i) taken.push_back(added(parts_, i));
        left += basis_.projected_out(push).squaredNorm();
        for (Eigen::Index row = 0; row < parts_.cols(); ++row) {
          double sum = 0;
          for (Eigen::Index i = row; i < parts_.cols(); ++i)
            sum += triangle_(row, i) * taken[static_cast<std::size_t>(i)];
          left -= sum * sum;
        }
      }
      for (std::size_t i = 0; i < squares.size(); ++i) squares[i].push_back(energy * moved[i] / left);
    }
    std::vector<double> result;
    for (std::vector<double>& each : squares) result.push_back(quantile(each, 0.75));
    return result;
  }

  const Eigenvalues& eigenvalues_;
  const Eigen::VectorXd& weight_;
  DecayBasis basis_;
  ChannelNoise noise_;
  double duration_;
  std::vector<Periodogram> left_;           // by the fit, of each channel
  std::vector<Eigen::MatrixXd> following_;  // d amplitudes / d eigenvalues, of each channel
  Eigen::MatrixXd triangle_;                // of the Jacobian
  Eigen::MatrixXd parts_;                   // each parameter as a sum over the samples: a column each
  std::vector<double> errors_;              // of each mode's largest amplitude
};

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
    const DecayEstimates found(record, values, weight, eigenvalues);
    // What moves stays in the fit, known or not: the others would take its motion for noise.
    constexpr double moves = 4, sure = 6, known = 0.01;
    Eigenvalues moving;
    for (std::size_t j = 0; j < eigenvalues.size(); ++j)
      if (found.certainty(j) > moves && !found.is_double(j)) moving.push_back(eigenvalues[j]);
    if (moving.size() < eigenvalues.size()) {
      eigenvalues = std::move(moving);
      continue;
    }
    for (std::size_t j = 0; j < eigenvalues.size(); ++j) {
      if (!(found.certainty(j) > sure)) continue;
      if (found.frequency_error(j) > known * std::abs(eigenvalues[j])) continue;
      MeasuredMode mode = found.described(j);
      // What else acts may look like a mode; what is left by chance takes none away.
      if (mode.times_noise < times_noise_told || mode.frequency.standard_error < known * mode.frequency.value)
        result.modes.push_back(std::move(mode));
    }
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
  const Periodogram spectrum = periodogram(fit.rest, record);
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
