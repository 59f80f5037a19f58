// Which chunks of a file are finished: a line of text, then one character for each chunk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cromer/cluster/disk.h"

namespace cromer::core {

/// FILE.journal beside FILE. Its size never changes, so that a full disk cannot stop it, and a chunk is
/// marked by one byte, which is written or not. One program at a time has it.
class Journal {
 public:
  static std::string path_of(const std::string& file) { return file + ".journal"; }

  /// Makes it anew: nothing finished. `work` tells this work from others, without line breaks.
  static Result<Journal> create(const std::string& file, std::uint64_t chunks, const std::string& work);

  /// Opens that of the same work; an Error where it is of another, damaged, or another program has it.
  static Result<Journal> open(const std::string& file, std::uint64_t chunks, const std::string& work);

  std::vector<std::uint64_t> unfinished() const;

  /// Comes back when the marks are on the disk. What they stand for must be there before.
  Result<void> mark(const std::vector<std::uint64_t>& chunks) const;

  /// All is finished: takes the journal away.
  Result<void> remove() const { return remove_file(path_); }

 private:
  Result<void> lock() const;

  std::string path_{};
  DiskFile file_{};
  std::uint64_t chunks_ = 0, begin_ = 0;  // begin_: where the characters begin [bytes]
};

}  // namespace cromer::core
