#include "cromer/os/replacement.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "cromer/os/file.h"

namespace cromer::core {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".cromer-";
constexpr std::size_t suffix = 6;  // characters

std::string pattern_in(const std::string& folder) {
  return fmt::format("{}/{}{}", folder, prefix, std::string(suffix, 'X'));
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
    const std::string path = each->path().string();
    if (name.starts_with(prefix) && name.size() == prefix.size() + suffix && os::is_own_and_old(path, old))
      os::remove(path);
  }
}

}  // namespace

Error cannot_write(const std::string& path, int number) {
  if (os::has_no_reader(path, number))
    return Error{"cannot_write", {{"path", path}, {"why", Notice{"no_reader_of_pipe"}}}};
  if (os::is_full(number))
    return Error{"cannot_write",
                 {{"path", path}, {"why", Notice{"no_room", {{"why", std::strerror(number)}}}}}};
  return Error{"cannot_write", {{"path", path}, {"why", std::strerror(number)}}};
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
  Replacement made(path, target_of(path));
  const std::string folder = folder_of(made.target_);
  sweep(folder);
  made.file_ = Descriptor(os::open_unnamed(folder));
  if (made.file_.is_open()) return made;
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
  file_ = Descriptor(os::open_new(free));
  if (!file_.is_open()) return false;
  temporary_ = std::move(free);
  return true;
}

Replacement::Replacement(Replacement&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, "")),
      file_(std::move(other.file_)) {}

Replacement::~Replacement() {
  file_.close();
  if (!temporary_.empty()) os::remove(temporary_);
}

// A link cannot replace a file that is there, so the new file first gets a name of its own.
bool Replacement::give_name() {
  for (int tries = 0; tries < 100; ++tries) {
    std::string free = pattern_in(folder_of(target_));
    if (!Descriptor(os::open_new(free)).is_open()) return false;
    os::remove(free);
    if (os::give_name(file_.number(), free)) {
      temporary_ = free;
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

Result<void> Replacement::take_place() {
  if (!os::take_permissions(file_.number(), target_)) return cannot_write(path_, errno);
  if (temporary_.empty()) {
    if (os::give_name(file_.number(), target_)) return {};
    if (errno != EEXIST || !give_name()) return cannot_write(path_, errno);
  }
  if (!file_.end() || !os::rename(temporary_, target_)) return cannot_write(path_, errno);
  temporary_.clear();
  return {};
}

}  // namespace cromer::core
