// Which chunks of a file are finished: a line of text, then one character for each chunk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cromer/cluster/disk.h"

namespace cromer::core {

/// FILE.journal beside FILE. Its size never changes, so that a full disk cannot stop it. A chunk is marked
/// by one byte, which is either written or not. Only one program at a time can hold it.
class Journal {
 public:
  static std::string path_of(const std::string& file) { return file + ".journal"; }

  /// Makes a new journal, with nothing finished. `work` tells this work from other work; it has no line
  /// breaks.
  static Result<Journal> create(const std::string& file, std::uint64_t chunks, const std::string& work);

  /// Opens the journal of the same work. An Error if it is of other work or damaged, or if another program
  /// holds it.
  static Result<Journal> open(const std::string& file, std::uint64_t chunks, const std::string& work);

  std::vector<std::uint64_t> unfinished() const;

  /// Marks chunks as finished; returns when the marks are on the disk. Their rows must be on the disk
  /// before.
  Result<void> mark(const std::vector<std::uint64_t>& chunks) const;

  /// Removes the journal, once all is finished.
  Result<void> remove() const { return remove_file(path_); }

 private:
  Result<void> lock() const;

  std::string path_{};
  DiskFile file_{};
  std::uint64_t chunks_ = 0, begin_ = 0;  // begin_: where the characters begin [bytes]
};

}  // namespace cromer::core
