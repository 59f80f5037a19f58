// Many recordings at once: which files, and the work on each of them on all processors.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/notice.h"
#include "cromer/result.h"

namespace cromer::core::cli {

/// What was named on the command line, folders opened.
struct RecordingFiles {
  std::vector<std::string> files;  ///< in the order named, a folder's by name, capitals first
  bool many = false;               ///< more than one file, or a folder, was named: the answer is a list
  bool of_folder = false;          ///< a folder was named
  std::vector<Notice> notes;       ///< what of a folder was left aside
};

/// A folder stands for the files right in it whose ending is that of a recording. One without any is an
/// Error.
Result<RecordingFiles> recording_files(const std::vector<std::string>& named);

/// Calls `work` with each index below `count`, on as many threads as there are processors; `watch` tells the
/// progress of all together. After an interruption no further one is begun.
void for_each_file(std::size_t count, const Watch& watch,
                   FunctionRef<void(std::size_t i, const Watch& watch)> work);

/// Those of `all` that are not `done`, in their order.
std::vector<std::string> missing_of(const std::vector<std::string>& all,
                                    const std::vector<std::string>& done);

/// "interrupted; what follows are the fits of 3 of 5 files; missing: d.csv, e.csv": of `all` files.
std::string interrupted_at(std::string_view results, std::string_view things, std::size_t all,
                           std::vector<std::string> missing);

}  // namespace cromer::core::cli
