#include "cromer/report/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

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

/// Writes the pieces of `make` into an open file, which is called `path`.
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

namespace {

Error cannot_read(const std::string& path, Notice why) {
  return Error{"in_file", {{"file", path}, {"what", std::move(why)}}};
}

Error cannot_read(const std::string& path, int number) {
  return cannot_read(path, Notice{"cannot_be_read", {{"why", std::strerror(number)}}});
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  struct stat info {};
  const bool standard_input = path == "-";
  if (!standard_input) {
    if (stat(path.c_str(), &info) != 0) return cannot_read(path, errno);
    if (S_ISDIR(info.st_mode)) return cannot_read(path, Notice{"reads_no_folder"});
    if (S_ISCHR(info.st_mode) || S_ISBLK(info.st_mode)) return cannot_read(path, Notice{"reads_no_device"});
  }
  std::FILE* file = standard_input ? stdin : std::fopen(path.c_str(), "rb");
  if (!file) return cannot_read(path, errno);

  std::string bytes;
  std::size_t used = 0;
  const std::size_t expected = info.st_size > 0 ? static_cast<std::size_t>(info.st_size) : 0;
  while (true) {
    // One byte more than the file has, so that its end is seen without growing the buffer.
    const std::size_t room = used < expected ? expected - used + 1 : std::size_t{1} << 16;
    bytes.resize(used + room);
    const std::size_t got = std::fread(bytes.data() + used, 1, room, file);
    used += got;
    // An endless stream of zeros (/dev/zero, an empty disk) is no recording.
    if (used == got && got > 0 && bytes.find_first_not_of('\0') == std::string::npos) {
      if (!standard_input) std::fclose(file);
      return cannot_read(path, Notice{"nothing_but_zero_bytes"});
    }
    if (got < room) break;
  }
  const bool failed = std::ferror(file) != 0;
  const int reason = errno;
  if (!standard_input) std::fclose(file);
  if (failed) return cannot_read(path, reason);
  bytes.resize(used);
  return bytes;
}

}  // namespace cromer::core
