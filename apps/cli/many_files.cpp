#include "many_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <thread>

#include "cromer/base/ascii.h"
#include "cromer/os/process.h"

namespace cromer::core::cli {
namespace {

constexpr std::string_view endings[] = {".csv", ".txt", ".tsv", ".dat", ".lvm", ".asc",
                                        ".zip", ".at2", ".vt2", ".dt2", ".uff", ".unv"};

bool is_recording(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  const bool hidden = path.filename().string().starts_with('.');
  return !hidden && std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

Result<void> open_folder(const std::string& folder, RecordingFiles& found) {
  std::error_code problem;
  std::vector<std::string> names;
  std::size_t left_aside = 0;
  for (std::filesystem::directory_iterator at(folder, problem), end; !problem && at != end;
       at.increment(problem)) {
    std::error_code none;
    if (at->is_regular_file(none) && is_recording(at->path()))
      names.push_back(at->path().string());
    else
      ++left_aside;
  }
  if (problem) return Error{"folder_unreadable", {{"folder", folder}, {"reason", problem.message()}}};
  if (names.empty())
    return Error{
        "folder_without_recordings",
        {{"folder", folder}, {"endings", std::vector<std::string>(std::begin(endings), std::end(endings))}}};
  if (left_aside > 0)
    found.notes.push_back(
        Notice{"entries_left_aside",
               {{"folder", folder}, {"left", left_aside}, {"all", left_aside + names.size()}}});
  std::sort(names.begin(), names.end());
  found.files.insert(found.files.end(), names.begin(), names.end());
  return {};
}

/// How far all files together are, told to one listener from several threads.
class SharedProgress {
 public:
  SharedProgress(const Watch& watch, std::size_t files) : watch_(watch), parts_(files, 0.0) {}

  Watch of(std::size_t file) {
    Watch part = without_progress(watch_);
    if (watch_.progress) part.progress = [this, file](double fraction) { tell(file, fraction); };
    return part;
  }

  void tell(std::size_t file, double fraction) {
    if (!watch_.progress) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    sum_ += fraction - parts_[file];
    parts_[file] = fraction;
    watch_.progress(sum_ / static_cast<double>(parts_.size()));
  }

 private:
  const Watch& watch_;
  std::mutex mutex_;
  std::vector<double> parts_;
  double sum_ = 0;
};

}  // namespace

Result<RecordingFiles> recording_files(const std::vector<std::string>& named) {
  RecordingFiles found;
  found.many = named.size() > 1;
  for (const auto& name : named) {
    std::error_code none;
    if (!std::filesystem::is_directory(name, none)) {
      found.files.push_back(name);
      continue;
    }
    found.many = found.of_folder = true;
    if (auto good = open_folder(name, found); !good) return good.error();
  }
  return found;
}

void for_each_file(std::size_t count, const Watch& watch,
                   FunctionRef<void(std::size_t i, const Watch& watch)> work) {
  SharedProgress progress(watch, count);
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count && !watch.interrupted(); i = next++) {
      work(i, progress.of(i));
      progress.tell(i, 1);
      // What each leaves behind cuts the freed memory into pieces too small for the next one.
      if (i % 16 == 15) os::give_memory_back();
    }
  };
  const std::size_t threads = std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(take);
  take();
  for (auto& thread : others) thread.join();
}

std::vector<std::string> missing_of(const std::vector<std::string>& all,
                                    const std::vector<std::string>& done) {
  std::vector<std::string> missing;
  for (const std::string& each : all)
    if (std::find(done.begin(), done.end(), each) == done.end()) missing.push_back(each);
  return missing;
}

std::string interrupted_at(std::string_view results, std::string_view things, std::size_t all,
                           std::vector<std::string> missing) {
  constexpr std::size_t most_named = 5;
  std::string said = fmt::format("interrupted; what follows are the {} of {} of {} {}", results,
                                 all - missing.size(), all, things);
  if (missing.empty()) return said;
  const std::size_t more = missing.size() - std::min(missing.size(), most_named);
  missing.resize(missing.size() - more);
  said += fmt::format("; missing: {}", fmt::join(missing, ", "));
  return more > 0 ? said + fmt::format(" and {} more", more) : said;
}

}  // namespace cromer::core::cli
