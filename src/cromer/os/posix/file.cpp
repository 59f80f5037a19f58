#include "cromer/os/file.h"

#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "cromer/os/descriptor.h"

namespace cromer::core {

bool Descriptor::end() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

namespace os {
namespace {

FileStatus status_of(const struct stat& found) {
  const mode_t mode = found.st_mode;
  const FileKind kind = S_ISREG(mode)                    ? FileKind::regular
                        : S_ISDIR(mode)                  ? FileKind::folder
                        : S_ISCHR(mode) || S_ISBLK(mode) ? FileKind::device
                                                         : FileKind::other;
  return {kind, found.st_size > 0 ? static_cast<std::uint64_t>(found.st_size) : 0};
}

/// Calls it until no signal interrupts it.
template <class Call>
std::ptrdiff_t uninterrupted(const Call& call) {
  for (;;)
    if (const ssize_t count = call(); count >= 0 || errno != EINTR) return count;
}

mode_t default_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

FileStatus status(const std::string& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0 ? status_of(found) : FileStatus{};
}

FileStatus status(int descriptor) {
  struct stat found {};
  return ::fstat(descriptor, &found) == 0 ? status_of(found) : FileStatus{};
}

bool may_write(const std::string& path) { return ::access(path.c_str(), W_OK) == 0; }

bool may_make_files_in(const std::string& folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

int open(const std::string& path, int flags) { return ::open(path.c_str(), flags | O_CLOEXEC, 0666); }

int open_to_write(const std::string& path, bool at_end) {
  const int flags = O_WRONLY | O_CLOEXEC | (at_end ? O_APPEND : 0);
  const int file = ::open(path.c_str(), flags | O_NONBLOCK);
  if (file >= 0) ::fcntl(file, F_SETFL, flags);
  return file;
}

#ifdef O_TMPFILE
// Where there is no /proc it could not be named later.
int open_unnamed(const std::string& folder) {
  if (::access("/proc/self/fd", X_OK) != 0) return -1;
  return ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
}

bool give_name(int descriptor, const std::string& path) {
  const std::string unnamed = "/proc/self/fd/" + std::to_string(descriptor);
  return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
}
#else
int open_unnamed(const std::string&) {
  errno = ENOTSUP;
  return -1;
}

bool give_name(int, const std::string&) {
  errno = ENOTSUP;
  return false;
}
#endif

int open_new(std::string& name) {
  const int file = ::mkstemp(name.data());
  if (file >= 0) ::fcntl(file, F_SETFD, FD_CLOEXEC);
  return file;
}

std::ptrdiff_t read(int descriptor, void* bytes, std::size_t size) {
  return uninterrupted([&] { return ::read(descriptor, bytes, size); });
}

std::ptrdiff_t write(int descriptor, const void* bytes, std::size_t size) {
  return uninterrupted([&] { return ::write(descriptor, bytes, size); });
}

std::ptrdiff_t read_at(int descriptor, void* bytes, std::size_t size, std::uint64_t offset) {
  return uninterrupted([&] { return ::pread(descriptor, bytes, size, static_cast<off_t>(offset)); });
}

std::ptrdiff_t write_at(int descriptor, const void* bytes, std::size_t size, std::uint64_t offset) {
  return uninterrupted([&] { return ::pwrite(descriptor, bytes, size, static_cast<off_t>(offset)); });
}

#ifdef __APPLE__
bool sync(int descriptor) { return ::fcntl(descriptor, F_FULLFSYNC) == 0 || ::fsync(descriptor) == 0; }
#else
bool sync(int descriptor) { return ::fdatasync(descriptor) == 0; }
#endif

void sync_folder(const std::string& folder) {
  const Descriptor opened(open(folder, O_RDONLY | O_DIRECTORY));
  if (opened.is_open()) ::fsync(opened.number());  // else the system does it when it likes
}

bool truncate(int descriptor, std::uint64_t size) {
  return ::ftruncate(descriptor, static_cast<off_t>(size)) == 0;
}

bool lock(int descriptor) {
  errno = 0;
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool take_permissions(int descriptor, const std::string& path) {
  struct stat there {};
  const mode_t mode = ::stat(path.c_str(), &there) == 0 ? there.st_mode & 07777 : default_permissions();
  return ::fchmod(descriptor, mode) == 0;
}

bool rename(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

bool remove(const std::string& path) { return ::unlink(path.c_str()) == 0; }

bool is_own_and_old(const std::string& path, double seconds) {
  struct stat found {};
  return ::lstat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode) && found.st_uid == ::geteuid() &&
         std::difftime(std::time(nullptr), found.st_mtime) > seconds;
}

bool is_full(int number) { return number == ENOSPC || number == EDQUOT || number == EFBIG; }

bool has_no_reader(const std::string& path, int number) {
  std::error_code failed;
  return number == ENXIO && std::filesystem::is_fifo(path, failed);
}

}  // namespace os
}  // namespace cromer::core
