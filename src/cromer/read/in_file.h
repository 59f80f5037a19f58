// Adds the file and the line to what an error or a notice says.
#pragma once

#include <string_view>

#include "cromer/result.h"

namespace cromer::core {

/// For a line of a file whose name is not known here; in_file adds it.
Error in_line(long line, const Error& error);
Error in_line(long line, Notice what);

/// "lab.csv: what", or "lab.csv:7: what" where in_line named the line.
Error in_file(std::string_view file, const Error& error);
Notice in_file(std::string_view file, Notice what);

/// The same for a file of an archive: `"Raw Data":7: what`.
Notice in_member(std::string_view member, Notice what);

/// in_file taken back, where the file's name stands beside the notice: "what", or "line 7: what". Any other
/// notice as it is.
Notice without_file(const Notice& notice, std::string_view file);

}  // namespace cromer::core
