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
//   stiffness = "1.1e6 N/m"  # any term of the law by the name of its option
#pragma once

#include <string>
#include <string_view>

#include "cromer/model/network.h"
#include "cromer/result.h"

namespace cromer::core {

/// Whether a name is that of a network's file, and not that of a recording: it ends in .toml.
bool is_network_file(std::string_view path);

/// An Error names file, line, column and cure.
Result<Network> read_network(std::string_view bytes, const std::string& file);
Result<Network> open_network(const std::string& path);

}  // namespace cromer::core
