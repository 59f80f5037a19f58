#include "cromer/live/recorder.h"

#include <algorithm>
#include <chrono>
#include <new>

#include "cromer/live/rows.h"

namespace cromer::core {
namespace {

constexpr double wait = 0.05;    // [s] for the source, before looking whether to stop
constexpr double too_fast = 50;  // a device's clock over the computer's, which no drift explains
constexpr double grace = 2;      // [s] that samples may be late before the duration is over without them
constexpr double between_syncs = 0.4;      // [s] with what a sample may be held back, less than one second
constexpr std::size_t kept_notices = 200;  // of a device that writes garbage all the time
constexpr std::size_t at_once = 10000;     // rows brought to the disk

/// Room for more at the end, so that adding them cannot fail.
void make_room(std::vector<double>& values, std::size_t more) {
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity()) values.reserve(std::max(needed, values.capacity() + values.capacity() / 2));
}

/// Nothing if there is such a column, or none was named.
std::optional<Remark> missing_column(const Headings& headings, const std::string& name) {
  std::vector<Notice> there;
  for (std::size_t i = 1; i < headings.size(); ++i) {
    if (name.empty() || is_named(headings[i], name)) return std::nullopt;
    there.push_back(Notice{"column_in_quotes", {{"column", headings[i]}}});
  }
  return Remark{RemarkKind::option,
                Notice{"no_such_column_to_fit_live", {{"column", name}, {"columns", there}}}};
}

}  // namespace

Result<void> Recorder::start() {
  // The file first: a device is not started for a recording that cannot be kept.
  if (auto good = file_.open(settings_.path); !good) return good;
  if (auto good = source_->open(); !good) {
    file_.drop_if_empty();
    return good;
  }
  running_ = true;
  thread_ = std::thread([this] { record(); });
  disk_ = std::thread([this] { keep_on_disk(); });
  return {};
}

void Recorder::stop() {
  stop_ = true;
  const std::lock_guard lock(stopping_);
  if (thread_.joinable()) thread_.join();
  if (disk_.joinable()) disk_.join();
}

void Recorder::fail(const Error& error) {
  const std::lock_guard lock(mutex_);
  if (failure_.empty()) failure_ = error.notice;
  kept_ = file_.rows();
  stop_ = true;
}

