// The correlations of a record's channels with each other, block by block, so that their scatter is known.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

/// Channels with mean and drift taken off and of standard deviation 1, a row each.
struct ScaledChannels {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  Eigen::VectorXd scale;  ///< standard deviations that they were divided by
};

/// No channel may be constant.
ScaledChannels scale_channels(const ModalRecord& record);

/// Sums over time of y(t + l h) y(t)ᵀ for the lags l = stride, 2 stride, ...; side by side, channels
/// wide each.
struct BlockCorrelations {
  int channels = 0, lags = 0, stride = 1;
  double step = 1;                      // [s] between lags
  std::vector<Eigen::MatrixXd> sums;    ///< of each block
  std::vector<Eigen::VectorXd> counts;  ///< of products, of each block and lag
  Eigen::MatrixXd mean;                 ///< of all products
  Eigen::VectorXd count;                ///< of all products, by lag
  double block_length = 0;              // [s]
};

/// Lags 1 to `lags`, times `stride`, in about `blocks` blocks of equal length. No product spans a gap.
BlockCorrelations block_correlations(const ScaledChannels& channels, const ModalRecord& record, int lags,
                                     int stride, int blocks);

}  // namespace cromer::core
