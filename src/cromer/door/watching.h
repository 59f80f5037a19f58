// A caller's Progress as the tasks' Watch.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/status.h"

namespace cromer::core {

/// Lives as long as the work.
class Watching {
 public:
  explicit Watching(const Progress& progress) {
    if (!progress) return;
    watch_.interrupt = &stopped_;
    watch_.progress = [this, &progress](double done) { tell(progress, done); };
    // Where nothing is said of the share for long, the caller hears the last one again, and may end the work.
    watch_.pulse = [this, &progress] { tell(progress, done_); };
  }
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;

  const Watch& watch() const { return watch_; }

 private:
  /// Not from two threads at once: of what comes meanwhile nothing is told.
  void tell(const Progress& progress, double done) {
    const std::unique_lock only(telling_, std::try_to_lock);
    if (!only) return;
    done_ = done;
    const auto now = Clock::now();
    if (last_ && now - *last_ < pause) return;
    last_ = now;
    if (!progress(done)) stopped_ = true;
  }

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds pause{50};

  std::atomic<bool> stopped_{false};
  std::mutex telling_;
  std::atomic<double> done_{0};
  std::optional<Clock::time_point> last_{};  ///< when the caller was told
  Watch watch_;
};

}  // namespace cromer::core
