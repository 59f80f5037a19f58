#include "cromer/identify/modal/still_beginning.h"

#include <algorithm>
#include <cmath>

#include "cromer/identify/modal/decay_fit.h"

namespace cromer::core {
namespace {

// Variances of a channel's first samples and of the others, for every number of them.
class SplitVariance {
 public:
  explicit SplitVariance(std::span<const double> values)
      : origin_(values.front()), sums_{0}, squares_{0}, steps_{0} {
    double last = 0;
    for (const double value : values) {
      const double y = value - origin_;
      steps_.push_back(steps_.back() + std::pow(y - last, 2));
      last = y;
      sums_.push_back(sums_.back() + y);
      squares_.push_back(squares_.back() + y * y);
    }
  }

  /// Whether the first k vary more from sample to sample than the others, as where a fast mode dies down.
  bool is_rougher_before(std::size_t k) const {
    constexpr double much = 3;
    const auto n = static_cast<double>(k), all = static_cast<double>(sums_.size() - 1);
    return steps_[k] / (n - 1) > much * (steps_.back() - steps_[k]) / (all - n);
  }
  double before(std::size_t k) const { return between(0, k); }
  double after(std::size_t k) const { return between(k, sums_.size() - 1); }
  /// Whether the first k vary no more than from sample to sample: no swing is seen in them.
  bool is_noise_before(std::size_t k) const {
    constexpr double most = 3;
    const auto n = static_cast<double>(k);
    return before(k) <= most * std::max(steps_[k] / (2 * (n - 1)), 1e-12 * squares_.back() / n);
  }
  double mean(std::size_t from, std::size_t to) const {
    return origin_ + (sums_[to] - sums_[from]) / static_cast<double>(to - from);
  }
  /// Whether the mean of the first k moves on by more than noise can: so begins a swing at its turning point.
  bool shifts_within(std::size_t k) const {
    constexpr double most = 2.5;
    const double noise = std::sqrt((between(0, k / 2) + between(k / 2, k)) / 2);
    return std::abs(mean(k / 2, k) - mean(0, k / 2)) > most * noise;
  }

 private:
  double between(std::size_t from, std::size_t to) const {
    const auto n = static_cast<double>(to - from);
    const double mean = (sums_[to] - sums_[from]) / n;
    // Of a channel that stands still only rounding is left.
    return std::max((squares_[to] - squares_[from]) / n - mean * mean, 1e-12 * squares_.back() / n);
  }

