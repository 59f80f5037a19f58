// How others reach this computer.
#pragma once

#include <string>
#include <vector>

namespace cromer::core::serve {

/// The numbers that a server at `address` is reached at: of 0.0.0.0 all IPv4 addresses of this computer but
/// the loopback's (that one where there are no others), else the address itself, [in brackets] where it has
/// colons.
std::vector<std::string> reached_at(const std::string& address);

}  // namespace cromer::core::serve
