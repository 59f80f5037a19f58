// The law of a recording that is still going on: one fit, and a thread that fits again and again.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "cromer/base/interrupt.h"
#include "cromer/live/recorder.h"
#include "cromer/live/rows.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

constexpr std::size_t live_fit_rows = 100000;

/// Fits the viscous law to the last rows, at most live_fit_rows, as `cromer fit --law viscous` does to the
/// file. `column` is a heading, with or without its unit; "" takes the column that a viscous swing explains
/// best. Empty while there are too few rows, and if none can be fitted.
std::optional<FittedRecording> live_fit(const SampleRows& rows, const Headings& headings,
                                        std::string_view column, const Watch& watch = {});

/// Fits a recording while it goes on, in a thread of its own.
class LiveFitter {
 public:
  /// Fits at most once a second, and for no more than a third of the time.
  LiveFitter(const Recorder& recorder, std::string column);
  ~LiveFitter();

  /// The latest fit, null before the first; and how many there have been.
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
