// Networks of masses: their motion, their modes, and their links from a recording; and the modes in a
// recording.
#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <cromer/drive.h>
#include <cromer/export.h>
#include <cromer/fit.h>
#include <cromer/methods.h>
#include <cromer/notice.h>
#include <cromer/quantity.h>
#include <cromer/read.h>
#include <cromer/result.h>
#include <cromer/status.h>

namespace cromer {

namespace core {
struct FittedNetwork;
struct ModesResult;
struct NetworkRun;
}  // namespace core

/// A mass or, where its position is an angle, a moment of inertia: one of the two is given.
struct Mass {
  std::string name{};               ///< as links call it; not "ground"
  std::optional<double> mass{};     // [kg] > 0
  std::optional<double> inertia{};  // [kg m^2] > 0
  double position = 0;              // [m] at t = 0; of an angle [rad]
  double velocity = 0;              // [m/s], [rad/s]
  Harmonic drive{};                 ///< its force, of an angle a torque [N m]
};

/// One coefficient of a link's law, as Oscillator calls it: {"stiffness", 50}.
struct LinkTerm {
  std::string name{};
  std::optional<double> value{};  ///< in SI units; empty where fit() is to find it
};

inline constexpr std::nullopt_t sought = std::nullopt;  ///< {"stiffness", cromer::sought}

/// Joins two masses, or one and the ground. Its force depends on u = x_to - x_from and on u'; both ends feel
/// it.
struct Link {
  std::string from = "ground", to = "ground";  ///< names of masses
  std::vector<LinkTerm> terms{};               // as in Oscillator; of angles torques [N m], by rad
};

/// Every mass is held by a link; all have masses, or all have moments of inertia.
struct Network {
  Network(std::vector<Mass> its_masses, std::vector<Link> its_links)
      : masses(std::move(its_masses)), links(std::move(its_links)) {}
  std::vector<Mass> masses;
  std::vector<Link> links;
};

/// Reads a network's file, which is TOML (docs/networks.md). An Error names line, column and cure.
CROMER_API Result<Network> read_network(const std::string& path);

/// Columns of equal length, recorded together: `{left, right}`, or any list of vectors, arrays or spans. It
/// copies no values: the columns must live as long as it does.
class Channels {
 public:
  Channels(std::initializer_list<std::span<const double>> columns) : columns_(columns) {}
  template <class Columns>
  requires requires(const Columns& columns) {
    { *columns.begin() } -> std::convertible_to<std::span<const double>>;
  }
  Channels(const Columns& columns)
      : columns_(columns.begin(), columns.end()) {}  // NOLINT: implicit on purpose

  const std::vector<std::span<const double>>& columns() const { return columns_; }

 private:
  std::vector<std::span<const double>> columns_;
};

struct NetworkRunOptions {
  Method method = "euler-cromer";
  std::optional<double> step{};           // [s] > 0; 1/200 of the shortest natural or drive period
  std::optional<double> until{};          // [s] > 0; 20 of the longest natural period
  std::optional<double> tolerance{};      // as in SimulateOptions
  std::optional<double> beta{}, gamma{};  // of newmark, 0 to 1; 1/4 and 1/2
  std::optional<double> rho_inf{};        // of generalized-alpha, 0 to 1; 0.8
  long long every = 1;                    ///< keep every n-th state, > 0
  Progress progress{};
};

/// The kept states. A run ends early as one of an oscillator does; the states up to there are good.
struct NetworkSimulation {
  std::vector<std::string> names;      ///< of the masses
  std::vector<double> t;               // [s]
  std::vector<std::vector<double>> x;  // [m] or [rad]; of each mass, one for each time
  std::vector<std::vector<double>> v;  // [m/s] or [rad/s]
  std::vector<double> energy;          // [J] of all masses and links
  Status status = Status::reached_end;
  bool interrupted = false;
  std::string message;  ///< why it ended early, in English; "" where it did not
  Counts counts;
  double step = 0;              // [s] as used
  std::vector<Notice> notices;  ///< what else there is to know
  std::shared_ptr<const core::NetworkRun> detail;

  bool succeeded() const { return status == Status::reached_end && !interrupted; }
};

/// Runs the network by any method of methods() whose formula takes the terms of its links; "exact" that of
/// linear networks of at most 500 masses. An Error names the argument.
CROMER_API Result<NetworkSimulation> simulate(const Network& network, const NetworkRunOptions& options = {});

struct NetworkFitOptions {
  std::optional<double> from{}, to{};  // [s] first and last time used
  std::optional<int> run{};            ///< of a recording, from 1; needed where it has several
  Progress progress{};
};

struct FittedLink {
  std::string from, to;
  std::vector<Parameter> parameters;  ///< what was sought
};

struct FittedMass {
  std::string name;
  Estimate position{};           // [m] or [rad] from rest, at the first sample
  Estimate velocity{};           // [m/s] or [rad/s] likewise
  Estimate equilibrium{};        // [m] or [rad] what its column reads at rest
  double rms = 0;                // [m] or [rad] of the residuals
  std::vector<double> residual;  // [m] or [rad] measured less fitted, for each time; NaN where missing
};

/// The links of a recorded network.
struct NetworkFit {
  FitStatus status = FitStatus::converged;
  std::string message;               ///< why, where it did not converge, in English
  std::vector<FittedLink> links{};   ///< all, in the order of the network
  std::vector<FittedMass> masses{};  ///< likewise
  std::vector<double> t{};           // [s] times used
  bool interrupted = false;
  std::vector<Notice> notices{};  ///< what else there is to know
  std::shared_ptr<const core::FittedNetwork> detail{};

