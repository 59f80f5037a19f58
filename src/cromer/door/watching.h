// A caller's Progress as the tasks' Watch.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "cromer/base/interrupt.h"
#include "cromer/progress.h"

namespace cromer::core {

/// Lives as long as the work.
class Watching {
 public:
  explicit Watching(const Progress& progress) {
    if (!progress) return;
    watch_.interrupt = &stopped_;
    watch_.progress = [this, &progress](double done) {
      const auto now = Clock::now();
      if (last_ && now - *last_ < pause) return;
      last_ = now;
      if (!progress(done)) stopped_ = true;
    };
  }
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;

  const Watch& watch() const { return watch_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds pause{50};

  std::atomic<bool> stopped_{false};
  std::optional<Clock::time_point> last_{};  ///< when the caller was told
  Watch watch_;
};

}  // namespace cromer::core
