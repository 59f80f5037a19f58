// Where the uncertainty of the spring constant comes from: k = (m + m_s/3) w0^2.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {

/// One input's part, by the law of propagation (JCGM 100:2008, 5.1).
struct Contribution {
  std::string quantity;         ///< mass, spring_mass, angular_frequency
  double value;                 ///< in `unit`
  double standard_uncertainty;  ///< in `unit`
  std::string unit;
  double sensitivity;   ///< dk/d(quantity)
  double contribution;  // [N/m] |sensitivity| times standard_uncertainty
  double share;         ///< of k's variance, 0 to 1; 0 if that is 0
};

/// The parts of mass, spring mass (if any) and frequency. `body` must have a mass.
std::vector<Contribution> stiffness_budget(const Estimate& angular_frequency, const Body& body);

/// The same propagated as distributions (JCGM 101:2008): masses are normal; the frequency follows Student's t
/// with its degrees of freedom, scaled to its standard error (6.4.9.2).
struct MonteCarlo {
  long long trials = 0;
  std::uint64_t seed = 1;
  double mean = 0, standard_deviation = 0;  // [N/m]
  double low = 0, high = 0;                 // [N/m] 95 % of the trials lie between, as many below as above
};

/// `trials` from 1000 to 1e7. The same seed gives the same numbers on every machine. Empty if interrupted.
std::optional<MonteCarlo> stiffness_monte_carlo(const Estimate& angular_frequency, double degrees,
                                                const Body& body, long long trials, std::uint64_t seed,
                                                const Watch& watch = {});

}  // namespace cromer::core
