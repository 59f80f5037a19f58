#include "cromer/identify/modal/block_correlations.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace cromer::core {

ScaledChannels scale_channels(const ModalRecord& record) {
  const auto n = static_cast<Eigen::Index>(record.samples());
  ScaledChannels scaled;
  scaled.values.resize(static_cast<Eigen::Index>(record.channels.size()), n);
  scaled.scale.resize(scaled.values.rows());
  // Places from -1 to 1 are orthogonal to a constant.
  const Eigen::RowVectorXd place = Eigen::RowVectorXd::LinSpaced(n, -1, 1);
  for (Eigen::Index c = 0; c < scaled.values.rows(); ++c) {
    const auto& channel = record.channels[static_cast<std::size_t>(c)];
    Eigen::RowVectorXd y = Eigen::Map<const Eigen::RowVectorXd>(channel.data(), n);
    y.array() -= y.mean();
    y -= y.dot(place) / place.squaredNorm() * place;
    scaled.scale(c) = std::sqrt(y.squaredNorm() / static_cast<double>(n));
    scaled.values.row(c) = y / scaled.scale(c);
    if (!record.measured.empty())
      scaled.values.row(c).array() *= Eigen::Map<const Eigen::RowVectorXd>(record.measured.data(), n).array();
  }
  return scaled;
}

BlockCorrelations block_correlations(const ScaledChannels& channels, const ModalRecord& record, int lags,
                                     int stride, int blocks) {
  const auto& y = channels.values;
  const Eigen::Index r = y.rows(), n = y.cols(), longest = static_cast<Eigen::Index>(lags) * stride;
  const Eigen::Index length = std::max<Eigen::Index>(1, (n - longest) / blocks);
  BlockCorrelations result;
  result.channels = static_cast<int>(r);
  result.lags = lags;
  result.stride = stride;
  result.step = record.step * stride;
  result.block_length = static_cast<double>(length) * record.step;
  result.mean = Eigen::MatrixXd::Zero(r, r * lags);
  result.count = Eigen::VectorXd::Zero(lags);
  const std::span<const double> was(record.measured);
  for (std::size_t piece = 0; piece < record.starts.size(); ++piece) {
    const auto begin = static_cast<Eigen::Index>(record.starts[piece]);
    const auto end = static_cast<Eigen::Index>(record.end(piece));
    for (Eigen::Index from = begin; from + stride < end; from += length) {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(r, r * lags);
      Eigen::VectorXd count = Eigen::VectorXd::Zero(lags);
      for (Eigen::Index l = 0; l < lags; ++l) {
        const Eigen::Index shift = (l + 1) * stride, many = std::min(length, end - shift - from);
        if (many <= 0) break;
        count(l) = was.empty() ? static_cast<double>(many)
                               : std::inner_product(was.begin() + from, was.begin() + from + many,
                                                    was.begin() + from + shift, 0.0);
        for (Eigen::Index a = 0; a < r; ++a)
          for (Eigen::Index b = 0; b < r; ++b)
            sum(a, l * r + b) = y.row(a).segment(from + shift, many).dot(y.row(b).segment(from, many));
      }
      result.mean += sum;
      result.count += count;
      result.sums.push_back(std::move(sum));
      result.counts.push_back(std::move(count));
    }
  }
  for (Eigen::Index l = 0; l < lags; ++l) result.mean.middleCols(l * r, r) /= std::max(1.0, result.count(l));
  return result;
}

}  // namespace cromer::core
