// Bytes at their places in a file, and what the disk says to that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "cromer/result.h"

namespace cromer::core {

/// A file opened for writing at places. Errors name the file, the system's reason and, where the disk is
/// full, the cure.
class DiskFile {
 public:
  DiskFile() = default;
  /// `flags` as open(2) has them, beside O_RDWR.
  static Result<DiskFile> open(const std::string& path, int flags);
  DiskFile(DiskFile&& other) noexcept
      : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}
  DiskFile& operator=(DiskFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    return *this;
  }
  ~DiskFile();

  Result<void> write(const void* bytes, std::size_t size, std::uint64_t offset) const;
  /// How many bytes were there to read, at most `size`.
  std::size_t read(void* bytes, std::size_t size, std::uint64_t offset) const;
  /// Comes back when the bytes are on the disk.
  Result<void> sync() const;
  int descriptor() const { return file_; }

 private:
  std::string path_{};
  int file_ = -1;
};

/// That a file of so many bytes has room in its folder; the Error says how much is needed and how much there
/// is.
Result<void> fits_on_disk(const std::string& path, double bytes);

/// Renames, and comes back when the folder knows it on the disk.
Result<void> rename_file(const std::string& from, const std::string& to);

/// Removes, likewise; it may be absent.
Result<void> remove_file(const std::string& path);

}  // namespace cromer::core
