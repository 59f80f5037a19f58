// The free motions of a linear network, M x'' + C x' + K x = 0: modes x = shape e^(z t), and what a step of a
// method makes of each.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/model/linear_network.h"

namespace cromer::core {

/// A mode and its two eigenvalues z^2 - (first + second) z + first second = 0: conjugate where it swings, the
/// first with the positive imaginary part.
struct ComplexMode {
  std::complex<double> first, second;       // [1/s]
  std::vector<std::complex<double>> shape;  ///< its largest component 1

  /// |z|^2 = w0^2 [1/s^2], and the decay rate -Re z [1/s].
  LinearLaw<double> law() const {
    return {.decay_rate = -(first + second).real() / 2, .stiffness = (first * second).real()};
  }
};

/// How alike two shapes are, 0 to 1, whatever their sizes and phases: the modal assurance criterion. R. J.
/// Allemang & D. L. Brown, Proc. 1st Int. Modal Analysis Conf., 110 (1982).
double modal_assurance(const std::vector<std::complex<double>>& a,
                       const std::vector<std::complex<double>>& b);

/// All modes, by rising |z|: as many as masses. Where damping does not couple the natural modes, these.
/// Error: about 1e-15 of the largest |z|. Eigenvalues that are not told from 0 are 0.
std::vector<ComplexMode> complex_modes(const LinearNetwork& network);

/// A share of the mass that takes part when the ground shakes along the same direction everywhere: the
/// effective modal mass over the whole. Of natural modes it adds up to 1.
double participation(const LinearNetwork& network, const ComplexMode& mode);

/// What a step of a method makes of a network.
struct EffectiveNetwork {
  std::vector<EffectiveOscillator> modes;  ///< of each mode, in their order
  double spectral_radius = 0;              ///< largest modulus of all eigenvalues; not a number where a step
                                           ///< found no solution
};

/// A step of h [s] as a linear map: `image` takes (x, h v, h^2 a), `parts` vectors one after another (3 where
/// the method carries an acceleration), and gives them one step later.
EffectiveNetwork effective_network(
    const std::vector<ComplexMode>& modes, std::size_t parts, double h,
    const std::function<std::vector<double>(const std::vector<double>&)>& image);

}  // namespace cromer::core
