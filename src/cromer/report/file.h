// Whole files in, as bytes; files written whole or not at all.
#pragma once

#include <string>
#include <string_view>

#include "cromer/base/function_ref.h"
#include "cromer/result.h"

namespace cromer::core {

/// Writes by a Replacement: on failure nothing is left, and the Error names path and reason. "-" is standard
/// output. A path that is no regular file (/dev/null, a pipe) is written to directly; a symbolic link keeps
/// pointing, its target is replaced or made. An existing file keeps its permissions.
Result<void> write_file(const std::string& path, std::string_view bytes);

/// Takes the next bytes of a file; an Error where they cannot be written.
using PieceSink = FunctionRef<Result<void>(std::string_view bytes)>;
using PiecesMaker = FunctionRef<Result<void>(const PieceSink& write)>;

/// The same for a file that `make` writes piece by piece. After an Error of `make` nothing is left either.
Result<void> write_file(const std::string& path, const PiecesMaker& make);

/// Checks that `path` can be written (its folder exists and is writable, it is no folder), before long work
/// starts. Changes nothing.
Result<void> check_writable(const std::string& path);

/// The bytes of a file, or of standard input for "-". Missing, unreadable, a folder, a device, or
/// nothing but zeros at its beginning is an Error that names the path and the reason. Pipes are read to their
/// end.
Result<std::string> read_file(const std::string& path);

}  // namespace cromer::core
