// Many recordings at once: which files, and their fits on all processors.
#pragma once

#include <string>
#include <vector>

#include "cromer/tasks/fit/fit.h"

namespace cromer::core::cli {

/// What was named on the command line, folders opened.
struct RecordingFiles {
  std::vector<std::string> files;  ///< in the order named, a folder's by name, capitals first
  bool many = false;               ///< more than one file, or a folder, was named: the answer is a list
  std::vector<Notice> notes;       ///< what of a folder was left aside
};

/// A folder stands for the files right in it whose ending is that of a recording. One without any is an
/// Error.
Result<RecordingFiles> recording_files(const std::vector<std::string>& named);

/// The fits of all files in their order, each file's as if it were alone, on as many threads as there are
/// processors. A file that cannot be read is a row that says why. After an interruption the files that were
/// not begun are missing.
std::vector<FittedRecording> fit_files(const std::vector<std::string>& files, const FitOptions& options,
                                       const Watch& watch);

}  // namespace cromer::core::cli
