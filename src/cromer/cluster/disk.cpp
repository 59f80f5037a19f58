#include "cromer/cluster/disk.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cromer/base/quantity.h"
#include "cromer/os/file.h"
#include "cromer/os/replacement.h"

namespace cromer::core {
namespace {

/// What to do if the disk is full; empty for any other error.
Notice cure(int number) { return os::is_full(number) ? Notice{"finished_is_kept"} : Notice{}; }

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

}  // namespace

Result<DiskFile> DiskFile::open(const std::string& path, int flags) {
  DiskFile opened;
  opened.path_ = path;
  opened.file_ = Descriptor(os::open(path, O_RDWR | flags));
  if (!opened.file_.is_open()) return not_opened(path, errno);
  return opened;
}

Result<DiskFile> DiskFile::open_unfinished(const std::string& path, const std::string& name) {
  DiskFile opened;
  opened.path_ = name;
  opened.kept_ = false;
  opened.file_ = Descriptor(os::open(path, O_RDWR));
  if (!opened.file_.is_open()) return cannot_write(name, errno);
  return opened;
}

Error DiskFile::not_written(int number) const {
  return kept_ ? core::not_written(path_, number) : cannot_write(path_, number);
}

Result<void> DiskFile::write(const void* bytes, std::size_t size, std::uint64_t offset) const {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const auto count = os::write_at(file_.number(), from, size, offset);
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
    const auto count =
        os::read_at(file_.number(), static_cast<char*>(bytes) + there, size - there, offset + there);
    if (count <= 0) break;
    there += static_cast<std::size_t>(count);
  }
  return there;
}

Result<void> DiskFile::sync() const {
  if (!os::sync(file_.number())) return not_written(errno);
  return {};
}

Result<void> fits_on_disk(const std::string& path, double bytes) {
  std::error_code failed;
  const auto disk = std::filesystem::space(folder_of(path), failed);
  if (failed) return {};  // opening will say why
  const double free = static_cast<double>(disk.available);
  if (bytes <= free) return {};
  return Error{"disk_too_small",
               {{"path", path},
                {"needed", bytes_in_words(bytes)},
                {"free", bytes_in_words(free)},
                {"folder", folder_of(path)}}};
}

Result<void> rename_file(const std::string& from, const std::string& to) {
  if (!os::rename(from, to)) return not_written(to, errno);
  os::sync_folder(folder_of(to));
  return {};
}

Result<void> remove_file(const std::string& path) {
  if (!os::remove(path) && errno != ENOENT) return not_removed(path, errno);
  os::sync_folder(folder_of(path));
  return {};
}

}  // namespace cromer::core
