// Lines to read from: a raw serial one, a TCP connection, and waiting for either.
#pragma once

#include <string>
#include <string_view>

#include "cromer/os/descriptor.h"
#include "cromer/result.h"

namespace cromer::core {

/// Raw: eight bits, no echo, no flow control. A device without a speed (a pseudo-terminal) takes any.
Result<Descriptor> open_serial(const std::string& device, int baud);

/// Tries each address of the host for at most `seconds`.
Result<Descriptor> open_tcp(const std::string& host, int port, double seconds);

/// Waits at most `seconds` for something to read or for the end of the input; whether either came.
bool readable(const Descriptor& descriptor, double seconds);

/// Sends all of it over a TCP connection; false where the other side is gone.
bool send_all(const Descriptor& connection, std::string_view bytes);

/// A second descriptor of standard input.
Descriptor standard_input_again();

}  // namespace cromer::core
