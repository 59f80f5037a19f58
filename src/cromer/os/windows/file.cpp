#include "cromer/os/file.h"

#include <share.h>
#include <sys/stat.h>
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <random>

#include "cromer/os/descriptor.h"
#include "cromer/os/windows/native.h"

namespace cromer::core {

bool Descriptor::end() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::_close(number) == 0;
}

namespace os {
namespace {

namespace fs = std::filesystem;

/// More than one call takes.
constexpr std::size_t most = std::size_t{1} << 30;

int number_of(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_WRITE_PROTECT:
      return EACCES;
    case ERROR_LOCK_VIOLATION:
      return EWOULDBLOCK;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_ALREADY_EXISTS:
    case ERROR_FILE_EXISTS:
      return EEXIST;
    default:
      return EIO;
  }
}

/// Sets errno; for a return.
bool failed() {
  errno = number_of(::GetLastError());
  return false;
}

FileStatus status_of(const struct _stat64& found) {
  const auto mode = found.st_mode & _S_IFMT;
  const FileKind kind = mode == _S_IFREG   ? FileKind::regular
                        : mode == _S_IFDIR ? FileKind::folder
                        : mode == _S_IFCHR ? FileKind::device
                                           : FileKind::other;
  return {kind, found.st_size > 0 ? static_cast<std::uint64_t>(found.st_size) : 0};
}

int open_as(const std::string& path, int flags, int permissions) {
  int file = -1;
  const errno_t number =
      ::_wsopen_s(&file, native(path).c_str(), flags | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, permissions);
  if (number != 0) errno = number;
  return number == 0 ? file : -1;
}

OVERLAPPED at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  return place;
}

}  // namespace

FileStatus status(const std::string& path) {
  struct _stat64 found {};
  return ::_wstat64(native(path).c_str(), &found) == 0 ? status_of(found) : FileStatus{};
}

FileStatus status(int descriptor) {
  struct _stat64 found {};
  return ::_fstat64(descriptor, &found) == 0 ? status_of(found) : FileStatus{};
}

bool may_write(const std::string& path) { return ::_waccess(native(path).c_str(), 2) == 0; }

// Windows says so only when one is made.
bool may_make_files_in(const std::string&) { return true; }

int open(const std::string& path, int flags) { return open_as(path, flags, _S_IREAD | _S_IWRITE); }

int open_to_write(const std::string& path, bool at_end) {
  return open(path, _O_WRONLY | (at_end ? _O_APPEND : 0));
}

int open_unnamed(const std::string&) {
  errno = ENOTSUP;
  return -1;
}

bool give_name(int, const std::string&) {
  errno = ENOTSUP;
  return false;
}

int open_new(std::string& name) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";  // names know no case here
  std::random_device random;
  const std::size_t begin = name.find_last_not_of('X') + 1;
  for (int tries = 0; tries < 100; ++tries) {
    for (std::size_t i = begin; i < name.size(); ++i) name[i] = letters[random() % letters.size()];
    const int file = open(name, _O_RDWR | _O_CREAT | _O_EXCL);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

std::ptrdiff_t read(int descriptor, void* bytes, std::size_t size) {
  return ::_read(descriptor, bytes, static_cast<unsigned>(std::min(size, most)));
}

std::ptrdiff_t write(int descriptor, const void* bytes, std::size_t size) {
  return ::_write(descriptor, bytes, static_cast<unsigned>(std::min(size, most)));
}

std::ptrdiff_t read_at(int descriptor, void* bytes, std::size_t size, std::uint64_t offset) {
  OVERLAPPED place = at(offset);
  DWORD count = 0;
  if (::ReadFile(handle_of(descriptor), bytes, static_cast<DWORD>(std::min(size, most)), &count, &place))
    return count;
  if (::GetLastError() == ERROR_HANDLE_EOF) return 0;
  failed();
  return -1;
}

std::ptrdiff_t write_at(int descriptor, const void* bytes, std::size_t size, std::uint64_t offset) {
  OVERLAPPED place = at(offset);
  DWORD count = 0;
  if (::WriteFile(handle_of(descriptor), bytes, static_cast<DWORD>(std::min(size, most)), &count, &place))
    return count;
  failed();
  return -1;
}

bool sync(int descriptor) { return ::_commit(descriptor) == 0; }

void sync_folder(const std::string&) {}

bool truncate(int descriptor, std::uint64_t size) {
  const errno_t number = ::_chsize_s(descriptor, static_cast<long long>(size));
  if (number != 0) errno = number;
  return number == 0;
}

// Far behind the end: what is locked here cannot be read by others.
bool lock(int descriptor) {
  OVERLAPPED place = at(std::uint64_t{1} << 62);
  return ::LockFileEx(handle_of(descriptor), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                      &place) != 0 ||
         failed();
}

// A new file has its folder's.
bool take_permissions(int, const std::string&) { return true; }

bool rename(const std::string& from, const std::string& to) {
  return ::MoveFileExW(native(from).c_str(), native(to).c_str(),
                       MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0 ||
         failed();
}

bool remove(const std::string& path) { return ::_wunlink(native(path).c_str()) == 0; }

bool is_own_and_old(const std::string& path, double seconds) {
  std::error_code failed;
  const fs::path file = native(path);
  if (!fs::is_regular_file(fs::symlink_status(file, failed)) || failed) return false;
  const auto changed = fs::last_write_time(file, failed);
  return !failed && fs::file_time_type::clock::now() - changed > std::chrono::duration<double>(seconds);
}

bool is_full(int number) { return number == ENOSPC || number == EFBIG; }

bool has_no_reader(const std::string&, int) { return false; }

}  // namespace os
}  // namespace cromer::core
