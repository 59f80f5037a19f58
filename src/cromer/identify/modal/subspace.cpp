#include "cromer/identify/modal/subspace.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace cromer::core {

Subspace::Subspace(const BlockCorrelations& correlations, int block_rows, const Eigen::VectorXd& scale)
    : channels_(correlations.channels), rows_(block_rows), scale_(scale) {
  Eigen::MatrixXd hankel(rows_ * channels_, rows_ * channels_);
  for (Eigen::Index a = 0; a < rows_; ++a)
    for (Eigen::Index b = 0; b < rows_; ++b)
      hankel.block(a * channels_, b * channels_, channels_, channels_) =
          correlations.mean.middleCols((a + b) * channels_, channels_);
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(hankel, Eigen::ComputeFullU | Eigen::ComputeFullV);
  left_ = svd.matrixU();
  right_ = svd.matrixV();
  singular_ = svd.singularValues();
}

void Subspace::prepare(int most) {
  const Eigen::Index upper = left_.rows() - channels_;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(left_.topLeftCorner(upper, most));
  triangle_ = qr.matrixQR().topRows(most).triangularView<Eigen::Upper>();
  rotated_lower_ = (qr.householderQ().transpose() * left_.block(channels_, 0, upper, most)).topRows(most);
}

ModelPoles Subspace::poles(int order) const {
  const Eigen::MatrixXd transition = triangle_.topLeftCorner(order, order)
                                         .triangularView<Eigen::Upper>()
                                         .solve(rotated_lower_.topLeftCorner(order, order));
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(transition);
  ModelPoles poles{order, solver.eigenvalues(), solver.eigenvectors(), {}};
  poles.left = poles.right.inverse();
  return poles;
}

Eigen::VectorXcd Subspace::shape(const ModelPoles& poles, Eigen::Index j) const {
  return scale_.asDiagonal() * (left_.topLeftCorner(channels_, poles.order) * poles.right.col(j));
}

// dA times the eigenvector r of the value z is (U⁺)† (dU⁻ - z dU⁺) r + (U⁺ᵀU⁺)⁻¹ dU⁺ᵀ (U⁻ - z U⁺) r. Turns of
// U within its own columns change no mode, so only dU out of them counts: for column j along vector k
//   (s_j u_kᵀ dH v_j + s_k u_jᵀ dH v_k) / (s_j² - s_k²).
// The result is the derivative of weight dA r + first_rowsᵀ (first block row of dU) r.
Eigen::MatrixXcd Subspace::gradient(const ModelPoles& poles, Eigen::Index j,
                                    const Eigen::RowVectorXcd& weight,
                                    const Eigen::VectorXcd& first_rows) const {
  const Eigen::Index n = poles.order, all = left_.rows(), upper = all - channels_, rest = all - n;
  const std::complex<double> z = poles.values(j);
  const Eigen::VectorXcd r = poles.right.col(j);
  const auto u = left_.leftCols(n), other = left_.rightCols(rest);
  const Eigen::MatrixXd triangle = triangle_.topLeftCorner(n, n);
  Eigen::MatrixXd parts(n, 2);  // of weight (U⁺ᵀU⁺)⁻¹, real and imaginary
  parts << weight.real().transpose(), weight.imag().transpose();
  triangle.triangularView<Eigen::Upper>().transpose().solveInPlace(parts);
  triangle.triangularView<Eigen::Upper>().solveInPlace(parts);
  Eigen::RowVectorXcd inverse(n);
  inverse.real() = parts.col(0).transpose();
  inverse.imag() = parts.col(1).transpose();
  const Eigen::RowVectorXcd row = inverse * u.topRows(upper).transpose();
  Eigen::VectorXcd outer = Eigen::VectorXcd::Zero(all), rest_of_fit = Eigen::VectorXcd::Zero(all);
  outer.tail(upper) += row.transpose();
  outer.head(upper) -= z * row.transpose();
  outer.head(channels_) += first_rows;
  rest_of_fit.head(upper) = u.bottomRows(upper) * r - z * (u.topRows(upper) * r);

  // What each pair (k, j) of singular vectors counts.
  Eigen::MatrixXcd turned =
      (other.transpose() * outer) * r.transpose() + (other.transpose() * rest_of_fit) * inverse;
  Eigen::MatrixXcd direct(rest, n), swapped(rest, n);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index k = 0; k < rest; ++k) {
      const double own = singular_(a), its = singular_(n + k);
      const std::complex<double> each = turned(k, a) / (own * own - its * its);
      direct(k, a) = each * own;
      swapped(k, a) = each * its;
    }
  const Eigen::MatrixXcd hankel =
      (other * direct) * right_.leftCols(n).transpose() + u * (right_.rightCols(rest) * swapped).transpose();
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(channels_, channels_ * (2 * rows_ - 1));
  for (Eigen::Index a = 0; a < rows_; ++a)
    for (Eigen::Index b = 0; b < rows_; ++b)
      result.middleCols((a + b) * channels_, channels_) +=
          hankel.block(a * channels_, b * channels_, channels_, channels_);
  return result;
}

Eigen::MatrixXcd Subspace::value_gradient(const ModelPoles& poles, Eigen::Index j) const {
  return gradient(poles, j, poles.left.row(j), Eigen::VectorXcd::Zero(channels_));
}

Eigen::MatrixXcd Subspace::shape_gradient(const ModelPoles& poles, Eigen::Index j, Eigen::Index reference,
                                          Eigen::Index component) const {
  const Eigen::VectorXcd seen = shape(poles, j);
  // d (s_c / s_0) = (ds_c - s_c/s_0 ds_0) / s_0, of both the eigenvector and the first block row.
  Eigen::VectorXcd first_rows = Eigen::VectorXcd::Zero(channels_);
  first_rows(component) += scale_(component) / seen(reference);
  first_rows(reference) -= seen(component) / seen(reference) * scale_(reference) / seen(reference);
  Eigen::RowVectorXcd through =
      first_rows.transpose() * left_.topLeftCorner(channels_, poles.order) * poles.right;
  for (Eigen::Index l = 0; l < through.size(); ++l)
    through(l) = l == j ? 0 : through(l) / (poles.values(j) - poles.values(l));
  return gradient(poles, j, through * poles.left, first_rows);
}

}  // namespace cromer::core
