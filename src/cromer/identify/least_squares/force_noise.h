// What noise of a recorded force does to the estimates of a fit that takes the force as it was recorded.
//
// The body answers the force, not its sensor's noise: what is left of the motion then holds, beside the noise
// of the motion's own sensor, the answer of the body to that of the force's. Near the resonance it is large,
// and so slow that the residuals of one record show hardly any of it for what it is; which answer it would
// be, the fitted law says. Two white noises, of variance a at each sample of the motion and a rho at each of
// the force, leave C = a (1 + rho H Hᵀ), the columns of H the body's answers to a unit of force at one
// sample. The rho is that of the largest restricted likelihood (H. D. Patterson & R. Thompson, Biometrika 58,
// 545 (1971)), by the innovations of a Kalman filter (P. C. Young, Recursive Estimation (2011), chapter 8).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "cromer/identify/least_squares/noise.h"

namespace cromer::core {

/// The body's answer to a force, from one step of the grid to the next:
///   s_{k+1} = transition s_k + entry u_k,   the value that is seen = sight s_k + directly u_k
struct AnswerToForce {
  std::array<std::array<double, 2>, 2> transition{};  // of position and velocity
  std::array<double, 2> entry{}, sight{};
  double directly = 0;
};

struct ForceNoise {
  double deviation = 0;  ///< of each sample of the force (rms), the most likely [the answer's unit of force]
  bool shows = false;  ///< noise of the motion's sensor alone would look like this in one record of a hundred
  double mean_square = 0;  ///< its variance, over all that are possible
  double deviance = 0;     ///< minus twice the logarithm of the likelihood with the most likely noise, up
                           ///< to `largest` unless a larger one shows, but for a constant
  double deviance_without = 0;   ///< the same without noise of the force
  EstimateNoise of_estimates{};  ///< over all noises of the force that are possible, none among them
};

/// Of residuals and their Jacobian, sample by sample with respect to `size` parameters, and the inverse of
/// the normal matrix. Empty where the answer grows without end. Gaps are those of the grid: a body that rings
/// on through a longer one than it tells is answered wrongly.
/// No deviation beyond `largest` is possible, unless it shows.
std::optional<ForceNoise> find_force_noise(const SampleGrid& grid, std::span<const double> residuals,
                                           std::span<const double> jacobian, int size,
                                           const SquareMatrix& inverse_matrix, const AnswerToForce& answer,
                                           double largest);

/// The mean sum of the squares of the answers at so many places of the grid to white noise of variance 1.
double answer_norm(const AnswerToForce& answer, std::size_t places);

}  // namespace cromer::core
