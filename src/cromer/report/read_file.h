// Whole files in, as bytes.
#pragma once

#include <string>

#include "cromer/result.h"

namespace cromer::core {

/// The bytes of a file, or of standard input for "-". Missing, unreadable, a folder, a device, or
/// nothing but zeros at its beginning is an Error that names the path and the reason. Pipes are read to their
/// end.
Result<std::string> read_file(const std::string& path);

}  // namespace cromer::core
