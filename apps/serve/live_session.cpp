#include "apps/serve/live_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cromer/documents/json/live.h"
#include "cromer/documents/words/words.h"

namespace cromer::core::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t batch = 10'000;  // numbers in one event: 64 listeners may each have one in memory
constexpr double shown = 10;           // [s] on the page

/// The path itself, or the first of NAME-2.csv, ... that does not exist or is empty.
std::string free_path(const std::string& path) {
  const auto is_free = [](const std::string& each) {
    std::error_code none;
    return !fs::exists(each, none) || fs::file_size(each, none) == 0;
  };
  if (is_free(path)) return path;
  const std::string stem = path.substr(0, path.size() - 4);
  for (int i = 2;; ++i)
    if (const std::string next = fmt::format("{}-{}.csv", stem, i); is_free(next)) return next;
}

std::string event(std::string_view name, const std::string& json) {
  return fmt::format("event: {}\ndata: {}\n", name, json);  // the document ends with a newline of its own
}

}  // namespace

std::shared_ptr<LiveSession::Active> LiveSession::active() const {
  const std::lock_guard lock(mutex_);
  return active_;
}

Result<std::string> LiveSession::start(std::optional<double> duration) {
  if (!setup_) return Error{"nothing_to_record_from"};
  if (const auto before = active(); before && before->recorder->status().running)
    return Error{"recording_goes_on"};
  const std::size_t stops_before = [this] {
    const std::lock_guard lock(mutex_);
    return stops_;
  }();
  auto next = std::make_shared<Active>();
  const std::string path = free_path(options_.output);
  next->name = fs::path(path).filename().string();
  next->duration = duration ? duration : options_.duration;
  next->recorder =
      make_recorder(*setup_, next->duration, path, "", [](const Notice& notice) { return in_words(notice); });
  if (auto good = next->recorder->start(); !good) return good.error();
  next->fitter = std::make_unique<LiveFitter>(*next->recorder, options_.column);
  std::unique_lock lock(mutex_);
  if (stops_ != stops_before) {
    lock.unlock();
    next->recorder->stop();
    return Error{"stopped_while_starting"};
  }
  next->number = ++recordings_;
  paths_[next->name] = path;
  active_.swap(next);
  return active_->name;
}

void LiveSession::stop() {
  {
    const std::lock_guard lock(mutex_);
    ++stops_;
  }
  if (const auto now = active()) now->recorder->stop();
}

std::string LiveSession::status() const {
  const auto now = active();
  if (!now) return live_status_json(options_.from, options_.duration, "", {}, {});
  const RecorderStatus status = now->recorder->status();
  return live_status_json(options_.from, status.running ? now->duration : options_.duration, now->name,
                          status, now->recorder->headings());
}

std::optional<std::string> LiveSession::path_of(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = paths_.find(name);
  return found == paths_.end() ? std::nullopt : std::optional(found->second);
}

std::string LiveSession::events(EventCursor& cursor) const {
  const auto now = active();
  const double time = steady_seconds();
  std::string text;
  if (now && now->number != cursor.recording) {
    const bool is_new = cursor.status_at == 0;
    cursor = {now->number};
    if (is_new) cursor.rows = now->recorder->first_within(shown);
  }
  if (now) {
    const std::size_t columns = std::max<std::size_t>(now->recorder->headings().size(), 1);
    const SampleRows rows = now->recorder->rows_since(cursor.rows, batch / columns);
    if (rows.size() > 0) text += event("samples", live_samples_json(cursor.rows, rows)) + "\n";
    cursor.rows += rows.size();
    const auto notices = now->recorder->notices_since(cursor.notices);
    if (!notices.empty()) text += event("notices", live_notices_json(notices)) + "\n";
    cursor.notices += notices.size();
    if (const std::size_t fits = now->fitter->count(); fits != cursor.fits) {
      text += event("fit", live_fit_json(*now->fitter->latest())) + "\n";
      cursor.fits = fits;
    }
  }
  if (time - cursor.status_at < 1) return text;
  cursor.status_at = time;
  return event("status", status()) + "\n" + text;
}

}  // namespace cromer::core::serve
