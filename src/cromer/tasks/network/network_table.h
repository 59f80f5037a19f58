// A network as the table that its file is, whoever made it.
#pragma once

#include "cromer/read/toml_reader.h"
#include "cromer/result.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer::core {

/// As read_network_file(). `name` is what messages call it; of a table that stands in no file they name the
/// entry in place of line and column: network.link[2].
Result<NetworkFile> read_network_table(const toml::table& table, const std::string& name);

}  // namespace cromer::core
