// Where samples come from, as it is typed: serial:DEVICE[:BAUD], tcp:HOST:PORT, phyphox:HOST[:PORT] or -.
#pragma once

#include <string>
#include <string_view>

#include "cromer/result.h"

namespace cromer::core {

enum class SourceKind { serial, tcp, phyphox, standard_input };

struct SourceName {
  SourceKind kind = SourceKind::standard_input;
  std::string place{};  ///< the device's path, or the host (an IPv6 address without its brackets)
  int number = 0;       ///< baud (115200 by default), or the port (phyphox: 8080)
};

/// An Error says what was typed and what can be.
Result<SourceName> parse_source(std::string_view text);

}  // namespace cromer::core
