// What the page asks of the core, and what it gets: the program's own tasks, options and documents.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::page {

enum class Status { done = 0, no_success = 1, bad_input = 2 };

struct Answer {
  Status status = Status::done;
  std::string text;             ///< a JSON document; {"message": ...} of bad input
  std::vector<double> numbers;  ///< that it refers to as {"block": [first, count]}
};

/// A request is lines: the task, then "option=value" for each option, named as on the command line and
/// without dashes; one given several times is a list. `file`: the recording's bytes, of tasks that read one;
/// its name is the option "file-name".
Answer answer(std::string_view request, std::string_view file);

}  // namespace cromer::core::page
