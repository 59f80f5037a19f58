// Adds the file, the line and the run to what an error or a notice says.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

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

/// "run 2: what"
Notice in_run(int run, Notice what);

/// What there is to say of several runs of a file, each with the run that it is about. What is said of
/// several runs is said once, with all of them.
class OfRuns {
 public:
  void say(int run, const Notice& what);
  std::vector<Notice> said() const;  ///< in the order in which it was said first

 private:
  std::vector<std::pair<Notice, std::vector<int>>> said_;
};

}  // namespace cromer::core
