// The commands: one file each, listed in main.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::cli {

/// What stands on the command line after the command's name.
using Arguments = std::vector<std::string>;

// What the program says to the shell.
constexpr int done = 0;  ///< the answer is there
constexpr int no_success =
    1;  ///< the computation did not succeed: diverged, no convergence, no oscillation, interrupted
constexpr int wrong_input = 2;  ///< options, files or outputs were wrong

struct Command {
  std::string_view name;
  std::string_view description;  ///< one line
  int (*run)(const Arguments& arguments);
};

int run_simulate(const Arguments& arguments);
int run_methods(const Arguments& arguments);
int run_modes(const Arguments& arguments);
int run_inspect(const Arguments& arguments);
int run_fit(const Arguments& arguments);
int run_compare(const Arguments& arguments);
int run_sweep(const Arguments& arguments);
int run_spectrum(const Arguments& arguments);
int run_record(const Arguments& arguments);
int run_serve(const Arguments& arguments);
int run_report(const Arguments& arguments);

/// Whether an option says what stands on a report's page, as its title.
bool is_option_of_page(std::string_view name);

}  // namespace cromer::core::cli
