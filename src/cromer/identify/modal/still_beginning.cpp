#include "cromer/identify/modal/still_beginning.h"

#include <algorithm>
#include <cmath>

#include "cromer/identify/modal/decay_fit.h"

namespace cromer::core {
namespace {

// Variances of a channel's first samples and of the others, for every number of them.
class SplitVariance {
 public:
  explicit SplitVariance(std::span<const double> values) : sums_{0}, squares_{0} {
    const double origin = values.front();
    for (const double value : values) {
      const double y = value - origin;
      sums_.push_back(sums_.back() + y);
      squares_.push_back(squares_.back() + y * y);
    }
  }

  double before(std::size_t k) const { return between(0, k); }
  double after(std::size_t k) const { return between(k, sums_.size() - 1); }

 private:
  double between(std::size_t from, std::size_t to) const {
    const auto n = static_cast<double>(to - from);
    const double mean = (sums_[to] - sums_[from]) / n;
    // Of a channel that stands still only rounding is left.
    return std::max((squares_[to] - squares_[from]) / n - mean * mean, 1e-12 * squares_.back() / n);
  }

  std::vector<double> sums_, squares_;
};

}  // namespace

std::size_t still_samples(const ModalRecord& record) {
  constexpr std::size_t fewest = 4;
  constexpr double quiet = 1.0 / 25;
  std::vector<SplitVariance> channels(record.channels.begin(), record.channels.end());
  const auto n = static_cast<double>(record.samples());
  std::size_t best = 0;
  double most = 0;
  for (std::size_t k = fewest; k <= record.samples() / 2; ++k) {
    const bool still = std::all_of(channels.begin(), channels.end(), [&](const SplitVariance& channel) {
      return channel.before(k) < quiet * channel.after(k);
    });
    if (!still) continue;
    const auto size = static_cast<double>(k);
    double gain = 0;
    for (const SplitVariance& channel : channels)
      gain += n * std::log(channel.before(record.samples())) - size * std::log(channel.before(k)) -
              (n - size) * std::log(channel.after(k));
    if (gain > most) most = gain, best = k;
  }
  return best;
}

bool is_still_before(const ModalRecord& record, std::size_t first, const std::vector<MeasuredMode>& modes) {
  Eigenvalues eigenvalues;
  for (const MeasuredMode& mode : modes) eigenvalues.push_back(mode.eigenvalue);
  const ModalRecord after = from_sample(record, first);
  const Eigen::MatrixXd left = DecayBasis(record, values_of(record), eigenvalues).residuals();
  const Eigen::MatrixXd left_after = DecayBasis(after, values_of(after), eigenvalues).residuals();
  constexpr double more = 3;
  const auto begin = static_cast<Eigen::Index>(first);
  for (Eigen::Index c = 0; c < left.cols(); ++c)
    if (left.col(c).head(begin).norm() / std::sqrt(static_cast<double>(begin)) >
        more * left_after.col(c).norm() / std::sqrt(static_cast<double>(left_after.rows())))
      return true;
  return false;
}

Notice still_before_motion(const ModalRecord& record, std::size_t still) {
  const double from = record.time(still);
  return Notice{"still_before_motion", {{"length", from - record.time(0)}, {"from", from}}};
}

ModalRecord from_sample(const ModalRecord& record, std::size_t first) {
  ModalRecord part = record;
  for (std::span<const double>& channel : part.channels) channel = channel.subspan(first);
  part.starts = {0};
  for (const std::size_t start : record.starts)
    if (start > first) part.starts.push_back(start - first);
  if (!part.times.empty())
    part.times.erase(part.times.begin(), part.times.begin() + static_cast<std::ptrdiff_t>(first));
  return part;
}

}  // namespace cromer::core
