// The file of a recording in progress: whole lines, one after the other.
#pragma once

#include <string>
#include <vector>

#include "cromer/live/rows.h"
#include "cromer/os/descriptor.h"
#include "cromer/result.h"

namespace cromer::core {

/// Unlike all other outputs (whole or not at all), this file keeps what came, whatever happens. Each append
/// writes whole lines at once, so that a killed program leaves a valid file; sync brings them to the disk. If
/// a write fails (a full disk), the file ends with its last whole line.
class RecordingFile {
 public:
  /// Makes the file, or takes an empty one. Any other existing file is an Error.
  Result<void> open(const std::string& path);

  /// Lines that begin with "# ", then the headings.
  Result<void> begin(const std::vector<std::string>& comments, const Headings& headings);
  Result<void> append(const SampleRows& rows);
  Result<void> comment(const std::vector<std::string>& lines);
  Result<void> sync();

  /// The number of rows in the file, those of an append that failed halfway included.
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
