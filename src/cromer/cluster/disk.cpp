#include "cromer/cluster/disk.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "cromer/base/quantity.h"
#include "cromer/base/replacement.h"

namespace cromer::core {
namespace {

/// What to do if the disk is full; empty for any other error.
Notice cure(int number) { return is_full(number) ? Notice{"finished_is_kept"} : Notice{}; }

Error not_opened(const std::string& path, int number) {
  return Error{"cannot_open", {{"path", path}, {"why", std::strerror(number)}, {"cure", cure(number)}}};
}

Error not_written(const std::string& path, int number) {
  return Error{"cannot_write_there",
               {{"path", path}, {"why", std::strerror(number)}, {"cure", cure(number)}}};
}

Error not_removed(const std::string& path, int number) {
  return Error{"cannot_remove", {{"path", path}, {"why", std::strerror(number)}, {"cure", cure(number)}}};
}

void sync_folder(const std::string& path) {
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // then the system does it when it likes
  ::fsync(folder);
  ::close(folder);
}

}  // namespace

Result<DiskFile> DiskFile::open(const std::string& path, int flags) {
  DiskFile opened;
  opened.path_ = path;
  opened.file_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
  if (opened.file_ < 0) return not_opened(path, errno);
  return opened;
}

Result<DiskFile> DiskFile::open_unfinished(const std::string& path, const std::string& name) {
  DiskFile opened;
  opened.path_ = name;
  opened.kept_ = false;
  opened.file_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (opened.file_ < 0) return cannot_write(name, errno);
  return opened;
}

Error DiskFile::not_written(int number) const {
  return kept_ ? core::not_written(path_, number) : cannot_write(path_, number);
}

DiskFile::~DiskFile() {
  if (file_ >= 0) ::close(file_);
}

Result<void> DiskFile::write(const void* bytes, std::size_t size, std::uint64_t offset) const {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t count = ::pwrite(file_, from, size, static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return not_written(errno);
    if (count == 0) return not_written(ENOSPC);
    from += count;
    size -= static_cast<std::size_t>(count);
    offset += static_cast<std::uint64_t>(count);
  }
  return {};
}

std::size_t DiskFile::read(void* bytes, std::size_t size, std::uint64_t offset) const {
  std::size_t there = 0;
  while (there < size) {
    const ssize_t count =
        ::pread(file_, static_cast<char*>(bytes) + there, size - there, static_cast<off_t>(offset + there));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    there += static_cast<std::size_t>(count);
  }
  return there;
}

Result<void> DiskFile::sync() const {
  if (::fdatasync(file_) != 0) return not_written(errno);
  return {};
}

Result<void> fits_on_disk(const std::string& path, double bytes) {
  struct statvfs disk {};
  if (::statvfs(folder_of(path).c_str(), &disk) != 0) return {};  // opening will say why
  const double free = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  if (bytes <= free) return {};
  return Error{"disk_too_small",
               {{"path", path},
                {"needed", bytes_in_words(bytes)},
                {"free", bytes_in_words(free)},
                {"folder", folder_of(path)}}};
}

Result<void> rename_file(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) return not_written(to, errno);
  sync_folder(to);
  return {};
}

Result<void> remove_file(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return not_removed(path, errno);
  sync_folder(path);
  return {};
}

}  // namespace cromer::core
