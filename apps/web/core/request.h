// A request of the page, taken apart.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core::page {

struct Request {
  std::string task;
  std::vector<TypedOption> settings{};  ///< in the order given
  std::string file_name = "recording";
};

/// An Error names a line that is not "option=value".
Result<Request> read_request(std::string_view text);

/// Takes a setting out, where it is there: those that are the page's own.
std::string take(Request& request, std::string_view name, std::string_view otherwise = "");

/// Every setting into its option. An Error names an option that is not in the table, or what is wrong with
/// the value, as the command line says it.
Result<void> assign(const Request& request, const std::vector<Option>& options);

}  // namespace cromer::core::page
