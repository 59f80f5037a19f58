#include "cromer/report/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/os/file.h"
#include "cromer/os/process.h"
#include "cromer/os/replacement.h"

namespace cromer::core {
namespace {

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = os::write(file, bytes.data(), bytes.size());
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
  const Descriptor file(os::open_to_write(path, false));
  if (!file.is_open()) return cannot_write(path, errno);
  return write_pieces(file.number(), path, make);
}

}  // namespace

Result<void> write_file(const std::string& path, std::string_view bytes) {
  return write_file(path, [&](const PieceSink& write) { return write(bytes); });
}

Result<void> write_file(const std::string& path, const PiecesMaker& make) {
  if (path == "-") return write_pieces(os::standard_output, "standard output", make);
  if (path.empty()) return Error{"file_without_name"};
  const os::FileKind there = os::status(path).kind;
  if (there == os::FileKind::folder) return Error{"cannot_write_folder", {{"path", path}}};
  if (there != os::FileKind::none && there != os::FileKind::regular) return write_directly(path, make);
  if (there != os::FileKind::none && !os::may_write(path)) return cannot_write(path, errno);

  auto fresh = Replacement::beside(path);
  if (!fresh) return fresh.error();
  if (auto written = write_pieces(fresh->descriptor(), path, make); !written) return written;
  return fresh->take_place();
}

Result<void> check_writable(const std::string& path) {
  if (path == "-") return {};
  if (path.empty()) return Error{"file_without_name"};
  if (const os::FileKind there = os::status(path).kind; there != os::FileKind::none) {
    if (there == os::FileKind::folder) return Error{"cannot_write_folder", {{"path", path}}};
    if (!os::may_write(path)) return cannot_write(path, errno);
    if (there != os::FileKind::regular) return {};
  } else if (errno == ENOTDIR) {
    return cannot_write(path, errno);
  }
  const std::string folder = folder_of(target_of(path));
  const os::FileKind place = os::status(folder).kind;
  if (place == os::FileKind::none)
    return Error{"cannot_write_without_folder", {{"path", path}, {"folder", folder}}};
  if (place != os::FileKind::folder)
    return Error{"cannot_write_in_no_folder", {{"path", path}, {"folder", folder}}};
  if (!os::may_make_files_in(folder)) return cannot_write(path, errno);
  return {};
}

namespace {

Error cannot_read(const std::string& path, Notice why) {
  return Error{"in_file", {{"file", path}, {"what", std::move(why)}}};
}

/// Where a file is not there: the one beside it whose name, but for the extension, is nearest; "" if none is.
std::string file_meant(const std::filesystem::path& path) {
  std::error_code failed;
  std::map<std::string, std::string> by_stem;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator each(folder, failed), end; !failed && each != end;
       each.increment(failed)) {
    std::error_code unknown;
    const std::filesystem::path& beside = each->path();
    if (each->is_regular_file(unknown))
      by_stem.try_emplace(beside.stem().string(), beside.filename().string());
  }
  std::vector<std::string_view> stems;
  for (const auto& [stem, name] : by_stem) stems.push_back(stem);
  const std::string near = nearest(path.stem().string(), stems);
  return near.empty() ? "" : (path.parent_path() / by_stem.at(near)).string();
}

Error cannot_read(const std::string& path, int number) {
  const std::string meant = number == ENOENT ? file_meant(path) : "";
  return cannot_read(
      path, meant.empty() ? Notice{"cannot_be_read", {{"why", std::strerror(number)}}}
                          : Notice{"cannot_be_read_but", {{"why", std::strerror(number)}, {"near", meant}}});
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  Descriptor opened;
  os::FileStatus status;
  int file = os::standard_input;
  if (path != "-") {
    status = os::status(path);
    if (status.kind == os::FileKind::none) return cannot_read(path, errno);
    if (status.kind == os::FileKind::folder) return cannot_read(path, Notice{"reads_no_folder"});
    if (status.kind == os::FileKind::device) return cannot_read(path, Notice{"reads_no_device"});
    opened = Descriptor(os::open(path, O_RDONLY));
    if (!opened.is_open()) return cannot_read(path, errno);
    file = opened.number();
  }

  std::string bytes;
  std::size_t used = 0;
  bool all_zero = true;
  const std::size_t expected = status.size;
  while (true) {
    // One byte more than the file has, so that its end is seen without growing the buffer.
    const std::size_t room = used < expected ? expected - used + 1 : std::size_t{1} << 16;
    bytes.resize(used + room);
    const auto got = os::read(file, bytes.data() + used, room);
    if (got < 0) return cannot_read(path, errno);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    // An endless stream of zeros (/dev/zero, an empty disk) is no recording.
    all_zero =
        all_zero && std::string_view(bytes).substr(0, used).find_first_not_of('\0') == std::string::npos;
    if (all_zero && used >= std::size_t{1} << 16) return cannot_read(path, Notice{"nothing_but_zero_bytes"});
  }
  if (all_zero && used > 0) return cannot_read(path, Notice{"nothing_but_zero_bytes"});
  bytes.resize(used);
  return bytes;
}

}  // namespace cromer::core
