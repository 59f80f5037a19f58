// Covariance-driven stochastic subspace identification: the poles of a structure under random forces, from
// the correlations of its motion (B. Peeters & G. De Roeck, Mech. Syst. Signal Process. 13, 855 (1999)).
//
// The correlations R_l = C A^(l-1) G of lags l = 1, 2, ... fill a block Hankel matrix H = O Γ. Its first left
// singular vectors U span the observability matrix O; A solves U⁺ A = U⁻, U without its last and its first
// block row; the modes are A's eigenvectors seen through the first block row of U.
//
// How scattered correlations scatter a mode follows to first order (E. Reynders, R. Pintelon, G. De Roeck,
// Mech. Syst. Signal Process. 22, 948 (2008); M. Döhler & L. Mevel, Mech. Syst. Signal Process. 38, 346
// (2013)). Here the derivative of a mode is taken as one array over the lags, W: d mode = Σ <W_l, dR_l>. Each
// block of the record then contributes one number, and the scatter of these numbers is the mode's.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "cromer/identify/modal/block_correlations.h"

namespace cromer::core {

/// The eigenvalues of one model order, those of one sampling step.
struct ModelPoles {
  int order = 0;
  Eigen::VectorXcd values;
  Eigen::MatrixXcd right;  ///< eigenvectors, a column each
  Eigen::MatrixXcd left;   ///< the inverse of `right`: a row each
};

class Subspace {
 public:
  /// Of 2 block_rows - 1 lags at least; scale: of the channels.
  Subspace(const BlockCorrelations& correlations, int block_rows, const Eigen::VectorXd& scale);

  /// order even, from 2 to `most` of prepare().
  ModelPoles poles(int order) const;
  void prepare(int most);

  /// The shape of pole j in the channels' own units, not normalised.
  Eigen::VectorXcd shape(const ModelPoles& poles, Eigen::Index j) const;

  /// d value(j), and d (shape / shape's component `reference`)_c, by the correlations, as their mean is laid
  /// out.
  Eigen::MatrixXcd value_gradient(const ModelPoles& poles, Eigen::Index j) const;
  Eigen::MatrixXcd shape_gradient(const ModelPoles& poles, Eigen::Index j, Eigen::Index reference,
                                  Eigen::Index component) const;

 private:
  Eigen::MatrixXcd gradient(const ModelPoles& poles, Eigen::Index j, const Eigen::RowVectorXcd& weight,
                            const Eigen::VectorXcd& first_rows) const;

  Eigen::Index channels_, rows_;
  Eigen::VectorXd scale_, singular_;
  Eigen::MatrixXd left_, right_;              // singular vectors
  Eigen::MatrixXd triangle_, rotated_lower_;  // of U⁺ = Q triangle, and Qᵀ U⁻
};

}  // namespace cromer::core
