#include "cromer/report/read_file.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace cromer::core {
namespace {

Error cannot_read(const std::string& path, int number) {
  return Error{"in_file",
               {{"file", path}, {"what", Notice{"cannot_be_read", {{"why", std::strerror(number)}}}}}};
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  struct stat info {};
  const bool standard_input = path == "-";
  if (!standard_input) {
    if (stat(path.c_str(), &info) != 0) return cannot_read(path, errno);
    if (S_ISDIR(info.st_mode)) return Error{"reads_no_folder", {{"path", path}}};
    if (S_ISCHR(info.st_mode) || S_ISBLK(info.st_mode)) return Error{"reads_no_device", {{"path", path}}};
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
      return Error{"nothing_but_zero_bytes", {{"path", path}}};
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
