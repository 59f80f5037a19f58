#include "cromer/base/replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace cromer::core {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".cromer-";
constexpr std::size_t suffix = 6;  // characters

std::string pattern_in(const std::string& folder) {
  return fmt::format("{}/{}{}", folder, prefix, std::string(suffix, 'X'));
}

mode_t default_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

// Removes what killed programs left in a folder; once for each folder.
void sweep(const std::string& folder) {
  constexpr double old = 3600;  // [s]
  static std::mutex mutex;
  static std::set<std::string> swept;
  {
    const std::lock_guard lock(mutex);
    if (!swept.insert(folder).second) return;
  }
  std::error_code failed;
  for (fs::directory_iterator each(folder, failed), end; !failed && each != end; each.increment(failed)) {
    const std::string name = each->path().filename().string();
    struct stat found {};
    if (!name.starts_with(prefix) || name.size() != prefix.size() + suffix ||
        ::lstat(each->path().c_str(), &found) != 0)
      continue;
    if (S_ISREG(found.st_mode) && found.st_uid == ::geteuid() &&
        std::difftime(std::time(nullptr), found.st_mtime) > old)
      ::unlink(each->path().c_str());
  }
}

// The path of an open file that has no name.
std::string place_of(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

}  // namespace

Error cannot_write(const std::string& path, int number) {
  std::error_code failed;
  const bool unread = number == ENXIO && fs::is_fifo(path, failed);
  if (unread) return Error{"cannot_write", {{"path", path}, {"why", Notice{"no_reader_of_pipe"}}}};
  if (is_full(number))
    return Error{"cannot_write",
                 {{"path", path}, {"why", Notice{"no_room", {{"why", std::strerror(number)}}}}}};
  return Error{"cannot_write", {{"path", path}, {"why", std::strerror(number)}}};
}

bool is_full(int number) { return number == ENOSPC || number == EDQUOT || number == EFBIG; }

int open_to_write(const std::string& path, bool at_end) {
  const int flags = O_WRONLY | O_CLOEXEC | (at_end ? O_APPEND : 0);
  const int file = ::open(path.c_str(), flags | O_NONBLOCK);
  if (file >= 0) ::fcntl(file, F_SETFL, flags);
  return file;
}

std::string target_of(const std::string& path) {
  constexpr int most = 40;  // links, as the system follows them
  fs::path target = path;
  std::error_code failed;
  for (int i = 0; i < most && fs::is_symlink(target, failed); ++i) {
    const fs::path next = fs::read_symlink(target, failed);
    if (failed) return path;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

Result<Replacement> Replacement::beside(const std::string& path) {
#ifdef O_TMPFILE
  Replacement made(path, target_of(path));
  const std::string folder = folder_of(made.target_);
  sweep(folder);
  made.descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (made.descriptor_ >= 0) return made;
#endif
  return named_beside(path);
}

Result<Replacement> Replacement::named_beside(const std::string& path) {
  Replacement made(path, target_of(path));
  sweep(folder_of(made.target_));
  if (!made.make_named()) return cannot_write(path, errno);
  return made;
}

bool Replacement::make_named() {
  std::string free = pattern_in(folder_of(target_));
  descriptor_ = ::mkostemp(free.data(), O_CLOEXEC);
  if (descriptor_ < 0) return false;
  temporary_ = std::move(free);
  return true;
}

Replacement::Replacement(Replacement&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, "")),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

Replacement::~Replacement() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

// A link cannot replace a file that is there, so the new file first gets a name of its own.
bool Replacement::give_name() {
  const std::string unnamed = place_of(descriptor_);
  for (int tries = 0; tries < 100; ++tries) {
    std::string free = pattern_in(folder_of(target_));
    const int taken = ::mkostemp(free.data(), O_CLOEXEC);
    if (taken < 0) return false;
    ::close(taken);
    ::unlink(free.c_str());
    if (::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, free.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      temporary_ = free;
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

Result<void> Replacement::take_place() {
  struct stat before {};
  const mode_t mode = ::stat(target_.c_str(), &before) == 0 ? before.st_mode & 07777 : default_permissions();
  if (::fchmod(descriptor_, mode) != 0) return cannot_write(path_, errno);
  if (temporary_.empty()) {
    if (::linkat(AT_FDCWD, place_of(descriptor_).c_str(), AT_FDCWD, target_.c_str(), AT_SYMLINK_FOLLOW) == 0)
      return {};
    if (errno != EEXIST || !give_name()) return cannot_write(path_, errno);
  }
  // On a network drive, closing may be what shows that a file was not written.
  if (::close(std::exchange(descriptor_, -1)) != 0) return cannot_write(path_, errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return cannot_write(path_, errno);
  temporary_.clear();
  return {};
}

}  // namespace cromer::core
