// Task: the methods there are, and what each really simulates.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {

/// What `cromer methods` takes: nothing, or natural frequency and step.
struct MethodsOptions {
  std::optional<double> natural_frequency{};  // [rad/s] > 0
  std::optional<double> damping_ratio{};      // >= 0; 0 by default
  std::optional<double> step{};               // [s] > 0
  std::optional<double> beta{}, gamma{};      // of newmark, 0 to 1; 1/4 and 1/2 by default
  std::optional<double> rho_inf{};            // of generalized-alpha, 0 to 1; 0.8 by default
  bool markdown = false;                      ///< print the table as docs/methods.md has it
};

/// One row of `cromer methods`.
struct MethodRow {
  std::string_view name;
  std::optional<int> order;  ///< empty for exact
  std::string order_text{};  ///< "4", "5(4)" with that of the error estimate, "exact"
  bool implicit = false;
  bool symplectic = false;  ///< said of the undamped law
  bool adaptive = false;
  bool reversible = false;
  bool a_stable = false;
  std::string_view source;               ///< where it is published
  std::optional<MethodEffect> effect{};  ///< with a step; empty for adaptive methods
  Notice words{};                        ///< the same in words
};

/// One row per method, in the order of the registry. An Error names option, value and constraint.
Result<std::vector<MethodRow>> list_methods(const MethodsOptions& options = {});

/// The table of docs/methods.md, in Markdown.
std::string methods_in_markdown();

}  // namespace cromer::core
