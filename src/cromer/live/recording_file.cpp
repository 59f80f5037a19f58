#include "cromer/live/recording_file.h"

#include <algorithm>
#include <cerrno>

#include "cromer/live/rows.h"
#include "cromer/os/file.h"
#include "cromer/os/replacement.h"

namespace cromer::core {
namespace {

constexpr std::size_t piece = 4096;  // bytes at most in one write, but for a longer line

}  // namespace

Result<void> RecordingFile::open(const std::string& path) {
  path_ = path;
  const std::string target = target_of(path);
  file_ = Descriptor(os::open(target, O_WRONLY | O_CREAT | O_EXCL | O_APPEND));
  made_ = file_.is_open();
  if (made_) return {};
  if (errno != EEXIST) return cannot_write(path, errno);
  file_ = Descriptor(os::open_to_write(target, true));
  if (!file_.is_open()) return cannot_write(path, errno);
  const os::FileStatus there = os::status(file_.number());
  if (there.kind != os::FileKind::none && there.size == 0) return {};
  file_.close();
  return Error{"recording_exists", {{"path", path}}};
}

Result<void> RecordingFile::write(std::string_view lines) {
  while (!lines.empty()) {
    std::size_t end = lines.size();
    if (end > piece) {
      end = lines.rfind('\n', piece - 1);
      end = end == std::string_view::npos ? lines.find('\n') + 1 : end + 1;
    }
    const std::string_view whole = lines.substr(0, end);
    lines.remove_prefix(end);
    for (std::size_t written = 0; written < whole.size();) {
      const auto more = os::write(file_.number(), whole.data() + written, whole.size() - written);
      if (more <= 0) {
        const Error why = cannot_write(path_, more < 0 ? errno : ENOSPC);
        count(whole.substr(0, written));
        const bool is_whole = written == 0 || whole[written - 1] == '\n' || cut();
        return is_whole ? why : Error{"last_line_not_whole", {{"what", why.notice}}};
      }
      written += static_cast<std::size_t>(more);
    }
    count(whole);
  }
  return {};
}

/// Counts the whole lines in what was written.
void RecordingFile::count(std::string_view written) {
  const std::size_t whole = written.rfind('\n') + 1;
  bytes_ += whole;
  lines_ += static_cast<std::size_t>(std::count(written.begin(), written.begin() + whole, '\n'));
}

/// Half a line would read as a number with fewer digits: a sample that never was.
bool RecordingFile::cut() { return os::truncate(file_.number(), bytes_); }

Result<void> RecordingFile::begin(const std::vector<std::string>& comments, const Headings& headings) {
  std::string text;
  for (const auto& each : comments) text += "# " + each + "\n";
  for (std::size_t i = 0; i < headings.size(); ++i) text += (i > 0 ? "," : "") + headings[i];
  return write(text + "\n");
}

Result<void> RecordingFile::append(const SampleRows& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) append_row(text, rows.t[i], rows.row(i));
  const std::size_t before = lines_;
  auto good = write(text);
  rows_ += lines_ - before;
  return good;
}

Result<void> RecordingFile::comment(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& each : lines) text += "# " + each + "\n";
  return write(text);
}

Result<void> RecordingFile::sync() {
  // A pipe or /dev/null has no disk.
  if (!os::sync(file_.number()) && errno != EINVAL && errno != EROFS) return cannot_write(path_, errno);
  return {};
}

void RecordingFile::drop_if_empty() {
  if (!made_ || lines_ > 0) return;
  file_.close();  // Windows removes no open file
  os::remove(target_of(path_));
}

}  // namespace cromer::core
