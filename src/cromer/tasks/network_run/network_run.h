// Task: a run of a network of masses by one method.
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

/// The kept states of a run: a column for each mass, all of one length.
struct NetworkStates {
  std::vector<double> t;               // [s]
  std::vector<std::vector<double>> x;  // [m] or [rad]
  std::vector<std::vector<double>> v;  // [m/s] or [rad/s]
  std::vector<double> energy;          // [J] of all masses and links
};

/// Where the energy of a run came from and went, over the kept states.
struct NetworkEnergy {
  double start = 0, end = 0;            // [J]
  double drive = 0;                     // [J] work of all drives
  double taken = 0;                     // [J] by all resistances
  std::vector<EnergyBalance> of_links;  ///< what each stores and takes

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
};

/// Runs the network. Of the options those of the integration are used: method (one), step, until, tolerance,
/// every, beta, gamma, rho_inf, and the memory. An Error names option, value and constraint, or the term that
/// keeps the network, or the method, from running.
Result<NetworkRun> run_network(const Network& network, const std::string& file,
                               const SimulateOptions& options, const Watch& watch = {});

/// The options of `simulate` that a network takes.
bool is_option_of_networks(std::string_view option);

}  // namespace cromer::core
