// Requests of the page and their answers: the program's own tasks, options and documents.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::page {

enum class Status { done = 0, no_success = 1, bad_input = 2 };

struct Answer {
  Status status = Status::done;
  std::string text;             ///< a JSON document; {"message": ...} after bad input
  std::vector<double> numbers;  ///< which the document refers to as {"block": [first, count]}
};

/// A request is lines of text: the task, then "option=value" for each option. Options are named as on the
/// command line, without dashes; one that is given several times is a list. `file` is the recording of tasks
/// that read one; its name is the option "file-name".
Answer answer(std::string_view request, std::string_view file);

}  // namespace cromer::core::page
