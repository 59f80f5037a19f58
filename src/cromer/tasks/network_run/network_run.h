// Task: runs of a network of masses, each by one method.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/analysis/energy_balance.h"
#include "cromer/base/interrupt.h"
#include "cromer/model/network.h"
#include "cromer/notice.h"
#include "cromer/result.h"
#include "cromer/run/course.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The force of a link that has memory.
struct InnerForce {
  std::size_t link = 0;
  std::vector<double> force{};  // [N] or [N m]
};

/// The kept states of a run: a column for each mass, all of one length.
struct NetworkStates {
  std::vector<double> t;               // [s]
  std::vector<std::vector<double>> x;  // [m] or [rad]
  std::vector<std::vector<double>> v;  // [m/s] or [rad/s]
  std::vector<double> energy;          // [J] of all masses and links, without what hysteresis stores
  std::vector<InnerForce> inner{};
};

/// What a link stores at the end, and what it took [J]: its resistances, friction, and the work done against
/// hysteresis.
struct LinkEnergy {
  double end = 0, taken = 0;
};

/// Where the energy of a run came from and went, over the kept states.
struct NetworkEnergy {
  double start = 0, end = 0;  // [J]
  double drive = 0;           // [J] work of all drives
  double taken = 0;           // [J] by all links
  std::vector<LinkEnergy> of_links;

  /// [J] made (+) or lost (-) by the method itself.
  double method() const { return (end - start) - (drive - taken); }
};

struct NetworkRun {
  std::string file;
  Network network;
  std::string method{};
  double step = 0;       // [s]
  double until = 0;      // [s]
  double tolerance = 0;  ///< as given, or what the method takes by default
  Outcome outcome{};
  NetworkStates states{};
  std::vector<State<double>> last{};      ///< of each mass, at outcome.t
  std::optional<NetworkEnergy> energy{};  ///< if the kept states are dense enough
  Notice message{};                       ///< why it ended early; empty if it did not
  std::vector<Notice> notices{};

  bool ok() const { return outcome.status == Status::reached_end; }
  /// Else `step` is the spacing of the states alone: the method chooses its steps, or needs none.
  bool takes_steps() const;
};

/// Runs the network. Of the options those of the integration are used: method (one), step, until,
/// tolerance, every, beta, gamma, rho_inf, and the memory. An Error names option, value and constraint, or
/// the term that keeps the network, or the method, from running.
Result<NetworkRun> run_network(const Network& network, const std::string& file,
                               const SimulateOptions& options, const Watch& watch = {});

/// The same by each of the methods, in their order; fewer where it was interrupted.
Result<std::vector<NetworkRun>> run_network_by_each(const Network& network, const std::string& file,
                                                    const SimulateOptions& options, const Watch& watch = {});

/// What a link stores at each kept state [J]; what hysteresis stores is left out.
std::vector<double> stored_by(const NetworkRun& run, std::size_t link);

/// The options of `simulate` that a network takes.
bool is_option_of_networks(std::string_view option);

}  // namespace cromer::core