  double origin_;
  std::vector<double> sums_, squares_, steps_;  // of the first k; steps: squared, from sample to sample
};

// How far a window of samples departs from the motion after it, followed back.
struct Departure {
  double farthest = 0;  // in standard deviations of the noise
  double share = 0;  // of channels that depart by ten deviations: rms up to the end, over that of the window
  std::size_t end = 0;  // one past the last sample that departs by more than noise
};

// `later` is what follows the first `window` samples of `part`.
Departure departure_before(const ModalRecord& later, const Eigenvalues& eigenvalues, const ModalRecord& part,
                           std::size_t window) {
  constexpr double more_than_noise = 4, far_more_than_noise = 10;
  const DecayBasis basis(later, values_of(later), eigenvalues);
  Eigen::VectorXd seconds(static_cast<Eigen::Index>(window));
  for (std::size_t i = 0; i < window; ++i)
    seconds(static_cast<Eigen::Index>(i)) = part.time(window) - part.time(i);
  const Eigen::MatrixXd off = (basis.before(seconds) - values_of(part).topRows(seconds.size())).array().abs();
  Departure found;
  for (Eigen::Index c = 0; c < off.cols(); ++c) {
    const auto left = basis.residuals().col(c);
    const double noise = left.norm() / std::sqrt(static_cast<double>(left.size()));
    Eigen::Index end = 0;
    for (Eigen::Index i = 0; i < off.rows(); ++i) {
      found.farthest = std::max(found.farthest, off(i, c) / noise);
      if (off(i, c) > more_than_noise * noise) end = i + 1;
    }
    found.end = std::max(found.end, static_cast<std::size_t>(end));
    if (off.col(c).maxCoeff() > far_more_than_noise * noise) {
      const Eigen::ArrayXd own = values_of(part).col(c).head(off.rows());
      const double departure = std::sqrt(off.col(c).head(end).array().square().mean());
      found.share = std::max(found.share, departure / std::sqrt((own - own.mean()).square().mean()));
    }
  }
  return found;
}

// What these modes leave of a record, a column for each channel.
Eigen::MatrixXd left_by(const ModalRecord& record, const std::vector<MeasuredMode>& modes) {
  Eigenvalues eigenvalues;
  for (const MeasuredMode& mode : modes) eigenvalues.push_back(mode.eigenvalue);
  return DecayBasis(record, values_of(record), eigenvalues).residuals();
}

}  // namespace

std::size_t still_samples(const ModalRecord& record) {
  constexpr std::size_t fewest = 8;
  constexpr double quiet = 0.25, louder = 2;
  std::vector<SplitVariance> channels(record.channels.begin(), record.channels.end());
  const auto n = static_cast<double>(record.samples());
  const std::size_t left = std::max(fewest_modal_samples, record.samples() / 10);
  const std::size_t last = std::max(left, record.samples()) - left;
  double whole = 0;
  for (const SplitVariance& channel : channels) whole += n * std::log(channel.before(record.samples()));
  std::size_t best = 0;
  double most = 0;
  for (std::size_t k = fewest; k < last; ++k) {
    bool still = false, swings = false;
    double gain = whole;
    const auto size = static_cast<double>(k);
    for (const SplitVariance& channel : channels) {
      const double before = channel.before(k), after = channel.after(k);
      if (before > louder * after || channel.is_rougher_before(k)) {
        gain = -1;
        break;
      }
      const bool is_quiet = before < quiet * after;
      still = still || is_quiet;
      swings = swings || !(is_quiet || channel.is_noise_before(k));
      gain -= size * std::log(before) + (n - size) * std::log(after);
    }
    if (still && !swings && gain > most) most = gain, best = k;
  }
  if (best == 0 || std::any_of(channels.begin(), channels.end(),
                               [&](const SplitVariance& channel) { return channel.shifts_within(best); }))
    return 0;
  // The variance of a motion that dies away says little about where it begins: it leaves the noise before it.
  constexpr double leaves = 5;
  for (std::size_t i = best; i < last; ++i)
    for (std::size_t c = 0; c < channels.size(); ++c)
      if (std::abs(record.channels[c][i] - channels[c].mean(0, best)) >
          leaves * std::sqrt(channels[c].before(best)))
        return i;
  return best;
}

bool is_still_before(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& modes) {
  const Eigen::MatrixXd values = values_of(record), left = left_by(record, modes),
                        left_after = left_by(from_sample(record, first), modes);
  constexpr double more = 3, mostly = 0.5;
  const auto begin = static_cast<Eigen::Index>(first);
  for (Eigen::Index c = 0; c < left.cols(); ++c) {
    const Eigen::VectorXd before = values.col(c).head(begin);
    const double off = left.col(c).head(begin).norm();
    if (off / std::sqrt(static_cast<double>(begin)) >
            more * left_after.col(c).norm() / std::sqrt(static_cast<double>(left_after.rows())) &&
        off > mostly * (before.array() - before.mean()).matrix().norm())
      return true;
  }
  return false;
}

bool is_spoilt_by(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& of_the_whole,
                  const std::vector<MeasuredMode>& of_the_part) {
  constexpr double worse = 1.5;
  const Eigen::MatrixXd whole = left_by(record, of_the_whole),
                        part = left_by(from_sample(record, first), of_the_part);
  return (whole.bottomRows(part.rows()).colwise().norm().array() > worse * part.colwise().norm().array())
      .any();
}

std::size_t samples_of_hold(const ModalRecord& record, std::size_t free,
                            const std::vector<MeasuredMode>& modes) {
  constexpr double of_another_motion = 0.5, periods = 1.5;
  double slowest = HUGE_VAL;
  Eigenvalues eigenvalues;
  for (const MeasuredMode& mode : modes) {
    slowest = std::min(slowest, mode.frequency.value);
    eigenvalues.push_back(mode.eigenvalue);
  }
  if (eigenvalues.empty()) return 0;
  const std::size_t window = std::max(record.samples() / 100,
                                      static_cast<std::size_t>(std::ceil(periods / (slowest * record.step))));
  for (std::size_t from = free; from > 0;) {
    const ModalRecord later = from_sample(record, from);
    const auto fitted = fit_eigenvalues(later, values_of(later), eigenvalues);
    if (!fitted) return 0;
    eigenvalues = *fitted;
    const std::size_t length = std::min(window, from);
    from -= length;
    const Departure off = departure_before(later, eigenvalues, from_sample(record, from), length);
    if (off.share > of_another_motion) return from + off.end;
  }
  return 0;
}

std::size_t samples_of_release(const ModalRecord& record, const std::vector<MeasuredMode>& modes) {
  constexpr double far_more = 30, periods = 1.5, hardly_swings = 0.5;
  constexpr int most_windows = 4;
  double slowest = HUGE_VAL;
  Eigenvalues eigenvalues;
  for (const MeasuredMode& mode : modes) {
    slowest = std::min(slowest, mode.frequency.value);
    // What hardly swings before it is gone may be the release itself.
    if (mode.damping_ratio.value < hardly_swings) eigenvalues.push_back(mode.eigenvalue);
  }
  if (eigenvalues.empty()) return 0;
  const auto window = static_cast<std::size_t>(std::ceil(periods / (slowest * record.step)));
  std::size_t released = 0;
  for (int turn = 0; turn < most_windows && released + 4 * window + fewest_modal_samples < record.samples();
       ++turn) {
    const ModalRecord part = from_sample(record, released), later = from_sample(part, window);
    const auto fitted = fit_eigenvalues(later, values_of(later), eigenvalues);
    if (!fitted) return released;
    eigenvalues = *fitted;
    const Departure off = departure_before(later, eigenvalues, part, window);
    if (off.farthest < far_more) return released;
    released += off.end;
    if (4 * off.end < 3 * window) return released;
  }
  return released;
}

Notice still_before_motion(const ModalRecord& record, std::size_t still, std::size_t released) {
  const double from = record.time(still);
  return Notice{released > 0 ? "let_go_slowly" : "still_before_motion",
                {{"length", from - record.time(0)}, {"from", from}}};
}

ModalRecord from_sample(const ModalRecord& record, std::size_t first) {
  ModalRecord part = record;
  for (std::span<const double>& channel : part.channels) channel = channel.subspan(first);
  part.starts = {0};
  for (const std::size_t start : record.starts)
    if (start > first) part.starts.push_back(start - first);
  for (std::vector<double>* each : {&part.times, &part.measured})
    if (!each->empty()) each->erase(each->begin(), each->begin() + static_cast<std::ptrdiff_t>(first));
  return part;
}

}  // namespace cromer::core
