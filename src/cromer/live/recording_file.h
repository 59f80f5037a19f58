// The file of a recording in progress: whole lines, one after the other.
#pragma once

#include <string>
#include <vector>

#include "cromer/live/descriptor.h"
#include "cromer/live/rows.h"
#include "cromer/result.h"

namespace cromer::core {

/// Not the rule of all other outputs (whole or not at all): what came is kept, whatever happens. Each append
/// is written at once, in whole lines, so that a program that is killed leaves a valid file; sync brings it
/// to the disk. Where a write fails (a disk that is full), the file ends with the last line that is whole.
class RecordingFile {
 public:
  /// Makes the file, or takes one that is empty; any other that exists is an Error that says so.
  Result<void> open(const std::string& path);

  /// Lines that begin with "# ", then the headings.
  Result<void> begin(const std::vector<std::string>& comments, const Headings& headings);
  Result<void> append(const Rows& rows);
  Result<void> comment(const std::vector<std::string>& lines);
  Result<void> sync();

  /// Rows in the file, those of an append that failed halfway included.
  std::size_t rows() const { return rows_; }

  /// Removes a file in which nothing was written.
  void drop_if_empty();

 private:
  Result<void> write(std::string_view lines);
  void count(std::string_view written);
  bool cut();

  std::string path_;
  Descriptor file_;
  bool made_ = false;
  std::size_t bytes_ = 0, lines_ = 0, rows_ = 0;  ///< that are whole
};

}  // namespace cromer::core
