// What the program says to the shell.
#pragma once

namespace cromer::core::cli {

constexpr int done = 0;  ///< the answer is there
constexpr int no_success =
    1;  ///< the computation did not succeed: diverged, no convergence, no oscillation, interrupted
constexpr int wrong_input = 2;  ///< options, files or outputs were wrong

}  // namespace cromer::core::cli
