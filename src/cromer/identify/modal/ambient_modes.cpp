#include "cromer/identify/modal/ambient_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "cromer/identify/least_squares/uncertainty.h"

namespace cromer::core {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

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

// A pole with the standard errors of its frequency [Hz] and damping ratio.
struct KnownPole {
  std::size_t pole = 0;
  double frequency_error = 0, damping_error = 0;
};

class Knowledge {
 public:
  explicit Knowledge(const ModeSearch& search)
      : subspace_(search.subspace),
        correlations_(search.correlations),
        all_(search.stable),
        known_(search.stable.poles.size()) {}

  const KnownPole& of(std::size_t i) {
    if (known_[i]) return *known_[i];
    const StabilityPole& pole = all_.poles[i];
    const ModelPoles& model = all_.model(pole.order);
    const std::complex<double> value = model.values(pole.index), rate = std::log(value) / correlations_.step;
    const auto deviations = block_deviations(correlations_, subspace_.value_gradient(model, pole.index));
    std::vector<double> frequency, damping;
    const double size = std::abs(rate);
    for (const std::complex<double>& each : deviations) {
      const std::complex<double> change = each / (value * correlations_.step);
      const double turned = (std::conj(rate) * change).real() / size;
      frequency.push_back(turned / two_pi);
      damping.push_back((-change.real() + rate.real() * turned / size) / size);
    }
    const Grouping grouping(correlations_, -rate.real());
    known_[i] = KnownPole{i, std::sqrt(grouping.variance(frequency)), std::sqrt(grouping.variance(damping))};
    return *known_[i];
  }

  // Of a group's poles with orders from `low` to `high`, that whose frequency scatters least.
  std::optional<KnownPole> best(const std::vector<std::size_t>& group, int low, int high) {
    std::optional<KnownPole> result;
    for (const std::size_t i : group) {
      if (all_.poles[i].order < low || all_.poles[i].order > high) continue;
      if (const KnownPole& each = of(i); !result || each.frequency_error < result->frequency_error)
        result = each;
    }
    return result;
  }

  MeasuredMode mode(const KnownPole& known, double duration) const {
    const StabilityPole& pole = all_.poles[known.pole];
    const ModelPoles& model = all_.model(pole.order);
    MeasuredMode mode;
    mode.eigenvalue = std::log(model.values(pole.index)) / correlations_.step;
    const Grouping grouping(correlations_, -mode.eigenvalue.real());
    mode.frequency = make_estimate(pole.frequency, known.frequency_error, grouping.student());
    mode.damping_ratio = make_estimate(pole.damping_ratio, known.damping_error, grouping.student());
    mode.order = pole.order;
    mode.lifetimes = -mode.eigenvalue.real() * duration;
    const auto larger = [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); };
    const auto reference = static_cast<Eigen::Index>(
        std::max_element(pole.shape.begin(), pole.shape.end(), larger) - pole.shape.begin());
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
    return mode;
  }

 private:
  const Subspace& subspace_;
  const BlockCorrelations& correlations_;
  const Stabilisation& all_;
  std::vector<std::optional<KnownPole>> known_;
};

}  // namespace

std::vector<MeasuredMode> ambient_modes(const ModeSearch& search, const ModalSettings& settings,
                                        double duration) {
  const Stabilisation& all = search.stable;
  Knowledge knowledge(search);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::vector<std::size_t>& group : all.groups) {
    const int first = all.poles[group.front()].order;
    const auto known = knowledge.best(group, first, first + 8);
    const StabilityPole& pole = all.poles[known->pole];
    if (known->frequency_error < 0.01 * pole.frequency && known->damping_error < 0.6 * pole.damping_ratio)
      groups.push_back(group);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return all.orders(a) > all.orders(b); });
  if (settings.modes > 0 && groups.size() > static_cast<std::size_t>(settings.modes))
    groups.resize(static_cast<std::size_t>(settings.modes));
  const int together = all.first_common_order(groups);
  std::vector<MeasuredMode> modes;
  for (const auto& group : groups) {
    auto known = knowledge.best(group, together, together + 10);
    if (!known) known = knowledge.best(group, 0, search.highest_order);
    modes.push_back(knowledge.mode(*known, duration));
    modes.back().seen = all.orders(group);
  }
  std::sort(modes.begin(), modes.end(), [](const MeasuredMode& a, const MeasuredMode& b) {
    return a.frequency.value < b.frequency.value;
  });
  return modes;
}

}  // namespace cromer::core