// The disk may be slow, and arrivals must be stamped meanwhile: hence a thread of its own.
void Recorder::keep_on_disk() {
  std::size_t written = 0;
  bool headed = false;
  Result<void> good;
  for (bool done = false; !done;) {
    try {
      good = write_rows(written, headed);
      if (good) good = write_end();
      done = true;
    } catch (const std::bad_alloc&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  file_.drop_if_empty();
  if (!good) fail(good.error());
  running_ = false;
}

/// Writes all rows behind the first `written`, until no more will come.
Result<void> Recorder::write_rows(std::size_t& written, bool& headed) {
  double synced = steady_seconds();
  Result<void> good;
  for (bool over = false; !over && good;) {
    {
      std::unique_lock lock(mutex_);
      more_.wait_for(lock, std::chrono::milliseconds(100), [&] { return over_ || rows_.size() > written; });
      over = over_;
    }
    const SampleRows rows = rows_since(written, at_once);
    over = over && rows.size() < at_once;
    if (!headed && rows.size() > 0) {
      good = file_.begin(settings_.comments, headings());
      headed = true;
    }
    if (good && rows.size() > 0) good = file_.append(rows);
    written += rows.size();
    if (!good || steady_seconds() - synced < between_syncs) continue;
    good = file_.sync();
    synced = steady_seconds();
  }
  return good;
}

void Recorder::record() {
  const double begun = steady_seconds();
  double first_arrival = 0;
  bool whole = false, starved = false;
  SampleRows rows;
  std::vector<Remark> notices;
  for (bool more = true; more && !stop_;) {
    // If memory runs out, rows being read may be lost; rows already read are published later.
    try {
      more = source_->receive(wait, rows, notices);
      if (first_arrival == 0 && rows.size() > 0) first_arrival = steady_seconds();
      if (!publish(rows, notices)) {
        whole = true;
        break;
      }
    } catch (const std::bad_alloc&) {
      starved = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    if (settings_.duration) {
      const double since = steady_seconds() - (first_arrival > 0 ? first_arrival : begun);
      more = more && since < *settings_.duration + grace;
    }
  }
  try {
    source_->finish(rows, notices);
  } catch (const std::bad_alloc&) {  // what was held back may be lost, the samples read before are not
    starved = true;
  }
  try {
    if (starved) notices.push_back({RemarkKind::gap, Notice{"out_of_memory"}});
    const double took = steady_seconds() - first_arrival;
    if (settings_.duration && whole && source_->times().by == TimesBy::device &&
        took < *settings_.duration / too_fast)
      notices.push_back({RemarkKind::clock, Notice{"device_times_pass_too_fast",
                                                   {{"duration", *settings_.duration}, {"took", took}}}});
    if (const double pace = source_->pace(); pace > too_fast)
      notices.push_back({RemarkKind::clock, Notice{"device_times_run_fast", {{"pace", pace}}}});
  } catch (const std::bad_alloc&) {  // the last remarks may be lost, the samples read are not
  }
  for (bool published = false; !published;) {
    try {
      publish(rows, notices);
      published = true;
    } catch (const std::bad_alloc&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  source_.reset();  // the device is free for others
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  more_.notify_one();
}

/// False when the recording has its whole length.
bool Recorder::publish(SampleRows& rows, std::vector<Remark>& notices) {
  bool more = true;
  if (settings_.duration && rows.size() > 0) {
    const double begin = rows_.size() > 0 ? rows_.t.front() : rows.t.front();
    const double limit = begin + *settings_.duration * (1 + 1e-9);
    const auto beyond = std::upper_bound(rows.t.begin(), rows.t.end(), limit);
    if (beyond != rows.t.end()) {
      rows.t.erase(beyond, rows.t.end());
      rows.values.resize(rows.width * rows.t.size());
      more = false;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    if (headings_.empty() && rows.size() > 0) {
      headings_ = source_->headings(), rows_.width = rows.width;
      if (auto missing = missing_column(headings_, settings_.column)) notices.push_back(*std::move(missing));
    }
    times_ = source_->times();
    make_room(rows_.t, rows.t.size());
    make_room(rows_.values, rows.values.size());
    notices_.reserve(kept_notices);  // behind this nothing throws: no row is added twice
    rows_.t.insert(rows_.t.end(), rows.t.begin(), rows.t.end());
    rows_.values.insert(rows_.values.end(), rows.values.begin(), rows.values.end());
    for (auto& notice : notices) {
      garbage_ += notice.kind == RemarkKind::garbage;
      if (notices_.size() < kept_notices) notices_.push_back(std::move(notice));
    }
  }
  more_.notify_one();
  rows.clear();
  notices.clear();
  return more;
}

Result<void> Recorder::write_end() {
  std::vector<std::string> lines;
  const auto say = [&](const Notice& notice) {
    lines.push_back(settings_.words ? settings_.words(notice) : notice.code);
  };
  {
    const std::lock_guard lock(mutex_);
    for (const Remark& remark : notices_) say(remark.what);
    if (const Notice times = sentence(times_); !times.empty()) say(times);
    if (garbage_ > 0) say(Notice{"lines_no_samples", {{"lines", garbage_}}});
    if (rows_.size() == 0) lines.clear();
  }
  if (!lines.empty())
    if (auto good = file_.comment(lines); !good) return good;
  return file_.sync();
}

/// How many rows others may see. The lock must be held.
std::size_t Recorder::held() const { return std::min(rows_.size(), kept_.value_or(rows_.size())); }

RecorderStatus Recorder::status() const {
  const std::lock_guard lock(mutex_);
  RecorderStatus now;
  now.running = running_;
  now.samples = held();
  if (now.samples > 0) {
    now.begin = rows_.t.front();
    now.end = rows_.t[now.samples - 1];
    const auto last = rows_.row(now.samples - 1);
    now.last.assign(last.begin(), last.end());
  }
  if (now.end > now.begin) now.rate = static_cast<double>(now.samples - 1) / (now.end - now.begin);
  now.garbage = garbage_;
  now.notices = notices_.size();
  now.times = times_;
  now.failure = failure_;
  return now;
}

Headings Recorder::headings() const {
  const std::lock_guard lock(mutex_);
  return headings_;
}

SampleRows Recorder::rows_since(std::size_t first, std::size_t most) const {
  const std::lock_guard lock(mutex_);
  SampleRows some;
  some.width = rows_.width;
  const std::size_t from = std::min(first, held()), to = from + std::min(most, held() - from);
  some.t.assign(rows_.t.begin() + from, rows_.t.begin() + to);
  some.values.assign(rows_.values.begin() + from * rows_.width, rows_.values.begin() + to * rows_.width);
  return some;
}

std::size_t Recorder::first_within(double seconds) const {
  const std::lock_guard lock(mutex_);
  const auto begin = rows_.t.begin(), end = begin + static_cast<std::ptrdiff_t>(held());
  if (begin == end) return 0;
  return static_cast<std::size_t>(std::lower_bound(begin, end, *(end - 1) - seconds) - begin);
}

std::vector<Remark> Recorder::notices_since(std::size_t first) const {
  const std::lock_guard lock(mutex_);
  return {notices_.begin() + std::min(first, notices_.size()), notices_.end()};
}

}  // namespace cromer::core
