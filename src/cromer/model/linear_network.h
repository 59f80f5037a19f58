// A network in small motions about rest, as matrices; and its exact motion where its law is linear.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "cromer/base/state.h"
#include "cromer/base/vector.h"
#include "cromer/model/network.h"
#include "cromer/model/network_system.h"

namespace cromer::core {

/// M x'' + C x' + K x = 0 about x = 0. Matrices are symmetric and stand row by row.
struct LinearNetwork {
  std::size_t size = 0;
  std::vector<double> mass;       // [kg] the diagonal of M
  std::vector<double> stiffness;  // [N/m]
  std::vector<double> damping;    // [kg/s]
};

/// What a link is to small motions about rest: stiffness [N/m] and damping [kg/s], the slopes of its force. A
/// hysteretic force counts with its stiffness where it begins; dry friction is left out.
State<double> slopes_at_rest(const Oscillator<double>& law);

/// Small motions of the network about rest.
LinearNetwork linearised(const Network& network);

/// The natural modes of K x = w^2 M x.
struct UndampedModes {
  std::size_t size = 0;
  std::vector<double> squares;  // [1/s^2] w^2, rising
  std::vector<double> shapes;   ///< one column a mode, its largest component 1; rows stand after each other
};

UndampedModes undamped_modes(const LinearNetwork& network);

/// Of each mode the damping 2 b [1/s] in q'' + 2 b q' + w^2 q; empty where damping ties modes together.
std::vector<double> modal_damping(const LinearNetwork& network, const UndampedModes& modes);

/// A linear network whose damping does not couple its modes: each moves as one oscillator, by its closed
/// form. Of one mass with one link it is that oscillator's, to the bit.
class NetworkByModes : public NetworkSystem<> {
 public:
  /// damping: not empty (modal_damping).
  NetworkByModes(const Network& network, const UndampedModes& modes, const std::vector<double>& damping);

  /// The state at t of the motion through y0 at t0; the times are numbers.
  State<MassVector> propagate(const MassVector& t0, const MassVector& t, const State<MassVector>& y0) const;

 private:
  UndampedModes modes_;
  std::vector<LinearLaw<double>> laws_;
  std::vector<double> weights_;  ///< of each mass in each mode's coordinate, as the shapes
  std::vector<std::pair<std::size_t, HarmonicForce<double>>> drives_;
};

/// Any linear network: by the exponential of its matrix over a step.
class NetworkByExponential : public NetworkSystem<> {
 public:
  explicit NetworkByExponential(const Network& network);

  /// Best asked from state to state: the matrix of a step is kept.
  static constexpr bool has_many_pieces = true;
  State<MassVector> propagate(const MassVector& t0, const MassVector& t, const State<MassVector>& y0) const;

 private:
  struct Step;
  std::shared_ptr<Step> step_;
};

}  // namespace cromer::core
