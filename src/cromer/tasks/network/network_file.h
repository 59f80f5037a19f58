// A network as a file (TOML):
//
//   [[mass]]
//   name = "floor 1"
//   mass = "1200 kg"       # or, of an angle, inertia = "0.05 kg m²"; position, velocity, drive_amplitude,
//   ...
//
//   [[link]]
//   from = "ground"        # or a mass
//   to = "floor 1"
//   stiffness = "1.1e6 N/m"  # any term of the law by the name of its option; "?" where a fit finds it
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/identify/network/fit_network.h"
#include "cromer/model/network.h"
#include "cromer/read/place.h"
#include "cromer/result.h"

namespace cromer::core {

/// Whether a name is that of a network's file, and not that of a recording: it ends in .toml.
bool is_network_file(std::string_view path);

/// What messages call a network that is in no file.
inline constexpr const char* given_network = "network";

/// A value that a file leaves open.
struct OpenValue {
  SoughtValue value{};
  std::string key{}, unit{};  ///< "stiffness", "N/m"
  Place place{};
};

struct NetworkFile {
  Network network{};
  std::vector<OpenValue> open{};  ///< 0 in the network
};

/// An Error names file, line, column and cure.
Result<NetworkFile> read_network_file(std::string_view bytes, const std::string& file);
Result<NetworkFile> open_network_file(const std::string& path);

/// The network, where no value may be open.
Result<Network> known_network(Result<NetworkFile> read);
Result<Network> read_network(std::string_view bytes, const std::string& file);
Result<Network> open_network(const std::string& path);

/// As many columns of the recording `file` as masses, or an Error.
Result<void> check_a_column_for_each_mass(const std::vector<std::string>& columns, const Network& network,
                                          const std::string& file);

}  // namespace cromer::core
