#include "cromer/tasks/record/live_fitter.h"

#include <algorithm>
#include <chrono>
#include <new>

namespace cromer::core {

LiveFitter::LiveFitter(const Recorder& recorder, std::string column)
    : recorder_(recorder), column_(std::move(column)), thread_([this] { work(); }) {}

LiveFitter::~LiveFitter() {
  stop_ = true;
  thread_.join();
}

std::shared_ptr<const FittedRecording> LiveFitter::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

// Out of memory there is no fit for a while; the recording goes on.
void LiveFitter::work() {
  while (!stop_) {
    try {
      fit_again_and_again();
    } catch (const std::bad_alloc&) {
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }
}

void LiveFitter::fit_again_and_again() {
  Rows rows;
  // Only what is fitted: a copy of all rows might be too much again.
  const std::size_t held = recorder_.status().samples;
  std::size_t seen = held - std::min(held, live_fit_rows);  // of the recorder's rows
  double next = steady_seconds() + 1;
  while (!stop_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double begun = steady_seconds();
    if (begun < next) continue;
    next = begun + 1;
    const Rows more = recorder_.rows_since(seen);
    if (more.size() == 0) continue;
    seen += more.size();
    rows.add(more);
    rows.keep_last(live_fit_rows);
    Watch watch;
    watch.interrupt = &stop_;
    auto found = live_fit(rows, recorder_.headings(), column_, watch);
    next = std::max(next, begun + 3 * (steady_seconds() - begun));
    if (!found || stop_) continue;
    const std::lock_guard lock(mutex_);
    latest_ = std::make_shared<const FittedRecording>(*std::move(found));
    ++count_;
  }
}

}  // namespace cromer::core
