// Free motion as a sum of oscillations: in each channel the same exponentials, with amplitudes of its own,
// about a straight line.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

/// One of each conjugate pair, that with the positive imaginary part. [1/s]
using Eigenvalues = std::vector<std::complex<double>>;

/// A column for each channel.
Eigen::MatrixXd values_of(const ModalRecord& record);

/// The record's motion without its mean and trend, and without these oscillations: what least squares leave
/// of it. A vector for each channel.
std::vector<std::vector<double>> without_oscillations(const ModalRecord& record,
                                                      const Eigenvalues& eigenvalues);

/// The cosines and sines of all oscillations, a constant and a trend; and the channels as their sums.
class DecayBasis {
 public:
  DecayBasis(const ModalRecord& record, const Eigen::MatrixXd& values, const Eigenvalues& eigenvalues);

  const Eigen::MatrixXd& residuals() const { return residuals_; }
  std::complex<double> amplitude(Eigen::Index channel, Eigen::Index mode) const {
    return {amplitudes_(2 * mode, channel), -amplitudes_(2 * mode + 1, channel)};
  }
  Eigen::Index columns() const { return columns_.cols(); }
  /// Since the first sample [s].
  const Eigen::VectorXd& times() const { return times_; }
  /// The channels' sums at times before the record's first sample, so many seconds before it (> 0): a row
  /// for each time.
  Eigen::MatrixXd before(const Eigen::VectorXd& seconds) const;

  /// The oscillation of least power.
  Eigen::Index weakest_mode() const;

  /// The derivatives of a channel's motion by each oscillation's angular frequency and decay rate, its
  /// amplitudes held.
  Eigen::MatrixXd derivatives(Eigen::Index channel) const;
  Eigen::MatrixXd projected_out(const Eigen::MatrixXd& of) const;
  /// How much of each column there is in a vector, by least squares: a row for each.
  Eigen::MatrixXd coordinates(const Eigen::MatrixXd& of) const;
  /// The sensitivity of column k's coordinate to each sample.
  Eigen::VectorXd dual(Eigen::Index k) const;

 private:
  /// The columns at times since the first sample [s].
  Eigen::MatrixXd columns_at(const Eigen::VectorXd& times) const;

  Eigenvalues eigenvalues_;
  Eigen::Index modes_;
  Eigen::VectorXd times_;
  Eigen::MatrixXd columns_, orthogonal_, triangle_, residuals_, amplitudes_;
};

/// The channels' power about some eigenvalues, each channel's over its whole; what the basis leaves of it;
/// and what noise leaves there that is as strong as at the middle one of the other frequencies.
struct PowerAbout {
  double all = 0, left = 0, noise = 0;

  /// What the basis accounts for, of all.
  double share() const { return all > 0 ? 1 - left / all : 0; }
  /// What neither the basis nor noise accounts for, of all; below 0 where less is left than noise would
  /// leave.
  double unexplained() const { return all > 0 ? (left - 1.5 * noise) / all : 1; }
};

PowerAbout power_about(const DecayBasis& basis, const Eigen::MatrixXd& values, const ModalRecord& record,
                       const Eigenvalues& about);

/// The eigenvalues of least squares over all channels, from these; empty where the iteration fails. At most
/// ten. The amplitudes are solved for at each step (G. H. Golub & V. Pereyra, SIAM J. Numer. Anal. 10, 413
/// (1973); L. Kaufman, BIT 15, 49 (1975)).
std::optional<Eigenvalues> fit_eigenvalues(const ModalRecord& record, const Eigen::MatrixXd& values,
                                           const Eigenvalues& start);

/// The sum over the channels of the power at multiples of a frequency step.
struct Periodogram {
  double step = 0;  // [rad/s]
  std::vector<double> power;
};

/// Of values at the record's times; zeros stand in its short gaps (places_with_short_gaps), and behind the
/// end up to a power of two that is `padding` times the length at least.
Periodogram periodogram(const Eigen::MatrixXd& values, const ModalRecord& record, std::size_t padding = 1);

}  // namespace cromer::core
