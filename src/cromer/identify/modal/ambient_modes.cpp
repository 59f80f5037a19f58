#include "cromer/identify/modal/ambient_modes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {
namespace {

// What each block of the record adds to a deviation, of which W is the derivative by the correlations.
std::vector<std::complex<double>> block_deviations(const BlockCorrelations& correlations,
                                                   const Eigen::MatrixXcd& gradient) {
  const Eigen::Index r = correlations.channels;
  Eigen::MatrixXcd weight = gradient;
  Eigen::VectorXcd mean(correlations.lags);
  for (Eigen::Index l = 0; l < correlations.lags; ++l) {
    weight.middleCols(l * r, r) /= correlations.count(l);
    mean(l) = weight.middleCols(l * r, r).cwiseProduct(correlations.mean.middleCols(l * r, r)).sum();
  }
  const Eigen::MatrixXd real = weight.real(), imaginary = weight.imag();
  std::vector<std::complex<double>> result;
  for (std::size_t b = 0; b < correlations.sums.size(); ++b) {
    const Eigen::MatrixXd& sum = correlations.sums[b];
    const std::complex<double> expected = (mean.array() * correlations.counts[b].array()).sum();
    result.push_back(std::complex<double>(real.cwiseProduct(sum).sum(), imaginary.cwiseProduct(sum).sum()) -
                     expected);
  }
  return result;
}

// How many neighbouring blocks make one that a motion of this decay rate forgets within.
class Grouping {
 public:
  Grouping(const BlockCorrelations& correlations, double decay_rate) {
    const auto blocks = correlations.sums.size();
    const double lifetimes = decay_rate * correlations.block_length;
    constexpr double enough = 3;
    size_ = static_cast<std::size_t>(
        std::clamp(std::ceil(enough / lifetimes), 1.0, std::max(1.0, static_cast<double>(blocks / 5))));
    groups_ = std::max<std::size_t>(2, blocks / size_);
    // Squares of the motion are correlated as exp(-2 decay_rate t): means over a length c/decay_rate have
    // less than their share of the variance, and so much more has the mean of all.
    const double c = 2 * lifetimes * static_cast<double>(size_);
    widening_ = 1 / std::max(0.1, 1 - (1 - std::exp(-c)) / c);
  }

  double variance(const std::vector<double>& deviations) const {
    std::vector<double> sums(groups_);
    for (std::size_t b = 0; b < deviations.size(); ++b)
      sums[std::min(b / size_, groups_ - 1)] += deviations[b];
    double square = 0, all = 0;
    for (const double each : sums) square += each * each, all += each;
    const auto n = static_cast<double>(groups_);
    return widening_ * (square - all * all / n) * n / (n - 1);
  }
  double student() const { return student_95(static_cast<double>(groups_ - 1)); }

 private:
  std::size_t size_, groups_;
  double widening_;
};

// What each block of the record adds to the deviations of a frequency [Hz] and a damping ratio.
struct PoleDeviations {
  std::vector<double> frequency, damping;
};

// What the poles of one mode at several orders say together, with standard errors.
struct MeanOfPoles {
  double frequency = 0, damping_ratio = 0, frequency_error = 0, damping_error = 0;
  double decay_rate = 0;   // [1/s]
  std::size_t middle = 0;  ///< the pole whose frequency is the median
};

class PoleStatistics {
 public:
  explicit PoleStatistics(const ModeSearch& search)
      : subspace_(search.subspace),
        correlations_(search.correlations),
        all_(search.stable),
        known_(search.stable.poles.size()) {}

  // Each pole weighs as its estimated variance says, and the deviations add up block by block: the pole of
  // the least estimated error alone would have an error that is larger than the estimate. There must be a
  // pole.
  MeanOfPoles mean(std::vector<std::size_t> poles) {
    std::sort(poles.begin(), poles.end(), [&](std::size_t a, std::size_t b) {
      return all_.poles[a].frequency < all_.poles[b].frequency;
    });
    MeanOfPoles mean;
    mean.middle = poles[poles.size() / 2];
    const StabilityPole& middle = all_.poles[mean.middle];
    const Grouping grouping(correlations_, middle.damping_ratio * two_pi * middle.frequency);
    const auto weighted = [&](double StabilityPole::*value, std::vector<double> PoleDeviations::*part) {
      double sum = 0, weights = 0;
      std::vector<double> deviations(correlations_.sums.size());
      for (const std::size_t i : poles) {
        const std::vector<double>& own = of(i).*part;
        const double weight = 1 / std::max(grouping.variance(own), 1e-300);
        weights += weight;
        sum += weight * all_.poles[i].*value;
        for (std::size_t b = 0; b < own.size(); ++b) deviations[b] += weight * own[b];
      }
      return std::pair{sum / weights, std::sqrt(grouping.variance(deviations)) / weights};
    };
    std::tie(mean.frequency, mean.frequency_error) =
        weighted(&StabilityPole::frequency, &PoleDeviations::frequency);
    std::tie(mean.damping_ratio, mean.damping_error) =
        weighted(&StabilityPole::damping_ratio, &PoleDeviations::damping);
    mean.decay_rate = mean.damping_ratio * two_pi * mean.frequency;
    return mean;
  }

