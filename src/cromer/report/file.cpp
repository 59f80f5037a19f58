#include "cromer/report/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cromer/base/replacement.h"

namespace cromer::core {
namespace {

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// What `make` gives, into an open file; `path` is what it is called.
Result<void> write_pieces(int file, const std::string& path, const PiecesMaker& make) {
  return make([&](std::string_view bytes) -> Result<void> {
    if (!write_all(file, bytes)) return cannot_write(path, errno);
    return {};
  });
}

Result<void> write_directly(const std::string& path, const PiecesMaker& make) {
  const int file = open_to_write(path, false);
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
  if (path.empty()) return Error{"file_without_name"};
  struct stat found {};
  const bool exists = ::stat(path.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) return Error{"cannot_write_folder", {{"path", path}}};
  if (exists && !S_ISREG(found.st_mode)) return write_directly(path, make);
  if (exists && ::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);

  auto fresh = Replacement::beside(path);
  if (!fresh) return fresh.error();
  if (auto written = write_pieces(fresh->descriptor(), path, make); !written) return written;
  return fresh->take_place();
}

Result<void> check_writable(const std::string& path) {
  if (path == "-") return {};
  if (path.empty()) return Error{"file_without_name"};
  struct stat found {};
  if (::stat(path.c_str(), &found) == 0) {
    if (S_ISDIR(found.st_mode)) return Error{"cannot_write_folder", {{"path", path}}};
    if (::access(path.c_str(), W_OK) != 0) return cannot_write(path, errno);
    if (!S_ISREG(found.st_mode)) return {};
  } else if (errno == ENOTDIR) {
    return cannot_write(path, errno);
  }
  const std::string folder = folder_of(target_of(path));
  if (::stat(folder.c_str(), &found) != 0)
    return Error{"cannot_write_without_folder", {{"path", path}, {"folder", folder}}};
  if (!S_ISDIR(found.st_mode))
    return Error{"cannot_write_in_no_folder", {{"path", path}, {"folder", folder}}};
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return cannot_write(path, errno);
  return {};
}

}  // namespace cromer::core
