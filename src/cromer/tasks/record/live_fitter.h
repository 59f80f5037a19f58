// Fits a recording while it goes on, in a thread of its own.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "cromer/live/recorder.h"
#include "cromer/tasks/record/live_fit.h"

namespace cromer::core {

class LiveFitter {
 public:
  /// At most one fit a second, and never more than a third of the time.
  LiveFitter(const Recorder& recorder, std::string column);
  ~LiveFitter();

  /// The last fit that there is, and how many there have been; null before the first.
  std::shared_ptr<const FittedRecording> latest() const;
  std::size_t count() const { return count_; }

 private:
  void work();
  void fit_again_and_again();

  const Recorder& recorder_;
  std::string column_;
  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> count_{0};
  mutable std::mutex mutex_;
  std::shared_ptr<const FittedRecording> latest_;
  std::thread thread_;
};

}  // namespace cromer::core
