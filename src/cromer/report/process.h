// Runs another program, feeds it a text and collects what it writes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/result.h"

namespace cromer {

struct ProcessOutput {
  std::string out, err;
  int exit_status = 0;  ///< 128 + signal where a signal ended it
};

/// `arguments[0]` is searched in PATH; no shell is involved. `input` is handed over as a file without a name:
/// any size, no pipe to break. An Error only where the program could not be run at all; its message is the
/// system's reason.
Result<ProcessOutput> run_process(const std::vector<std::string>& arguments, std::string_view input);

}  // namespace cromer
