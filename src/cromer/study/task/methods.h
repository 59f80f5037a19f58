// Task: the methods there are.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace cromer {

/// One row of `cromer methods`.
struct MethodRow {
  std::string_view name;
  std::optional<int> order;  ///< empty for exact
  bool implicit = false;
  bool symplectic = false;  ///< said of the undamped law
  bool adaptive = false;
  std::string_view source;  ///< where it is published
};

/// One row per method, in the order of the registry.
std::vector<MethodRow> list_methods();

}  // namespace cromer