  bool succeeded() const { return detail && status == FitStatus::converged; }

  /// The network with the values found and the start of the recording, as simulate() takes it. An Error where
  /// the fit has no values.
  CROMER_API Result<Network> network() const;
};

/// Finds what the network's links leave open. `channels` has the positions [m] or angles [rad] of all masses,
/// in the order of the network, at times t [s] that increase strictly; NaN is a missing value. No start
/// values are needed; at most twenty unknowns, three of them for each mass. An Error names the argument; a
/// record that cannot be fitted is a status (docs/networks.md).
CROMER_API Result<NetworkFit> fit(std::span<const double> t, const Channels& channels, const Network& network,
                                  const NetworkFitOptions& options = {});

/// The same of a recording that has such a column for each mass, and no other of this kind.
CROMER_API Result<NetworkFit> fit(const Recording& recording, const Network& network,
                                  const NetworkFitOptions& options = {});

struct ModesOptions {
  std::vector<Method> method{};     ///< what these make of each mode; none
  std::optional<double> step{};     // [s] > 0, of these methods
  std::optional<double> beta{};     // of newmark, 0 to 1; 1/4
  std::optional<double> gamma{};    // of newmark, 0 to 1; 1/2
  std::optional<double> rho_inf{};  // of generalized-alpha, 0 to 1; 0.8
  // Of a recording:
  std::optional<int> run{};                ///< from 1; needed where the file has several
  std::optional<double> from{}, to{};      // [s] the times used; all
  std::optional<int> modes{};              ///< at most this many; all that are found
  std::optional<double> from_frequency{};  // [rad/s] only modes between
  std::optional<double> to_frequency{};    // [rad/s]
  std::optional<Method> of_method{};       ///< that simulated it, with `step`: its share is taken out
  std::optional<Network> network{};        ///< to set its modes beside; its masses are the channels, in order
  ReadOptions read{};                      ///< of a file
  Observed observed = Observed::position;  ///< of channels
};

/// What a method makes of a mode, from the eigenvalues of its own step.
struct ModeByMethod {
  std::string method;
  double step = 0;                        // [s]
  std::optional<double> frequency{};      // [Hz] |eigenvalue|/2 pi; empty where nothing oscillates
  std::optional<double> damping_ratio{};  ///< likewise; negative where the mode grows
  bool stable = true;                     ///< the mode stays bounded
};

/// The mode of a network that matches one of a recording.
struct ModeOfNetwork {
  std::size_t mode = 0;  ///< from 1, by rising frequency
  double frequency = 0;  // [Hz]
  double damping_ratio = 0;
  double mac = 0;  ///< modal assurance criterion of the two shapes, 0.5 to 1: 1 for the same
};

struct Mode {
  Estimate frequency{};                       // [Hz] |eigenvalue|/2 pi; NaN where it falls away from rest
  Estimate damping_ratio{};                   ///< NaN where the frequency is 0 or NaN
  std::vector<std::complex<double>> shape{};  ///< of each name; the largest is 1
  std::vector<std::complex<double>> shape_error{};  ///< standard errors of its parts; of recordings
  std::optional<double> participation{};            ///< effective modal mass over the whole; of networks
  std::optional<ModeOfNetwork> of_network{};        ///< of recordings, with ModesOptions::network
  std::vector<ModeByMethod> methods{};
};

struct Modes {
  std::vector<std::string> names{};  ///< of the masses, or of the channels
  std::vector<Mode> modes{};         ///< by rising frequency
  std::vector<Notice> notices{};     ///< what else there is to know
  Notice message{};                  ///< why no modes were found in a recording; empty if some were
  std::shared_ptr<const core::ModesResult> detail{};
};

/// The modes of small motions about rest of the network in a file that ends in .toml (docs/networks.md), of
/// at most 500 masses; else those in a recording of several channels, with 95 % intervals. An Error names the
/// argument, or what is wrong in which line of the file.
CROMER_API Result<Modes> modes(const std::string& file, const ModesOptions& options = {});

/// Those of a network.
CROMER_API Result<Modes> modes(const Network& network, const ModesOptions& options = {});

/// Those in channels that were recorded together at times t [s] that increase strictly, in the SI unit of
/// what was observed; NaN is a missing value.
CROMER_API Result<Modes> modes(std::span<const double> t, const Channels& channels,
                               const ModesOptions& options = {});

}  // namespace cromer