  MeasuredMode mode(const MeanOfPoles& mean, double duration) const {
    const Grouping grouping(correlations_, mean.decay_rate);
    MeasuredMode mode;
    const double w = two_pi * mean.frequency;
    mode.eigenvalue = {-mean.decay_rate, w * std::sqrt(1 - mean.damping_ratio * mean.damping_ratio)};
    mode.frequency = make_estimate(mean.frequency, mean.frequency_error, grouping.student());
    mode.damping_ratio = make_estimate(mean.damping_ratio, mean.damping_error, grouping.student());
    mode.lifetimes = mean.decay_rate * duration;
    mode.order = all_.poles[mean.middle].order;
    add_shape(mode, all_.poles[mean.middle], grouping);
    return mode;
  }

 private:
  const PoleDeviations& of(std::size_t i) {
    if (known_[i]) return *known_[i];
    const StabilityPole& pole = all_.poles[i];
    const ModelPoles& model = all_.model(pole.order);
    const std::complex<double> value = model.values(pole.index), rate = std::log(value) / correlations_.step;
    const double size = std::abs(rate);
    PoleDeviations result;
    for (const std::complex<double>& each :
         block_deviations(correlations_, subspace_.value_gradient(model, pole.index))) {
      const std::complex<double> change = each / (value * correlations_.step);
      const double turned = (std::conj(rate) * change).real() / size;
      result.frequency.push_back(turned / two_pi);
      result.damping.push_back((-change.real() + rate.real() * turned / size) / size);
    }
    known_[i] = std::move(result);
    return *known_[i];
  }

  void add_shape(MeasuredMode& mode, const StabilityPole& pole, const Grouping& grouping) const {
    const ModelPoles& model = all_.model(pole.order);
    const auto smaller = [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); };
    const auto reference = static_cast<Eigen::Index>(
        std::max_element(pole.shape.begin(), pole.shape.end(), smaller) - pole.shape.begin());
    for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(pole.shape.size()); ++c) {
      if (c == reference) {
        mode.shape.emplace_back(1);
        mode.shape_error.emplace_back(0);
        continue;
      }
      mode.shape.push_back(pole.shape[static_cast<std::size_t>(c)] /
                           pole.shape[static_cast<std::size_t>(reference)]);
      std::vector<double> real, imaginary;
      for (const auto& each :
           block_deviations(correlations_, subspace_.shape_gradient(model, pole.index, reference, c))) {
        real.push_back(each.real());
        imaginary.push_back(each.imag());
      }
      mode.shape_error.emplace_back(std::sqrt(grouping.variance(real)),
                                    std::sqrt(grouping.variance(imaginary)));
    }
  }

  const Subspace& subspace_;
  const BlockCorrelations& correlations_;
  const Stabilisation& all_;
  std::vector<std::optional<PoleDeviations>> known_;
};

}  // namespace

std::vector<MeasuredMode> ambient_modes(const ModeSearch& search, const ModalSettings& settings,
                                        double duration) {
  const Stabilisation& all = search.stable;
  PoleStatistics statistics(search);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::vector<std::size_t>& group : all.groups) {
    const int first = all.poles[group.front()].order;
    const bool known = std::any_of(group.begin(), group.end(), [&](std::size_t i) {
      if (all.poles[i].order > first + 8) return false;
      const MeanOfPoles pole = statistics.mean({i});
      return pole.frequency_error < 0.01 * pole.frequency && pole.damping_error < 0.6 * pole.damping_ratio;
    });
    if (known) groups.push_back(group);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return all.orders(a) > all.orders(b); });
  if (settings.modes > 0 && groups.size() > static_cast<std::size_t>(settings.modes))
    groups.resize(static_cast<std::size_t>(settings.modes));
  const int together = all.first_common_order(groups);
  std::vector<MeasuredMode> modes;
  for (const auto& group : groups) {
    std::vector<std::size_t> poles;
    for (const std::size_t i : group)
      if (all.poles[i].order >= together && all.poles[i].order <= together + 10) poles.push_back(i);
    modes.push_back(statistics.mode(statistics.mean(poles.empty() ? group : poles), duration));
  }
  std::sort(modes.begin(), modes.end(), [](const MeasuredMode& a, const MeasuredMode& b) {
    return a.frequency.value < b.frequency.value;
  });
  return modes;
}

}  // namespace cromer::core
