#include "cromer/report/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

namespace cromer {
namespace {

namespace fs = std::filesystem;

Error cannot_write(const std::string& path, int number) {
  return {fmt::format("cannot write {}: {}", path, std::strerror(number))};
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// The file the path stands for: symbolic links are followed, so that the link stays one.
std::string target_of(const std::string& path) {
  std::error_code failed;
  if (!fs::is_symlink(path, failed)) return path;
  const fs::path target = fs::weakly_canonical(path, failed);
  return failed ? path : target.string();
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

mode_t default_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// What `make` gives, into an open file; `path` is what it is called.
Result<void> write_pieces(int file, const std::string& path, const PiecesMaker& make) {
  return make([&](std::string_view bytes) -> Result<void> {
    if (!write_all(file, bytes)) return cannot_write(path, errno);
    return {};
  });
}

Result<void> write_directly(const std::string& path, const PiecesMaker& make) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return cannot_write(path, errno);
  const auto written = write_pieces(file, path, make);
  ::close(file);
  return written;
}

}  // namespace

Result<void> write_file(const std::string& path, std::string_view bytes) {
  return write_file(path, [&](const PieceSink& write) { return write(bytes); });
}

Result<void> write_file(const std::string& path, const PiecesMaker& make) {
  if (path == "-") return write_pieces(STDOUT_FILENO, "standard output", make);
  if (path.empty()) return Error{"cannot write a file without a name"};
  struct stat found {};
  const bool exists = ::stat(path.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) return Error{fmt::format("cannot write {}: it is a folder", path)};
  if (exists && !S_ISREG(found.st_mode)) return write_directly(path, make);
  if (exists && ::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);

  const std::string target = target_of(path);
  std::string temporary = folder_of(target) + "/.cromer-XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) return cannot_write(path, errno);
  const mode_t mode = exists ? found.st_mode & 07777 : default_permissions();
  const auto written = write_pieces(file, path, make);
  bool done = written && ::fchmod(file, mode) == 0;
  int number = errno;
  if (::close(file) != 0 && done) done = false, number = errno;
  if (done && ::rename(temporary.c_str(), target.c_str()) != 0) done = false, number = errno;
  if (!done) {
    ::unlink(temporary.c_str());
    return written ? Result<void>(cannot_write(path, number)) : written;
  }
  return {};
}

Result<void> check_writable(const std::string& path) {
  if (path == "-") return {};
  if (path.empty()) return Error{"cannot write a file without a name"};
  struct stat found {};
  if (::stat(path.c_str(), &found) == 0) {
    if (S_ISDIR(found.st_mode)) return Error{fmt::format("cannot write {}: it is a folder", path)};
    if (::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);
    if (!S_ISREG(found.st_mode)) return {};
  } else if (errno == ENOTDIR) {
    return cannot_write(path, errno);
  }
  const std::string folder = folder_of(target_of(path));
  if (::stat(folder.c_str(), &found) != 0)
    return Error{fmt::format("cannot write {}: there is no folder {}", path, folder)};
  if (!S_ISDIR(found.st_mode)) return Error{fmt::format("cannot write {}: {} is no folder", path, folder)};
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return cannot_write(path, errno);
  return {};
}

}  // namespace cromer
