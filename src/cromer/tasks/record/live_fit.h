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

/// Viscous law of the last live_fit_rows at most, found as `cromer fit --law viscous` finds it in the file.
/// `column` is a heading, with or without its unit; where none is named, the column that such a swing
/// explains best, by what is left of its spread. Nothing while the rows are too few to say anything, or
/// cannot be fitted at all.
std::optional<FittedRecording> live_fit(const Rows& rows, const Headings& headings, std::string_view column,
                                        const Watch& watch = {});

/// Fits a recording while it goes on, in a thread of its own.
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
