// Files that are written and read at any place, and the errors of the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "cromer/os/descriptor.h"
#include "cromer/result.h"

namespace cromer::core {

/// A file open for writing and reading at any place. Errors name the file, the system's reason and, where
/// the disk is full, the cure.
class DiskFile {
 public:
  DiskFile() = default;
  /// `flags` as open(2) has them, beside O_RDWR.
  static Result<DiskFile> open(const std::string& path, int flags);
  /// A file that is there under another name until it is finished. Messages call it `name`.
  static Result<DiskFile> open_unfinished(const std::string& path, const std::string& name);

  Result<void> write(const void* bytes, std::size_t size, std::uint64_t offset) const;
  /// Returns how many bytes there were to read, at most `size`.
  std::size_t read(void* bytes, std::size_t size, std::uint64_t offset) const;
  /// Returns when the bytes are on the disk.
  Result<void> sync() const;
  int descriptor() const { return file_.number(); }

 private:
  Error not_written(int number) const;

  std::string path_{};
  bool kept_ = true;  ///< what is finished of it stays where there is no room for more
  Descriptor file_{};
};

/// Checks that a file of so many bytes has room in its folder; the Error says how much is needed and how
/// much is free.
Result<void> fits_on_disk(const std::string& path, double bytes);

/// Renames a file; returns when the folder on the disk has the new name.
Result<void> rename_file(const std::string& from, const std::string& to);

/// Removes a file, which may be absent; returns when the folder on the disk no longer has it.
Result<void> remove_file(const std::string& path);

}  // namespace cromer::core
