// Where in which file something is wrong, or worth knowing.
#pragma once

#include <string_view>

#include "cromer/result.h"

namespace cromer::core {

/// Of a line of a file whose name is not known here.
Error in_line(long line, const Error& error);
Error in_line(long line, Notice what);

/// "lab.csv: what", and "lab.csv:7: what" of a line.
Error in_file(std::string_view file, const Error& error);
Notice in_file(std::string_view file, Notice what);

/// The same of a file of an archive: `"Raw Data":7: what`.
Notice in_member(std::string_view member, Notice what);

}  // namespace cromer::core
